// The few lines of a grid in work at a time, so that the output of one stage is still in the cache for the next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace edgescan {

/// Lines are written one after the other. At least the newest `held` lines are available, `stride` cells apart. There is a margin on the
/// left and on the right, and lines of the margin's value precede the first line, so that a filter can read a few cells in any direction
/// without bounds checks.
template <class T>
class LineWindow {
public:
    static constexpr int kMargin = 16; ///< cells

    LineWindow(int beamCount, int held, T fill = T{}, int firstLine = 0)
        : beams(beamCount), stride(beamCount + 2 * kMargin), fill_(fill), held_(held), end_(firstLine), oldest_(firstLine - held),
          cells_(static_cast<std::size_t>(stride) * static_cast<std::size_t>(held + kRoom) + kBeyond, fill) {}

    /// Cell (line, 0).
    [[nodiscard]] T* line(int i) { return cells_.data() + (i - oldest_) * stride + kMargin; }
    [[nodiscard]] const T* line(int i) const { return cells_.data() + (i - oldest_) * stride + kMargin; }

    /// The line after the newest one, to be written; its margin is already set.
    T* next() {
        if (end_ - oldest_ == held_ + kRoom) {
            std::copy(cells_.begin() + kRoom * stride, cells_.begin() + (held_ + kRoom) * stride, cells_.begin());
            oldest_ += kRoom;
        }
        return line(end_++);
    }
    /// Adds a line of the margin's value, for the area behind the last line of the sweep.
    void nextEmpty() {
        T* cells = next();
        std::fill(cells, cells + beams, fill_);
    }

    int beams = 0;
    std::ptrdiff_t stride = 0; ///< cells from a cell to the one on the next line

private:
    static constexpr int kBeyond = 64; // cells behind the last line, for loops that process whole lanes
    static constexpr int kRoom = 32;   // number of lines that are written before the newest lines are moved to the front of the buffer
    T fill_;
    int held_;
    int end_;    // the line after the newest one
    int oldest_; // the line at the front of the buffer
    std::vector<T> cells_;
};

} // namespace edgescan
