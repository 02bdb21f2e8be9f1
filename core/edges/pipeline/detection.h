// Everything that one run of the method produced for one scan and one set of settings. Made once, never changed.
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/gray/gray.h"
#include "core/edges/settings/parameters.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace edgescan {

struct StageTime {
    std::string stage;
    double milliseconds = 0.0;
    double cpuMilliseconds = 0.0; ///< of the thread that ran it
    Stage of = Stage::Edges;
};
/// Of this thread, for differences.
[[nodiscard]] double threadCpuMilliseconds();

struct Detection {
    std::shared_ptr<const Scan> scan;
    Settings settings;
    std::shared_ptr<const GrayImage> gray;
    std::shared_ptr<const Grid<std::uint8_t>> masked;   ///< lines x beams, 255 = takes no part in a method on gray levels; null: all do
    std::shared_ptr<const Grid<std::uint8_t>> smoothed; ///< lines x beams, what the gradient saw; null where the method has none
    std::shared_ptr<const Grid<std::uint8_t>> mask;     ///< lines x beams, 255 = edge
    std::shared_ptr<const Grid<DepthEdge>> classes;     ///< lines x beams; null where the method tells no classes apart
    std::shared_ptr<const GapFilling> filled;           ///< gaps that were filled; null unless that was asked for
    std::shared_ptr<const DepthSurface> surface;        ///< the sweep as EdgeScan+ cleaned it; null for other methods
    std::shared_ptr<const DepthCracks> cracks;          ///< what lies between its edges; null unless the pipeline keeps it
    std::shared_ptr<const DepthResponses> responses;    ///< what EdgeScan+ measured; null for other methods
    std::shared_ptr<const std::vector<std::uint32_t>> edges; ///< indices of the edge cells, ascending
    std::vector<StageTime> timings;                          ///< only the stages that were run again
    double totalMs = 0.0;
};

/// What the automatic values came out as.
[[nodiscard]] Measured measuredOf(const Detection& detection);

/// Edge cells by DepthEdge; all 0 where the method tells no classes apart.
[[nodiscard]] std::array<std::size_t, kDepthEdges> countClasses(const Detection& detection);

} // namespace edgescan
