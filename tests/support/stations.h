// Two stations of one bell with known truth: simulated scans, the second one placed with an error.
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/base/angles.h"
#include "core/inspect/registration/placed_scan.h"
#include "core/scan/georef/rotations.h"

#include <Eigen/Geometry>

#include <cmath>
#include <memory>

namespace edgescan::test {

struct Stations {
    inspect::PlacedScan fixed, moved; ///< in the frame of the first station; the second one is displaced by `error`
    RigidTransform error;

    /// The distance that remains at a point 6 m above the first station, metres, and the angle that remains, degrees.
    [[nodiscard]] double leftM(const RigidTransform& correction) const {
        const Eigen::Vector3d there(0, 0, 6);
        return (correction * (error * there) - there).norm();
    }
    [[nodiscard]] double leftDeg(const RigidTransform& correction) const {
        return degrees(Eigen::AngleAxisd(correction.rotation * error.rotation).angle());
    }
};

[[nodiscard]] inline std::shared_ptr<const Scan> scanFrom(const RigidTransform& station, std::uint64_t seed, int repeat, int lines,
                                                          int beams) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.repeat = repeat;
    settings.lines = lines;
    settings.beams = beams;
    settings.station = station;
    return std::make_shared<const Scan>(sim::simulate(settings)->scan);
}

/// The second station is `apartM` to the side and turned by 20 degrees; its pose is wrong by `errorM` and `errorDeg`.
[[nodiscard]] inline Stations twoStations(std::uint64_t seed, double apartM, double errorM, double errorDeg, int lines = 100,
                                          int beams = 120) {
    const RigidTransform place{rotationRpyDeg({8, -6, 20}), Eigen::Vector3d(apartM, -0.4 * apartM, 0.1)};
    const Eigen::Vector3d way = Eigen::Vector3d(1 + static_cast<double>(seed % 3), -1, 0.7).normalized();
    const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 1, -0.5 + static_cast<double>(seed % 2)).normalized();
    Stations stations;
    stations.error = {rotationAbout(axis, radians(errorDeg)), errorM * way};
    stations.fixed = inspect::placedBy(scanFrom({}, seed, 0, lines, beams), {});
    stations.moved = inspect::placedBy(scanFrom(place, seed, 1, lines, beams), stations.error * place);
    return stations;
}

} // namespace edgescan::test
