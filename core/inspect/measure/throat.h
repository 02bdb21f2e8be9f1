// The narrowest free distance across an opening, between two rims that the user picked.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <optional>

namespace edgescan::inspect {

/// The two cells on the rims near `a` and `b` that are closest to each other with free space between them: every cell on the straight line
/// between them has no return or is behind it. Rim cells are cells next to a farther surface or a void, within a quarter of the distance of
/// the rims. A picked cell on a surface that is seen through the opening means the rim in front of it. Empty if there is no such pair,
/// if one of the two cells has no range, or if the rims are farther apart in depth than the opening is wide.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> narrowestBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                                           std::uint32_t b);

} // namespace edgescan::inspect
