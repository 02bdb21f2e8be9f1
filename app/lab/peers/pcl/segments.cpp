// PCL's segmentations of a cloud: region growing over normals, and LCCP, which joins supervoxels at convex borders.
#include "app/lab/peers/pcl/points.h"

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <numbers>

namespace edgescan::lab {
namespace {

// Chosen on a tuning scene of docs/measurements/make-rocks with ten trials each, because PCL has no defaults for most of them.
constexpr int kNormalPoints = 30;
constexpr unsigned kGrowNeighbours = 30;
constexpr float kGrowSmoothnessDeg = 20.0F;
constexpr float kGrowCurvature = 0.03F;
constexpr int kFewestPoints = 30;
constexpr float kVoxelM = 0.05F;
constexpr float kSeedM = 0.2F;
constexpr float kConcavityDeg = 20.0F;
constexpr float kSmoothness = 0.2F;

float radians(float degrees) { return degrees * std::numbers::pi_v<float> / 180.0F; }

PclEdges segmentsOf(const PclScan& scan, StepClock& clock) {
    PclEdges result;
    result.segments = Grid<std::uint32_t>(scan.pointsM.lines, scan.pointsM.beams);
    result.steps = clock.popSteps();
    return result;
}

} // namespace

PclEdges grownRegions(const PclScan& scan) {
    StepClock clock;
    const MeasuredPoints points = measuredPoints(scan);
    const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
    clock.ended("conversion");

    const auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud(points.cloud);
    estimation.setSearchMethod(tree);
    estimation.setKSearch(kNormalPoints);
    estimation.compute(*normals);
    clock.ended("normals");

    pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
    growing.setMinClusterSize(kFewestPoints);
    growing.setMaxClusterSize(static_cast<int>(points.cloud->size()));
    growing.setSearchMethod(tree);
    growing.setNumberOfNeighbours(kGrowNeighbours);
    growing.setInputCloud(points.cloud);
    growing.setInputNormals(normals);
    growing.setSmoothnessThreshold(radians(kGrowSmoothnessDeg));
    growing.setCurvatureThreshold(kGrowCurvature);
    std::vector<pcl::PointIndices> clusters;
    growing.extract(clusters);
    clock.ended("segments");

    PclEdges result = segmentsOf(scan, clock);
    for (std::size_t n = 0; n < clusters.size(); ++n) {
        for (const auto point : clusters[n].indices)
            result.segments[points.cells[static_cast<std::size_t>(point)]] = static_cast<std::uint32_t>(n + 1);
    }
    return result;
}

PclEdges convexPatches(const PclScan& scan) {
    StepClock clock;
    const MeasuredPoints points = measuredPoints(scan);
    clock.ended("conversion");

    pcl::SupervoxelClustering<pcl::PointXYZ> supervoxels(kVoxelM, kSeedM);
    supervoxels.setUseSingleCameraTransform(false);
    supervoxels.setInputCloud(points.cloud);
    supervoxels.setColorImportance(0.0F);
    supervoxels.setSpatialImportance(1.0F);
    supervoxels.setNormalImportance(4.0F);
    std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZ>::Ptr> clusters;
    supervoxels.extract(clusters);
    std::multimap<std::uint32_t, std::uint32_t> neighbours;
    supervoxels.getSupervoxelAdjacency(neighbours);
    clock.ended("supervoxels");

    pcl::LCCPSegmentation<pcl::PointXYZ> convex;
    convex.setConcavityToleranceThreshold(kConcavityDeg);
    convex.setSanityCheck(true);
    convex.setSmoothnessCheck(true, kVoxelM, kSeedM, kSmoothness);
    convex.setKFactor(1);
    convex.setInputSupervoxels(clusters, neighbours);
    convex.setMinSegmentSize(0);
    convex.segment();
    pcl::PointCloud<pcl::PointXYZL> labelled = *supervoxels.getLabeledCloud();
    convex.relabelCloud(labelled);
    clock.ended("segments");

    PclEdges result = segmentsOf(scan, clock);
    for (std::size_t n = 0; n < labelled.size() && n < points.cells.size(); ++n) result.segments[points.cells[n]] = labelled[n].label;
    return result;
}

} // namespace edgescan::lab
