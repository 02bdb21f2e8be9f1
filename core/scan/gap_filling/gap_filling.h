// Small gaps of a scan filled from what surrounds them, with an uncertainty (docs/method.md, "Gaps").
#pragma once

#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// Where a filled range comes from.
enum class FilledBy : std::uint8_t {
    Plane, ///< one plane through all that was measured within two cells of the gap
    Line,  ///< the straight line between the two ends of the gap, along the beams or along the lines
};

/// A range that nobody measured.
struct FilledCell {
    std::uint32_t cell = 0; ///< line * beams + beam
    float rangeMm = 0;
    float sdMm = 0; ///< standard deviation to be expected, noise of the device not included
    FilledBy by = FilledBy::Plane;

    bool operator==(const FilledCell&) const = default;
};

struct GapFilling {
    std::vector<FilledCell> cells; ///< ascending by cell; each of a cell that has no range in the scan
    std::size_t byPlane = 0;       ///< of these
    std::size_t gaps = 0;          ///< connected groups of missing cells of which at least one was filled

    /// Null where the cell was not filled.
    [[nodiscard]] const FilledCell* at(std::size_t cell) const;
};

/// Gaps (8 neighbours) of up to `longest` + 2 cells one way and four times that the other, not at the border of the grid and without cells
/// that somebody masked or gated, are filled: by a plane in inverse range where all around lies on one, else cell by cell along the way
/// whose ends differ less, if they differ by less than 80 mm + 2 % of the range. All others stay gaps. `longest` below 1: nothing is
/// filled. `noise` is that of the measured cells. Needs angles, or points, for the uncertainty. The same on every machine.
[[nodiscard]] GapFilling fillGaps(const Scan& scan, const RangeNoise& noise, int longest);

/// The same with the noise measured in the scan.
[[nodiscard]] GapFilling fillGaps(const Scan& scan, int longest);

/// A copy of the scan in which the filled cells count as measured, and their uncertainty: mm, 0 at cells that were measured. For exports
/// that ask for it. Cells of a cloud without known rays stay without a range.
struct ScanWithFilled {
    Scan scan;
    Grid<float> sdMm; ///< lines x beams
};
[[nodiscard]] ScanWithFilled withFilled(const Scan& scan, const GapFilling& filling);

} // namespace edgescan
