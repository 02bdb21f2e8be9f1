// Range CSV (thesis figure 5.7): one text line per scan line, millimetres between commas.
#pragma once

#include "core/points/source.h"
#include "core/points/text_layout.h"

namespace edgescan {

/// True when the table is ranges rather than points: many columns without names, or few with the geometry given.
[[nodiscard]] bool looksLikeRangeCsv(const TextLayout& layout, const Source& source);

/// lines x beams. 0 and empty cells are no returns. Geometry from the options, or the LMS511 defaults for 1141 columns.
/// Error: rows of unequal length, negative ranges, no geometry.
Result<Scan> readRangeCsv(const Source& source, const TextLayout& layout);

} // namespace edgescan
