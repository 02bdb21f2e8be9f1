// A section as a drawing, as a table and as a picture in true scale.
#pragma once

#include "core/exports/export_kinds.h"
#include "core/inspect/section/section.h"

namespace edgescan::exports {

/// By the extension of the input's path: .dxf, .csv or .png. Error: the options have no plane.
Result<std::string> sectionBytes(const ExportInput& input);

/// Rocks that the section of the options cuts, and the box of its vertices in a frame. Nothing without a plane.
[[nodiscard]] OwnPart::Content sectionContent(const edges::Detection& detection, const ExportOptions& options,
                                              const std::filesystem::path& path);

/// The plane in a record, and back. Error: damaged.
[[nodiscard]] nlohmann::ordered_json planeRecord(const ExportOptions& options, const Scan& scan);
Result<Done> readPlane(const nlohmann::ordered_json& record, const Scan& scan, const std::string& where, ExportOptions& options);

} // namespace edgescan::exports
