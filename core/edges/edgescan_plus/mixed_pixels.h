// Mixed pixels: the beam's spot covers two surfaces, and the measured range is between them (docs/method/edges.md, "Step 2").
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

namespace edgescan::edges {

/// Longest run of mixed pixels, cells.
inline constexpr int kLongestRun = 8;

/// Cells of the lines on both sides of a long run.
inline constexpr int kMixedLine = 5;

/// Numbers of lines before and after its own that snapMixedPixels() reads, and of lines after its own that it may write.
inline constexpr int kMixedLinesBefore = kMixedLine;
inline constexpr int kMixedLinesAfter = kLongestRun + kMixedLine - 1;
inline constexpr int kMixedLinesWritten = kLongestRun - 1;

/// Moves cells that are strictly between the straight continuations of both sides to the closer one. A single cell must be farther than the
/// jump threshold from both. A run of two cells is moved if the spot of the beam (13 mm + 4.6 mrad, LMS511) covers all of it and the
/// surfaces are at least 1.6 thresholds apart. With `limits.spotGrows`, runs have up to kLongestRun cells; those of more than two have half
/// the width of the spot at least. Without it the surfaces are two thresholds apart. Processes one line of `field`; `angle`: of an index
/// step at its cells, radians. `snapped` holds a copy of the field's u, including the lines that may be written.
void snapMixedPixels(const DepthField& field, Along along, int line, const float* angle, const DepthLimits& limits, Lines& snapped);

} // namespace edgescan::edges
