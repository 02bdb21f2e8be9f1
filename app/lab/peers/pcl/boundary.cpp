// PCL's BoundaryEstimation: a point is on a boundary if the directions to its neighbours have a wide gap.
#include "app/lab/peers/pcl/points.h"

#include <pcl/features/boundary.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <numbers>

namespace edgescan::lab {
namespace {

constexpr std::size_t kChunk = 2000; // points between two checks of the time

} // namespace

PclEdges boundaryEstimation(const PclScan& scan, const PclLimits& limits, bool radius) {
    StepClock clock;
    const MeasuredPoints points = measuredPoints(scan);
    const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
    tree->setInputCloud(points.cloud);
    clock.ended("conversion");

    const auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
    normals->resize(points.cloud->size());
    PclEdges result;
    result.mask = Grid<std::uint8_t>(scan.pointsM.lines, scan.pointsM.beams);
    // Chunks distributed over the whole scan, so that the part processed within the time limit represents the rest.
    const std::size_t chunks = (points.cells.size() + kChunk - 1) / kChunk;
    std::size_t done = 0;
    double normalMs = 0;
    double boundaryMs = 0;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        if (done > 0 && clock.secondsSinceStart() > limits.seconds) break;
        const auto indices = std::make_shared<pcl::Indices>();
        for (std::size_t n = chunk; n < points.cells.size(); n += chunks) indices->push_back(static_cast<pcl::index_t>(n));
        const double before = clock.secondsSinceStart();
        pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> normalEstimation;
        normalEstimation.setInputCloud(points.cloud);
        normalEstimation.setIndices(indices);
        normalEstimation.setSearchMethod(tree);
        pcl::BoundaryEstimation<pcl::PointXYZ, pcl::Normal, pcl::Boundary> boundary;
        boundary.setInputCloud(points.cloud);
        boundary.setIndices(indices);
        boundary.setInputNormals(normals);
        boundary.setSearchMethod(tree);
        boundary.setAngleThreshold(std::numbers::pi_v<float> / 2);
        if (radius) {
            normalEstimation.setRadiusSearch(limits.radiusM);
            boundary.setRadiusSearch(limits.radiusM);
        } else {
            normalEstimation.setKSearch(limits.neighbours);
            boundary.setKSearch(limits.neighbours);
        }
        pcl::PointCloud<pcl::Normal> some;
        normalEstimation.compute(some);
        for (std::size_t n = 0; n < indices->size(); ++n) (*normals)[static_cast<std::size_t>((*indices)[n])] = some[n];
        const double between = clock.secondsSinceStart();
        pcl::PointCloud<pcl::Boundary> edges;
        boundary.compute(edges);
        for (std::size_t n = 0; n < indices->size(); ++n) {
            if (edges[n].boundary_point != 0) result.mask[points.cells[static_cast<std::size_t>((*indices)[n])]] = 255;
        }
        normalMs += 1000 * (between - before);
        boundaryMs += 1000 * (clock.secondsSinceStart() - between);
        done += indices->size();
    }
    result.share = points.cells.empty() ? 1.0 : static_cast<double>(done) / static_cast<double>(points.cells.size());
    result.steps = clock.popSteps();
    result.steps.push_back({"normals", normalMs});
    result.steps.push_back({"edges", boundaryMs});
    result.classes.push_back({"boundary", result.mask, true});
    return result;
}

} // namespace edgescan::lab
