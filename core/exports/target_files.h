// The operator's targets as a table and as a drawing.
#pragma once

#include "core/exports/export_kinds.h"
#include "core/inspect/measure/notebook.h"

#include <string>
#include <vector>

namespace edgescan::exports {

using TargetList = std::vector<inspect::PinnedTarget>;

/// By the extension of the input's path: .csv (a row per target) or .dxf (on the layer TARGETS a point per target, on TARGET_NAMES its
/// number and name as text, on TARGET_NOTES its note). A target without a range is a row without a place, and a comment in a drawing.
/// Error: the options have no targets, no place for the frame, a drawing would have no point.
Result<std::string> targetBytes(const ExportInput& input);

/// How many targets a file holds, and the box of their places in a frame.
[[nodiscard]] OwnPart::Content targetContent(const edges::Detection& detection, const ExportOptions& options,
                                             const std::filesystem::path& path);

/// The targets in a record, and back. Error: damaged, or of cells that the scan does not have.
[[nodiscard]] nlohmann::ordered_json targetsRecord(const ExportOptions& options, const Scan& scan);
Result<Done> readTargets(const nlohmann::ordered_json& record, const Scan& scan, const std::string& where, ExportOptions& options);

} // namespace edgescan::exports
