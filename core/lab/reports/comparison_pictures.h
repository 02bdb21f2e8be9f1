// A comparison as pictures: what each method found, and how that stands against the truth.
#pragma once

#include "core/exports/provenance/contact_sheet.h"
#include "core/lab/peers/comparison.h"

namespace edgescan {

/// The range image, and on it every method's edges: in the colours and shapes of their classes where a method tells classes apart.
[[nodiscard]] Grid<Rgb> edgesSheet(const Scan& scan, const std::vector<ComparedMethod>& methods);

/// Places in the legend of truthMarks().
inline constexpr std::uint8_t kMarkFound = 1, kMarkMissed = 2, kMarkFalse = 3;

/// Per cell of lines x beams: kMarkFound where a detection found a true cell, kMarkMissed on true cells that no detection found,
/// kMarkFalse where a detection found none. The mask (255 = edge) is thinned and cells are matched as for the score; what is not scored is
/// not marked.
[[nodiscard]] Grid<std::uint8_t> truthMarks(const Grid<std::uint8_t>& mask, const EdgeTruth& truth, double tolerance);

/// Cells found, missed and false of every method that has a score; below each, where its cells are drawn too small to see their shapes,
/// the middle of the same picture magnified. Methods that were also scored at their best threshold are drawn at that, except EdgeScan+ and
/// its parts: they are drawn as they are set. `tolerance`: cells, that of the scores. Empty where no method has a score.
[[nodiscard]] Grid<Rgb> truthSheet(const Scan& scan, const std::vector<ComparedMethod>& methods, const EdgeTruth& truth, double tolerance);

} // namespace edgescan
