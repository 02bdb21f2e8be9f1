// Point lists as text: .xyz .txt .asc .csv .pts and 3DTK's .3d.
#pragma once

#include "core/points/point_table.h"
#include "core/points/source.h"
#include "core/points/text_layout.h"

namespace edgescan {

/// The points as the file has them, before anything is made of them.
Result<PointTable> readTextPoints(const Source& source, const TextLayout& layout);

/// Error: a row is cut off or is no number (with its line), fewer rows than promised, no grid.
Result<Scan> readPointText(const Source& source, const TextLayout& layout);

} // namespace edgescan
