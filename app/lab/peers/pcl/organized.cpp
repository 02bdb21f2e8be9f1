// PCL's OrganizedEdgeFromNormals: discontinuities of depth, and Canny on normals.
#include "app/lab/peers/pcl/points.h"

#include <pcl/features/integral_image_normal.h>
#include <pcl/features/organized_edge_detection.h>

namespace edgescan::lab {
namespace {

using Detector = pcl::OrganizedEdgeFromNormals<pcl::PointXYZ, pcl::Normal, pcl::Label>;

constexpr float kDepthStep = 0.02F; // share of the depth: PCL's default

} // namespace

PclEdges organizedEdges(const PclScan& scan, bool unrolled) {
    StepClock clock;
    const PclCloud::Ptr cloud = organisedCloud(unrolled ? scan.unrolledM : scan.pointsM);
    clock.ended("conversion");

    const auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
    pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
    estimation.setMaxDepthChangeFactor(kDepthStep);
    estimation.setNormalSmoothingSize(static_cast<float>(kNormalWindow));
    estimation.setInputCloud(cloud);
    estimation.compute(*normals);
    clock.ended("normals");

    Detector detector;
    detector.setInputCloud(cloud);
    detector.setInputNormals(normals);
    detector.setDepthDisconThreshold(kDepthStep);
    detector.setMaxSearchNeighbors(50);
    detector.setEdgeType(Detector::EDGELABEL_NAN_BOUNDARY | Detector::EDGELABEL_OCCLUDING | Detector::EDGELABEL_OCCLUDED |
                         Detector::EDGELABEL_HIGH_CURVATURE);
    pcl::PointCloud<pcl::Label> labels;
    std::vector<pcl::PointIndices> unused;
    detector.compute(labels, unused);
    clock.ended("edges");

    PclEdges result;
    result.mask = Grid<std::uint8_t>(scan.pointsM.lines, scan.pointsM.beams);
    const auto classOf = [&](const char* name, std::uint32_t bit, bool counts) {
        PclClass one{name, Grid<std::uint8_t>(scan.pointsM.lines, scan.pointsM.beams), counts};
        for (std::size_t k = 0; k < labels.size(); ++k) {
            if ((labels[k].label & bit) == 0 || !scan.pointsM[k].allFinite()) continue;
            one.mask[k] = 255;
            if (counts) result.mask[k] = 255;
        }
        result.classes.push_back(std::move(one));
    };
    classOf("occluding", Detector::EDGELABEL_OCCLUDING, true);
    classOf("occluded", Detector::EDGELABEL_OCCLUDED, false);
    classOf("border of missing data", Detector::EDGELABEL_NAN_BOUNDARY, false);
    classOf("high curvature", Detector::EDGELABEL_HIGH_CURVATURE, true);
    clock.ended("merge");
    result.steps = clock.popSteps();
    return result;
}

} // namespace edgescan::lab
