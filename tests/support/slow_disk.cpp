// A library for LD_PRELOAD: simulates a disk whose syncs take EDGESCAN_SLOW_SYNC_MS, and which is full after EDGESCAN_FULL_AFTER bytes of a
// file. With EDGESCAN_FALSE_DISK it stores another last byte than the one written.
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <vector>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

long numberOf(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? 0 : std::atol(text);
}

int slowly() {
    const long ms = numberOf("EDGESCAN_SLOW_SYNC_MS");
    timespec wait{ms / 1000, ms % 1000 * 1'000'000};
    ::nanosleep(&wait, nullptr);
    return 0;
}

} // namespace

extern "C" {

int fsync(int /*file*/) { return slowly(); }
int fdatasync(int /*file*/) { return slowly(); }

ssize_t write(int file, const void* bytes, size_t size) {
    using Write = ssize_t (*)(int, const void*, size_t);
    static const Write real = reinterpret_cast<Write>(::dlsym(RTLD_NEXT, "write"));
    const long most = numberOf("EDGESCAN_FULL_AFTER");
    struct stat facts {};
    if (most > 0 && ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode)) {
        if (facts.st_size >= most) {
            errno = ENOSPC;
            return -1;
        }
        const auto room = static_cast<size_t>(most - facts.st_size);
        if (size > room) size = room;
    }
    if (numberOf("EDGESCAN_FALSE_DISK") > 0 && file > STDERR_FILENO && size > 0 && ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode)) {
        std::vector<char> changed(static_cast<const char*>(bytes), static_cast<const char*>(bytes) + size);
        changed.back() = static_cast<char>(changed.back() ^ 1);
        return real(file, changed.data(), size);
    }
    return real(file, bytes, size);
}

} // extern "C"
