// Converts a scan to PCL's types.
#include "app/lab/peers/pcl/points.h"

#include <ctime>
#include <memory>

namespace edgescan::lab {
namespace {

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

PclCloud::Ptr organisedCloud(const Grid<Eigen::Vector3f>& pointsM) {
    const auto cloud = std::make_shared<PclCloud>(static_cast<std::uint32_t>(pointsM.beams), static_cast<std::uint32_t>(pointsM.lines));
    cloud->is_dense = false;
    for (std::size_t k = 0; k < pointsM.size(); ++k) (*cloud)[k].getVector3fMap() = pointsM[k];
    return cloud;
}

MeasuredPoints measuredPoints(const PclScan& scan) {
    MeasuredPoints all{{}, std::make_shared<PclCloud>()};
    for (std::size_t k = 0; k < scan.pointsM.size(); ++k) {
        if (!scan.pointsM[k].allFinite()) continue;
        pcl::PointXYZ point;
        point.getVector3fMap() = scan.pointsM[k];
        all.cloud->push_back(point);
        all.cells.push_back(k);
    }
    return all;
}

StepClock::StepClock() : start_(threadSeconds()), last_(start_) {}

void StepClock::ended(const char* step) {
    const double now = threadSeconds();
    steps_.push_back({step, 1000.0 * (now - last_)});
    last_ = now;
}

double StepClock::secondsSinceStart() const { return threadSeconds() - start_; }

} // namespace edgescan::lab
