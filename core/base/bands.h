// Divides the lines of a grid among threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace edgescan {

/// The number of threads that work on a grid: `wanted`, or with 0 as many as make it faster.
[[nodiscard]] inline int bandsFor(std::size_t cells, int wanted) {
    // A smaller grid is done by one thread before a second one has begun. More than two threads gain little, because each band also reads
    // lines of the next band.
    constexpr std::size_t kCellsForTwo = 1000000;
    if (wanted > 0) return wanted;
    return cells >= kCellsForTwo && std::thread::hardware_concurrency() >= 2 ? 2 : 1;
}

/// Calls work(n) for 0 <= n < count on this thread, and on a second one as soon as that one is free; this thread does not wait for it to
/// begin. Returns when all calls are done. Throws what one of them threw.
void runInParallel(int count, const std::function<void(int)>& work);

/// Calls each of these functions; on two threads if `threads` is more than 1.
inline void runParts(int threads, const std::vector<std::function<void()>>& parts) {
    if (threads > 1) return runInParallel(static_cast<int>(parts.size()), [&](int n) { parts[static_cast<std::size_t>(n)](); });
    for (const std::function<void()>& part : parts) part();
}

/// Ends the second thread, which otherwise waits for work until the process ends. Call it before fork(). The next runInParallel() starts
/// the thread again.
void endSecondThread();

/// The first line of a band. For the band behind the last one: the number of lines.
[[nodiscard]] inline int firstLineOfBand(int lines, int bands, int band) {
    return static_cast<int>(static_cast<long long>(lines) * band / bands);
}

/// Calls work(first, last) for bands of lines first <= line < last that cover all lines.
template <class Work>
void runInBands(int lines, int bands, Work work) {
    bands = std::clamp(bands, 1, std::max(1, lines));
    if (bands == 1) return work(0, lines);
    runInParallel(bands, [&](int band) { work(firstLineOfBand(lines, bands, band), firstLineOfBand(lines, bands, band + 1)); });
}

/// What work(first, last) makes of parts of the lines, in the order of the lines: more parts than threads, because some take longer. For
/// work whose parts read the same memory and share none that they write.
template <class Work>
[[nodiscard]] auto madeOfParts(int lines, int threads, Work work) {
    constexpr int kPartsForEach = 8;
    const int parts = threads > 1 ? std::clamp(threads * kPartsForEach, 1, std::max(1, lines)) : 1;
    std::vector<decltype(work(0, 0))> made(static_cast<std::size_t>(parts));
    runInParallel(parts, [&](int part) {
        made[static_cast<std::size_t>(part)] = work(firstLineOfBand(lines, parts, part), firstLineOfBand(lines, parts, part + 1));
    });
    return made;
}

} // namespace edgescan
