// Rocks as JSON and as a table (docs/reference/command-line.md, "JSON of rocks").
#pragma once

#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/rock_columns.h"
#include "core/rocks/attributes/study.h"
#include "core/rocks/attributes/why_border.h"
#include "core/scan/grid/placement.h"

#include <nlohmann/json_fwd.hpp>

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

} // namespace edgescan::exports
