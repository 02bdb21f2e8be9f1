// Memory of large arrays in large pages where the system has them: touching new memory costs more than many a filter does.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace edgescan {

/// For std::vector. Blocks of 4 MB and more start at a page of 2 MB and ask for such pages.
template <class T>
struct LargeBlockAllocator {
    using value_type = T;

    LargeBlockAllocator() = default;
    template <class U>
    explicit LargeBlockAllocator(const LargeBlockAllocator<U>&) {}

    T* allocate(std::size_t count) {
        constexpr std::size_t kPage = std::size_t{2} << 20U;
        const std::size_t bytes = count * sizeof(T);
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_alloc();
        if (bytes < 2 * kPage) {
            if (void* small = std::malloc(bytes)) return static_cast<T*>(small);
            throw std::bad_alloc();
        }
        void* large = std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage);
        if (large == nullptr) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        madvise(large, bytes, MADV_HUGEPAGE); // advice: where it is not taken, nothing changes but the time
#endif
        return static_cast<T*>(large);
    }
    void deallocate(T* block, std::size_t /*count*/) { std::free(block); }

    bool operator==(const LargeBlockAllocator&) const = default;
};

} // namespace edgescan
