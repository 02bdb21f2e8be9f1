// The true rocks of a simulated scene (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace edgescan::lab {

/// The true dimensions of a rock, including hidden parts; metres, scanner frame.
struct TrueRock {
    std::uint32_t object = 0; ///< its number in object.png
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero();
    std::array<double, 3> spansM{}; ///< longest first
};

/// The true rocks of a scene. All grids are lines x beams.
struct TrueRocks {
    Grid<std::uint32_t> rock;                       ///< 0 background, otherwise 1 + index in `rocks` of the rock that the beam's centre hit
    Grid<std::uint16_t> cleanMm;                    ///< range without noise, 0 = no range
    Grid<std::uint16_t> tearToBeamMm, tearToLineMm; ///< gap in depth to the next beam and line, mm; empty if the truth does not have it
    std::vector<TrueRock> rocks;
};

/// Reads object.png, range_clean.png and rocks.json, and tear_beam.png and tear_line.png if they exist. Error: missing, damaged, of
/// different shapes.
Result<TrueRocks> readTrueRocks(const std::filesystem::path& folder);

/// The same from the simulation in memory.
[[nodiscard]] TrueRocks trueRocksOf(const sim::Simulation& simulation);

/// Largest and smallest distance, metres, of two parallel lines around the points, in the plane at right angles to the direction of their
/// mean. `a` >= `b`; zero for fewer than 3 points.
struct VisibleSpans {
    double aM = 0.0, bM = 0.0;
};
/// Uses its own calipers, not those of core/rocks/selection: the score must not share a fault with the scored code.
[[nodiscard]] VisibleSpans spansAcrossSight(const std::vector<Eigen::Vector3d>& pointsM);

/// The spans of the visible part of each rock: from the noise-free ends of its beams' centres. In the order of `rocks`.
[[nodiscard]] std::vector<VisibleSpans> trueSpans(const Scan& scan, const TrueRocks& truth);

/// The connected parts of rocks (8 neighbours), numbered from 1; 0 = background.
[[nodiscard]] Grid<std::uint32_t> visibleParts(const Grid<std::uint32_t>& rock);

} // namespace edgescan::lab
