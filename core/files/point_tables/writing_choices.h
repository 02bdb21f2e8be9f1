// What an export may ask of a format in addition to its frame: one row per choice, for flags, records and dialogs.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace edgescan::files {

struct WritingChoices {
    bool comments = false;
    bool doubles = false;
    bool dxf2000 = false;
    bool shortLines = false;
    bool filled = false;
    bool confidence = false;
    bool borders = false;

    bool operator==(const WritingChoices&) const = default;
};

struct WritingChoice {
    const char* key;  ///< of the flag and of the record's list "choices"
    const char* help; ///< one sentence without its full stop
    bool WritingChoices::*member;
    std::array<std::string_view, 4> files; ///< extensions of the formats that it changes
    bool needsEdges = false;               ///< a scan alone has none

    [[nodiscard]] constexpr bool changes(std::string_view extension) const {
        return !extension.empty() && std::ranges::find(files, extension) != files.end();
    }
};

inline constexpr std::array<WritingChoice, 7> kWritingChoices{{
    {"comments",
     "XYZ and CSV with all columns, and the grid and the record in comment lines: GIS and spreadsheet programs may refuse them",
     &WritingChoices::comments,
     {".xyz", ".txt", ".asc", ".csv"}},
    {"doubles",
     "PCD in mine coordinates with numbers of 8 bytes, which PCL and Open3D do not read; else metres from an origin in a comment",
     &WritingChoices::doubles,
     {".pcd"}},
    {"dxf-2000", "DXF of release 2000 instead of release 12", &WritingChoices::dxf2000, {".dxf"}},
    {"short-lines", "DXF: also the edge lines of two points only", &WritingChoices::shortLines, {".dxf"}, true},
    {"with-filled",
     "PCD, PLY and CSV: also the cells that were filled and not measured, which the field filled_sd_mm marks",
     &WritingChoices::filled,
     {".pcd", ".ply", ".csv"},
     true},
    {"with-confidence",
     "PCD, PLY and CSV: the field confidence, how many percent of nearby settings find the edge too; 0 where there is none",
     &WritingChoices::confidence,
     {".pcd", ".ply", ".csv"},
     true},
    {"with-borders",
     "PCD, PLY and CSV: the field border, how likely each edge is the border of a rock, in percent; NaN where unknown and where no edge is",
     &WritingChoices::borders,
     {".pcd", ".ply", ".csv"},
     true},
}};

} // namespace edgescan::files
