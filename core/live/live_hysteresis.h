// Hysteresis of Canny on rows that keep arriving: which weak cells hang on a strong one.
#pragma once

#include "core/base/grid.h"

#include <cstdint>
#include <vector>

namespace edgescan {

enum class EdgeClass : std::uint8_t { None, Weak, Strong };

/// A value. Rows are settled once; the unsettled ones at the end are given anew with every update.
class LiveHysteresis {
public:
    explicit LiveHysteresis(int beams = 0) : classes_(0, beams), mask_(0, beams) {}

    /// `classes` replaces the rows from settledRows() on and may bring more; its first `settledNow` rows stay as they are for good.
    void update(const Grid<EdgeClass>& classes, int settledNow);

    [[nodiscard]] int settledRows() const { return settled_; }
    /// 255 where a cell is strong or joined to a strong one through weak ones, diagonals included.
    [[nodiscard]] const Grid<std::uint8_t>& mask() const { return mask_; }

private:
    void seed(int firstRow, int lastRow);
    void grow(int lastRow, bool forGood);
    [[nodiscard]] bool touchesEdge(int row, int beam, int lastRow) const;

    Grid<EdgeClass> classes_;
    Grid<std::uint8_t> mask_;
    int settled_ = 0;
    std::vector<std::uint32_t> pending_;  // edge cells whose neighbours were not looked at yet
    std::vector<std::uint32_t> borrowed_; // settled cells that are edges only as long as the unsettled rows stay as they are
};

} // namespace edgescan
