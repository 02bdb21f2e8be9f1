// Fills small gaps of a scan from the cells around them, with an uncertainty (docs/method/edges.md, "Gaps").
#pragma once

#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// How a filled range was computed.
enum class FilledBy : std::uint8_t {
    Plane, ///< from one plane through all measured cells at most two cells away from the gap
    Line,  ///< from the straight line between the two ends of the gap, along the beams or along the lines
};

/// A range that was computed, not measured.
struct FilledCell {
    std::uint32_t cell = 0; ///< line * beams + beam
    float rangeMm = 0;
    float sdMm = 0; ///< expected standard deviation, without the noise of the scanner
    FilledBy by = FilledBy::Plane;

    bool operator==(const FilledCell&) const = default;
};

struct GapFilling {
    std::vector<FilledCell> cells; ///< ascending by cell; these cells have no range in the scan
    std::size_t byPlane = 0;       ///< number of cells filled from a plane
    std::size_t gaps = 0;          ///< connected groups of missing cells in which at least one cell was filled

    /// Null if the cell was not filled.
    [[nodiscard]] const FilledCell* at(std::size_t cell) const;
};

/// Fills gaps (connected over 8 neighbours) of up to `longest` + 2 cells in one direction and four times that in the other. Gaps at the
/// border of the grid and gaps with cells that the operator masked or gated are not filled. If all cells around the gap are on one plane,
/// the plane in inverse range fills it. Otherwise each cell is filled along the direction whose two ends differ less, if they differ by
/// less than 80 mm + 2 % of the range. All other gaps stay. `longest` below 1: nothing is filled. `noise` is the range noise of the
/// measured cells. The uncertainty needs angles or points. The result is the same on every machine.
[[nodiscard]] GapFilling fillGaps(const Scan& scan, const RangeNoise& noise, int longest);

/// The same, with the noise measured in the scan.
[[nodiscard]] GapFilling fillGaps(const Scan& scan, int longest);

/// A copy of the scan in which filled cells count as measured, and their uncertainty in mm (0 at measured cells). For exports with filled
/// gaps. Cells of a cloud without known rays stay without a range.
struct ScanWithFilled {
    Scan scan;
    Grid<float> sdMm; ///< lines x beams
};
[[nodiscard]] ScanWithFilled withFilled(const Scan& scan, const GapFilling& filling);

} // namespace edgescan
