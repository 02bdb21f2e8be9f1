// Finds barriers and computes the distance to them.
#include "core/rocks/segmentation/barrier.h"

#include "core/base/bands.h"
#include "core/base/simd.h"
#include "core/rocks/segmentation/distance.h"

namespace edgescan::rocks {
namespace {

constexpr float kChainLow = 0.5F;
constexpr float kChainHigh = 0.8F;
constexpr int kChainCells = 3;

EDGESCAN_INLINE void strengthsOf(const float* jump, const float* fold, std::size_t cells, float* __restrict strength) {
    for (std::size_t k = 0; k < cells; ++k) strength[k] = std::max(std::max(jump[k], -fold[k]), 0.0F);
}

// Changes chains to what is free: neither in a chain nor without a range.
EDGESCAN_INLINE void markFree(const Support* support, std::size_t cells, std::uint8_t* __restrict chain) {
    for (std::size_t k = 0; k < cells; ++k) chain[k] = (chain[k] == 0) & (support[k] != Support::Void) ? 1 : 0;
}
// Of cells at a crack with a jump. `jump`: of the crack of the first of the cells, towards the next cell, or from the cell before.
EDGESCAN_INLINE void markJumps(const float* jump, std::size_t cells, std::uint8_t* __restrict free) {
    for (std::size_t k = 0; k < cells; ++k) free[k] = jump[k] > 1.0F ? 0 : free[k];
}

// 0 at barriers.
Grid<std::uint8_t> barriers(const Inputs& inputs) {
    const Grid<Support>& support = inputs.surface->inverse.support;
    const edges::DepthResponses& responses = *inputs.responses;
    const Grid<float>& folds = rockFolds(responses);
    Grid<float> strength(support.lines, support.beams);
    const auto beams = static_cast<std::size_t>(support.beams);
    const int threads = bandsFor(support.size(), 0);
    runInBands(support.lines, threads, [&](int first, int last) {
        for (int i = first; i < last; ++i) vectorised<strengthsOf>(responses.jump->line(i), folds.line(i), beams, strength.line(i));
    });
    Grid<std::uint8_t> free = edges::linkedChains(strength, kChainHigh, kChainLow, kChainCells);
    const edges::DepthCracks& cracks = *inputs.cracks;
    runInBands(support.lines, threads, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            vectorised<markFree>(support.line(i), beams, free.line(i));
            // The cracks at the border of the sweep have no jump.
            vectorised<markJumps>(cracks.jumpBeams.line(i), beams, free.line(i));
            vectorised<markJumps>(cracks.jumpBeams.line(i), beams - 1, free.line(i) + 1);
            vectorised<markJumps>(cracks.jumpLines.line(i), beams, free.line(i));
            if (i > 0) vectorised<markJumps>(cracks.jumpLines.line(i - 1), beams, free.line(i));
        }
    });
    return free;
}

} // namespace

Grid<float> barrierDistance(const Inputs& inputs) { return distanceToZero(barriers(inputs)); }

} // namespace edgescan::rocks
