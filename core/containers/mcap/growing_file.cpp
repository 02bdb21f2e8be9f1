// A recording's file: whole pieces.
#include "core/containers/mcap/writer.h"

#include "core/base/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace edgescan::containers {
namespace {

Error createError(const std::filesystem::path& path, int code) {
    switch (code) {
    case EEXIST:
        return {"a file of this name exists already and a recording overwrites nothing", path.string(), "choose another name"};
    case ENOENT:
    case ENOTDIR:
        return {"the folder to record into does not exist", path.string(), "make the folder or choose another"};
    case EACCES:
    case EPERM:
    case EROFS:
        return {"recording here is not allowed", path.string(), "choose another folder"};
    case ENOSPC:
    case EDQUOT:
        return {"the disk is full, nothing is recorded", path.string(), "free some space or choose another disk"};
    default:
        return {std::string("the recording cannot be started: ") + std::strerror(code), path.string(), "choose another folder or disk"};
    }
}

Error appendError(const std::filesystem::path& path, int code) {
    switch (code) {
    case ENOSPC:
    case EDQUOT:
        return {"the disk is full, the recording ends here", path.string(), "free some space and start a new recording"};
    case EFBIG:
        return {"the file has reached the limit set for its size, the recording ends here", path.string(), "start a new recording"};
    default:
        return {std::string("the recording ends here: ") + std::strerror(code), path.string(), "check the disk and start a new recording"};
    }
}

} // namespace

Result<GrowingFile> GrowingFile::create(const std::filesystem::path& path, DiskCalls calls) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return createError(path, errno);
    if (!calls.write) calls.write = ::write;
    if (!calls.sync) calls.sync = ::fdatasync;
    return GrowingFile(path, descriptor, std::move(calls));
}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_),
      calls_(std::move(other.calls_)) {}

GrowingFile& GrowingFile::operator=(GrowingFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(size_, other.size_);
    std::swap(calls_, other.calls_);
    return *this;
}

GrowingFile::~GrowingFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Result<Done> GrowingFile::append(ByteView bytes) {
    for (auto rest = bytes; !rest.empty();) {
        const std::ptrdiff_t count = calls_.write(descriptor_, rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const int code = count < 0 ? errno : ENOSPC;
            // What is there of the piece is taken away again, so that the file ends with a whole record.
            static_cast<void>(::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0 &&
                              ::lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET) >= 0);
            return appendError(path_, code);
        }
        rest = rest.subspan(static_cast<std::size_t>(count));
    }
    size_ += bytes.size();
    return Done{};
}

Result<Done> GrowingFile::sync() const {
    while (calls_.sync(descriptor_) != 0) {
        if (errno == EINTR) continue;
        if (errno == EINVAL || errno == EROFS || errno == ENOTSUP) break; // a pipe or a file system that cannot
        return Error{std::string("the disk reports that it lost some of what was recorded: ") + std::strerror(errno), path_.string(),
                     "check the disk, and start a new recording on another one"};
    }
    return Done{};
}

void GrowingFile::removeName() const {
    if (isOpenAt(descriptor_, path_)) ::unlink(path_.c_str());
}

void GrowingFile::syncFolder() const {
    const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : std::filesystem::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    static_cast<void>(calls_.sync(descriptor));
    ::close(descriptor);
}

} // namespace edgescan::containers
