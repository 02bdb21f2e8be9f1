// Fuzzes the reader of bags of ROS 2 in SQLite.
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return edgescan::fuzz::openBytes(bytes, size, ".db3");
}
