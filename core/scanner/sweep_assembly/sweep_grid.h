// The cells of a growing sweep, and scans of it that cost only the copying of new rows. A lost row has no cells until a scan is made.
#pragma once

#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace edgescan::scanner {

/// Cells of one row, as many as `rangeMm` has; `intensity` is empty if there are none.
struct RowCells {
    const std::vector<float>& rangeMm;
    const std::vector<CellState>& state;
    const std::vector<float>& intensity;
};

/// A value type; copies share nothing.
class SweepGrid {
public:
    explicit SweepGrid(int beams = 0) : beams_(beams) {}

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int beams() const { return beams_; }

    /// Grows to `count` rows; all cells of new rows are Lost.
    void grow(int count);
    /// Writes beam first + stride * i of the row for each i.
    void write(int row, int first, int stride, const RowCells& cells);
    /// Whether any of those beams of the row is not Lost.
    [[nodiscard]] bool holds(int row, int first, int stride, std::size_t count) const;
    /// Whether those beams hold exactly these values.
    [[nodiscard]] bool same(int row, int first, int stride, const std::vector<float>& rangeMm, const std::vector<CellState>& state) const;
    [[nodiscard]] std::uint32_t lostIn(int row) const {
        return rowCounts_[static_cast<std::size_t>(row)][static_cast<std::size_t>(CellState::Lost)];
    }
    /// Removes the rows from `row` on and returns them as a grid.
    SweepGrid cutFrom(int row);

    /// Number of cells by state in the first `rows` rows.
    [[nodiscard]] std::array<std::size_t, kCellStates> counts(int rows) const;

    /// A scan with the ranges, states and intensities of the first `rows` rows. Its other members are left from an earlier use. Scans that
    /// are not in use any more are reused, and only the rows that changed since are copied into them.
    std::shared_ptr<Scan> scan(int rows);

private:
    struct Copy { // a scan, and the state of the grid that it holds
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
    /// Where the cells of the row begin below; kLostRow: it has none.
    [[nodiscard]] std::size_t at(int row) const { return at_[static_cast<std::size_t>(row)]; }
    void appendCells(const SweepGrid& other, int row, std::size_t to);

    int beams_ = 0;
    int rows_ = 0;
    bool hasIntensity_ = false;   // since the first row with intensities
    std::vector<std::size_t> at_; // per row
    // The cells of the rows that are not lost, in the order in which they arrived.
    std::vector<float> rangeMm_;
    std::vector<CellState> state_;
    std::vector<float> intensity_;                                  // empty without intensities
    std::vector<std::uint64_t> changed_;                            // per row: number of its last change
    std::vector<std::array<std::uint32_t, kCellStates>> rowCounts_; // per row
    std::uint64_t change_ = 0;
    Store store_;
};

} // namespace edgescan::scanner
