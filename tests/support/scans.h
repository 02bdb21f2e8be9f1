// Small scans made in memory, for tests.
#pragma once

#include "core/scan/grid/scan.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace edgescan::test {

inline PolarGeometry regularAngles(int lines, int beams, Axis axis = Axis::Sweep) {
    PolarGeometry polar;
    polar.axis = axis;
    for (int j = 0; j < beams; ++j) polar.beamDeg.push_back(90.0 - (beams - 1) * 0.25 / 2 + 0.25 * j);
    for (int i = 0; i < lines; ++i) polar.lineDeg.push_back(-(lines - 1) * 0.25 / 2 + 0.25 * i);
    return polar;
}

/// A scan whose range at each cell is `range(line, beam)` in mm; 0 means no return.
template <class Range>
Scan makeScan(int lines, int beams, Range range) {
    Scan scan;
    scan.name = "made";
    scan.rangeMm = Grid<float>(lines, beams);
    scan.state = Grid<CellState>(lines, beams, CellState::NoReturn);
    scan.geometry = regularAngles(lines, beams);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const float r = static_cast<float>(range(i, j));
            scan.rangeMm.at(i, j) = r;
            if (r > 0) scan.state.at(i, j) = CellState::Valid;
        }
    }
    return scan;
}

/// A growing scan: the first lines of `scan`.
inline std::shared_ptr<const Scan> firstLines(const Scan& scan, int lines) {
    auto part = std::make_shared<Scan>();
    const auto cells = static_cast<std::ptrdiff_t>(scan.rangeMm.index(lines, 0));
    part->rangeMm = Grid<float>(lines, scan.beams(), std::vector<float>(scan.rangeMm.cells.begin(), scan.rangeMm.cells.begin() + cells));
    part->state = Grid<CellState>(lines, scan.beams(), std::vector<CellState>(scan.state.cells.begin(), scan.state.cells.begin() + cells));
    part->geometry = regularAngles(lines, scan.beams());
    return part;
}

/// A flat wall `distanceMm` in front of a sweeping scanner, in whole millimetres.
inline double wallRangeMm(const PolarGeometry& polar, int line, int beam, double distanceMm) {
    const double a = polar.beamDeg[static_cast<std::size_t>(beam)] * std::numbers::pi / 180;
    const double p = polar.lineDeg[static_cast<std::size_t>(line)] * std::numbers::pi / 180;
    return std::round(distanceMm / (std::sin(a) * std::cos(p)));
}

/// Boxes at different depths in front of a back wall, with a share of cells without a return.
inline Scan boxesScan(int lines, int beams, std::uint32_t seed, double dropouts = 0.0) {
    std::mt19937 random(seed);
    Grid<float> depth(lines, beams, 9000.0F);
    for (int box = 0; box < 12; ++box) {
        const int top = static_cast<int>(random() % static_cast<unsigned>(lines));
        const int left = static_cast<int>(random() % static_cast<unsigned>(beams));
        const int height = 3 + static_cast<int>(random() % static_cast<unsigned>(lines / 2 + 1));
        const int width = 3 + static_cast<int>(random() % static_cast<unsigned>(beams / 2 + 1));
        const auto range = static_cast<float>(2000 + random() % 6000);
        for (int i = top; i < std::min(lines, top + height); ++i) {
            for (int j = left; j < std::min(beams, left + width); ++j) depth.at(i, j) = range;
        }
    }
    return makeScan(lines, beams, [&](int i, int j) {
        const bool dropped = static_cast<double>(random() % 10000) < dropouts * 10000;
        return dropped ? 0.0F : depth.at(i, j) + static_cast<float>(random() % 21) - 10.0F;
    });
}

} // namespace edgescan::test
