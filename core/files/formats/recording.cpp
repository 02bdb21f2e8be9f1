// Recordings of a live scan (MCAP).
#include "core/base/translated_text.h"
#include "core/files/formats/format.h"

#include "core/containers/mcap/records.h"
#include "core/files/addons/addon.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/save_recording.h"

#include <optional>

namespace edgescan::files {
namespace {

bool looksLikeRecording(const Source& source) { return source.text().starts_with(containers::kMcapMagic); }

/// A recording of this program, or what an add-on knows in the same container. What its header calls a profile decides which of them is
/// tried first.
Result<Reading> readMcapFile(const Source& source) {
    const auto readOther = addon().readMcap;
    if (readOther == nullptr) {
        auto recording = readingOf<readRecording>(source);
        if (recording || recording.error().what == source.cancelled().what) return recording;
        return source.refused(withValues("%1, and %2", {recording.error().what, kNoRobots}), kBuildWithRobots);
    }
    constexpr std::size_t kProfileAt = containers::kMcapMagic.size() + containers::kMcapRecordHead + 4;
    if (source.text().substr(0, kProfileAt + 3).ends_with("ros")) {
        if (auto bag = readOther(source)) return std::move(*bag);
        return readingOf<readRecording>(source);
    }
    auto recording = readingOf<readRecording>(source);
    if (recording) return recording;
    if (auto bag = readOther(source)) return std::move(*bag);
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
