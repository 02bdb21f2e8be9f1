// Any bytes as a recording: the result is a scan or an error sentence.
#include "core/files/recording/replay.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace edgescan;
    // The magic bytes are given, so that the fuzzer does not have to find them.
    Bytes file(containers::kMcapMagic.begin(), containers::kMcapMagic.end());
    file.insert(file.end(), bytes, bytes + size);
    const auto recording = files::Recording::fromBytes(std::move(file), "fuzz");
    if (!recording) return 0;
    const auto scan = files::scanOf(*recording, "fuzz");
    if (!scan) return 0;
    std::size_t cells = 0;
    for (const std::size_t count : countCells(*scan)) cells += count;
    if (cells != scan->cells()) std::abort();
    return 0;
}
