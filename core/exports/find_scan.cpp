// Finds a file by its hash.
#include "core/exports/find_scan.h"

#include "core/base/inputs.h"
#include "core/base/sha256.h"

#include <algorithm>
#include <system_error>
#include <vector>

namespace edgescan::exports {
namespace {

namespace fs = std::filesystem;

template <class Iterator>
void addFiles(std::vector<fs::path>& files, Iterator entries) {
    std::error_code problem;
    for (const Iterator end; entries != end && !problem; entries.increment(problem)) {
        std::error_code ignored;
        if (entries->is_regular_file(ignored)) files.push_back(entries->path());
    }
}

/// Files of one folder, likely ones first: the file with the old name, then the others by name.
void likelyFirst(std::vector<fs::path>& files, const std::string& oldName) {
    const fs::path stem = fs::path(oldName).stem();
    const auto rank = [&](const fs::path& file) { return file.filename() == oldName ? 0 : file.stem() == stem ? 1 : 2; };
    std::sort(files.begin(), files.end(),
              [&](const fs::path& a, const fs::path& b) { return std::pair(rank(a), a) < std::pair(rank(b), b); });
}

} // namespace

Result<fs::path> findScan(const std::string& sha256, const std::string& oldName, const fs::path& exported,
                          const std::optional<fs::path>& scansFolder, const std::function<bool(const fs::path&)>& isIt) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (const fs::path& name : namesOf(exported)) {
        const fs::path folder = name.has_parent_path() ? name.parent_path() : fs::path(".");
        addFiles(files, fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, problem));
    }
    likelyFirst(files, oldName);
    if (scansFolder) {
        if (!fs::is_directory(*scansFolder, problem))
            return Error{"there is no such folder", scansFolder->string(), "give --scans the folder that holds the scan"};
        std::vector<fs::path> more;
        addFiles(more, fs::recursive_directory_iterator(*scansFolder, fs::directory_options::skip_permission_denied, problem));
        likelyFirst(more, oldName);
        files.insert(files.end(), more.begin(), more.end());
    }
    std::optional<fs::path> first;
    for (const fs::path& file : files) {
        const auto hash = sha256OfFile(file);
        if (!hash || *hash != sha256) continue;
        if (isIt(file)) return file;
        if (!first) first = file;
    }
    if (first) return *first;
    const std::string where = scansFolder ? " or under " + scansFolder->string() : "";
    return Error{"the scan " + oldName + " with SHA-256 " + sha256.substr(0, 16) + "... is not next to the export" + where,
                 exported.string(), scansFolder ? "copy the scan there" : "give --scans the folder that holds it"};
}

} // namespace edgescan::exports
