// Writes through a temporary file and a rename; reads a whole file.
#include "core/base/whole_file.h"
#include "core/base/translated_text.h"

#include "core/base/file_address.h"
#include "core/base/file_lock.h"
#include "core/base/inputs.h"
#include "core/base/memory.h"
#include "core/base/own_kind.h"
#include "core/base/replaced_files.h"
#include "core/base/stop.h"
#include "core/base/temporary_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

Error readError(const fs::path& path, int code) {
    const std::string reason = std::strerror(code);
    switch (code) {
    case ENOENT:
    case ENOTDIR:
        if (const auto elsewhere = addressElsewhere(path.string())) return *elsewhere;
        if (path.string().find("\xEF\xBF\xBD") != std::string::npos) // U+FFFD, as Qt's file dialogs write a byte that is not UTF-8
            return {"there is no such file; a name with other bytes than UTF-8 does not come through a file dialog", path.string(),
                    "give the name on the command line, drag the file into the window, or rename it"};
        return {"there is no such file", path.string(), "check the spelling and the folder"};
    case EACCES:
    case EPERM:
        return {"reading this file is not allowed", path.string(), "ask its owner for the right to read it"};
    case EISDIR:
        return {"this is a folder, not a file", path.string(), "choose a file inside it"};
    default:
        return {withValues("the file cannot be read: %1", {reason}), path.string(), "check the disk and the path"};
    }
}

/// Error if writing `path`, which leads to `target`, would replace a folder or a read-only file, or the name is too long.
Result<Done> checkMayBeReplaced(const fs::path& path, const fs::path& target) {
    struct stat old {};
    if (::stat(target.c_str(), &old) != 0) return errno == ENAMETOOLONG ? Result<Done>(writeError(path, errno)) : Done{};
    if (S_ISDIR(old.st_mode)) return writeError(path, EISDIR);
    constexpr mode_t kAnyWriter = 0222; // root may write everything
    const bool own = old.st_uid == ::geteuid() || ::geteuid() == 0;
    if (own && (old.st_mode & kAnyWriter) == 0)
        return Error{"this file is read-only, so it was not replaced", path.string(),
                     "allow writing with chmod u+w, or choose another name"};
    if (!own && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0 && errno == EACCES)
        return Error{"this file belongs to another user, who does not allow writing, so it was not replaced", path.string(),
                     "choose another name, or ask its owner"};
    return Done{};
}

