// A scanner in a box room with a few boulders, for the tests of the cloud view: ranges by ray casting, edges by jumps.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

namespace edgescan::demo {

inline double rangeM(const Eigen::Vector3d& d) {
    double nearest = 1e9;
    const Eigen::Vector3d walls(6.0, 4.0, 10.0);
    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] != 0.0) nearest = std::min(nearest, walls[axis] / std::abs(d[axis]));
    }
    struct Boulder {
        Eigen::Vector3d centre;
        double radius;
    };
    static const std::vector<Boulder> boulders = {
        {{0.0, 0.0, 6.0}, 1.2}, {{-2.6, -1.2, 7.0}, 1.0}, {{2.4, 1.0, 5.0}, 0.7}, {{1.8, -1.6, 8.0}, 1.1}, {{-1.5, 1.6, 4.5}, 0.5}};
    for (const Boulder& b : boulders) {
        const double along = d.dot(b.centre);
        const double off = b.centre.squaredNorm() - along * along;
        if (along > 0.0 && off < b.radius * b.radius) nearest = std::min(nearest, along - std::sqrt(b.radius * b.radius - off));
    }
    return nearest;
}

/// Sweep: lines over +-30 degrees, beams over +-50 degrees about the z axis; line 0 points towards +y, beam 0 towards +x. Every
/// `holeEvery`-th cell has no return (0 = all cells return).
inline std::shared_ptr<Scan> room(int lines, int beams, int holeEvery = 0) {
    auto scan = std::make_shared<Scan>();
    scan->name = "room";
    PolarGeometry geometry;
    geometry.axis = Axis::Sweep;
    for (int i = 0; i < lines; ++i) geometry.lineDeg.push_back(-30.0 + 60.0 * i / (lines - 1));
    for (int j = 0; j < beams; ++j) geometry.beamDeg.push_back(40.0 + 100.0 * j / (beams - 1));
    scan->geometry = geometry;
    scan->rangeMm = Grid<float>(lines, beams, 1000.0F);
    scan->state = Grid<CellState>(lines, beams, CellState::Valid);
    const CartesianTables tables(*scan);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const std::size_t k = scan->rangeMm.index(i, j);
            scan->rangeMm[k] = static_cast<float>(1000.0 * rangeM(tables.direction(i, j)));
            if (holeEvery > 0 && k % static_cast<std::size_t>(holeEvery) == 0) scan->state[k] = CellState::NoReturn;
        }
    }
    return scan;
}

/// Cells on the nearer side of a jump of more than 0.3 m.
inline std::shared_ptr<const std::vector<std::uint32_t>> edges(const Scan& scan) {
    auto out = std::make_shared<std::vector<std::uint32_t>>();
    for (int i = 1; i + 1 < scan.lines(); ++i) {
        for (int j = 1; j + 1 < scan.beams(); ++j) {
            const float r = scan.rangeMm.at(i, j);
            const float far =
                std::max({scan.rangeMm.at(i - 1, j), scan.rangeMm.at(i + 1, j), scan.rangeMm.at(i, j - 1), scan.rangeMm.at(i, j + 1)});
            const std::size_t k = scan.rangeMm.index(i, j);
            if (far - r > 300.0F && scan.state[k] == CellState::Valid) out->push_back(static_cast<std::uint32_t>(k));
        }
    }
    return out;
}

} // namespace edgescan::demo
