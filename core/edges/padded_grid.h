// A grid with a margin, so that a filter can look a few cells in any direction without asking where the grid ends.
#pragma once

#include "core/base/large_block.h"

#include <cstddef>
#include <vector>

namespace edgescan {

template <class T>
class PaddedGrid {
public:
    static constexpr int kMargin = 16; ///< cells on every side
    static constexpr int kBeyond = 64; ///< cells after the last line, for loops that work on whole blocks

    PaddedGrid() = default;
    PaddedGrid(int lineCount, int beamCount, T fill = T{})
        : lines(lineCount), beams(beamCount), stride(beamCount + 2 * kMargin),
          cells_(static_cast<std::size_t>(stride) * static_cast<std::size_t>(lineCount + 2 * kMargin) + kBeyond, fill) {}

    /// Cell (line, 0); lines and beams from -kMargin may be reached from it.
    [[nodiscard]] T* line(int i) { return cells_.data() + place(i); }
    [[nodiscard]] const T* line(int i) const { return cells_.data() + place(i); }

    int lines = 0;
    int beams = 0;
    std::ptrdiff_t stride = 0; ///< from a cell to the one on the next line

private:
    [[nodiscard]] std::ptrdiff_t place(int i) const { return (i + kMargin) * stride + kMargin; }
    std::vector<T, LargeBlockAllocator<T>> cells_;
};

} // namespace edgescan
