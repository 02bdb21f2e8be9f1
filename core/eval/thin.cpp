// Thinning.
#include "core/eval/thin.h"

#include <algorithm>
#include <array>
#include <vector>

namespace edgescan {
namespace {

// The eight neighbours, north first, clockwise; outside the grid nothing is set.
std::array<bool, 8> neighbours(const Grid<std::uint8_t>& mask, int line, int beam) {
    static constexpr std::array<std::array<int, 2>, 8> steps{{{-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}}};
    std::array<bool, 8> set{};
    for (std::size_t n = 0; n < steps.size(); ++n) {
        const int i = line + steps[n][0];
        const int j = beam + steps[n][1];
        set[n] = mask.contains(i, j) && mask.at(i, j) != 0;
    }
    return set;
}

bool removable(const std::array<bool, 8>& p, bool secondPass) {
    const auto [n, ne, e, se, south, sw, w, nw] = p;
    const int runs = (!n && (ne || e)) + (!e && (se || south)) + (!south && (sw || w)) + (!w && (nw || n));
    const int pairsOne = (nw || n) + (ne || e) + (se || south) + (sw || w);
    const int pairsTwo = (n || ne) + (e || se) + (south || sw) + (w || nw);
    const int pairs = std::min(pairsOne, pairsTwo);
    const bool kept = secondPass ? (n || ne || !se) && e : (south || sw || !nw) && w;
    return runs == 1 && pairs >= 2 && pairs <= 3 && !kept;
}

} // namespace

Grid<std::uint8_t> thinned(Grid<std::uint8_t> mask) {
    std::vector<std::size_t> alive;
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (mask[k] != 0) alive.push_back(k);
    }
    const auto beams = static_cast<std::size_t>(mask.beams);
    std::vector<std::size_t> gone;
    for (int idle = 0, pass = 0; idle < 2; ++pass) {
        gone.clear();
        for (const std::size_t k : alive) {
            const auto p = neighbours(mask, static_cast<int>(k / beams), static_cast<int>(k % beams));
            if (removable(p, pass % 2 == 1)) gone.push_back(k);
        }
        for (const std::size_t k : gone) mask[k] = 0;
        std::erase_if(alive, [&](std::size_t k) { return mask[k] == 0; });
        idle = gone.empty() ? idle + 1 : 0;
    }
    return mask;
}

} // namespace edgescan
