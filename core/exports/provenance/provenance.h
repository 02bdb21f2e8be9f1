// Provenance: every export says inside and beside itself what it was made of, so that anybody can make it again.
// (docs/operator.md, "S7", "S8".)
#pragma once

#include "core/base/file_bytes.h"
#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/files/point_tables/writing_choices.h"
#include "core/scan/grid/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::rocks {
struct Study; // core/rocks/attributes/study.h
} // namespace edgescan::rocks

namespace edgescan::exports {

enum class ExportContent : std::uint8_t {
    EdgeCloud,
    FullCloud,    ///< all valid points, with a field for edges
    EdgeImage,    ///< 8-bit PNG, 255 = edge
    GrayImage,    ///< 8-bit PNG
    RangeImage,   ///< 16-bit PNG, millimetres
    WholeScan,    ///< every cell with its state, as saveScan writes it; of the detection only the scan counts
    RockLabels,   ///< 16-bit PNG: 0 none, then the rocks, largest first
    RockTable,    ///< a row per rock, commas between
    RockReport,   ///< the same and more as JSON
    RockCloud,    ///< all valid points, with a field for rocks
    RockOutlines, ///< DXF in space, or GeoJSON in the picture
    RockHulls,    ///< PLY or OBJ
};
inline constexpr int kExportContents = 12;

/// "edge cloud", "full cloud", "edge image", "gray image", "range image", "whole scan", "rock labels",
/// "rock table", "rock report", "rock cloud", "rock outlines", "rock hulls".
[[nodiscard]] const char* exportContentName(ExportContent content);
[[nodiscard]] bool isCloud(ExportContent content);
[[nodiscard]] bool isOfRocks(ExportContent content);

struct ExportOptions {
    CoordinateFrame frame = CoordinateFrame::Scanner; ///< of a cloud
    bool ascii = false;                               ///< PCD and PLY as text
    std::string operatorName{};                       ///< who exports; empty = not said
    std::string role{};
    bool includeAttached = false; ///< of a projected cloud: also the points behind the nearest of each cell
    files::WritingChoices choices{};
    std::shared_ptr<const rocks::Study> rocks{};                   ///< of the detection's scan, for exports of rocks
    std::shared_ptr<const std::vector<std::uint32_t>> selection{}; ///< of a cloud: these cells alone, ascending; null = all
    bool sidecar = true;                                           ///< the record also beside the export
};

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
