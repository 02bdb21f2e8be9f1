// The Point Cloud Library's own edge detectors and segmentations, run on a scan for comparison (thesis, chapters 4 and 6.3).
#pragma once

#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/scan/grid/scan.h"

#include <string>
#include <vector>

namespace edgescan::lab {

/// The methods of PCL.
enum class PclMethod : std::uint8_t {
    BoundaryNeighbours,    ///< BoundaryEstimation on the 30 nearest points
    BoundaryRadius,        ///< BoundaryEstimation on all points within a radius
    RangeImageBorder,      ///< RangeImageBorderExtractor on the scan's own grid
    OrganizedEdge,         ///< OrganizedEdgeFromNormals on the points without conversion
    OrganizedEdgeUnrolled, ///< OrganizedEdgeFromNormals on x = beam, y = line angle times range, z = range, so that depth is range
    RegionGrowing,         ///< segments: RegionGrowing over normals and curvature
    ConvexPatches,         ///< segments: LCCPSegmentation of supervoxels
};
inline constexpr int kPclEdgeMethods = 5; ///< number of methods that find edges; they come first

[[nodiscard]] constexpr const char* pclMethodName(PclMethod peer) {
    constexpr const char* kNames[]{"PCL BoundaryEstimation k=30",  "PCL BoundaryEstimation radius", "PCL RangeImageBorderExtractor",
                                   "PCL OrganizedEdgeFromNormals", "PCL OrganizedEdge, un-rolled",  "PCL RegionGrowing",
                                   "PCL LCCP on supervoxels"};
    return kNames[static_cast<std::size_t>(peer)];
}

struct PclLimits {
    double seconds = 10.0; ///< thread CPU time after which a method that works point by point stops; infinite = never
    int neighbours = 30;
    double radiusM = 0.1;
    std::uint64_t memoryBytes = 0; ///< of the separate process; 0 = according to the size of the scan
};

/// One kind of edge that a method distinguishes.
struct PclClass {
    std::string name;
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge
    bool counts = true;      ///< part of PclEdges::mask; false for shadow borders, veils, occluded edges and borders of holes
};

struct PclEdges {
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge of the nearer surface
    std::vector<PclClass> classes;
    std::vector<edges::StageTime> steps; ///< milliseconds of thread CPU time
    double share = 1.0;                  ///< share of the points processed within the time limit; the mask covers only these
    /// lines x beams, 0 = no segment; empty for methods that find edges; for methods that find segments `mask` is empty
    Grid<std::uint32_t> segments;
};

/// A scan as input of the PCL methods: all lines x beams, metres, sensor at the origin; NaN without a range.
struct PclScan {
    Grid<Eigen::Vector3f> pointsM;
    Grid<Eigen::Vector3f> directions; ///< unit directions of the beams, also without a range
    Grid<Eigen::Vector3f> unrolledM;  ///< angles from the middle of the grid multiplied by the range, and the range as depth
};
[[nodiscard]] PclScan pclScan(const Scan& scan);

/// Runs the method in a separate process (edgescan-peers, in the folder of this program or in ../lib/edgescan): PCL may crash, hang or use
/// up the memory, and linking PCL would make the start of every command 40 ms slower. Its memory and time are limited according to the size
/// of the scan. Error: built without PCL, too few cells for this method, or the reason why the process ended.
[[nodiscard]] Result<PclEdges> runPclMethod(PclMethod peer, const PclScan& scan, const PclLimits& limits);

/// Error: the reason why PCL methods cannot run here.
[[nodiscard]] Result<Done> checkPclIsAvailable();

} // namespace edgescan::lab
