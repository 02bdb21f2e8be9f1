// The gradient detectors of the thesis's chapter 3.
#include "core/edges/gray/gradient_masks.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace edgescan::edges {
namespace {

// To the lower right, and to the lower left.
MaskComponents robertsDifferences(const Neighbours& at) { return {at.centre - at.around[4], at.around[3] - at.around[5]}; }

// 5 x (three in a row) - 3 x (the other five) = 8 x (three in a row) - 3 x all.
int kirschAnswer(const Neighbours& at, std::size_t turn) {
    const auto& n = at.around;
    int all = 0;
    for (const int level : n) all += level;
    return 8 * (n[turn] + n[(turn + 1) % 8] + n[(turn + 2) % 8]) - 3 * all;
}

int robinsonAnswer(const Neighbours& at, std::size_t turn) {
    const auto& n = at.around;
    const auto three = [&](std::size_t t) { return n[t % 8] + 2 * n[(t + 1) % 8] + n[(t + 2) % 8]; };
    return three(turn) - three(turn + 4);
}

double degreesOf(MaskComponents way) { return std::atan2(way.alongLines, way.alongBeams) * 180.0 / std::numbers::pi; }

// The middle of the strongest mask; its first cell is at the top left.
MaskDirection strongestOf(const Neighbours& at, int (*answer)(const Neighbours&, std::size_t)) {
    static constexpr std::array<MaskComponents, 8> kPlaces{{{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
    int strongest = 0;
    MaskDirection direction;
    for (std::size_t turn = 0; turn < kPlaces.size(); ++turn) {
        if (answer(at, turn) <= strongest) continue;
        strongest = answer(at, turn);
        direction.deg = degreesOf(kPlaces[(turn + 1) % 8]);
    }
    return direction;
}

} // namespace

float strengthOf(MaskComponents answers, Norm norm) {
    const auto [along, across] = answers;
    if (norm == Norm::L1) return static_cast<float>(std::abs(along) + std::abs(across));
    return static_cast<float>(std::sqrt(static_cast<double>(along * along + across * across)));
}

MaskDirection directionOf(MaskComponents answers, double share) {
    MaskDirection direction{share * answers.alongBeams, share * answers.alongLines};
    if (answers.alongBeams != 0 || answers.alongLines != 0) direction.deg = degreesOf(answers);
    return direction;
}

Grid<float> robertsResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings) {
    return responseOfNeighbours(levels, missing,
                                [norm = settings.norm](const Neighbours& at) { return strengthOf(robertsDifferences(at), norm); });
}

// The sum of both diagonal differences decreases from line to line; their difference increases from beam to beam.
MaskDirection robertsDirection(const Neighbours& at) {
    const MaskComponents c = robertsDifferences(at);
    return directionOf({c.alongLines - c.alongBeams, -c.alongBeams - c.alongLines}, 0.5);
}

Grid<float> kirschResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& /*settings*/) {
    return responseOfNeighbours(levels, missing, [](const Neighbours& at) {
        int strongest = 0;
        for (std::size_t turn = 0; turn < 8; ++turn) strongest = std::max(strongest, kirschAnswer(at, turn));
        return static_cast<float>(strongest);
    });
}

MaskDirection kirschDirection(const Neighbours& at) { return strongestOf(at, kirschAnswer); }

Grid<float> robinsonResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& /*settings*/) {
    return responseOfNeighbours(levels, missing, [](const Neighbours& at) {
        int strongest = 0;
        // The other four masks are these with the opposite sign.
        for (std::size_t turn = 0; turn < 4; ++turn) strongest = std::max(strongest, std::abs(robinsonAnswer(at, turn)));
        return static_cast<float>(strongest);
    });
}

MaskDirection robinsonDirection(const Neighbours& at) { return strongestOf(at, robinsonAnswer); }

} // namespace edgescan::edges
