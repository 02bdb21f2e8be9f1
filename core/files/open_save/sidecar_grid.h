// A list of points that this program wrote, with its record beside it: the record holds the grid whose cells the points are.
#pragma once

#include "core/base/result.h"
#include "core/files/point_tables/point_table.h"
#include "core/files/point_tables/source.h"

#include <filesystem>
#include <optional>

namespace edgescan::files {

inline constexpr const char* kSidecarFormat = "edgescan-provenance/1";

/// NAME.EXT.provenance.json beside the export.
[[nodiscard]] std::filesystem::path sidecarPath(const std::filesystem::path& exported);

/// Whether to look there at all.
[[nodiscard]] bool isGridBeside(const Source& source);

/// The scan as it was: each point in the cell that its direction names, in the order of the cells, ranges on whole counts again where the
/// printed digits allow no other. Empty when there is no record beside the file, when it was written for another file, or when the grid has
/// no angles or does not fit the points; a remark says why.
[[nodiscard]] std::optional<Scan> scanOfGridBeside(PointTable& table, const Source& source);

} // namespace edgescan::files
