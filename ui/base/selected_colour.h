// The colour of the selection, in all views: its rim in full, its inside as a light tint under which edges and faces stay visible.
#pragma once

#include <QColor>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::ui {

/// As light as rock faces and the cloud, so that edges contrast with it as they do with them. It differs from every rock colour for all
/// kinds of colour vision.
inline constexpr QRgb kSelectedColour = qRgb(190, 40, 250);
inline constexpr double kSelectedTint = 0.25; ///< opacity inside the rim

/// The cells at the rim of `cells` (ascending, of a grid with `beams`): at least one of their four neighbours is not selected.
[[nodiscard]] inline std::vector<std::uint32_t> rimOf(const std::vector<std::uint32_t>& cells, std::uint32_t beams) {
    std::vector<std::uint32_t> rim;
    std::size_t above = 0, below = 0; // the first cells that are not before the neighbours
    const auto has = [&](std::size_t& from, std::int64_t k) {
        while (from < cells.size() && cells[from] < k) ++from;
        return from < cells.size() && cells[from] == k;
    };
    for (std::size_t n = 0; n < cells.size(); ++n) {
        const std::uint32_t k = cells[n], beam = k % beams;
        const bool left = beam > 0 && n > 0 && cells[n - 1] + 1 == k;
        const bool right = beam + 1 < beams && n + 1 < cells.size() && cells[n + 1] == k + 1;
        const bool up = has(above, std::int64_t{k} - beams), down = has(below, std::int64_t{k} + beams);
        if (!left || !right || !up || !down) rim.push_back(k);
    }
    return rim;
}

} // namespace edgescan::ui
