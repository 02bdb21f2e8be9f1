// Tries a lock again and again: flock() alone would wait without limit.
#include "core/base/file_lock.h"

#include "core/base/descriptor.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <thread>

namespace edgescan {
namespace {

Lock lockAs(int kind, int file, std::chrono::milliseconds within) {
    const auto until = std::chrono::steady_clock::now() + within;
    while (::flock(file, kind | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR) return Lock::Unknown;
        if (std::chrono::steady_clock::now() >= until) return Lock::Busy;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return Lock::Acquired;
}

} // namespace

Lock lockFile(int file, std::chrono::milliseconds within) { return lockAs(LOCK_EX, file, within); }

bool isLocked(const char* path) {
    const Descriptor file(::open(path, O_RDONLY | O_CLOEXEC));
    return file.isOpen() && lockAs(LOCK_SH, file.number(), std::chrono::milliseconds(0)) ==
                                Lock::Busy; // NFS allows no other lock on a file opened for reading
}

} // namespace edgescan
