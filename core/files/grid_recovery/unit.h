// What a number in a point list is worth, and which ranges are status codes.
#pragma once

#include "core/base/grid.h"
#include "core/files/grid_recovery/recover_grid.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::files {

struct RangeUnit {
    double mmPerUnit = 1000.0;
    bool wholeMm = false; ///< every range is a whole number of millimetres within the precision of the file
    std::string remark;   ///< a sentence when the unit was found out, or when ranges are beyond those of such scanners
};

/// Unit of the distances `ranges` (> 0) from the origin. A scanner that measures whole millimetres gives itself away.
[[nodiscard]] RangeUnit findUnit(std::span<const double> ranges, const Precision& precision, std::optional<double> knownMmPerUnit);

/// Millimetres per number, of a warning that is such a remark; empty of any other.
[[nodiscard]] std::optional<double> unitOfWarning(const std::string& warning);

/// Status codes of a SICK LMS2xx in place of whole millimetres; empty when the scan shows none: they are the
/// largest values there are, no other value is among them, and they repeat as no range does. `rangeMm` lines x beams.
[[nodiscard]] std::vector<std::uint32_t> lms2xxStatusCodes(const Grid<float>& rangeMm, const Grid<CellState>& state,
                                                           const PolarGeometry& geometry);

} // namespace edgescan::files
