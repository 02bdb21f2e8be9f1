// Barriers, where a rock certainly ends, and the distance of each cell to them (docs/method/rocks.md, "Step 2").
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/inputs.h"

#include <algorithm>

namespace edgescan::rocks {

/// Which neighbouring cells are on one surface: both have a range, measured or filled, and there is no jump between them.
struct CellLinks {
    const Grid<Support>& support;
    const edges::DepthCracks& cracks;

    [[nodiscard]] bool solid(std::size_t k) const { return support[k] != Support::Void; }
    /// Between cell k and the next beam; that cell must exist.
    [[nodiscard]] bool toNextBeam(std::size_t k) const { return solid(k) && solid(k + 1) && cracks.jumpBeams[k] <= 1.0F; }
    /// Between cell k and the next line; that cell must exist.
    [[nodiscard]] bool toNextLine(std::size_t k) const {
        return solid(k) && solid(k + static_cast<std::size_t>(support.beams)) && cracks.jumpLines[k] <= 1.0F;
    }
};

/// The folds that count for rocks.
[[nodiscard]] inline const Grid<float>& rockFolds(const edges::DepthResponses& responses) {
    return responses.roughness.rough ? responses.unweighed : responses.crease;
}

/// Strength of the separation between rocks, per cell: the jump or the valley after suppression, whichever is stronger; 0 on a ridge,
/// because a ridge is inside one rock.
[[nodiscard]] inline float separationStrength(const edges::DepthResponses& responses, std::size_t k) {
    return std::max({(*responses.jump)[k], -rockFolds(responses)[k], 0.0F});
}

/// Exact distance of each cell to the nearest barrier, in cells, 0 on a barrier. Lines x beams. Barriers are chains of separating edges,
/// both cells of each jump, and voids.
[[nodiscard]] Grid<float> barrierDistance(const Inputs& inputs);

} // namespace edgescan::rocks
