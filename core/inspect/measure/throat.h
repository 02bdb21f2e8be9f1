// The narrowest free way across an opening, between two rims that somebody pointed at.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <optional>

namespace edgescan {

/// Two cells on the rims near `a` and `b` that lie nearest each other, with nothing measured in the way: every cell on the straight line
/// between them has no return or lies behind it. Rims: cells beside something farther or nothing, within a quarter of the distance from
/// the cell that was picked. Empty where no such pair is there, or one of the two cells has no range.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> narrowestBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                                           std::uint32_t b);

} // namespace edgescan
