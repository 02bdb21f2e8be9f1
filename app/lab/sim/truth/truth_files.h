// Ground truth as files (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/sim/truth/truth.h"

#include <filesystem>

namespace edgescan::sim {

/// The truth for the score of a scan. All grids are lines x beams.
struct TruthSet {
    EdgeTruth edges;
    Grid<std::uint16_t> object;  ///< 0 no object, 1 wall, 2.. rocks; empty if unknown
    Grid<std::uint16_t> cleanMm; ///< range without noise, whole mm, 0 = no range; empty if unknown
};

/// Which folds of a re-scanned surface count: none, or those between its facets (docs/method/edges.md). Other scenes have one truth.
enum class Facets : std::uint8_t { None, Folds };

/// Writes gt_class.png, gt_ignore.png (of a re-scan also gt_class_facets.png and gt_ignore_facets.png), object.png, face.png,
/// range_clean.png, tear_beam.png, tear_line.png (gap in depth to the next beam and line, mm), rocks.json (true size, volume, visible cells
/// and visible spans of each rock, metres) and scene.json (every setting, including the seed) into the folder, which is created if it does
/// not exist.
Result<Done> writeTruth(const Simulation& simulation, const SimulationSettings& settings, const std::filesystem::path& folder);

/// Writes gt_class.png, gt_ignore.png, object.png and range_clean.png into the folder, which is created if it does not exist.
Result<Done> writeTruthSet(const TruthSet& truth, const std::filesystem::path& folder);

/// Writes rocks.json, from a simulation with truth, into a folder that exists.
Result<Done> writeRockList(const Simulation& simulation, const std::filesystem::path& folder);

/// Ranges as in range_clean.png.
[[nodiscard]] Grid<std::uint16_t> wholeMm(const Grid<float>& mm);

/// Numbers of a 16-bit picture of the truth; empty if the file does not exist. Error: damaged, not such a picture.
Result<Grid<std::uint16_t>> readTruthNumbers(const std::filesystem::path& path);

/// Distance between the surfaces of two neighbouring cells, whole mm; 65535 for all larger values.
[[nodiscard]] Grid<std::uint16_t> wholeTears(const Grid<sim::Seam>& seams);

/// From the simulation in memory.
[[nodiscard]] TruthSet truthSetOf(const Simulation& simulation);

/// Whether the truth has the pictures of facets.
[[nodiscard]] bool hasFacets(const std::filesystem::path& folder);

/// Reads gt_class.png and gt_ignore.png, and object.png and range_clean.png if they exist. Error: missing, damaged, of different shapes.
/// With Facets::Folds: the pictures of facets in their place if there are any.
Result<TruthSet> readTruth(const std::filesystem::path& folder, Facets facets = Facets::None);

} // namespace edgescan::sim
