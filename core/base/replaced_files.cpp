// Identifies a file by its whole path, because its new content has another inode.
#include "core/base/replaced_files.h"

#include <map>
#include <mutex>
#include <utility>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

std::mutex replacedMutex;
std::map<fs::path, bool> firstWritings; // whether there was such a file

fs::path wholePath(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

} // namespace

void noteWriting(const fs::path& target) {
    std::error_code ignored;
    const bool isThere = fs::exists(target, ignored);
    const std::lock_guard lock(replacedMutex);
    firstWritings.try_emplace(wholePath(target), isThere);
}

bool popReplaced(const fs::path& path) {
    const std::lock_guard lock(replacedMutex);
    const auto found = firstWritings.find(wholePath(path));
    return found != firstWritings.end() && std::exchange(found->second, false);
}

} // namespace edgescan
