// The rim of an open void: a chimney, a brow, the end of a wall (docs/method/edges.md, "The rim of an open void").
#pragma once

#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// Cells behind one another, also from the end of a line to the next one.
struct CellRun {
    std::uint32_t first = 0, last = 0; ///< `last` is behind the run
};

/// The cells without a range that say nothing about the surface, ascending: a filter left them out, or their telegrams never arrived. Runs,
/// because a few telegrams with counters far apart claim millions of lost cells.
[[nodiscard]] std::vector<CellRun> withheldCells(const Scan& scan);

/// Measured cells next to a void of at least 30 connected cells (4 neighbours), ascending. A cell is left out where its surface slants by
/// more than `limits.rimSlant` towards the void: there ranges fade out, and nothing ends. `withheld` cells do not belong to a void: missing
/// data has no rim (docs/reference/rules.md, "S3"). `ofCamera`: a depth camera sees from two places, so most of its voids are shadows of
/// what is in front, or points that it could not match. Then only the near side of a void is a rim: along the line or the beam the void
/// ends at a surface that is farther away by a jump.
[[nodiscard]] std::vector<std::uint32_t> voidRimCells(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits,
                                                      const std::vector<CellRun>& withheld, bool ofCamera);

} // namespace edgescan::edges
