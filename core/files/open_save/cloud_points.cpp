// Collects the points of a cloud.
#include "core/files/open_save/cloud_points.h"

#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan::files {

Result<std::vector<Eigen::Vector3f>> cloudPoints(const std::filesystem::path& path) {
    const Result<Scan> cloud = openScan(path);
    if (!cloud) return cloud.error();
    const CartesianTables tables(*cloud);
    std::vector<Eigen::Vector3f> points;
    for (std::size_t k = 0; k < cloud->cells(); ++k) {
        if (cloud->state[k] == CellState::Valid) points.emplace_back(tables.point(k).cast<float>());
    }
    for (const AttachedPoint& point : cloud->attached) points.emplace_back(point.pointM.cast<float>());
    return points;
}

} // namespace edgescan::files
