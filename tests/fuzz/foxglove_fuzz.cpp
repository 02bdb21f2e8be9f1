// Fuzzes the reader of EdgeScan's own clouds for Foxglove.
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return edgescan::fuzz::openBytes(bytes, size, ".mcap");
}
