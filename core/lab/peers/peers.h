// The Point Cloud Library's own edge detectors and segmentations on a scan, for comparison (thesis, chapters 4 and 6.3).
#pragma once

#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/scan/grid/scan.h"

#include <string>
#include <vector>

namespace edgescan {

enum class Peer : std::uint8_t {
    BoundaryNeighbours,    ///< BoundaryEstimation on the 30 nearest points
    BoundaryRadius,        ///< BoundaryEstimation on all points within a radius
    RangeImageBorder,      ///< RangeImageBorderExtractor on the scan's own grid
    OrganizedEdge,         ///< OrganizedEdgeFromNormals on the points as they are
    OrganizedEdgeUnrolled, ///< OrganizedEdgeFromNormals on x = beam, y = line angle times range, z = range: depth is range again
    RegionGrowing,         ///< segments: RegionGrowing over normals and curvature
    ConvexPatches,         ///< segments: LCCPSegmentation of supervoxels
};
inline constexpr int kPeers = 5; ///< those that find edges come first

[[nodiscard]] constexpr const char* peerName(Peer peer) {
    constexpr const char* kNames[]{"PCL BoundaryEstimation k=30",  "PCL BoundaryEstimation radius", "PCL RangeImageBorderExtractor",
                                   "PCL OrganizedEdgeFromNormals", "PCL OrganizedEdge, un-rolled",  "PCL RegionGrowing",
                                   "PCL LCCP on supervoxels"};
    return kNames[static_cast<std::size_t>(peer)];
}

struct PeerLimits {
    double seconds = 10.0; ///< thread CPU time after which a peer that works point by point stops; infinite = never
    int neighbours = 30;
    double radiusM = 0.1;
    std::uint64_t memoryBytes = 0; ///< of the peer's process; 0 = by the size of the scan
};

/// One kind of edge that a peer tells apart.
struct PeerClass {
    std::string name;
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge
    bool counts = true;      ///< part of PeerEdges::mask: shadow borders, veils, occluded edges and borders of holes are not
};

struct PeerEdges {
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge of the nearer surface
    std::vector<PeerClass> classes;
    std::vector<StageTime> steps; ///< milliseconds of thread CPU time
    double share = 1.0;           ///< of the points that were done before the time was up; the mask then covers only these
    Grid<std::uint32_t> segments; ///< lines x beams, 0 = none; empty for what finds edges, and `mask` for what finds segments
};

/// A scan as the peers see it: all lines x beams, metres, the sensor at 0; NaN where there is no range.
struct PeerScan {
    Grid<Eigen::Vector3f> pointsM;
    Grid<Eigen::Vector3f> directions; ///< of the beams, unit; also where there is no range
    Grid<Eigen::Vector3f> unrolledM;  ///< angles from the middle of the grid times the range, and the range as depth
};
[[nodiscard]] PeerScan peerScan(const Scan& scan);

/// Runs the detector in a process of its own (edgescan-peers, beside this program or in ../lib/edgescan): PCL may crash, hang or run out of
/// memory, and starting with PCL linked would cost every command 40 ms. Its memory and time are limited by the size of the scan.
/// Error: built without PCL, too few cells for this detector, or what ended it.
[[nodiscard]] Result<PeerEdges> runPeer(Peer peer, const PeerScan& scan, const PeerLimits& limits);

/// Error: why no peer can run here.
[[nodiscard]] Result<Done> peersArePresent();

} // namespace edgescan
