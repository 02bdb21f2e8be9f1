// Large blocks of memory in large pages, and kept when they are given back. The system hands out memory in pages of 4 KiB and clears
// each when it is first touched: that cost the detection of a scan a fifth of its time, and another fifth the next time.
// Sanitizers bring their own operator new.
#if __has_include(<gnu/libc-version.h>) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <malloc.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20U;
constexpr std::size_t kLarge = std::size_t{1} << 20U; // from here on a block begins at a large page

// What is given back stays in the heap, up to these sizes: the next picture of the same scan wants it again.
constexpr int kKeptBlock = 32 << 20; // the most that the library allows; larger ones go back to the system at once
constexpr int kKeptInAll = 128 << 20;

void* largeBlock(std::size_t size) {
    [[maybe_unused]] static const bool kept = mallopt(M_MMAP_THRESHOLD, kKeptBlock) + mallopt(M_TRIM_THRESHOLD, kKeptInAll) == 2;
    void* block = std::aligned_alloc(kLargePage, size);
    // Advice: where it is not taken, nothing changes but the time.
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
