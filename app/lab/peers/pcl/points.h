// Converts a scan to PCL's types.
#pragma once

#include "app/lab/peers/peers.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace edgescan::lab {

inline constexpr int kNormalWindow = 10; ///< window, in cells, over which OrganizedEdgeFromNormals averages normals: PCL's default

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

/// An organised cloud, beams wide and lines high; NaN without a range.
[[nodiscard]] PclCloud::Ptr organisedCloud(const Grid<Eigen::Vector3f>& pointsM);

/// The cells with a range, and their points in the same order.
struct MeasuredPoints {
    std::vector<std::size_t> cells;
    PclCloud::Ptr cloud;
};
[[nodiscard]] MeasuredPoints measuredPoints(const PclScan& scan);

/// Thread CPU time between two readings, with a name for each.
class StepClock {
public:
    StepClock();
    /// Ends the step that began with the last call (or with the construction).
    void ended(const char* step);
    [[nodiscard]] double secondsSinceStart() const;
    [[nodiscard]] std::vector<edges::StageTime> popSteps() { return std::move(steps_); }

private:
    double start_, last_;
    std::vector<edges::StageTime> steps_;
};

// The PCL methods, one file each. They may throw, and PCL may crash in any of them.
[[nodiscard]] PclEdges boundaryEstimation(const PclScan& scan, const PclLimits& limits, bool radius);
[[nodiscard]] PclEdges rangeImageBorders(const PclScan& scan);
[[nodiscard]] PclEdges organizedEdges(const PclScan& scan, bool unrolled);
[[nodiscard]] PclEdges grownRegions(const PclScan& scan);
[[nodiscard]] PclEdges convexPatches(const PclScan& scan);

} // namespace edgescan::lab
