// The results of one run of the method for one scan and one set of settings. Immutable after construction.
#pragma once

#include "core/base/grid.h"
#include "core/base/made_when_read.h"
#include "core/edges/settings/settings.h"
#include "core/edges/settings/stage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {
struct GapFilling;
struct Scan;
} // namespace edgescan

namespace edgescan::edges {

using BorderPercent = std::uint8_t; // core/edges/rock_borders/rock_borders.h
struct DepthCracks;
struct DepthResponses;
struct DepthSurface;
struct GrayImage;
struct Measured;

struct StageTime {
    std::string stage;
    double milliseconds = 0.0;
    double cpuMilliseconds = 0.0; ///< of the thread that ran it
    Stage of = Stage::Edges;
};
/// CPU time of this thread, for differences.
[[nodiscard]] double threadCpuMilliseconds();

struct Detection {
    std::shared_ptr<const Scan> scan;
    Settings settings;
    MadeWhenRead<GrayImage> gray;                     ///< methods that read it have made it
    std::shared_ptr<const Grid<std::uint8_t>> masked; ///< lines x beams, 255 = ignored by methods on gray levels; null: they use all cells
    std::shared_ptr<const Grid<std::uint8_t>> smoothed;      ///< lines x beams, the input of the gradient; null if the method has none
    std::shared_ptr<const Grid<std::uint8_t>> mask;          ///< lines x beams, 255 = edge
    std::shared_ptr<const Grid<DepthEdge>> classes;          ///< lines x beams; null if the method does not distinguish classes
    std::shared_ptr<const GapFilling> filled;                ///< filled gaps; null unless the settings fill gaps
    std::shared_ptr<const DepthSurface> surface;             ///< the sweep after EdgeScan+'s cleaning; null for other methods
    std::shared_ptr<const DepthCracks> cracks;               ///< the surface and its cracks; null unless the pipeline stores them
    std::shared_ptr<const DepthResponses> responses;         ///< EdgeScan+'s responses; null for other methods
    std::shared_ptr<const std::vector<std::uint32_t>> edges; ///< indices of the edge cells, ascending
    /// probability of each of `edges` to be the border of a rock, %, in their order; empty for methods that do not measure the surface
    MadeWhenRead<std::vector<BorderPercent>> borders;
    std::vector<StageTime> timings; ///< only of the stages that were run again
    double totalMs = 0.0;
};

/// The values of automatic settings on this scan.
[[nodiscard]] Measured measuredOf(const Detection& detection);

/// Number of edge cells by DepthEdge; all 0 if the method does not distinguish classes.
[[nodiscard]] std::array<std::size_t, kDepthEdges> countClasses(const Detection& detection);

/// Edge cells by their probability to be the border of a rock: from kStrongBorder on, from kWeakBorder on, below, unknown.
struct BorderCounts {
    std::size_t strong = 0, weak = 0, folds = 0, unknown = 0;
};
/// All 0 if the method does not measure the surface.
[[nodiscard]] BorderCounts countBorders(const Detection& detection);

/// The edge cell nearest to a cell, which may be that cell itself, of those up to `reach` lines and beams away; empty: all of them are
/// without an edge.
[[nodiscard]] std::optional<std::size_t> nearestEdge(const Grid<std::uint8_t>& mask, std::size_t cell, int reach);
/// The same within so many lines and beams; `lineByBeam`: the distance from line to line, in distances from beam to beam.
[[nodiscard]] std::optional<std::size_t> nearestEdge(const Grid<std::uint8_t>& mask, std::size_t cell, int lines, int beams,
                                                     double lineByBeam);

} // namespace edgescan::edges
