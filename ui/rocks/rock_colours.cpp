// Colours of rock faces.
#include "ui/rocks/rock_colours.h"

#include <algorithm>

namespace edgescan::ui {

std::vector<std::uint8_t> rockColours(const RockMap& map) {
    constexpr std::uint8_t kNone = 255;
    const std::size_t count = map.rocks + std::size_t{1};
    std::vector<std::vector<std::uint32_t>> neighbours(count);
    for (const RegionBorder& border : map.borders) {
        if (border.a == 0 || border.b > map.rocks) continue;
        neighbours[border.a].push_back(border.b);
        neighbours[border.b].push_back(border.a);
    }
    std::vector<std::uint8_t> colours(count, kNone);
    for (std::size_t rock = 1; rock < count; ++rock) {
        std::array<int, kRockColourCount> taken{};
        for (const std::uint32_t other : neighbours[rock]) {
            if (colours[other] != kNone) ++taken[colours[other]];
        }
        // The first choice depends on the rock's oldest piece alone; the least taken one follows where more than seven meet.
        const std::size_t first = map.regions[rock].group * 2654435761U % kRockColourCount;
        std::size_t best = first;
        for (std::size_t step = 1; step < kRockColourCount; ++step) {
            const std::size_t next = (first + step) % kRockColourCount;
            if (taken[next] < taken[best]) best = next;
        }
        colours[rock] = static_cast<std::uint8_t>(best);
    }
    return colours;
}

} // namespace edgescan::ui
