// What an export may ask of a format in addition to its frame: one row per choice, for flags, records and dialogs.
#pragma once

#include <array>

namespace edgescan::files {

struct WritingChoices {
    bool comments = false;
    bool doubles = false;
    bool dxf2000 = false;
    bool shortLines = false;
    bool filled = false;
    bool confidence = false;

    bool operator==(const WritingChoices&) const = default;
};

struct WritingChoice {
    const char* key;  ///< of the flag and of the record's list "choices"
    const char* help; ///< one sentence without its full stop
    bool WritingChoices::*member;
};

inline constexpr std::array<WritingChoice, 6> kWritingChoices{{
    {"comments", "XYZ and CSV with all columns, and the grid and the record in comment lines: GIS and spreadsheet programs may refuse them",
     &WritingChoices::comments},
    {"doubles",
     "PCD in mine coordinates with numbers of 8 bytes, which PCL and Open3D do not read; else metres from an origin in a comment",
     &WritingChoices::doubles},
    {"dxf-2000", "DXF of release 2000 instead of release 12", &WritingChoices::dxf2000},
    {"short-lines", "DXF: also the edge lines of two points only", &WritingChoices::shortLines},
    {"with-filled", "PCD, PLY and CSV: also the cells that were filled and not measured, which the field filled_sd_mm marks",
     &WritingChoices::filled},
    {"with-confidence",
     "PCD, PLY and CSV: the field confidence, how many percent of nearby settings find the edge too; 0 where there is none",
     &WritingChoices::confidence},
}};

} // namespace edgescan::files
