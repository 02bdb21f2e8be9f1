// Fuzzes the reader of what is packed with gzip.
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return edgescan::fuzz::openBytes(bytes, size, ".xyz.gz");
}
