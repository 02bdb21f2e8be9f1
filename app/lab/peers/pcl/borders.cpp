// PCL's RangeImageBorderExtractor on the scan's own grid.
#include "app/lab/peers/pcl/points.h"

#include <pcl/features/range_image_border_extractor.h>
#include <pcl/range_image/range_image.h>

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

// A range image whose pixels are the cells of a scan: without resampling, so that every border is a cell.
class GridRangeImage : public pcl::RangeImage {
public:
    explicit GridRangeImage(const PclScan& scan) : directions_(scan.directions) {
        const PclCloud::Ptr cloud = organisedCloud(scan.pointsM);
        width = cloud->width;
        height = cloud->height;
        is_dense = false;
        points.resize(cloud->size(), unobserved_point);
        for (std::size_t k = 0; k < cloud->size(); ++k) {
            const pcl::PointXYZ& from = (*cloud)[k];
            if (!pcl::isFinite(from)) continue;
            points[k].x = from.x;
            points[k].y = from.y;
            points[k].z = from.z;
            points[k].range = from.getVector3fMap().norm();
        }
    }

    void calculate3DPoint(float imageX, float imageY, float range, Eigen::Vector3f& point) const override {
        const int beam = std::clamp(static_cast<int>(std::lround(imageX)), 0, static_cast<int>(width) - 1);
        const int line = std::clamp(static_cast<int>(std::lround(imageY)), 0, static_cast<int>(height) - 1);
        point = directions_.at(line, beam) * range;
    }

private:
    const Grid<Eigen::Vector3f>& directions_;
};

} // namespace

PclEdges rangeImageBorders(const PclScan& scan) {
    StepClock clock;
    const GridRangeImage image(scan);
    clock.ended("range image");
    pcl::RangeImageBorderExtractor extractor(&image);
    pcl::PointCloud<pcl::BorderDescription> borders;
    extractor.compute(borders);
    clock.ended("edges");

    PclEdges result;
    result.mask = Grid<std::uint8_t>(scan.pointsM.lines, scan.pointsM.beams);
    PclClass object{"object border", result.mask, true};
    PclClass shadow{"shadow border", result.mask, false};
    PclClass veil{"veil point", result.mask, false};
    for (std::size_t k = 0; k < borders.size(); ++k) {
        const pcl::BorderTraits& traits = borders[k].traits;
        if (!scan.pointsM[k].allFinite()) continue;
        if (traits[pcl::BORDER_TRAIT__OBSTACLE_BORDER]) object.mask[k] = 255;
        if (traits[pcl::BORDER_TRAIT__SHADOW_BORDER]) shadow.mask[k] = 255;
        if (traits[pcl::BORDER_TRAIT__VEIL_POINT]) veil.mask[k] = 255;
    }
    result.mask = object.mask;
    result.classes = {std::move(object), std::move(shadow), std::move(veil)};
    clock.ended("merge");
    result.steps = clock.popSteps();
    return result;
}

} // namespace edgescan::lab
