// Ground truth as files (docs/method.md, "Truth and score").
#pragma once

#include "core/sim/truth/truth.h"

#include <filesystem>

namespace edgescan {

/// What a scan is scored against. All grids are lines x beams.
struct TruthSet {
    EdgeTruth edges;
    Grid<std::uint16_t> object;  ///< 0 none, 1 wall, 2.. rocks; empty when it is not known
    Grid<std::uint16_t> cleanMm; ///< range without noise, whole mm, 0 = none; empty when it is not known
};

/// Writes gt_class.png, gt_ignore.png, object.png, face.png, range_clean.png, tear_beam.png, tear_line.png (gap in depth to the next beam
/// and line, mm), rocks.json (true size, volume, visible cells and visible spans of each rock, metres) and scene.json (every setting, seed
/// included) into the folder, which is made when it is missing.
Result<Done> writeTruth(const Simulation& simulation, const SimulationSettings& settings, const std::filesystem::path& folder);

/// Numbers of a 16-bit picture of the truth; empty when there is no such file. Error: damaged, no such picture.
Result<Grid<std::uint16_t>> readTruthNumbers(const std::filesystem::path& path);

/// How far apart the surfaces of two neighbouring cells are, whole mm; 65535 for all that is more.
[[nodiscard]] Grid<std::uint16_t> wholeTears(const Grid<sim::Seam>& seams);

/// From what the simulator holds in memory.
[[nodiscard]] TruthSet truthSetOf(const Simulation& simulation);

/// gt_class.png and gt_ignore.png; object.png and range_clean.png where they are there. Error: missing, damaged, of different shapes.
Result<TruthSet> readTruth(const std::filesystem::path& folder);

} // namespace edgescan
