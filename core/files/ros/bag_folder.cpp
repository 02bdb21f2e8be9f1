// Finds the file of a bag's folder by what is there, because a bag that was interrupted has no metadata.yaml.
#include "core/files/ros/bag_folder.h"

#include <algorithm>
#include <string>
#include <vector>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "metadata.yaml";

bool holdsMessages(const fs::path& path) {
    std::string name = path.filename().string();
    for (const char* packed : {".zstd", ".zst", ".gz"}) {
        if (name.ends_with(packed)) name.erase(name.rfind('.'));
    }
    return name.ends_with(".mcap") || name.ends_with(".db3") || name.ends_with(".bag");
}

} // namespace

Result<fs::path> fileOfBag(const fs::path& path) {
    std::error_code problem;
    const fs::path folder = path.filename() == kMetadata ? path.parent_path() : path;
    if (!fs::is_directory(folder.empty() ? fs::path(".") : folder, problem)) return path;
    std::vector<fs::path> files;
    for (auto at = fs::directory_iterator(folder.empty() ? fs::path(".") : folder, problem); !problem && at != fs::directory_iterator();
         at.increment(problem)) {
        if (holdsMessages(at->path()) && at->is_regular_file(problem)) files.push_back(at->path());
    }
    if (files.empty()) return path;
    std::ranges::sort(files);
    if (files.size() == 1) return files.front();
    return Error{"this folder holds " + std::to_string(files.size()) + " files of a bag", path.string(),
                 "open one of them, as " + files.front().filename().string()};
}

} // namespace edgescan::files
