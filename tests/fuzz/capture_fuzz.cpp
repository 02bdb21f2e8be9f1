// Fuzzes the reader of captures: PCAP, PCAPNG and raw streams, recognised by content.
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return edgescan::fuzz::openBytes(bytes, size, ".bin");
}
