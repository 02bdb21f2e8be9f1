// Edges that continue across cells without a range: cells next to the gap are used before those at its corners.
#include "core/edges/edgescan_plus/gap_detour.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace edgescan::edges {
namespace {

constexpr std::array<std::array<int, 2>, 4> kSides{{{0, -1}, {0, 1}, {-1, 0}, {1, 0}}};
constexpr std::array<std::array<int, 2>, 4> kCorners{{{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}};

// The measured cell among these that has no response yet and has the lowest cost; -1 if there is none.
template <class Cost>
std::ptrdiff_t cheapest(const InverseRange& inverse, const Grid<float>& response, std::size_t k,
                        const std::array<std::array<int, 2>, 4>& around, Cost cost) {
    const auto beams = static_cast<std::size_t>(inverse.u.beams);
    const int line = static_cast<int>(k / beams);
    const int beam = static_cast<int>(k % beams);
    std::ptrdiff_t best = -1;
    for (const auto& [di, dj] : around) {
        if (!inverse.u.contains(line + di, beam + dj)) continue;
        const std::size_t place = inverse.u.index(line + di, beam + dj);
        if (inverse.support[place] != Support::Measured || response[place] != 0.0F) continue;
        if (best < 0 || cost(inverse.u[place]) < cost(inverse.u[static_cast<std::size_t>(best)])) best = static_cast<std::ptrdiff_t>(place);
    }
    return best;
}

template <class Cost>
void move(const InverseRange& inverse, std::size_t k, Grid<float>& response, Cost cost) {
    const float value = response[k];
    if (value == 0.0F) return;
    response[k] = 0.0F;
    std::ptrdiff_t place = cheapest(inverse, response, k, kSides, cost);
    if (place < 0) place = cheapest(inverse, response, k, kCorners, cost);
    if (place >= 0) response[static_cast<std::size_t>(place)] = value;
}

// Calls of(k) for every filled cell.
template <class Of>
void forFilled(const Grid<Support>& supports, Of of) {
    const Support* support = supports.cells.data();
    for (std::size_t k = 0; k < supports.size(); ++k) {
        const void* next = std::memchr(support + k, static_cast<int>(Support::Filled), supports.size() - k); // few cells are filled
        if (next == nullptr) return;
        k = static_cast<std::size_t>(static_cast<const Support*>(next) - support);
        of(k);
    }
}

} // namespace

void moveJumpsOffGaps(const InverseRange& inverse, Grid<float>& jump) {
    forFilled(inverse.support, [&](std::size_t k) { move(inverse, k, jump, [](float u) { return -u; }); });
}

void moveFoldsOffGaps(const InverseRange& inverse, Grid<float>& crease) {
    forFilled(inverse.support,
              [&](std::size_t k) { move(inverse, k, crease, [own = inverse.u[k]](float u) { return std::abs(u - own); }); });
}

} // namespace edgescan::edges
