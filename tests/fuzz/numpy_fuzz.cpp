// Fuzzes the reader of numpy arrays and archives of them.
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return edgescan::fuzz::openBytes(bytes, size, ".npy");
}
