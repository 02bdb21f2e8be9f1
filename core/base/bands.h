// The lines of a grid shared out among threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace edgescan {

/// How many threads work on a grid: `wanted`, or with 0 as many as pay.
[[nodiscard]] inline int bandsFor(std::size_t cells, int wanted) {
    // Below, one thread is done before anybody waits. More than two gain little: each looks at lines of the next as well.
    constexpr std::size_t kCellsForTwo = 1000000;
    if (wanted > 0) return wanted;
    return cells >= kCellsForTwo && std::thread::hardware_concurrency() >= 2 ? 2 : 1;
}

/// Calls work(first, last) for bands of lines first <= line < last that cover all lines; the first band on this thread.
template <class Work>
void inBands(int lines, int bands, Work work) {
    bands = std::clamp(bands, 1, std::max(1, lines));
    const auto start = [&](int band) { return static_cast<int>(static_cast<long long>(lines) * band / bands); };
    std::vector<std::future<void>> others;
    // Where no thread can be had, the band waits until it is asked for.
    for (int band = 1; band < bands; ++band)
        others.push_back(std::async(std::launch::async | std::launch::deferred, work, start(band), start(band + 1)));
    work(0, start(1));
    for (std::future<void>& other : others) other.get();
}

} // namespace edgescan
