// A read lease on the file makes a program that opens the file for writing wait until EdgeScan gives the lease back, at most
// /proc/sys/fs/lease-break-time seconds. There is no lease if a program already has the file open for writing. All pages are loaded before
// the bytes are used, so that an unreadable disk causes an error of the reading that follows, not a signal.
#include "core/base/held_file.h"

#include "core/base/memory.h"
#include "core/base/whole_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <optional>

#ifndef MADV_POPULATE_READ
#define MADV_POPULATE_READ 22 // Linux 5.14; older kernels refuse it
#endif

namespace edgescan {
namespace {

constexpr std::uint64_t kLeast = std::uint64_t{1} << 20U;  // smaller files are read faster than mapped
constexpr std::uint64_t kMost = std::uint64_t{256} << 20U; // such a file is read long before a lease can be broken
constexpr int kLeastSeconds = 20;                          // seconds that a writer waits

// Another machine may change a file of a network file system in spite of a lease on this one.
bool isOfThisMachine(int file) {
    static constexpr std::array<std::uint32_t, 4> kKinds{0xEF53, 0x58465342, 0x9123683E, 0x01021994}; // ext, XFS, Btrfs, tmpfs
    struct statfs system {};
    return ::fstatfs(file, &system) == 0 && std::ranges::find(kKinds, static_cast<std::uint32_t>(system.f_type)) != kKinds.end();
}

bool othersWaitLongEnough() {
    const int file = ::open("/proc/sys/fs/lease-break-time", O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    std::array<char, 16> text{};
    const ssize_t length = ::read(file, text.data(), text.size());
    ::close(file);
    int seconds = 0;
    return length > 0 && std::from_chars(text.data(), text.data() + length, seconds).ec == std::errc{} && seconds >= kLeastSeconds;
}

bool acquireLease(int file) {
    // The signal when a writer waits: SIGURG, which is ignored by default.
    return ::fcntl(file, F_SETSIG, SIGURG) == 0 && ::fcntl(file, F_SETLEASE, F_RDLCK) == 0;
}

std::optional<std::span<const std::byte>> mappedUnderLease(int file) {
    struct stat status {};
    if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    const auto isRight = [&] {
        const auto size = static_cast<std::uint64_t>(status.st_size);
        return size >= kLeast && size <= kMost && checkMemory(size, {});
    };
    if (!isRight() || !isOfThisMachine(file) || !othersWaitLongEnough() || !acquireLease(file)) return std::nullopt;
    if (::fstat(file, &status) != 0 || !isRight()) return std::nullopt; // from here on the file cannot change
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (at == MAP_FAILED) return std::nullopt;
    if (::madvise(at, size, MADV_POPULATE_READ) != 0) {
        ::munmap(at, size);
        return std::nullopt;
    }
    return std::span(static_cast<const std::byte*>(at), size);
}

} // namespace

HeldFile::~HeldFile() {
    if (lease_ < 0) return;
    ::munmap(const_cast<std::byte*>(mapped_.data()), mapped_.size());
    ::close(lease_); // closing gives the lease back
}

Result<HeldFile> holdFile(const std::filesystem::path& path) {
    // O_NONBLOCK: opening a pipe must not block; the reading refuses it.
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file >= 0) {
        if (const auto mapped = mappedUnderLease(file)) return HeldFile(*mapped, file);
        ::close(file);
    }
    auto bytes = readWholeFile(path);
    if (!bytes) return bytes.error();
    return HeldFile(std::move(*bytes));
}

} // namespace edgescan
