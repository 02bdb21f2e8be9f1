// Rocks as files: labels, rows, hulls, and their part of a record.
#pragma once

#include "core/base/result.h"
#include "core/exports/provenance.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/rock_columns.h"
#include "core/rocks/attributes/study.h"
#include "core/rocks/attributes/why_border.h"
#include "core/scan/grid/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace edgescan::exports {

inline constexpr const char* kRocksSchema = "edgescan-rocks/1";

/// The names of targets, for the rows of the rocks that they are on.
[[nodiscard]] rocks::NamedCells namedCells(std::span<const inspect::PinnedTarget> targets);

/// The same for the same scan, settings and edits, independent of time and folder. Frames other than Scanner need a scan with a placement.
[[nodiscard]] nlohmann::ordered_json rocksReport(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names = {});

/// An array with an object per rock: the values of rocks::rockColumns() by their keys.
[[nodiscard]] nlohmann::ordered_json rockRowsJson(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names = {});

/// A header and a row per rock, separated by commas; elements of lists are separated by blanks.
[[nodiscard]] std::string rocksTable(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names = {});

/// SHA-256 of the labels, lines x beams unsigned 32-bit little endian.
[[nodiscard]] std::string labelsSha256(const Grid<std::uint32_t>& labels);

/// Why two regions are two rocks, or one (docs/reference/command-line.md, "JSON of why two rocks").
[[nodiscard]] nlohmann::ordered_json whyReport(const rocks::Study& study, const rocks::BorderWhy& why);

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
