// Smooths noisy ranges. Loops of plain arithmetic without branches, so that the compiler can vectorise them.
#include "core/edges/edgescan_plus/noise_smoothing.h"

#include "core/base/bands.h"
#include "core/base/simd.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace edgescan::edges {
namespace {

constexpr int kReach = 2;           // lines and beams
constexpr float kDeviations = 3.0F; // from here on a cell is on another surface

// A line of cells; what is known of it.
struct NoisyLine {
    const float* u;
    const Support* support;
};

// One over the square of the largest difference of u that counts.
struct Narrowness {
    float offsetM, perMetre, perSquareMetre;
    [[nodiscard]] EDGESCAN_INLINE float at(float u) const {
        const float most = (offsetM * u + perMetre) * u + perSquareMetre;
        return 1.0F / (most * most);
    }
};

EDGESCAN_INLINE void narrownessOfLine(const float* u, int beams, const Narrowness& narrowness, float* __restrict out) {
    for (int j = 0; j < beams; ++j) out[j] = narrowness.at(u[j]);
}

// Adds the pairs of cells that are `beams` before and behind the cells first <= j < last.
EDGESCAN_INLINE void addPairs(const float* u, const float* narrow, const NoisyLine& before, const NoisyLine& behind, int beams, int first,
                              int last, float* __restrict sums, float* __restrict weights) {
    for (int j = first; j < last; ++j) {
        const float a = before.u[j - beams] - u[j];
        const float b = behind.u[j + beams] - u[j];
        const bool solid = (before.support[j - beams] != Support::Void) & (behind.support[j + beams] != Support::Void);
        const float ofA = std::max(0.0F, 1.0F - a * a * narrow[j]);
        const float ofB = std::max(0.0F, 1.0F - b * b * narrow[j]);
        const float both = solid ? ofA * ofB : 0.0F;
        const float weight = both * both;
        sums[j] += weight * (a + b);
        weights[j] += weight;
    }
}

EDGESCAN_INLINE void moveLine(const float* sums, const float* weights, const Support* support, int beams, float share,
                              float* __restrict u) {
    for (int j = 0; j < beams; ++j) {
        const float move = share * sums[j] / (1.0F + 2.0F * weights[j]);
        u[j] += support[j] != Support::Void ? move : 0.0F;
    }
}

} // namespace

void smoothNoise(InverseRange& inverse, const RangeNoise& noise, double share, int threads) {
    const Grid<float> from = inverse.u;
    const auto most = [](double mm) { return kDeviations * 0.001F * static_cast<float>(mm); };
    const Narrowness narrowness{most(noise.offsetMm), most(noise.perMetreMm), most(noise.perSquareMetreMm)};
    const auto lineAt = [&](int i) { return NoisyLine{from.line(i), inverse.support.line(i)}; };
    runInBands(from.lines, bandsFor(from.size(), threads), [&](int first, int last) {
        const auto count = static_cast<std::size_t>(from.beams);
        std::vector<float> narrow(count), sums(count), weights(count);
        for (int i = first; i < last; ++i) {
            vectorised<narrownessOfLine>(from.line(i), from.beams, narrowness, narrow.data());
            std::ranges::fill(sums, 0.0F);
            std::ranges::fill(weights, 0.0F);
            for (int lines = 0; lines <= kReach && i >= lines && i + lines < from.lines; ++lines) {
                for (int beams = lines == 0 ? 1 : -kReach; beams <= kReach; ++beams)
                    vectorised<addPairs>(from.line(i), narrow.data(), lineAt(i - lines), lineAt(i + lines), beams, std::abs(beams),
                                         from.beams - std::abs(beams), sums.data(), weights.data());
            }
            vectorised<moveLine>(sums.data(), weights.data(), inverse.support.line(i), from.beams, static_cast<float>(share),
                                 inverse.u.line(i));
        }
    });
}

} // namespace edgescan::edges
