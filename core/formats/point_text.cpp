// Point lists as text: .xyz .txt .asc .csv .pts and 3DTK's .3d.

#include "core/formats/format.h"

#include "core/base/memory.h"
#include "core/points/column_rows.h"
#include "core/points/point_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace edgescan {
namespace {

constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

struct Columns {
    std::array<std::size_t, 3> xyz{0, 1, 2};
    std::size_t rangeMm = kNoColumn;
    std::size_t state = kNoColumn;
    std::array<std::size_t, 3> scanner{kNoColumn, kNoColumn, kNoColumn};
    std::size_t needed = 3; ///< columns a row must have
    std::optional<double> unitMm;
};

/// "x_mm", "x [mm]", "x(m)" -> millimetres per unit, and the name without it.
std::optional<double> splitUnit(std::string& name) {
    const std::size_t end = name.find_first_of("_ ([");
    if (end == std::string::npos) return std::nullopt;
    std::string unit;
    std::copy_if(name.begin() + static_cast<std::ptrdiff_t>(end), name.end(), std::back_inserter(unit),
                 [](char c) { return c >= 'a' && c <= 'z'; });
    name.resize(end);
    if (unit == "mm") return 1.0;
    if (unit == "cm") return 10.0;
    if (unit == "m") return 1000.0;
    return std::nullopt;
}

Result<Columns> columnsOf(const TextLayout& layout, const Source& source) {
    Columns columns;
    if (layout.columns < 3) {
        return source.refusedAtLine(layout.firstLine, "holds " + std::to_string(layout.columns) + " numbers where a point needs three",
                                    "choose a point list or a table of ranges");
    }
    std::array<std::size_t, 3> named{kNoColumn, kNoColumn, kNoColumn};
    std::optional<double> unit;
    for (std::size_t i = 0; i < layout.names.size(); ++i) {
        std::string name = layout.names[i];
        if (name == "range_mm") columns.rangeMm = i;
        if (name == "state") columns.state = i;
        if (name.size() == 9 && name.starts_with("scanner_") && name[8] >= 'x' && name[8] <= 'z')
            columns.scanner[static_cast<std::size_t>(name[8] - 'x')] = i;
        const auto itsUnit = splitUnit(name);
        if (name.size() != 1 || name[0] < 'x' || name[0] > 'z') continue;
        named[static_cast<std::size_t>(name[0] - 'x')] = i;
        if (itsUnit) unit = itsUnit;
    }
    if (std::count(named.begin(), named.end(), kNoColumn) == 0) {
        columns.xyz = named;
        columns.unitMm = unit;
    }
    columns.needed = std::max({columns.xyz[0], columns.xyz[1], columns.xyz[2]}) + 1;
    for (const std::size_t own : {columns.rangeMm, columns.state, columns.scanner[0], columns.scanner[1], columns.scanner[2]}) {
        if (own != kNoColumn) columns.needed = std::max(columns.needed, own + 1);
    }
    return columns;
}

Result<PointTable> readTextPoints(const Source& source) {
    if (const auto byte = firstByteThatIsNoText(source.text())) {
        return source.refusedAtByte(*byte, "this is neither text nor any scan format that is known",
                                    "choose a scan: raw grid, PCD, PLY, XYZ, CSV or .3d");
    }
    const auto found = textLayoutOf(source);
    if (!found) return found.error();
    const TextLayout& layout = *found;
    const auto columns = columnsOf(layout, source);
    if (!columns) return columns.error();
    // A point takes six bytes of text at least and 24 in memory, a little more while it grows and is recognised.
    if (auto enough = checkMemory(std::uint64_t{source.bytes.size()} * 10, source.path.string()); !enough) return enough.error();
    PointTable table;
    table.format = "point list";
    RowReader rows(source, layout);
    rows.measure(columns->xyz);
    std::vector<double> row;
    while (rows.next(row)) {
        if (row.size() < columns->needed) {
            return source.refusedAtLine(rows.lineNumber(),
                                        "holds " + std::to_string(row.size()) + " numbers where a point needs " +
                                            std::to_string(columns->needed),
                                        "the file may be cut off here, copy it again");
        }
        table.points.emplace_back(row[columns->xyz[0]], row[columns->xyz[1]], row[columns->xyz[2]]);
        if (columns->rangeMm != kNoColumn) table.rangeMm.push_back(static_cast<float>(row[columns->rangeMm]));
        if (columns->state != kNoColumn) {
            const double state = row[columns->state];
            table.state.push_back(state >= 0 && state < 256 ? static_cast<std::uint8_t>(state) : std::uint8_t{255});
        }
        if (const auto& s = columns->scanner; std::count(s.begin(), s.end(), kNoColumn) == 0)
            table.scannerPoints.emplace_back(row[s[0]], row[s[1]], row[s[2]]);
        if (table.points.size() % 16384 == 0 && !source.goOn("reading points", rows.fraction() * 0.5)) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    if (layout.promisedRows && *layout.promisedRows != table.points.size()) {
        return source.refused("promises " + std::to_string(*layout.promisedRows) + " points and holds " +
                                  std::to_string(table.points.size()),
                              "copy the file again");
    }
    table.width = table.points.size();
    table.precision = precisionOf(rows.digits());
    table.unitMm = columns->unitMm;
    table.description = layout.description;
    if (endsWithoutLineEnd(source.text())) table.remarks.emplace_back(kMayBeCutOff);
    if (source.extension() == ".3d") {
        table.format = "3DTK scan";
        table.unitMm = 10.0; // 3DTK: centimetres, left-handed
        table.leftHanded = true;
    }
    return table;
}

/// Lists are read line by line whatever their length: the record takes one line, and whoever counts rows is hardly off.
void appendListComments(std::string& text, const CloudColumns& cloud) {
    if (cloud.frame != CoordinateFrame::Scanner) text += "# " + frameText(cloud) + "\n";
    for (const std::string& line : commentLines(cloud.description)) text += "# " + line + "\n";
    if (!cloud.record.empty()) text += "# " + (kRecordMark + cloud.record) + "\n";
}

template <char separator>
Result<std::string> pointTextBytes(const CloudColumns& cloud, const std::string& where, bool) {
    if (auto enough = checkRoom(cloud, where, 12); !enough) return enough.error();
    std::string text;
    appendListComments(text, cloud);
    if constexpr (separator == ' ') text += "# "; // many readers of .xyz take no header line
    for (std::size_t i = 0; i < cloud.columns.size(); ++i) {
        if (i > 0) text += separator;
        text += cloud.columns[i].name + (i < 3 ? "_m" : "");
    }
    text += '\n';
    appendRows(text, cloud, separator);
    return text;
}

} // namespace

Format pointListFormat() {
    return {.title = "Point list",
            .reads = {".xyz", ".txt", ".asc", ".pts"},
            .writes = {".xyz", ".txt", ".asc"},
            .points = readTextPoints,
            .write = pointTextBytes<' '>};
}

Format pointTableFormat() { return {.title = "Point table", .writes = {".csv"}, .points = readTextPoints, .write = pointTextBytes<','>}; }

Format scan3dFormat() { return {.title = "3DTK scan", .reads = {".3d"}, .points = readTextPoints}; }

} // namespace edgescan
