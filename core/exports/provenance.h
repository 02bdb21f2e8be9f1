// Provenance: every export contains a record of how it was made, and has the same record in a sidecar, so that anyone can make it again
// (docs/reference/rules.md, "S7", "S8").
#pragma once

#include "core/base/file_bytes.h"
#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/exports/export_kinds.h"
#include "core/exports/written_coordinates.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::exports {

/// The record: one line of ASCII JSON, the same for the same scan, settings and options with the same program, independent of time and
/// folder. It ends with a SHA-256 of itself.
[[nodiscard]] std::string exportRecord(ExportContent content, const edges::Detection& detection, const ExportOptions& options);

/// True if a record's own SHA-256 is that of all its other parts.
[[nodiscard]] bool recordIsWhole(const nlohmann::ordered_json& record);

/// The files of an export in the order in which they must appear: one, or two for a raw grid. `path` chooses the format of a cloud; the
/// record is inside if the format has a place for it.
Result<std::vector<FileBytes>> exportFiles(ExportContent content, const edges::Detection& detection, const std::filesystem::path& path,
                                           const std::string& record, const ExportOptions& options);

/// The record inside an export's bytes; empty if there is none.
[[nodiscard]] std::string embeddedRecord(std::string_view bytes);

/// What an export wrote.
struct Written {
    std::size_t count = 0;                           ///< points, cells or rocks
    std::optional<WrittenCoordinates> coordinates{}; ///< empty for pictures
};

/// Writes the export and, unless the options say otherwise, its sidecar: both completely, or neither (core/base/whole_file.h). Count and
/// bounds of the bytes are compared with those of the scan before. A device or pipe gets the export only. Error: the scan has no pose for
/// the requested frame, the format cannot hold its values, or the file cannot be written.
Result<Written> exportWithProvenance(ExportContent content, const edges::Detection& detection, const std::filesystem::path& path,
                                     const ExportOptions& options = {});

} // namespace edgescan::exports
