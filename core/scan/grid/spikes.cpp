// Echoes of dust close to a surface.
#include "core/scan/grid/spikes.h"

#include "core/base/simd.h"
#include "core/scan/grid/marked_cells.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace edgescan {
namespace {

constexpr float kLeastM = 0.020F;
constexpr float kDeviations = 6;

// The least deviation of a spike's range, as a share of the range.
struct Height {
    float offsetM, perMetre;
    [[nodiscard]] float at(float u) const { return std::max(kLeastM * u, offsetM * u + perMetre); }
};

// First pass: compares each cell with its four neighbours, so that few cells remain for the full check.
EDGESCAN_INLINE void markCandidates(const float* u, std::ptrdiff_t stride, int beams, const Height& height,
                                    std::uint8_t* __restrict marked) {
    for (int j = 1; j < beams - 1; ++j) {
        const float nearest = std::max(std::max(u[j - 1], u[j + 1]), std::max(u[j - stride], u[j + stride]));
        const float farthest = std::min(std::min(u[j - 1], u[j + 1]), std::min(u[j - stride], u[j + stride]));
        const float off = 1 + height.at(u[j]);
        marked[j] = static_cast<std::uint8_t>((u[j] > off * nearest) | (off * u[j] < farthest));
    }
}

bool isSpike(const InverseRange& inverse, int line, int beam, const Height& height) {
    const float u = inverse.u.at(line, beam);
    if (!inverse.isMeasured(line, beam)) return false;
    float nearest = 0;
    float farthest = 1e9F;
    for (int i = line - 1; i <= line + 1; ++i) {
        for (int j = beam - 1; j <= beam + 1; ++j) {
            if (i == line && j == beam) continue;
            if (inverse.support.at(i, j) == Support::Void) return false;
            nearest = std::max(nearest, inverse.u.at(i, j));
            farthest = std::min(farthest, inverse.u.at(i, j));
        }
    }
    const float off = 1 + height.at(u);
    const float apart = nearest - farthest;
    return (u > off * nearest && u - nearest > apart) || (off * u < farthest && farthest - u > apart);
}

} // namespace

void removeSpikes(InverseRange& inverse, const RangeNoise& noise) {
    const Grid<float>& u = inverse.u;
    const Height height{kDeviations * 0.001F * static_cast<float>(noise.offsetMm),
                        kDeviations * 0.001F * static_cast<float>(noise.perMetreMm)};
    std::vector<std::uint8_t> marked(static_cast<std::size_t>(u.beams));
    // Spikes never touch each other, so their order does not matter.
    for (int i = 1; i + 1 < u.lines; ++i) {
        vectorised<markCandidates>(u.line(i), u.beams, u.beams, height, marked.data());
        forEachMarked(marked, [&](std::size_t beam) {
            const int j = static_cast<int>(beam);
            if (!isSpike(inverse, i, j, height)) return;
            inverse.u.at(i, j) = 0.25F * (u.at(i, j - 1) + u.at(i, j + 1) + u.at(i - 1, j) + u.at(i + 1, j));
            inverse.support.at(i, j) = Support::Filled;
        });
    }
}

} // namespace edgescan
