// What EdgeScan+ measured at one cell: steps in depth, folds, their limits, and which neighbour is stronger
// (docs/method.md, "Step 2" to "Step 7").
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <array>
#include <optional>
#include <vector>

namespace edgescan {

struct CellStrength {
    int line = 0;
    int beam = 0;
    double strength = 0.0; ///< in units of the thresholds
};

/// A step in depth between the cell and one of its four neighbours. The limit is the sum of its four parts.
struct DepthStepAtCell {
    Along along = Along::Beams;
    int line = 0; ///< of the neighbour
    int beam = 0;
    double stepMm = 0.0;
    double smallestMm = 0.0;  ///< J0
    double growthMm = 0.0;    ///< p x nearer range
    double grazingMm = 0.0;   ///< g x slope
    double reliefMm = 0.0;    ///< what the relief of a slanted surface may make of it
    double strength = 0.0;    ///< S_J: step over limit
    bool cellIsNearer = true; ///< else the edge is the neighbour's
    [[nodiscard]] double limitMm() const { return smallestMm + growthMm + grazingMm + reliefMm; }
};

/// A fold of the surface at the cell.
struct FoldAtCell {
    Along along = Along::Beams;
    double dihedralDeg = 0.0; ///< between the planes of both sides, 0 = flat
    bool convex = true;
    double noiseDeg = 0.0; ///< what noise alone may look like
    double meets = 1.0;    ///< share that counts: less where the planes do not meet at the cell
    double strength = 0.0; ///< |S_C| of this way alone
};

/// One channel after suppression.
struct ThinnedStrength {
    float before = 0.0F;                  ///< negative: concave
    float kept = 0.0F;                    ///< `before`, or 0; without what a gap beside the cell sends round by it
    std::optional<CellStrength> stronger; ///< the neighbour that took the edge
};

struct DepthProbe {
    Support support = Support::Void;
    double noiseMm = 0.0;               ///< sigma used, at the cell's range
    double noiseAt5mMm = 0.0;           ///< at 5 m
    double foldNoiseMm = 0.0;           ///< what folds are compared with at the cell's range: more where neighbours err alike
    double creaseDeg = 0.0;             ///< C0
    bool interlaced = false;            ///< the beams are interlaced
    bool grazingRaised = false;         ///< and so g is larger than typed
    std::optional<double> snappedMm;    ///< a mixed pixel was taken at this range
    std::vector<DepthStepAtCell> steps; ///< strongest first; those of the cell itself before those that are a neighbour's
    std::vector<FoldAtCell> folds;      ///< strongest first
    ThinnedStrength jump, crease;
};

/// Runs the stages again up to the line of the cell; equal to depthResponses() to the last bit, but without responses that
/// go round gaps.
[[nodiscard]] DepthProbe probeDepth(const Scan& scan, const DepthEdgeSettings& settings, int line, int beam,
                                    const GapFilling* filling = nullptr);

} // namespace edgescan
