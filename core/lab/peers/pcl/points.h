// Converts a scan to PCL's types.
#pragma once

#include "core/lab/peers/peers.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace edgescan {

inline constexpr int kNormalWindow = 10; ///< window, in cells, over which OrganizedEdgeFromNormals averages normals: PCL's default

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

/// An organised cloud, beams wide and lines high; NaN without a range.
[[nodiscard]] PclCloud::Ptr organisedCloud(const Grid<Eigen::Vector3f>& pointsM);

/// The cells with a range, and their points in the same order.
struct MeasuredPoints {
    std::vector<std::size_t> cells;
    PclCloud::Ptr cloud;
};
[[nodiscard]] MeasuredPoints measuredPoints(const PeerScan& scan);

/// Thread CPU time between two readings, with a name for each.
class StepClock {
public:
    StepClock();
    /// Ends the step that began with the last call (or with the construction).
    void ended(const char* step);
    [[nodiscard]] double secondsSinceStart() const;
    [[nodiscard]] std::vector<StageTime> take() { return std::move(steps_); }

private:
    double start_, last_;
    std::vector<StageTime> steps_;
};

// The PCL methods, one file each. They may throw, and PCL may crash in any of them.
[[nodiscard]] PeerEdges boundaryEstimation(const PeerScan& scan, const PeerLimits& limits, bool radius);
[[nodiscard]] PeerEdges rangeImageBorders(const PeerScan& scan);
[[nodiscard]] PeerEdges organizedEdges(const PeerScan& scan, bool unrolled);
[[nodiscard]] PeerEdges grownRegions(const PeerScan& scan);
[[nodiscard]] PeerEdges convexPatches(const PeerScan& scan);

} // namespace edgescan
