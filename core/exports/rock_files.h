// Rocks as files: labels, rows, hulls, and their part of a record.
#pragma once

#include "core/base/result.h"
#include "core/exports/provenance.h"
#include "core/rocks/attributes/rock_columns.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/grid/placement.h"

#include <nlohmann/json_fwd.hpp>

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

/// 0 = not a rock, then the rocks. Error: too many rocks for the numbers of a 16-bit picture.
Result<Grid<std::uint16_t>> labelPicture(const rocks::Study& study, const std::string& where);

/// A row per rock, and the whole report with the input and version of the record. Error: the scan has no placement for the frame.
Result<std::string> tableBytes(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names,
                               const std::filesystem::path& path);
Result<std::string> reportBytes(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names,
                                const std::filesystem::path& path, const std::string& record);

/// Convex hulls of the visible points by extension: .ply or .obj. Error: another extension, no placement for the frame.
Result<std::string> hullBytes(const rocks::Study& study, CoordinateFrame frame, const std::filesystem::path& path,
                              const std::string& record);

/// {"settings", "edits", "count", "labels_sha256", "note"}; "listed" where not all rocks are listed in their order.
[[nodiscard]] nlohmann::ordered_json rocksRecord(const rocks::Study& study);

} // namespace edgescan::exports
