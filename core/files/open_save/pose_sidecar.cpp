// Reads and writes the pose sidecar of a scan.
#include "core/files/open_save/pose_sidecar.h"
#include "core/base/translated_text.h"

#include "core/base/pipe.h"
#include "core/base/whole_file.h"

#include <string_view>
#include <system_error>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTail = ".pose.json";
constexpr std::uint64_t kMostPoseBytes = std::uint64_t{64} << 20U; // the bound of parseJson()

} // namespace

fs::path poseSidecar(const fs::path& scan) { return fs::path(scan.string() + std::string(kTail)); }

bool isPoseSidecar(const fs::path& path) { return path.string().ends_with(kTail); }

ReadingOptions withPoseSidecar(ReadingOptions options, const fs::path& scan) {
    std::error_code none;
    if (options.pose.empty() && !isPipe(scan) && fs::is_regular_file(poseSidecar(scan), none)) options.pose = poseSidecar(scan).string();
    return options;
}

Result<std::optional<std::string>> readPoseSidecar(const fs::path& scan) {
    std::error_code none;
    if (!fs::exists(poseSidecar(scan), none)) return std::optional<std::string>();
    const auto bytes = readWholeFile(poseSidecar(scan), kMostPoseBytes);
    if (!bytes) return bytes.error();
    return std::optional(std::string(textOf(*bytes)));
}

Result<Done> writePoseSidecar(const fs::path& scan, const std::optional<std::string>& text) {
    const fs::path path = poseSidecar(scan);
    std::error_code trouble;
    if (!text) {
        fs::remove(path, trouble);
        if (trouble)
            return Error{withValues("the pose could not be removed (%1)", {trouble.message()}), path.string(), "remove the file by hand"};
        return Done{};
    }
    return replaceOwnSidecar(path, *text);
}

} // namespace edgescan::files
