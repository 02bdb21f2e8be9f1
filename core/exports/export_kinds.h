// Every kind of export is one row: window, command line, batch, Python, records and `verify` read this table.
#pragma once

#include "core/base/file_bytes.h"
#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/files/point_tables/writing_choices.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::rocks {
struct Study;
} // namespace edgescan::rocks
namespace edgescan::inspect {
struct PinnedTarget;
struct SectionPlane;
} // namespace edgescan::inspect
namespace edgescan::files {
struct SaveOptions;
} // namespace edgescan::files

namespace edgescan::exports {

/// In the order of the table.
enum class ExportContent : std::uint8_t {
    EdgeCloud,
    FullCloud,
    EdgeImage,
    GrayImage,
    RangeImage,
    WholeScan,
    RockReport,
    RockTable,
    RockLabels,
    RockOutlines,
    RockPictureOutlines,
    RockHulls,
    RockCloud,
    Section,
    Targets,
    End ///< how many there are
};

struct ExportOptions {
    CoordinateFrame frame = CoordinateFrame::Scanner; ///< of a cloud
    bool ascii = false;                               ///< PCD and PLY as text
    std::string operatorName{};                       ///< who exports; empty = unknown
    std::string role{};
    bool includeAttached = false; ///< of a projected cloud: also the points behind the nearest of each cell
    files::WritingChoices choices{};
    std::shared_ptr<const rocks::Study> rocks{};                         ///< of the detection's scan, for exports of rocks
    std::shared_ptr<const std::vector<std::uint32_t>> selection{};       ///< of a cloud: these cells alone, ascending; null = all
    std::shared_ptr<const inspect::SectionPlane> section{};              ///< of a section
    std::shared_ptr<const std::vector<inspect::PinnedTarget>> targets{}; ///< of the detection's scan
    bool sidecar = true;                                                 ///< also write the record to a sidecar
};

/// What an export is made from.
struct ExportInput {
    const edges::Detection& detection;
    const Scan& scan; ///< of a cloud: with the cells that were filled or selected
    const std::filesystem::path& path;
    const std::string& record;
    const ExportOptions& options;
    const files::SaveOptions& save;
};

/// A file that an export can be written to.
struct ExportFile {
    /// None; the frame's; the frame's, which the file's name says; those of the mine grid and no others.
    enum class Coordinates : std::uint8_t { None, Inside, InName, MineOnly };
    const char* extension;
    const char* title; ///< in the window's list of files; null: not in the list
    Coordinates coordinates;
    bool inFolder = true; ///< also written to an output folder
};

/// What an export has besides the options of all: a part of its record, and the content of its file.
struct OwnPart {
    struct Content {
        std::size_t count = 0;
        Eigen::AlignedBox3d box{}; ///< of its places in the frame
    };
    const char* key; ///< of the record
    bool needed;     ///< the export is made from it: every record has it, and rocks are added only where there are some
    /// Null where the options have none.
    nlohmann::ordered_json (*record)(const ExportOptions& options, const Scan& scan);
    /// Puts the part of a record back into the options. Error: damaged.
    Result<Done> (*read)(const nlohmann::ordered_json& part, const Scan& scan, const std::string& where, ExportOptions& options);
    Content (*content)(const edges::Detection& detection, const ExportOptions& options,
                       const std::filesystem::path& path) = nullptr; ///< null: as ExportKind::counts says
};

struct ExportKind {
    /// A cloud takes filled cells as well, where they are asked for. Targets: edges, and what the operator pinned.
    enum class Needs : std::uint8_t { Scan, Edges, Rocks, Targets };
    /// In the order of the flags. Points: any format of points, the file of the table where none is asked for. Scan: any format.
    enum class Holds : std::uint8_t { Picture, Numbers, Points, Shapes, Scan };
    enum class Counts : std::uint8_t { EdgePoints, Points, Cells, Rocks, Targets };
    /// In the window: the command in the menu and its keys, the line of the question with %1 for the count, and the file's name.
    struct InWindow {
        const char* menu = nullptr;
        const char* keys = "";
        const char* title = nullptr; ///< null: the window does not offer it so
        const char* tail = nullptr;
        bool namesMethod = true;
    };

    ExportContent content;
    const char* key;    ///< of batch and Python
    const char* record; ///< what records call it
    Needs needs;
    Holds holds;
    Counts counts;
    const char* tail; ///< of a file's name
    std::span<const ExportFile> files;
    const char* flag; ///< of `detect` or `rocks`; null: neither writes it
    const char* help; ///< of the flag; %1 becomes the formats of points
    Result<std::vector<FileBytes>> (*make)(const ExportInput& input);
    InWindow window{};
    const char* unit = nullptr; ///< of a picture's values
    const OwnPart* own = nullptr;
};

[[nodiscard]] std::span<const ExportKind> exportKinds();
[[nodiscard]] const ExportKind& exportKind(ExportContent content);
/// By the record's name; null when no kind has it.
[[nodiscard]] const ExportKind* exportKindNamed(std::string_view record);

[[nodiscard]] inline bool isCloud(ExportContent content) { return exportKind(content).holds == ExportKind::Holds::Points; }
[[nodiscard]] inline bool isOfRocks(ExportContent content) { return exportKind(content).needs == ExportKind::Needs::Rocks; }

/// True if the file has the names of targets.
[[nodiscard]] bool namesTargets(ExportContent content);

/// "edge points", "points", "cells", "rocks", "targets".
[[nodiscard]] const char* countedThings(const ExportKind& kind);

/// "edges_LOCAL.pcd": what follows the scan's name.
[[nodiscard]] std::string exportFileName(const ExportKind& kind, std::string_view extension, CoordinateFrame frame);

/// Error when `path` has an extension that this kind cannot be written to. `where` goes into it, and `between` between the extensions.
Result<Done> checkExtension(const ExportKind& kind, const std::filesystem::path& path, const std::string& where, const char* between);

} // namespace edgescan::exports
