// Recordings of a live scan (MCAP).
#include "core/files/formats/format.h"

#include "core/files/recording/replay.h"
#include "core/files/recording/save_recording.h"

namespace edgescan::files {
namespace {

bool looksLikeRecording(const Source& source) { return source.text().starts_with(containers::kMcapMagic); }

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
            .read = readingOf<readRecording>,
            .writeScan = recordingFile,
            .placesItself = true};
}

} // namespace edgescan::files
