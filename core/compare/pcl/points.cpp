// A scan as PCL sees it, and the door of the module.
#include "core/compare/pcl/points.h"

#include <pcl/console/print.h>
#include <pcl/pcl_config.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <memory>

namespace edgescan {
namespace {

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Result<PeerEdges> runPeer(Peer peer, const PeerScan& scan, const PeerLimits& limits) {
    const auto points = std::ranges::count_if(scan.pointsM.cells, [](const Eigen::Vector3f& p) { return p.allFinite(); });
    if (points < 100 || scan.pointsM.lines < 8 || scan.pointsM.beams < 8)
        return Error{"PCL needs a grid of 8 x 8 cells and 100 points at least", "", "choose a larger scan"};
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // it complains that a sweep is no camera
    try {
        switch (peer) {
        case Peer::BoundaryNeighbours:
            return boundaryEstimation(scan, limits, false);
        case Peer::BoundaryRadius:
            return boundaryEstimation(scan, limits, true);
        case Peer::RangeImageBorder:
            return rangeImageBorders(scan);
        case Peer::OrganizedEdge:
            return organizedEdges(scan, false);
        case Peer::OrganizedEdgeUnrolled:
            return organizedEdges(scan, true);
        }
    } catch (const std::exception& error) {
        return Error{std::string("PCL gave up (") + error.what() + ")", "", "leave this peer out"};
    }
    return Error{"there is no such peer", "", ""};
}

} // namespace

PclCloud::Ptr organisedCloud(const Grid<Eigen::Vector3f>& pointsM) {
    const auto cloud = std::make_shared<PclCloud>(static_cast<std::uint32_t>(pointsM.beams), static_cast<std::uint32_t>(pointsM.lines));
    cloud->is_dense = false;
    for (std::size_t k = 0; k < pointsM.size(); ++k) (*cloud)[k].getVector3fMap() = pointsM[k];
    return cloud;
}

StepClock::StepClock() : start_(threadSeconds()), last_(start_) {}

void StepClock::ended(const char* step) {
    const double now = threadSeconds();
    steps_.push_back({step, 1000.0 * (now - last_)});
    last_ = now;
}

double StepClock::secondsSinceStart() const { return threadSeconds() - start_; }

} // namespace edgescan

extern "C" __attribute__((visibility("default"))) const edgescan::PeerModule* edgescanPeers() {
    static const edgescan::PeerModule module{edgescan::runPeer, PCL_VERSION_PRETTY};
    return &module;
}
