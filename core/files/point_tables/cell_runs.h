// The cells of a list of points as text, for the sidecar of a file that has no room for them.
#pragma once

#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

/// The cells of the points that edgePoints() gives, or validPoints() where `edgeMask` is null, in their order. Runs of cells that follow
/// each other are pairs of numbers with blanks between: the cells from the end of the run before to the first of this one (less than 0
/// where the list goes back), and how many. "0 3 1 2" is the cells 0 1 2 4 5.
[[nodiscard]] std::string cellRunsText(const Scan& scan, const Grid<std::uint8_t>* edgeMask, bool withAttached);

/// The cells again. Empty when the text is something else, when a cell is not less than `gridCells`, or when there are not `points` of
/// them.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> cellsOfRuns(std::string_view text, std::size_t points, std::size_t gridCells);

} // namespace edgescan::files
