// EdgeScan+: jumps and creases of the surface, measured relative to straight lines in inverse range (docs/method/edges.md, "EdgeScan+").
#pragma once

#include "core/edges/edgescan_plus/noise_memory.h"
#include "core/edges/edgescan_plus/range_field.h"
#include "core/edges/edgescan_plus/roughness.h"
#include "core/edges/edgescan_plus/void_rim.h"
#include "core/edges/settings/settings.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "core/scan/grid/inverse_range.h"

#include <memory>

namespace edgescan::edges {

/// The strength of jumps and creases per cell, before the decision. 1 = at the threshold; 0 where a neighbour is stronger or the cell was
/// not measured. Depends only on the settings that feed Stage::Surface and Stage::Responses; if another setting changes,
/// only decideDepthEdges() runs again.
struct DepthResponses {
    std::shared_ptr<const Grid<float>> jump; ///< lines x beams
    Grid<float> crease;                      ///< lines x beams; positive: convex, negative: concave; weighed if the scan is rough
    RangeNoise noise;                        ///< measured or typed, mm
    double jumpMm = 0;                       ///< J0, automatic or typed, mm
    NoiseScales scales;                      ///< of the measured noise
    RangeNoise foldNoise;                    ///< the noise for folds: what smoothing leaves of `noise` if that is white
    bool neighboursAlike = false;            ///< the errors of neighbours are correlated: measured, or set by noiseKind
    std::vector<std::uint32_t> border;       ///< measured cells next to a void of more than 4 cells, ascending
    /// those of `border` and beyond that are near sides of an outline (core/edges/edgescan_plus/silhouettes.h), ascending
    std::vector<std::uint32_t> silhouettes;
    Roughness roughness;            ///< nothing if the settings do not ask for it
    Grid<float> unweighed;          ///< `crease` before it was weighed; empty unless the scan is rough
    std::vector<std::uint32_t> rim; ///< those of `border` at an open void (core/edges/edgescan_plus/void_rim.h), ascending
};

struct DepthEdges {
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge; an edge cell always has a range that was measured, or filled on request
    Grid<DepthEdge> kind;    ///< lines x beams
    RangeNoise noise;        ///< measured or typed
};

/// Steps 1 and 6: the cleaned sweep and its noise. Only settings that feed Stage::Surface change it.
struct DepthSurface {
    InverseRange inverse;
    SweepSlips slips;
    AngularSteps steps;
    RangeNoise noise;   ///< measured: for tolerances
    RangeNoise steady;  ///< for thresholds; both are `ofRange` if errors of neighbours are correlated
    RangeNoise ofRange; ///< noiseByRange(): for spikes, and for thresholds under the rules of default set 4
    double spacingMm = 0;
    NoiseScales scales;
    MemoryNoise memory;            ///< the noise if errors of neighbours are correlated; empty if it is not needed
    std::vector<CellRun> withheld; ///< cells left out by a filter or lost, ascending: not open voids
    double smoothed = 0;           ///< share of smoothNoise() in `inverse`, 0 to 1
};
[[nodiscard]] DepthSurface depthSurface(const Scan& scan, const Settings& settings, int threads = 0);

/// The same with filled gaps. Noise, slips and dust echoes are those of the measured cells; then filled cells become Support::Wanted. Null:
/// the surface is returned unchanged.
[[nodiscard]] DepthSurface withFilledGaps(DepthSurface surface, const GapFilling* filling);

/// The thresholds of all stages, from settings and noise.
[[nodiscard]] DepthLimits depthLimits(const DepthSurface& surface, const Settings& settings);

/// The surface and its cracks before non-maximum suppression. Grids are lines x beams.
struct DepthCracks {
    Grid<float> smoothed;  ///< 1/m: mixed pixels moved to a surface, smoothed along surfaces
    Grid<float> jumpBeams; ///< S_J of the crack between a cell and the next beam; above 1 the surface breaks there; 0 next to a void
    Grid<float> jumpLines; ///< the same towards the next line
    Grid<float> foldBeams; ///< S_C of a cell along the beams; positive: convex, negative: concave
    Grid<float> foldLines; ///< the same along the lines
};

class StoredFolds;

/// Steps 2 to 5. Fills `cracks` and `folds` if they are not null; the responses are the same with and without them, and with any number of
/// threads (0: as many as make it faster).
[[nodiscard]] DepthResponses depthResponses(const DepthSurface& surface, const Settings& settings, DepthCracks* cracks = nullptr,
                                            int threads = 0, StoredFolds* folds = nullptr);

/// depthResponses() to the last bit, with settings that differ only in the crease angle, which StoredFolds::covers(). `before`, `folds`: of
/// another crease angle.
[[nodiscard]] DepthResponses withCreaseAngle(const DepthResponses& before, const StoredFolds& folds, const DepthSurface& surface,
                                             const Settings& settings, int threads = 0);

/// The values on which the decision is based: the response of the requested classes, 1 = at the threshold. Lines x beams.
[[nodiscard]] Grid<float> requestedStrength(const DepthResponses& responses, const Settings& settings);
/// The same for cell `k` alone.
/// The same of one line, into as many values as it has beams.
void requestedStrengthsOfLine(const DepthResponses& responses, const Settings& settings, int line, float* strengths);
[[nodiscard]] float requestedStrengthAt(const DepthResponses& responses, const Settings& settings, std::size_t k);

/// Hysteresis: chains (8 neighbours) of cells above `low` that contain a cell above `high` and at least `minimum` cells: 255, otherwise 0.
/// Lines x beams.
[[nodiscard]] Grid<std::uint8_t> linkedChains(const Grid<float>& strength, float high, float low, int minimum);

/// Edge cells of one class, ascending.
struct ClassCells {
    DepthEdge kind = DepthEdge::None;
    std::vector<std::uint32_t> cells;
};
/// The requested classes that no threshold decides, in the order in which they take cells: silhouettes and the rims of open voids, both in
/// chains of the minimum length (two cells at most two cells apart are linked), and data borders.
[[nodiscard]] std::vector<ClassCells> edgesAtVoids(const DepthResponses& responses, const Settings& settings);

/// Step 7: classes, hysteresis and minimum length. The result is the same for any number of threads (0: as many as make it faster).
[[nodiscard]] DepthEdges decideDepthEdges(const DepthResponses& responses, const Settings& settings, int threads = 1);

} // namespace edgescan::edges
