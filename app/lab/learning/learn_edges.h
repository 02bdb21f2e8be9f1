// Samples of edges of which the truth is known, for the trees of core/edges/rock_borders (docs/method/edges.md, "Rock border or fold").
#pragma once

#include "app/lab/learning/boosting.h"
#include "app/lab/sim/truth/truth_files.h"
#include "core/scan/grid/scan.h"

#include <cstddef>
#include <memory>

namespace edgescan::lab {

/// Cells of a scan that are the border of a body: within two cells of a true outline or contact, or next to another body of 25 cells and
/// more. Lines x beams, 1 or 0.
[[nodiscard]] Grid<std::uint8_t> trueBorders(const sim::TruthSet& truth);

/// Adds at most `most` of the jumps and folds that the default settings draw, evenly over the scan, each with the weight 1. Cells that
/// are not scored are left out.
void addEdgeSamples(const std::shared_ptr<const Scan>& scan, const sim::TruthSet& truth, std::size_t most, TreeSamples& samples);

} // namespace edgescan::lab
