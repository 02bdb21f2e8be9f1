// Memory of large vectors in large pages where the system has them: touching new memory costs more than many a filter does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace edgescan {

/// An empty vector with room for `count` values.
template <class T>
std::vector<T> hugePageVector(std::size_t count) {
    std::vector<T> room;
    room.reserve(count);
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t kPage = 4096;
    const auto start = (reinterpret_cast<std::uintptr_t>(room.data()) + kPage - 1) / kPage * kPage;
    const auto end = (reinterpret_cast<std::uintptr_t>(room.data()) + count * sizeof(T)) / kPage * kPage;
    // Advice: where it is not taken, nothing changes but the time.
    if (end > start + (std::uintptr_t{2} << 20U)) madvise(reinterpret_cast<void*>(start), end - start, MADV_HUGEPAGE);
#endif
    return room;
}

} // namespace edgescan
