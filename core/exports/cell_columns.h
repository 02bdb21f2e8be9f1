// Columns that a cloud carries besides points, edges and classes: one row each.
#pragma once

#include "core/base/result.h"
#include "core/exports/export_kinds.h"
#include "core/files/point_tables/cloud_columns.h"

#include <filesystem>
#include <vector>

namespace edgescan::exports {

/// Those that the kind has and the options ask for. Error: a column without values, or a format that has no room for it.
Result<std::vector<files::CellColumn>> cellColumns(const ExportKind& kind, const edges::Detection& detection,
                                                   const std::filesystem::path& path, const ExportOptions& options);

} // namespace edgescan::exports
