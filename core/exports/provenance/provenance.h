// Provenance: every export says inside and beside itself what it was made of, so that anybody can make it again.
// (docs/operator.md, "S7", "S8".)
#pragma once

#include "core/base/file_bytes.h"
#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/exports/provenance/export_kinds.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::exports {

/// The record: one line of ASCII JSON, the same for the same scan, settings and options on the same program, whatever the time and
/// the folder. It ends with a SHA-256 of itself.
[[nodiscard]] std::string exportRecord(ExportContent content, const edges::Detection& detection, const ExportOptions& options);

/// True when a record's own SHA-256 is that of the rest of it.
[[nodiscard]] bool recordIsWhole(const nlohmann::ordered_json& record);

/// The files of an export in the order they must appear: one, or two of a raw grid. `path` chooses the format of a cloud; the record stands
/// inside where the format has room.
Result<std::vector<FileBytes>> exportFiles(ExportContent content, const edges::Detection& detection, const std::filesystem::path& path,
                                           const std::string& record, const ExportOptions& options);

/// The record inside an export's bytes; empty when there is none.
[[nodiscard]] std::string embeddedRecord(std::string_view bytes);

/// Writes the export and, unless told otherwise, its sidecar, both whole or neither, reads the export back and compares bytes, count and
/// bounds. Gives the number of points or cells written. A device or pipe gets the export only. Error: no pose for the frame asked for,
/// cannot be written, or what was read back is not what was written.
Result<std::size_t> exportWithProvenance(ExportContent content, const edges::Detection& detection, const std::filesystem::path& path,
                                         const ExportOptions& options = {});

} // namespace edgescan::exports
