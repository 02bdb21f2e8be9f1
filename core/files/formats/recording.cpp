// Recordings of a live scan (MCAP).
#include "core/files/formats/format.h"

#include "core/containers/ros/bag.h"
#include "core/files/formats/ros_bag.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/save_recording.h"

#include <optional>

namespace edgescan::files {
namespace {

bool looksLikeRecording(const Source& source) { return source.text().starts_with(containers::kMcapMagic); }

/// The scan of a ROS bag in this container; empty: it holds no topic of ROS.
std::optional<Result<Reading>> rosScanIn(const Source& source) {
    const ByteView bytes(reinterpret_cast<const std::uint8_t*>(source.bytes.data()), source.bytes.size());
    const auto content = containers::readMcap(bytes, source.path.string(), [&] { return source.goOn("reading", 0.0); });
    if (!content || !containers::hasRosTopics(*content)) return std::nullopt;
    return readRosMcap(*content, source);
}

/// A recording of this program, or a ROS 2 bag in the same container. What its header calls a profile decides which of them is tried first.
Result<Reading> readMcapFile(const Source& source) {
    constexpr std::size_t kProfileAt = containers::kMcapMagic.size() + containers::kMcapRecordHead + 4;
    if (source.text().substr(0, kProfileAt + 3).ends_with("ros")) {
        if (auto bag = rosScanIn(source)) return std::move(*bag);
        return readingOf<readRecording>(source);
    }
    auto recording = readingOf<readRecording>(source);
    if (recording) return recording;
    if (auto bag = rosScanIn(source)) return std::move(*bag);
    return recording;
}

Result<std::vector<FileBytes>> recordingFile(const Scan& scan, const std::filesystem::path& path) {
    const auto bytes = recordingOf(scan, path.string());
    if (!bytes) return bytes.error();
    return std::vector<FileBytes>{{path, std::string(bytes->begin(), bytes->end())}};
}

} // namespace

Format recordingFormat() {
    return {.title = "Recording",
            .reads = {".mcap"},
            .writes = {".mcap"},
            .recognises = looksLikeRecording,
            .read = readMcapFile,
            .writeScan = recordingFile,
            .options = {"topic", "joint", "scan"},
            .placesItself = true};
}

} // namespace edgescan::files
