// A comparison as pictures: the edges of each method, and their agreement with the truth.
#pragma once

#include "app/lab/peers/comparison.h"
#include "app/lab/reports/titled_tiles.h"
#include "core/edges/pipeline/detection.h"

namespace edgescan::lab {

/// The range image, and on it every method's edges: in the colours and shapes of their classes if a method distinguishes classes.
[[nodiscard]] Grid<Rgb> edgesSheet(const Scan& scan, const std::vector<ComparedMethod>& methods);

/// Indices of the legend of truthMarks().
inline constexpr std::uint8_t kMarkFound = 1, kMarkMissed = 2, kMarkFalse = 3;

/// Per cell of lines x beams: kMarkFound where a detection found a true cell, kMarkMissed on true cells that were not found, kMarkFalse
/// where a detection is false. The mask (255 = edge) is thinned, and cells are matched as for the score; cells that are not scored are not
/// marked.
[[nodiscard]] Grid<std::uint8_t> truthMarks(const Grid<std::uint8_t>& mask, const sim::EdgeTruth& truth, double tolerance);

/// Found, missed and false cells of every method with a score. If a picture is too small to show the shapes of marks, its middle is
/// magnified below it. Methods that were also scored at their best threshold are drawn at that threshold, except EdgeScan+ and its parts,
/// which are drawn with their settings. `tolerance`: of the scores, cells. Empty if there are no scores.
[[nodiscard]] Grid<Rgb> truthSheet(const Scan& scan, const std::vector<ComparedMethod>& methods, const sim::EdgeTruth& truth,
                                   double tolerance);

/// Two tiles: found, missed and false cells of a detection, and its edges by their probability to be the border of a rock.
[[nodiscard]] Grid<Rgb> sceneSheet(const edges::Detection& detection, const sim::EdgeTruth& truth, double tolerance);

} // namespace edgescan::lab
