// The true rocks of a simulated scene (docs/method.md, "Truth and score").
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/scan/grid/scan.h"
#include "core/sim/simulate.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace edgescan {

/// A rock as it really is, hidden parts included; metres, scanner frame.
struct TrueRock {
    std::uint32_t object = 0; ///< its number in object.png
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero();
    std::array<double, 3> spansM{}; ///< longest first
};

/// All grids are lines x beams.
struct TrueRocks {
    Grid<std::uint32_t> rock;                       ///< 0 background, else 1 + place in `rocks` of what the beam's centre hit
    Grid<std::uint16_t> cleanMm;                    ///< range without noise, 0 = none
    Grid<std::uint16_t> tearToBeamMm, tearToLineMm; ///< gap in depth to the next beam and line, mm; empty where the truth does not tell
    std::vector<TrueRock> rocks;
};

/// object.png, range_clean.png and rocks.json; tear_beam.png and tear_line.png where they are there. Error: missing, damaged, of different
/// shapes.
Result<TrueRocks> readTrueRocks(const std::filesystem::path& folder);

/// The same from what the simulator holds in memory.
[[nodiscard]] TrueRocks trueRocksOf(const Simulation& simulation);

/// Largest and smallest distance of two parallel lines that hold the points between them, metres, as seen across the line of sight: in the
/// plane at right angles to the direction of their mean. `a` >= `b`; zero for fewer than 3 points.
struct VisibleSpans {
    double aM = 0.0, bM = 0.0;
};
/// With calipers of its own, not those of core/rocks/selection: what scores must not share a fault with what is scored.
[[nodiscard]] VisibleSpans spansAcrossSight(const std::vector<Eigen::Vector3d>& pointsM);

/// Of the visible part of each rock: where its beams' centres end without noise. In the order of `rocks`.
[[nodiscard]] std::vector<VisibleSpans> trueSpans(const Scan& scan, const TrueRocks& truth);

/// The parts of rocks that hang together over 8 neighbours, numbered from 1; 0 = background.
[[nodiscard]] Grid<std::uint32_t> visibleParts(const Grid<std::uint32_t>& rock);

} // namespace edgescan
