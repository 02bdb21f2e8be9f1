// The gradient detectors of the thesis's chapter 3.
#include "core/edges/detectors/gradient_masks.h"

#include "core/edges/detectors/ring.h"

#include <cmath>
#include <cstdlib>

namespace edgescan {
namespace {

float strength(int along, int across, Norm norm) {
    if (norm == Norm::L1) return static_cast<float>(std::abs(along) + std::abs(across));
    return static_cast<float>(std::sqrt(static_cast<double>(along * along + across * across)));
}

// Sobel's masks for a middle weight of 2, Prewitt's for 1.
Grid<float> edgesOfThree(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm, int middle) {
    return responseOfRings(levels, missing, [=](const Ring& ring) {
        const auto& n = ring.around;
        const int alongBeams = (n[2] + middle * n[3] + n[4]) - (n[0] + middle * n[7] + n[6]);
        const int alongLines = (n[6] + middle * n[5] + n[4]) - (n[0] + middle * n[1] + n[2]);
        return strength(alongBeams, alongLines, norm);
    });
}

} // namespace

Grid<float> robertsResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm) {
    return responseOfRings(levels, missing, [=](const Ring& ring) {
        const auto& n = ring.around;
        return strength(ring.centre - n[4], n[3] - n[5], norm);
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
        const auto& n = ring.around;
        int all = 0;
        for (const int level : n) all += level;
        // 5 x (three in a row) - 3 x (the other five) = 8 x (three in a row) - 3 x all.
        int strongest = 0;
        for (std::size_t turn = 0; turn < n.size(); ++turn)
            strongest = std::max(strongest, 8 * (n[turn] + n[(turn + 1) % 8] + n[(turn + 2) % 8]) - 3 * all);
        return static_cast<float>(strongest);
    });
}

Grid<float> robinsonResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing) {
    return responseOfRings(levels, missing, [](const Ring& ring) {
        const auto& n = ring.around;
        int strongest = 0;
        // The other four masks are these with the opposite sign.
        for (std::size_t turn = 0; turn < 4; ++turn) {
            const int here = n[turn] + 2 * n[turn + 1] + n[turn + 2];
            const int opposite = n[turn + 4] + 2 * n[(turn + 5) % 8] + n[(turn + 6) % 8];
            strongest = std::max(strongest, std::abs(here - opposite));
        }
        return static_cast<float>(strongest);
    });
}

} // namespace edgescan
