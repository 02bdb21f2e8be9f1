// Fuzzes the reader of ROS 1 bags. The magic bytes are given, so that the fuzzer does not have to find them.
#include "core/base/bytes.h"
#include "tests/fuzz/open_bytes.h"

#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
    edgescan::Bytes file(kMagic.begin(), kMagic.end());
    file.insert(file.end(), bytes, bytes + size);
    return edgescan::fuzz::openBytes(file.data(), file.size(), ".bag");
}
