// The cells of a growing sweep, and scans of it that cost only the rows that are new.
#pragma once

#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace edgescan {

/// Cells of one row, as many as `rangeMm` has; no intensities where there are none.
struct RowCells {
    const std::vector<float>& rangeMm;
    const std::vector<CellState>& state;
    const std::vector<float>& intensity;
};

/// A value; copies share nothing.
class SweepGrid {
public:
    explicit SweepGrid(int beams = 0) : beams_(beams) {}

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int beams() const { return beams_; }

    /// Rows up to `count`, all cells of the new ones Lost.
    void grow(int count);
    /// Writes beam first + stride * i of the row for each i.
    void write(int row, int first, int stride, const RowCells& cells);
    /// Those beams of the row hold something: not all of them are Lost.
    [[nodiscard]] bool holds(int row, int first, int stride, std::size_t count) const;
    /// They hold just this.
    [[nodiscard]] bool same(int row, int first, int stride, const std::vector<float>& rangeMm, const std::vector<CellState>& state) const;
    [[nodiscard]] std::uint32_t lostIn(int row) const {
        return rowCounts_[static_cast<std::size_t>(row)][static_cast<std::size_t>(CellState::Lost)];
    }
    /// The rows from `row` on leave this grid and make the one that is returned.
    SweepGrid cutFrom(int row);

    /// Cells by state of the first `rows` rows.
    [[nodiscard]] std::array<std::size_t, kCellStates> counts(int rows) const;

    /// A scan with the ranges, states and intensities of the first `rows` rows; what else it holds is left over from an earlier one. Scans
    /// that nobody looks at any more are used again, and only rows that changed since are copied into them.
    std::shared_ptr<Scan> scan(int rows);

private:
    struct Copy { // a scan and how far it follows the grid
        Scan scan;
        std::uint64_t change = 0;
        int rows = 0;
    };
    class Copies;
    /// Copying a grid makes a new, empty store.
    struct Store {
        Store();
        Store(const Store&);
        Store& operator=(const Store&);
        Store(Store&&) noexcept = default;
        Store& operator=(Store&&) noexcept = default;
        ~Store() = default;
        std::shared_ptr<Copies> copies;
    };

    [[nodiscard]] std::size_t index(int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(beams_); }

    int beams_ = 0;
    int rows_ = 0;
    std::vector<float> rangeMm_;
    std::vector<CellState> state_;
    std::vector<float> intensity_;                                  // empty until a row brings some
    std::vector<std::uint64_t> changed_;                            // per row: number of its last change
    std::vector<std::array<std::uint32_t, kCellStates>> rowCounts_; // per row
    std::uint64_t change_ = 0;
    Store store_;
};

} // namespace edgescan