Descriptor openFolderOf(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

/// Locks the folders of several files during the lifetime of this object, so that files that belong together appear together although
/// another program writes files of the same names. On a file system without locks, and where a program that is not a writer holds the lock
/// (`flock FOLDER command`), the files are written without it: then the hashes in the record show what does not belong together.
class FolderLocks {
public:
    explicit FolderLocks(const std::vector<FileMove>& moves) {
        std::map<Number, Descriptor> folders; // the same order in every program, so that two do not wait for each other
        for (const FileMove& move : moves) {
            Descriptor folder = openFolderOf(move.to);
            struct stat status {};
            if (folder.isOpen() && ::fstat(folder.number(), &status) == 0)
                folders.try_emplace({status.st_dev, status.st_ino}, std::move(folder));
        }
        for (auto& [number, folder] : folders) {
            lock(number, folder.number());
            held_.push_back(std::move(folder));
        }
    }

private:
    using Number = std::pair<dev_t, ino_t>;
    static void lock(const Number& number, int folder) {
        static std::mutex mutex;
        static std::set<Number> waitedInVain; // this program does not wait for them again until they are free
        const auto within = [&] {
            const std::lock_guard guard(mutex);
            return waitedInVain.contains(number) ? std::chrono::seconds(0) : kLongestWait;
        }();
        const Lock outcome = lockFile(folder, within);
        const std::lock_guard guard(mutex);
        if (outcome == Lock::Busy)
            waitedInVain.insert(number);
        else
            waitedInVain.erase(number);
    }

    static constexpr std::chrono::seconds kLongestWait{
        20}; // many writers on a busy machine take seconds; each holds the lock for renames only
    std::vector<Descriptor> held_;
};

/// Renames in the order of the list. On an error, the files that have moved before are named; they cannot be taken back.
template <class Renamed>
Result<Done> renameAll(const std::vector<FileMove>& moves, Renamed renamed) {
    std::optional<FolderLocks> locks;
    if (moves.size() > 1) locks.emplace(moves);
    for (std::size_t n = 0; n < moves.size(); ++n) {
        noteWriting(moves[n].to);
        if (::rename(moves[n].from.c_str(), moves[n].to.c_str()) != 0) {
            Error failed = writeError(moves[n].to, errno);
            for (std::size_t before = 0; before < n; ++before)
                failed.what += (before == 0 ? "; already in place: " : ", ") + moves[before].to.filename().string();
            return failed;
        }
        renamed(n);
    }
    locks.reset();
    std::set<fs::path> folders;
    for (const FileMove& move : moves) {
        if (!folders.insert(move.to.parent_path()).second) continue;
        if (const Descriptor folder = openFolderOf(move.to); folder.isOpen()) static_cast<void>(::fsync(folder.number()));
    }
    return Done{};
}

constexpr std::chrono::seconds kReaderComesWithin{3};
constexpr std::chrono::seconds kReaderReadsWithin{30};

/// Opens for writing and does not wait for ever: opening a pipe for writing works only after a program opened it for reading.
Result<int> openDevice(const fs::path& path) {
    const auto until = std::chrono::steady_clock::now() + kReaderComesWithin;
    while (true) {
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
        if (descriptor >= 0) return descriptor;
        std::error_code ignored;
        if (const int code = errno; code != ENXIO || !fs::is_fifo(path, ignored)) return writeError(path, code);
        if (std::chrono::steady_clock::now() >= until)
            return Error{"no program reads from this pipe", path.string(), "start what reads from it first, or choose a file"};
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// During the lifetime of this object, a closed reader of a pipe causes an errno instead of a signal that ends the program.
class NoBrokenPipe {
public:
    NoBrokenPipe() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        wasPending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    NoBrokenPipe(const NoBrokenPipe&) = delete;
    NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;
    ~NoBrokenPipe() {
        const timespec now{};
        if (!wasPending_) sigtimedwait(&pipe_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

private:
    sigset_t pipe_{}, before_{};
    bool wasPending_ = false;
};

Result<Done> writeDevice(const fs::path& path, std::span<const std::byte> bytes) {
    const Result<int> opened = isStandardOutput(path) ? Result<int>(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)) : openDevice(path);
    if (!opened) return opened.error();
    const Descriptor file(*opened);
    const NoBrokenPipe guard;
    while (!bytes.empty()) {
        pollfd wait{file.number(), POLLOUT, 0};
        const int ready = ::poll(&wait, 1, static_cast<int>(std::chrono::milliseconds(kReaderReadsWithin).count()));
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0) return Error{"what reads from this pipe takes nothing", path.string(), "start it again, or choose a file"};
        const ssize_t count = ::write(file.number(), bytes.data(), bytes.size());
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0 && errno == EPIPE)
            return Error{"what reads from this pipe has ended", path.string(), "start it again, or choose a file"};
        if (count < 0) return writeError(path, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return Done{};
}

} // namespace

bool isStandardOutput(const fs::path& path) { return path == "-" || (!path.has_parent_path() && path.native().starts_with("-.")); }

// A rename would destroy /dev/null or a pipe, so these are written to directly.
bool isDevice(const fs::path& path) {
    if (isStandardOutput(path)) return true;
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    return !problem && fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Result<fs::path> finalTarget(const fs::path& path) {
    std::error_code problem;
    if (fs::is_directory(path, problem)) return writeError(path, EISDIR);
    if (!path.has_filename()) return Error{"there is no file name to write to", path.string(), "give a file name"};
    constexpr int kMostLinks = 40; // the kernel's limit
    fs::path target = path;
    for (int links = 0; links <= kMostLinks; ++links) {
        struct stat status {};
        if (::lstat(target.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return target;
        // Another user could place a link here so that EdgeScan overwrites one of our files.
        if (status.st_uid != ::geteuid() && status.st_uid != 0)
            return Error{"this is a link that belongs to another user", target.string(), "give the file it leads to, or another name"};
        const fs::path next = fs::read_symlink(target, problem);
        if (problem) return writeError(path, problem.value());
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    return writeError(path, ELOOP);
}

namespace {

Result<Done> writeAll(const std::vector<FileContent>& files) {
    std::vector<fs::path> targets;
    std::set<fs::path> taken;
    for (const FileContent& file : files) {
        if (isDevice(file.path)) {
            targets.emplace_back();
            continue;
        }
        auto target = finalTarget(file.path);
        if (!target) return target.error();
        if (auto may = checkMayBeReplaced(file.path, *target); !may) return may;
        std::error_code ignored;
        if (!taken.insert(fs::weakly_canonical(fs::absolute(*target, ignored), ignored)).second)
            return Error{"two results cannot have one file", file.path.string(), "give each a name of its own"};
        targets.push_back(std::move(*target));
    }
    const auto cancelled = [&] { return Error{"it was cancelled, so nothing was written", files.front().path.string(), "save it again"}; };
    std::vector<TemporaryFile> ready;
    std::vector<FileMove> moves;
    for (std::size_t n = 0; n < files.size(); ++n) {
        if (isStopWished()) return cancelled();
        if (targets[n].empty()) {
            if (auto written = writeDevice(files[n].path, files[n].bytes); !written) return written.error();
            continue;
        }
        auto temporary = TemporaryFile::write(files[n].path, targets[n], files[n].bytes, targets.front());
        if (!temporary) return temporary.error();
        moves.push_back({temporary->path(), temporary->target()});
        ready.push_back(std::move(*temporary));
    }
    if (isStopWished()) return cancelled();
    return renameAll(moves, [&](std::size_t n) { ready[n].wasRenamed(); });
}

} // namespace

Result<Done> writeWholeFiles(const std::vector<FileContent>& files) {
    for (const FileContent& file : files) {
        if (isDevice(file.path)) continue;
        if (auto other = checkIsNoInput(file.path); !other) return other;
        std::error_code none;
        if (!fs::is_regular_file(file.path, none)) continue;
        if (auto same = checkIsOfKind(file.path, ownKind(textOf(file.bytes))); !same) return same;
    }
    return writeAll(files);
}

Result<Done> checkCanBeWritten(const fs::path& path) {
    if (isDevice(path)) return Done{};
    if (auto other = checkIsNoInput(path); !other) return other;
    const auto target = finalTarget(path);
    if (!target) return target.error();
    if (auto may = checkMayBeReplaced(path, *target); !may) return may;
    const fs::path folder = target->has_parent_path() ? target->parent_path() : fs::path(".");
    return ::access((folder / "").c_str(), W_OK | X_OK) == 0 ? Result<Done>(Done{}) : writeError(path, errno);
}

Result<Done> changeWholeFile(const fs::path& path, std::uint64_t most, const FileChange& change) {
    const FolderLocks lock({{path, path}});
    std::error_code problem;
    std::optional<std::string> before;
    if (fs::exists(path, problem)) {
        const auto bytes = readWholeFile(path, most);
        if (!bytes) return bytes.error();
        before = textOf(*bytes);
    }
    const auto after = change(before);
    if (!after) return after.error();
    if (*after == before) return Done{};
    if (*after) return writeWholeFile(path, **after);
    fs::remove(path, problem);
    if (problem)
        return Error{withValues("the file cannot be removed (%1)", {problem.message()}), path.string(), "check the rights of its folder"};
    return Done{};
}

Result<Done> makeFolder(const fs::path& folder, const char* remedy) {
    std::error_code failed;
    if (fs::is_regular_file(folder, failed)) return Error{"this is a file and not a folder", folder.string(), "give the name of a folder"};
    failed.clear();
    if (!folder.empty()) fs::create_directories(folder, failed);
    if (failed) return Error{withValues("the folder cannot be made (%1)", {failed.message()}), folder.string(), remedy};
    return Done{};
}

Result<Done> replaceOwnSidecar(const fs::path& path, const std::string& text) { return writeAll({{path, std::as_bytes(std::span(text))}}); }

Result<Done> moveWholeFiles(const std::vector<FileMove>& moves) {
    for (const FileMove& move : moves) {
        if (auto other = checkIsNoInput(move.to); !other) return other;
        if (auto may = checkMayBeReplaced(move.to, move.to); !may) return may;
    }
    return renameAll(moves, [](std::size_t /*n*/) {});
}

Result<Done> writeWholeFile(const fs::path& path, std::span<const std::byte> bytes) { return writeWholeFiles({{path, bytes}}); }

Result<Done> writeWholeFile(const fs::path& path, const std::string& text) { return writeWholeFile(path, std::as_bytes(std::span(text))); }

Result<std::vector<std::byte>> readWholeFile(const fs::path& path, std::uint64_t most) {
    // O_NONBLOCK: opening a pipe without a writer must not block; the check below refuses it.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0) return readError(path, errno);
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) return readError(path, errno);
    if (S_ISDIR(status.st_mode)) return readError(path, EISDIR);
    if (!S_ISREG(status.st_mode)) return Error{"this is a device or a pipe, not a file", path.string(), "choose a file"};
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > most)
        return Error{
            withValues("the file is too large for what it should be: %1, and at most %2 are read", {sizeText(size), sizeText(most)}),
            path.string(), "choose another file"};
    if (auto enough = checkMemory(size, path.string()); !enough) return enough.error();
    // resize() clears the new elements. In pieces, the memory is still in the cache when the file is read into it.
    constexpr std::size_t kPiece = std::size_t{1} << 18U;
    std::vector<std::byte> bytes;
    bytes.reserve(size);
    std::size_t filled = 0;
    while (filled < size) {
        if (filled == bytes.size()) bytes.resize(std::min<std::size_t>(size, filled + kPiece));
        const ssize_t count = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return readError(path, errno);
        if (count == 0) break;
        filled += static_cast<std::size_t>(count);
    }
    bytes.resize(filled);
    return bytes;
}

} // namespace edgescan
