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
Components differencesOfThree(const Ring& ring, int middle) {
    const auto& n = ring.around;
    return {(n[2] + middle * n[3] + n[4]) - (n[0] + middle * n[7] + n[6]), (n[6] + middle * n[5] + n[4]) - (n[0] + middle * n[1] + n[2])};
}

Grid<float> edgesOfThree(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm, int middle) {
    return responseOfRings(levels, missing, [=](const Ring& ring) {
        const Components c = differencesOfThree(ring, middle);
        return strength(c.alongBeams, c.alongLines, norm);
    });
}

// Down to the right, and down to the left.
Components robertsDifferences(const Ring& ring) { return {ring.centre - ring.around[4], ring.around[3] - ring.around[5]}; }

// 5 x (three in a row) - 3 x (the other five) = 8 x (three in a row) - 3 x all.
int kirschAnswer(const Ring& ring, std::size_t turn) {
    const auto& n = ring.around;
    int all = 0;
    for (const int level : n) all += level;
    return 8 * (n[turn] + n[(turn + 1) % 8] + n[(turn + 2) % 8]) - 3 * all;
}

int robinsonAnswer(const Ring& ring, std::size_t turn) {
    const auto& n = ring.around;
    const auto three = [&](std::size_t t) { return n[t % 8] + 2 * n[(t + 1) % 8] + n[(t + 2) % 8]; };
    return three(turn) - three(turn + 4);
}

double degreesOf(int alongBeams, int alongLines) { return std::atan2(alongLines, alongBeams) * 180.0 / std::numbers::pi; }

// The middle of the strongest mask; its first cell is the one at the top left.
std::optional<double> strongestOf(const Ring& ring, int (*answer)(const Ring&, std::size_t)) {
    static constexpr std::array<Components, 8> kPlaces{{{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
    int strongest = 0;
    std::optional<double> deg;
    for (std::size_t turn = 0; turn < kPlaces.size(); ++turn) {
        if (answer(ring, turn) <= strongest) continue;
        strongest = answer(ring, turn);
        const Components middle = kPlaces[(turn + 1) % 8];
        deg = degreesOf(middle.alongBeams, middle.alongLines);
    }
    return deg;
}

} // namespace

Grid<float> robertsResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm) {
    return responseOfRings(levels, missing, [=](const Ring& ring) {
        const Components c = robertsDifferences(ring);
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
    return responseOfRings(levels, missing, [](const Ring& ring) {
        int strongest = 0;
        for (std::size_t turn = 0; turn < 8; ++turn) strongest = std::max(strongest, kirschAnswer(ring, turn));
        return static_cast<float>(strongest);
    });
}

Grid<float> robinsonResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing) {
    return responseOfRings(levels, missing, [](const Ring& ring) {
        int strongest = 0;
        // The other four masks are these with the opposite sign.
        for (std::size_t turn = 0; turn < 4; ++turn) strongest = std::max(strongest, std::abs(robinsonAnswer(ring, turn)));
        return static_cast<float>(strongest);
    });
}

MaskDirection maskDirection(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, int line, int beam) {
    if (missing != nullptr && missing->at(line, beam) != 0) return {};
    const Ring ring = ringAt(levels, missing, line, beam);
    if (method == Method::Kirsch) return {{}, {}, strongestOf(ring, kirschAnswer)};
    if (method == Method::Robinson) return {{}, {}, strongestOf(ring, robinsonAnswer)};
    const bool diagonal = method == Method::Roberts;
    if (!diagonal && method != Method::Sobel && method != Method::Prewitt) return {};
    const Components c = diagonal ? robertsDifferences(ring) : differencesOfThree(ring, method == Method::Sobel ? 2 : 1);
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
