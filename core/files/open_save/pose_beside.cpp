// Reads and writes the pose file beside a scan.
#include "core/files/open_save/pose_beside.h"

#include "core/base/pipe.h"
#include "core/base/whole_file.h"

#include <string_view>
#include <system_error>
#include <unistd.h>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTail = ".pose.json";
constexpr std::uint64_t kMostPoseBytes = std::uint64_t{64} << 20U; // the bound of parseJson()

} // namespace

fs::path poseBeside(const fs::path& scan) { return fs::path(scan.string() + std::string(kTail)); }

bool isPoseBeside(const fs::path& path) { return path.string().ends_with(kTail); }

ReadingOptions withPoseBeside(ReadingOptions options, const fs::path& scan) {
    std::error_code none;
    if (options.pose.empty() && !isPipe(scan) && fs::is_regular_file(poseBeside(scan), none)) options.pose = poseBeside(scan).string();
    return options;
}

Result<std::optional<std::string>> readPoseBeside(const fs::path& scan) {
    std::error_code none;
    if (!fs::exists(poseBeside(scan), none)) return std::optional<std::string>();
    const auto bytes = readWholeFile(poseBeside(scan), kMostPoseBytes);
    if (!bytes) return bytes.error();
    return std::optional(std::string(textOf(*bytes)));
}

Result<Done> writePoseBeside(const fs::path& scan, const std::optional<std::string>& text) {
    const fs::path path = poseBeside(scan);
    std::error_code trouble;
    if (!text) {
        fs::remove(path, trouble);
        if (trouble) return Error{"the pose could not be removed (" + trouble.message() + ")", path.string(), "remove the file by hand"};
        return Done{};
    }
    if (fs::exists(path, trouble) && ::access(path.c_str(), W_OK) != 0)
        return Error{"this file may not be written to", path.string(), "allow it, or remove the file"};
    // By a file of another name: the pose that the scan was opened with is an input, which writeWholeFile() does not replace.
    const fs::path fresh = path.string() + ".new";
    if (auto written = writeWholeFile(fresh, *text); !written) return written;
    fs::rename(fresh, path, trouble);
    if (!trouble) return Done{};
    const std::string why = trouble.message();
    fs::remove(fresh, trouble);
    return Error{"the pose could not be stored (" + why + ")", path.string(), "check that the folder may be written to"};
}

} // namespace edgescan::files
