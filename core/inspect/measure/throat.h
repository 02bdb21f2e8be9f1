// The narrowest free distance across an opening, between two rims that the user picked.
#pragma once

#include "core/inspect/measure/near_side.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace edgescan::inspect {

/// The two cells on the rims near `a` and `b` that are closest to each other with free space between them: every cell on the straight line
/// between them has no return or is behind it, half of them by a quarter of the width or more. Rim cells are cells next to a farther
/// surface or a void, within a quarter of the distance of the rims. A picked cell on a surface that is seen through the opening means the
/// rim in front of it. Empty if no pair has free space between its cells, if one of the two cells has no range, or if the rims are farther
/// apart in depth than the opening is wide.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> narrowestBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                                           std::uint32_t b);

/// How far a second click at the same place ends from the first: cells along or across the lines.
inline constexpr int kClickSpread = 2;

/// A click, first, and the four clicks kClickSpread cells from it that a hand may do as well.
[[nodiscard]] std::vector<std::uint32_t> clicksNear(const Scan& scan, std::uint32_t clicked);

/// What one or two clicks find, and what clicks next to them find.
struct Throat {
    std::array<std::uint32_t, 2> ends{};
    double leastM = 0.0, mostM = 0.0; ///< lengths of the shortest and of the longest of them
};

/// For all pairs of a click at each side (the click itself, and those kClickSpread cells from it in four directions; a click means
/// nearSideCell()) the way across the middle of the opening that the line between the two crosses, if that way crosses the line; else
/// narrowestBetween() the sides of that opening; else narrowestBetween() the two, unless most pairs find an opening. The ends are those of
/// the median length, that of the first click first. Empty if no pair finds a way. Twice the same cell is one click: throatThrough().
[[nodiscard]] std::optional<Throat> throatAt(const Scan& scan, const CartesianTables& tables, std::uint32_t clickedA,
                                             std::uint32_t clickedB);

/// True if throatThrough() finds a way.
[[nodiscard]] bool isIntoOpening(const Scan& scan, const CartesianTables& tables, std::uint32_t k);

/// The cell of the opening that a click means: the meant cell, or in a void and at its rim the nearest cell of that void within kSnapReach,
/// for a view of points has none in the void. Empty: the click is on the rock at a side.
[[nodiscard]] std::optional<std::uint32_t> openingOfClick(const Scan& scan, const CartesianTables& tables, const ClickedCell& click);

/// The shortest way across the middle of the opening around a click, on a void or on what is seen through it. The middle is the cell that
/// is farthest from the sides, uphill from the click, and again from between the ends that it finds while the way gets shorter; of an
/// opening that is not closed within half of the lines or beams, the click itself.
/// Of 32 straight ways over the grid through the middle, each is between the first nearer surfaces at both ends with free space between
/// them. The least and the most are of clicks next to the click, and next to the middle that each of them finds. Empty if no way through
/// the click has such ends, or what is seen through it is not as far behind it as it is wide.
[[nodiscard]] std::optional<Throat> throatThrough(const Scan& scan, const CartesianTables& tables, std::uint32_t clicked);

} // namespace edgescan::inspect
