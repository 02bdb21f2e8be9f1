// The gradient detectors of the thesis's chapter 3.
#include "core/gray/gradient_masks.h"

#include "core/gray/neighbours.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace edgescan {
namespace {

float strength(int along, int across, Norm norm) {
    if (norm == Norm::L1) return static_cast<float>(std::abs(along) + std::abs(across));
    return static_cast<float>(std::sqrt(static_cast<double>(along * along + across * across)));
}

struct Components {
    int alongBeams, alongLines;
};

// Sobel's masks for a middle weight of 2, Prewitt's for 1.
Components differencesOfThree(const Neighbours& at, int middle) {
    const auto& n = at.around;
    return {(n[2] + middle * n[3] + n[4]) - (n[0] + middle * n[7] + n[6]), (n[6] + middle * n[5] + n[4]) - (n[0] + middle * n[1] + n[2])};
}

Grid<float> edgesOfThree(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm, int middle) {
    return responseOfNeighbours(levels, missing, [=](const Neighbours& at) {
        const Components c = differencesOfThree(at, middle);
        return strength(c.alongBeams, c.alongLines, norm);
    });
}

// Down to the right, and down to the left.
Components robertsDifferences(const Neighbours& at) { return {at.centre - at.around[4], at.around[3] - at.around[5]}; }

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

double degreesOf(int alongBeams, int alongLines) { return std::atan2(alongLines, alongBeams) * 180.0 / std::numbers::pi; }

// The middle of the strongest mask; its first cell is the one at the top left.
std::optional<double> strongestOf(const Neighbours& at, int (*answer)(const Neighbours&, std::size_t)) {
    static constexpr std::array<Components, 8> kPlaces{{{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
    int strongest = 0;
    std::optional<double> deg;
    for (std::size_t turn = 0; turn < kPlaces.size(); ++turn) {
        if (answer(at, turn) <= strongest) continue;
        strongest = answer(at, turn);
        const Components middle = kPlaces[(turn + 1) % 8];
        deg = degreesOf(middle.alongBeams, middle.alongLines);
    }
    return deg;
}

} // namespace

Grid<float> robertsResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm) {
    return responseOfNeighbours(levels, missing, [=](const Neighbours& at) {
        const Components c = robertsDifferences(at);
        return strength(c.alongBeams, c.alongLines, norm);
    });
}

Grid<float> sobelResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm) {
    return edgesOfThree(levels, missing, norm, 2);
}

Grid<float> prewittResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm) {
    return edgesOfThree(levels, missing, norm, 1);
}

Grid<float> kirschResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing) {
    return responseOfNeighbours(levels, missing, [](const Neighbours& at) {
        int strongest = 0;
        for (std::size_t turn = 0; turn < 8; ++turn) strongest = std::max(strongest, kirschAnswer(at, turn));
        return static_cast<float>(strongest);
    });
}

Grid<float> robinsonResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing) {
    return responseOfNeighbours(levels, missing, [](const Neighbours& at) {
        int strongest = 0;
        // The other four masks are these with the opposite sign.
        for (std::size_t turn = 0; turn < 4; ++turn) strongest = std::max(strongest, std::abs(robinsonAnswer(at, turn)));
        return static_cast<float>(strongest);
    });
}

MaskDirection maskDirection(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, int line, int beam) {
    if (missing != nullptr && missing->at(line, beam) != 0) return {};
    const Neighbours at = neighboursAt(levels, missing, line, beam);
    if (method == Method::Kirsch) return {{}, {}, strongestOf(at, kirschAnswer)};
    if (method == Method::Robinson) return {{}, {}, strongestOf(at, robinsonAnswer)};
    const bool diagonal = method == Method::Roberts;
    if (!diagonal && method != Method::Sobel && method != Method::Prewitt) return {};
    const Components c = diagonal ? robertsDifferences(at) : differencesOfThree(at, method == Method::Sobel ? 2 : 1);
    // The sum of both diagonal differences falls from line to line, their difference rises from beam to beam.
    const Components along = diagonal ? Components{c.alongLines - c.alongBeams, -c.alongBeams - c.alongLines} : c;
    MaskDirection direction;
    const double share = diagonal ? 0.5 : 1.0;
    direction.alongBeams = share * along.alongBeams;
    direction.alongLines = share * along.alongLines;
    if (along.alongBeams != 0 || along.alongLines != 0) direction.deg = degreesOf(along.alongBeams, along.alongLines);
    return direction;
}

} // namespace edgescan
