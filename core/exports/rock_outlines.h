// Outlines of rocks as files: in space, in the mine grid for GIS programs, and in the picture.
#pragma once

#include "core/base/result.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/grid/placement.h"

#include <filesystem>
#include <string>

namespace edgescan::exports {

/// The outlines of the visible surfaces by extension: .dxf (closed polylines in space on the layers ROCKS and ROCKS_DOUBTFUL, and each
/// rock's number as text on ROCK_NUMBERS) or .geojson (closed lines in the mine grid, with its coordinate system where it is known,
/// otherwise a local one). Error: another extension, no placement for the frame; for .geojson also every other frame, because programs take
/// its numbers for places.
Result<std::string> outlineBytes(const rocks::Study& study, CoordinateFrame frame, const std::filesystem::path& path,
                                 const std::string& record);

/// The labels as polygons of the picture, as JSON: x = beam, y = line, corners of cells.
[[nodiscard]] std::string pictureOutlines(const rocks::Study& study, const std::string& record);

} // namespace edgescan::exports
