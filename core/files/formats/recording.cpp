// Recordings of a live scan (MCAP).
#include "core/files/formats/format.h"

#include "core/containers/ros/bag.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/save_recording.h"

namespace edgescan::files {

Result<Reading> readRosMcap(const containers::McapContent& content, const Source& source); // ros_bag.cpp

namespace {

bool looksLikeRecording(const Source& source) { return source.text().starts_with(containers::kMcapMagic); }

/// A recording of this program, or a ROS 2 bag in the same container.
Result<Reading> readMcapFile(const Source& source) {
    const ByteView bytes(reinterpret_cast<const std::uint8_t*>(source.bytes.data()), source.bytes.size());
    auto recording = readRecording(source);
    if (recording) return Reading(std::move(*recording));
    const auto content = containers::readMcap(bytes, source.path.string());
    if (content && containers::hasRosTopics(*content)) return readRosMcap(*content, source);
    return recording.error();
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
            .placesItself = true};
}

} // namespace edgescan::files
