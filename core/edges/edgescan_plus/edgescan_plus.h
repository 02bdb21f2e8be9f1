// EdgeScan+: jumps and creases of the surface, measured against straight lines in inverse range (docs/method.md, "EdgeScan+").
#pragma once

#include "core/edges/edgescan_plus/noise_memory.h"
#include "core/edges/edgescan_plus/range_field.h"
#include "core/edges/settings/settings.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "core/scan/grid/inverse_range.h"

namespace edgescan {

/// The sliders (docs/method.md, "Sliders"). Automatic values follow the noise of the scan (step 6).
struct DepthEdgeSettings {
    double jumpMm = -1.0;       ///< J0; below 0: 30 mm x noise / that of an LMS511
    double jumpGrowth = 0.01;   ///< p: share of the range
    double creaseDeg = 30.0;    ///< C0: dihedral angle
    double sensitivity = 1.0;   ///< high threshold of the hysteresis
    double hysteresisLow = 0.7; ///< share of the high one
    int minimumLength = 5;      ///< cells
    double grazing = 0.1;       ///< g: index steps that a grazing surface may be out of place
    double noiseAt5mMm = -1.0;  ///< sigma at 5 m; below 0: measured
    NoiseKind noiseKind = NoiseKind::Measured;
    bool straighten = true; ///< interlaced beams and slipped lines are measured and taken into account
    bool jumps = true;
    bool convex = true;
    bool concave = true;
    bool silhouettes = true; ///< the near side of a void, where it is certain (core/edges/edgescan_plus/silhouettes.h)
    bool border = false;     ///< where the data end: nobody knows what is there, so it is no edge of a rock (docs/operator.md, "S3")
};

enum class DepthEdge : std::uint8_t { None = 0, Jump = 1, Convex = 2, Concave = 3, Border = 4, Silhouette = 5 };
inline constexpr int kDepthEdges = 6; // None included

/// The strength of jumps and creases per cell, before anything is decided. 1 = at the threshold; 0 where a neighbour is stronger or
/// nothing was measured. Depends only on jumpMm, jumpGrowth, creaseDeg, grazing, noiseAt5mMm and straighten: when another slider moves,
/// decideDepthEdges() alone runs again.
struct DepthResponses {
    Grid<float> jump;                       ///< lines x beams
    Grid<float> crease;                     ///< lines x beams; positive: convex, negative: concave
    RangeNoise noise;                       ///< measured or typed
    double jumpMm = 0;                      ///< J0, automatic or typed
    NoiseScales scales;                     ///< of the noise as measured
    RangeNoise foldNoise;                   ///< what folds are compared with: `noise` where it is white
    bool neighboursAlike = false;           ///< the noise has memory, or was said to have
    std::vector<std::uint32_t> border;      ///< measured cells beside a void of more than 4 cells, ascending
    std::vector<std::uint32_t> silhouettes; ///< of these, the near sides of an outline (core/edges/edgescan_plus/silhouettes.h), ascending
};

struct DepthEdges {
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge; never a cell without a range that was measured, or filled on request
    Grid<DepthEdge> kind;    ///< lines x beams
    RangeNoise noise;        ///< measured or typed
};

/// Steps 1 and 6: the sweep cleaned, and its noise. Of all the sliders only `straighten` and `noiseKind` change it.
struct DepthSurface {
    InverseRange inverse;
    SweepSlips slips;
    AngularSteps steps;
    RangeNoise noise;
    double spacingMm = 0;
    NoiseScales scales;
    MemoryNoise memory; ///< what the noise is where its cells err alike; nothing where nobody needs it
};
[[nodiscard]] DepthSurface depthSurface(const Scan& scan, bool straighten, int threads = 0, NoiseKind noise = NoiseKind::Measured);

/// The same with filled gaps: noise, slips and echoes of dust are those of what was measured, then filled cells become Support::Wanted.
/// Null: the surface as it is.
[[nodiscard]] DepthSurface withFilledGaps(DepthSurface surface, const GapFilling* filling);

/// The thresholds of all stages, from sliders and noise.
[[nodiscard]] DepthLimits depthLimits(const DepthSurface& surface, const DepthEdgeSettings& settings);

/// What lies between the edges: the surface and its cracks before a neighbour suppresses anything. Grids are lines x beams.
struct DepthCracks {
    Grid<float> smoothed;  ///< 1/m: mixed pixels snapped, smoothed along surfaces
    Grid<float> jumpBeams; ///< S_J of the crack between a cell and the next beam; over 1 the surface breaks there; 0 beside a void
    Grid<float> jumpLines; ///< likewise towards the next line
    Grid<float> foldBeams; ///< S_C of a cell along the beams; positive: convex, negative: concave
    Grid<float> foldLines; ///< likewise along the lines
};

/// Steps 2 to 5. `cracks`: filled on the way where it is not null; the responses are the same, with any number of threads
/// (0: as many as pay).
[[nodiscard]] DepthResponses depthResponses(const DepthSurface& surface, const DepthEdgeSettings& settings, DepthCracks* cracks = nullptr,
                                            int threads = 0);

/// What is decided on: the response of the classes that are wanted, 1 = at the threshold. Lines x beams.
[[nodiscard]] Grid<float> depthStrength(const DepthResponses& responses, const DepthEdgeSettings& settings);

/// Chains (8 neighbours) of cells above `low` that reach `high` somewhere and have `minimum` cells at least: 255, else 0.
[[nodiscard]] Grid<std::uint8_t> linkedChains(const Grid<float>& strength, float high, float low, int minimum);

/// The silhouettes, ascending, in chains of `minimum` cells at least; two cells within two of each other are linked.
[[nodiscard]] std::vector<std::uint32_t> longSilhouettes(const DepthResponses& responses, int minimum);

/// Step 7: classes, hysteresis and minimum length. The same with any number of threads (0: as many as pay).
[[nodiscard]] DepthEdges decideDepthEdges(const DepthResponses& responses, const DepthEdgeSettings& settings, int threads = 1);

} // namespace edgescan
