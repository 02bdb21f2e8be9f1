// The measurements of EdgeScan+ at one cell: steps in depth, folds, their limits, and a stronger neighbour (docs/method/edges.md, "Step 2"
// to "Step 7").
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <array>
#include <optional>
#include <vector>

namespace edgescan::edges {

struct CellStrength {
    int line = 0;
    int beam = 0;
    double strength = 0.0; ///< in units of the thresholds
};

/// A step in depth between the cell and one of its four neighbours, mm. The limit is the sum of four parts.
struct DepthStepAtCell {
    Along along = Along::Beams;
    int line = 0; ///< of the neighbour
    int beam = 0;
    double stepMm = 0.0;
    double smallestMm = 0.0;  ///< J0
    double growthMm = 0.0;    ///< p x the nearer range
    double grazingMm = 0.0;   ///< g x the slope
    double reliefMm = 0.0;    ///< the largest step that the relief of a slanted surface may cause
    double strength = 0.0;    ///< S_J: step divided by limit
    bool cellIsNearer = true; ///< false: the edge belongs to the neighbour
    [[nodiscard]] double limitMm() const { return smallestMm + growthMm + grazingMm + reliefMm; }
};

/// A fold of the surface at the cell.
struct FoldAtCell {
    Along along = Along::Beams;
    double dihedralDeg = 0.0; ///< angle between the planes of both sides, 0 = flat
    bool convex = true;
    double noiseDeg = 0.0; ///< the angle that noise alone may cause
    double meets = 1.0;    ///< weight: less than 1 if the planes do not meet at the cell
    double strength = 0.0; ///< |S_C| of this direction alone
};

/// One channel (jumps or creases) before and after suppression.
struct ThinnedStrength {
    float before = 0.0F;                  ///< negative: concave
    float after = 0.0F;                   ///< `before`, or 0 if suppressed; without responses moved here from a gap next to the cell
    float compared = 0.0F;                ///< size of the cell's response in the one direction that suppression compares; folds add both
    std::optional<CellStrength> stronger; ///< the neighbour that suppressed this cell, with its response in that direction
};

struct DepthProbe {
    Support support = Support::Void;
    double noiseMm = 0.0;       ///< the sigma in use, at the cell's range
    double noiseAt5mMm = 0.0;   ///< at 5 m
    double foldNoiseMm = 0.0;   ///< the noise for folds at the cell's range: larger than noiseMm if the errors of neighbours are correlated
    double creaseDeg = 0.0;     ///< C0
    bool interlaced = false;    ///< the beams are interlaced
    bool grazingRaised = false; ///< and therefore g is larger than the value of the settings
    std::optional<double> snappedMm;    ///< the range to which a mixed pixel was moved
    std::vector<DepthStepAtCell> steps; ///< strongest first; steps whose edge is at the cell precede those whose edge is at the neighbour
    std::vector<FoldAtCell> folds;      ///< strongest first
    ThinnedStrength jump, crease;
};

/// Runs the stages again up to the line of the cell. The values equal those of depthResponses() to the last bit, but without responses that
/// were moved around gaps.
[[nodiscard]] DepthProbe probeDepth(const Scan& scan, const Settings& settings, int line, int beam, const GapFilling* filling = nullptr);

} // namespace edgescan::edges
