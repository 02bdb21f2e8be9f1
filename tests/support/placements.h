// Random places in the mine, for tests.
#pragma once

#include "core/scan/georef/rotations.h"
#include "core/scan/grid/placement.h"

#include <memory>
#include <random>

namespace edgescan::test {

/// Near N 6,200,000 E 620,000; `lines` poses, or one pose for all lines if 1. The mounting differs slightly from the ideal one.
inline std::shared_ptr<const Placement> randomPlacement(unsigned seed, int lines, bool sweep) {
    std::mt19937 random(seed);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    auto placement = std::make_shared<Placement>();
    placement->mount.sensorInMover = {rotationRpyDeg({between(-1, 1), between(-1, 1), between(-1, 1)}), {0.0015, 0.004, 0.035}};
    placement->mount.axis = sweep ? Eigen::Vector3d(1, 0.01, -0.02) : Eigen::Vector3d(0.01, 0.02, 1);
    placement->mount.zeroDeg = between(-180, 180);
    placement->mount.direction = seed % 2 == 0 ? 1 : -1;
    placement->poses.clear();
    for (int i = 0; i < lines; ++i) {
        const Eigen::Vector3d rpy(between(-180, 180), between(-90, 90), between(-180, 180));
        placement->poses.push_back({rotationRpyDeg(rpy), {between(0, 100), between(0, 100), between(0, 10)}});
    }
    placement->originEnhM = {620000, 6200000, 250};
    placement->gridScale = seed % 3 == 0 ? 0.9996 : 1.0;
    placement->grid = "UTM 17N";
    placement->source = "test \"pose\"";
    placement->timeUtc = "2026-11-20T10:15:30.250Z";
    if (seed % 2 == 0) placement->scanStartUtc = "2026-11-20T10:15:20.125Z";
    placement->warnings = {"The pose carries no time, so its age is not known."};
    if (seed % 2 == 1) placement->boom = Boom{{between(-4, -2), between(-1, 1), between(-1, 1)}, {0.1, between(-0.2, 0.2), 0.3}};
    return placement;
}

} // namespace edgescan::test
