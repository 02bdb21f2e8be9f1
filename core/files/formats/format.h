// What the program knows of one file format. A format is one row: where it is read, written or checked, the row is asked.
#pragma once

#include "core/base/file_bytes.h"
#include "core/files/formats/reading.h"
#include "core/files/point_tables/cloud_columns.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

/// What of a scan's cells comes back from a file.
enum class Keeps : std::uint8_t {
    States,    ///< every cell with its state, and the scan's place in the mine, in whatever frame the coordinates are
    NoReturns, ///< every cell; all states but valid become missing returns
    Sidecar,   ///< as NoReturns, by the grid in the sidecar; every state where comment lines are asked for
    Points,    ///< a list of the valid points
};

/// What a format cannot do is left out: null, or no extension.
struct Format {
    const char* title;                   ///< for dialogs: "Point Cloud Library"
    std::vector<const char*> reads{};    ///< extensions in the dialog that opens files, lower case, with the dot
    std::vector<const char*> writes{};   ///< extensions that choose this format on saving; the first is the usual one
    bool (*recognises)(const Source&){}; ///< by content; the extension is only a hint
    Result<Reading> (*read)(const Source&){};
    Result<std::string> (*write)(CloudColumns, const std::string& where, bool asText){}; ///< `asText`: where there is a choice
    /// Instead of columns: the files of a whole scan as ranges and angles, in the order they must appear.
    Result<std::vector<FileBytes>> (*writeScan)(const Scan&, const std::filesystem::path&){};
    std::string (*record)(std::string_view bytes) = recordInComments; ///< the record of an export that is inside; empty = none
    Keeps keeps = Keeps::States;
    double stepM = 0;            ///< coordinates are rounded to whole steps of it; 0: by a micrometre at most, where the numbers are small
    bool keepsIntensity = false; ///< writes the column of that name
    bool aboutOrigin = false; ///< mine coordinates are 4-byte metres from their origin, which the file holds, unless doubles are asked for
    std::vector<const char*> inFloats{}; ///< programs that read its coordinates into 4-byte numbers
    bool writesByLines = false;          ///< `write` makes the columns that are to be made later (CloudColumns::linesLater) as it writes
    bool drawsEdges = false;             ///< a drawing of edge lines: the window does not offer it for all points
    std::vector<std::string_view> options{}; ///< keys of the reading options that not every format has
    bool placesItself = false;               ///< pose and calibration are taken into account by `read`
};

} // namespace edgescan::files
