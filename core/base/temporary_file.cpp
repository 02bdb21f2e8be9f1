// Creates, locks, writes and reads back temporary files; removes those of killed programs.
#include "core/base/temporary_file.h"

#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".part";

/// The beginning of the names of this machine's temporary files. Programs of several machines may share the folder and a process number.
const std::string& beginning() {
    static const std::string kBeginning = [] {
        std::array<char, 256> host{};
        if (::gethostname(host.data(), host.size() - 1) != 0 || host[0] == '\0') return std::string(".edgescan-host-");
        std::string name = std::string(host.data()).substr(0, 64);
        std::ranges::replace(name, '/', '_');
        return ".edgescan-" + name + "-";
    }();
    return kBeginning;
}

/// A short name that does not depend on the target's name, so that a target name of the greatest allowed length still works.
fs::path newName(const fs::path& target) {
    static std::atomic<unsigned> serial{0};
    return target.parent_path() / (beginning() + std::to_string(::getpid()) + "-" + std::to_string(serial++) + kEnding);
}

/// Whether programs on this machine give such a name: HOST-PROCESS-NUMBER.
bool isName(std::string_view name) {
    if (!name.starts_with(beginning()) || !name.ends_with(kEnding)) return false;
    name = name.substr(beginning().size());
    name.remove_suffix(std::string_view(kEnding).size());
    return std::ranges::count(name, '-') == 1 && name.find_first_not_of("-0123456789") == std::string_view::npos;
}

/// Removes a temporary file if its program has ended: then its lock can be taken.
void removeIfDead(const fs::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
    struct stat status {};
    if (!file.isOpen() || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != ::geteuid()) return;
    if (lockFile(file.number()) == Lock::Acquired && isOpenAt(file.number(), path)) ::unlink(path.c_str());
}

/// Once for each folder that this program writes into.
void removeLeftovers(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> seen;
    {
        const std::lock_guard lock(mutex);
        if (!seen.insert(folder).second) return;
    }
    std::vector<fs::path> found;
    std::error_code failed;
    const fs::directory_iterator end;
    for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, failed); !failed && at != end; at.increment(failed)) {
        if (isName(at->path().filename().native())) found.push_back(at->path());
    }
    for (const fs::path& path : found) removeIfDead(path);
}

/// Returns 0, or the errno of the failed write.
int writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

/// Reads the open file piece by piece and compares it with the expected bytes.
bool holds(int file, std::span<const std::byte> bytes) {
    std::vector<std::byte> piece(std::min<std::size_t>(bytes.size() + 1, std::size_t{1} << 18U)); // stays in the cache
    std::size_t at = 0;
    while (true) {
        const ssize_t count = ::pread(file, piece.data(), piece.size(), static_cast<off_t>(at));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return count == 0 && at == bytes.size();
        const auto read = static_cast<std::size_t>(count);
        if (read > bytes.size() - at || std::memcmp(piece.data(), bytes.data() + at, read) != 0) return false;
        at += read;
    }
}

} // namespace

Error writeError(const fs::path& path, int code) {
    switch (code) {
    case ENOENT:
        return {"the folder to write into does not exist", path.string(), "make the folder or choose another"};
    case ENOTDIR:
        return {"the folder to write into is not a folder", path.string(), "choose another folder"};
    case EACCES:
    case EPERM:
        return {"writing here is not allowed", path.string(), "choose another folder or ask for the right to write"};
    case EROFS:
        return {"the disk can only be read", path.string(), "choose another folder"};
    case ENOSPC:
    case EDQUOT:
        return {"the disk is full, so this file was not written", path.string(), "free some space or choose another disk"};
    case EFBIG:
        return {"the file would be larger than the limit set for it", path.string(), "choose another disk or raise the limit"};
    case EISDIR:
        return {"this is a folder, not a file", path.string(), "give a file name"};
    case ELOOP:
        return {"this link leads in a circle", path.string(), "give the file itself"};
    case ENAMETOOLONG:
        return {"the file name is too long", path.string(), "choose a shorter name"};
    default:
        return {std::string("the file cannot be written: ") + std::strerror(code), path.string(), "choose another folder or disk"};
    }
}

bool isOpenAt(int file, const fs::path& path) {
    struct stat open {
    }, named{};
    return ::fstat(file, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

Result<TemporaryFile> TemporaryFile::write(const fs::path& asked, const fs::path& target, std::span<const std::byte> bytes,
                                           const fs::path& like) {
    removeLeftovers(target.parent_path());
    struct stat old {};
    const bool hasMode = ::stat(like.c_str(), &old) == 0 || ::stat(target.c_str(), &old) == 0;
    constexpr int kMostTries = 100;
    for (int n = 0; n < kMostTries; ++n) {
        const fs::path path = newName(target);
        Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (!file.isOpen() && errno == EEXIST) continue; // of a killed program with the same process number
        if (!file.isOpen()) return writeError(asked, errno);
        // Another program may take the file for a dead one before it is locked.
        if (lockFile(file.number()) == Lock::Busy || !isOpenAt(file.number(), path)) continue;
        TemporaryFile temporary(std::move(file), path, target);
        const int number = temporary.file_.number();
        if (hasMode) static_cast<void>(::fchmod(number, old.st_mode & 0777U)); // a wrong mode is not a reason to fail
        if (const int code = writeAll(number, bytes)) return writeError(asked, code);
        if (::fsync(number) != 0 && errno != EINVAL) return writeError(asked, errno);
        if (!holds(number, bytes))
            return Error{"what was read back is not what was written, so this file was not written", asked.string(),
                         "check the disk and try again"};
        return temporary;
    }
    return writeError(asked, EEXIST);
}

TemporaryFile::~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
}

} // namespace edgescan
