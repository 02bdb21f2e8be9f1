// The few lines of a grid that are worked on, so that what one stage passes on to the next stays in the cache.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace edgescan {

/// Lines come one after the other; at least the newest `held` are there, `stride` cells from each other. There is a margin on the left and
/// on the right, and before the first line lie lines of the margin's value, so that a filter can look a few cells in any direction without
/// asking where the sweep ends.
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

    /// The line after the newest one, to be written; its margin is there already.
    T* next() {
        if (end_ - oldest_ == held_ + kRoom) {
            std::copy(cells_.begin() + kRoom * stride, cells_.begin() + (held_ + kRoom) * stride, cells_.begin());
            oldest_ += kRoom;
        }
        return line(end_++);
    }
    /// A line of the margin's value, for what lies after the last line of the sweep.
    void nextEmpty() {
        T* cells = next();
        std::fill(cells, cells + beams, fill_);
    }

    int beams = 0;
    std::ptrdiff_t stride = 0; ///< from a cell to the one on the next line

private:
    static constexpr int kBeyond = 64; // cells after the last line, for loops that work on whole lanes
    static constexpr int kRoom = 32;   // lines that come before the newest ones are moved to the front again
    T fill_;
    int held_;
    int end_;    // line after the newest one
    int oldest_; // line at the front
    std::vector<T> cells_;
};

} // namespace edgescan
