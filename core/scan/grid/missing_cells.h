// Missing cells as a grid, and the cells that have a missing cell within reach of a filter window.
#pragma once

#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan {

/// lines x beams: 255 where the cell has no valid range, otherwise 0.
[[nodiscard]] Grid<std::uint8_t> missingCells(const Scan& scan);

/// lines x beams: 255 where a valid cell is isolated: fewer than 2 of its 8 neighbours have a range within 8 % of its range + 60 mm
/// (docs/method/edges.md, "Step 1").
[[nodiscard]] Grid<std::uint8_t> isolatedCells(const Scan& scan);

/// The same for one cell.
[[nodiscard]] bool isIsolated(const Scan& scan, std::uint32_t cell);

/// The same, line by line. The scan must outlive this object.
class IsolatedLines {
public:
    explicit IsolatedLines(const Scan& scan, int firstLine = 0);
    /// Writes the `beams` values of the next line.
    void next(std::uint8_t* isolated);

private:
    const Scan* scan_;
    int line_;                                 // the next line
    std::array<std::vector<float>, 3> ranges_; // of the line before, the line itself and the line after
};

/// lines x beams: 255 where a missing cell is at most `reach` lines and beams away.
[[nodiscard]] Grid<std::uint8_t> nearMissing(const Grid<std::uint8_t>& missing, int reach);

} // namespace edgescan
