// The cell that a click means: at an edge the near side, at a hole the nearest measured cell. Every tool that takes a cell asks here.
#pragma once

#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace edgescan::inspect {

/// How far a click is moved, cells along and across the lines: a click at an edge rarely hits the very cell.
inline constexpr int kSnapReach = 3;

enum class SnapReason : std::uint8_t {
    AsClicked,    ///< the cell is on the nearer surface, or no edge is near: it stays
    BehindAnEdge, ///< the clicked cell is on the surface behind an edge
    MixedPixel,   ///< the beam covered two surfaces, and the range is between them
    Dust,         ///< the clicked cell is one echo in front of all that is around it
    NoRange,      ///< nothing was measured at the clicked cell
};

struct ClickedCell {
    std::uint32_t cell = 0; ///< the cell to measure at
    std::uint32_t clicked = 0;
    SnapReason reason = SnapReason::AsClicked;
    double nearerM = 0.0; ///< how much nearer than the clicked cell; 0 if that has no range
    /// On another surface in front of `cell`, also within reach of the click: the click may have meant that one.
    std::optional<std::uint32_t> alsoNear{};

    [[nodiscard]] bool moved() const { return cell != clicked; }
    /// False: nothing was measured within kSnapReach of the click.
    [[nodiscard]] bool measured() const { return moved() || reason != SnapReason::NoRange; }
};

/// The cell itself, for one that was chosen without a click or with the intention to take no other.
[[nodiscard]] inline ClickedCell exactly(std::size_t k) { return {static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k)}; }

/// Depends on the ranges alone. `k` must be a cell of the scan.
[[nodiscard]] ClickedCell nearSideCell(const Scan& scan, std::uint32_t k);
/// Of a click on an edge of `mask` (lines x beams, 255 = edge): the nearest edge cell on the surface of nearSideCell(), within two cells of
/// that. Otherwise nearSideCell().
[[nodiscard]] ClickedCell nearSideEdge(const Scan& scan, const Grid<std::uint8_t>& mask, std::uint32_t k);

} // namespace edgescan::inspect
