// Writes through a temporary file and a rename; reads a whole file.
#include "core/base/whole_file.h"

#include "core/base/inputs.h"
#include "core/base/memory.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

/// A descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    [[nodiscard]] int number() const { return number_; }
    int release() { return std::exchange(number_, -1); }

private:
    int number_;
};

/// A temporary file, removed at the end unless it was renamed.
struct Temporary {
    fs::path path;
    fs::path target;
    bool renamed = false;

    Temporary(fs::path temporaryPath, fs::path targetPath) : path(std::move(temporaryPath)), target(std::move(targetPath)) {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    Temporary(Temporary&& other) noexcept
        : path(std::move(other.path)), target(std::move(other.target)), renamed(std::exchange(other.renamed, true)) {}
    Temporary& operator=(Temporary&&) = delete;
    ~Temporary() {
        if (!renamed) ::unlink(path.c_str());
    }
};

Error writeError(const fs::path& path, int code) {
    const std::string reason = std::strerror(code);
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
        return {"the disk is full, nothing was written", path.string(), "free some space or choose another disk"};
    case EFBIG:
        return {"the file would be larger than the limit set for it", path.string(), "choose another disk or raise the limit"};
    case EISDIR:
        return {"this is a folder, not a file", path.string(), "give a file name"};
    case ELOOP:
        return {"this link leads in a circle", path.string(), "give the file itself"};
    case ENAMETOOLONG:
        return {"the file name is too long", path.string(), "choose a shorter name"};
    default:
        return {"the file cannot be written: " + reason, path.string(), "choose another folder or disk"};
    }
}

Error readError(const fs::path& path, int code) {
    const std::string reason = std::strerror(code);
    switch (code) {
    case ENOENT:
    case ENOTDIR:
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
        return {"the file cannot be read: " + reason, path.string(), "check the disk and the path"};
    }
}

/// Returns 0, or the errno of the failed write.
int writeAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

/// The file that a path leads to through its links. Another user could place a link here so that EdgeScan overwrites one of our files.
Result<fs::path> finalTarget(const fs::path& path) {
    std::error_code problem;
    if (fs::is_directory(path, problem)) return writeError(path, EISDIR);
    if (!path.has_filename()) return Error{"there is no file name to write to", path.string(), "give a file name"};
    constexpr int kMostLinks = 40; // the kernel's limit
    fs::path target = path;
    for (int links = 0; links <= kMostLinks; ++links) {
        struct stat status {};
        if (::lstat(target.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return target;
        if (status.st_uid != ::geteuid() && status.st_uid != 0)
            return Error{"this is a link that belongs to another user", target.string(), "give the file it leads to, or another name"};
        const fs::path next = fs::read_symlink(target, problem);
        if (problem) return writeError(path, problem.value());
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    return writeError(path, ELOOP);
}

fs::path temporaryNameFor(const fs::path& target) {
    static std::atomic<unsigned> serial{0};
    // A short name that does not depend on the target's name, so that a target name of the greatest allowed length still works.
    const std::string name = ".edgescan-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".part";
    return target.parent_path() / name;
}

/// Writes all bytes to the disk under a temporary name in the folder of the target.
Result<Temporary> writeTemporary(const fs::path& path, const fs::path& target, std::span<const std::byte> bytes) {
    Temporary temporary(temporaryNameFor(target), target);
    // The mode is that of a plain open(), or that of the file that is replaced.
    struct stat old {};
    const bool replaces = ::stat(target.c_str(), &old) == 0;
    ::unlink(temporary.path.c_str()); // left by a killed program with the same process number
    Descriptor file(::open(temporary.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.number() < 0) {
        temporary.renamed = true; // the temporary file is not ours: do not remove it
        return writeError(path, errno);
    }
    if (replaces) static_cast<void>(::fchmod(file.number(), old.st_mode & 0777U)); // a wrong mode is not a reason to fail
    if (const int code = writeAll(file.number(), bytes)) return writeError(path, code);
    if (::fsync(file.number()) != 0 && errno != EINVAL) return writeError(path, errno);
    if (::close(file.release()) != 0 && errno != EINTR) return writeError(path, errno);
    return temporary;
}

void syncFolder(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.number() >= 0) static_cast<void>(::fsync(descriptor.number()));
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
            return Error{"nobody reads from this pipe", path.string(), "start what reads from it first, or choose a file"};
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

Result<Done> writeWholeFiles(const std::vector<FileContent>& files) {
    for (const FileContent& file : files) {
        if (auto other = checkIsNoInput(file.path); !other) return other;
    }
    std::vector<Temporary> ready;
    for (const FileContent& file : files) {
        if (isDevice(file.path)) {
            if (auto written = writeDevice(file.path, file.bytes); !written) return written.error();
            continue;
        }
        const auto target = finalTarget(file.path);
        if (!target) return target.error();
        auto temporary = writeTemporary(file.path, *target, file.bytes);
        if (!temporary) return temporary.error();
        ready.push_back(std::move(*temporary));
    }
    for (Temporary& temporary : ready) {
        if (::rename(temporary.path.c_str(), temporary.target.c_str()) != 0) return writeError(temporary.target, errno);
        temporary.renamed = true;
        syncFolder(temporary.target);
    }
    return Done{};
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
        return Error{"the file is too large for what it should be: " + sizeText(size) + ", and at most " + sizeText(most) + " are read",
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
