// Puts large blocks of memory into large pages, and stores freed blocks for reuse. The system gives out memory in pages of 4 KiB and clears
// each page when it is first used. That took a fifth of the time of a detection, and another fifth in the next one. Sanitizers have their
// own operator new.
#if __has_include(<gnu/libc-version.h>) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <malloc.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20U;
constexpr std::size_t kLarge = std::size_t{1} << 20U; // from this size on a block begins at a large page

// Freed blocks up to these sizes stay in the heap: the next picture of the same scan needs them again.
constexpr int kKeptBlock = 32 << 20; // the most that the library allows; larger blocks go back to the system at once
constexpr int kKeptInAll = 128 << 20;

void* largeBlock(std::size_t size) {
    [[maybe_unused]] static const bool kept = mallopt(M_MMAP_THRESHOLD, kKeptBlock) + mallopt(M_TRIM_THRESHOLD, kKeptInAll) == 2;
    void* block = std::aligned_alloc(kLargePage, size);
    // Only advice: if the system ignores it, only the time changes.
    if (block != nullptr) madvise(block, size, MADV_HUGEPAGE);
    return block;
}

} // namespace

void* operator new(std::size_t size) {
    for (;;) {
        void* block = size < kLarge ? std::malloc(size == 0 ? 1 : size) : largeBlock(size);
        if (block != nullptr) return block;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

#endif
