// Point lists as text: .xyz .txt .asc .csv .pts and 3DTK's .3d.
#include "core/base/foreign_text.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/base/translated_text.h"
#include "core/files/formats/format.h"
#include "core/files/point_tables/axis_words.h"
#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/description.h"
#include "core/files/point_tables/point_columns.h"
#include "core/files/point_tables/point_table.h"
#include "core/files/point_tables/text_refusals.h"
#include "core/files/point_tables/text_words.h"
#include "core/scan/georef/placed_points.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace edgescan::files {
namespace {

// Two columns of whole numbers that no heading names.

constexpr std::size_t kFewestPoints = 12;
constexpr double kMostShared = 0.01;  // of the points, in a cell with another one: second returns
constexpr double kNeighboursAre = 5;  // times nearer than any two points
constexpr std::size_t kPairs = 20011; // looked at, enough for a median

struct PlacedCell {
    std::uint64_t cell = 0;
    std::size_t point = 0;
};

/// Cells in order, of all points that have a place.
std::vector<PlacedCell> cellsInOrder(const PointTable& table) {
    std::vector<PlacedCell> cells;
    cells.reserve(table.points.size());
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (!isReturn(table.points[n])) continue;
        cells.push_back({(std::uint64_t{table.line[n]} << 32U) | table.beam[n], n});
    }
    std::ranges::sort(cells, {}, [](const PlacedCell& c) { return std::pair(c.cell, c.point); });
    return cells;
}

std::size_t extent(const std::vector<std::uint32_t>& indexes) {
    const auto [least, most] = std::ranges::minmax(indexes);
    return std::size_t{most} - least + 1;
}

/// Whether table.line and table.beam are rows and columns of a grid, as FARO writes them, and no numbers, classes or colours: hardly two
/// points share a pair, every index has several points, and neighbours in the grid are neighbours in space.
bool areCells(const PointTable& table) {
    const std::size_t points = table.points.size();
    if (points < kFewestPoints || table.line.size() != points || table.beam.size() != points) return false;
    const auto missing = [](const auto& indexes) { return std::ranges::find(indexes, kNoIndex) != indexes.end(); };
    if (missing(table.line) || missing(table.beam)) return false;
    const std::size_t lines = extent(table.line);
    const std::size_t beams = extent(table.beam);
    if (lines < 2 || beams < 2 || points < 2 * std::max(lines, beams)) return false;
    const std::vector<PlacedCell> cells = cellsInOrder(table);
    if (cells.size() < kFewestPoints) return false;
    std::size_t shared = 0;
    std::size_t neighbours = 0;
    std::vector<double> toNeighbour, toFarCell;
    const std::size_t stride = std::max<std::size_t>(1, cells.size() / kPairs);
    for (std::size_t n = 1; n < cells.size(); ++n) {
        shared += cells[n].cell == cells[n - 1].cell ? 1 : 0;
        if (cells[n].cell != cells[n - 1].cell + 1) continue;
        if (neighbours++ % stride != 0) continue;
        const Eigen::Vector3d& here = table.points[cells[n].point];
        toNeighbour.push_back((here - table.points[cells[n - 1].point]).norm());
        toFarCell.push_back((here - table.points[cells[(n + cells.size() / 2) % cells.size()].point]).norm());
    }
    if (static_cast<double>(shared) > kMostShared * static_cast<double>(cells.size()) || 4 * neighbours < cells.size()) return false;
    return valueInOrder(toNeighbour, toNeighbour.size() / 2) * kNeighboursAre < valueInOrder(toFarCell, toFarCell.size() / 2);
}

constexpr std::size_t kRowsLookedAt = 200;

struct Columns {
    std::array<std::size_t, 3> xyz{0, 1, 2};
    NamedColumns named;
    std::size_t needed = 3;    ///< columns a row must have
    bool unnamedCells = false; ///< line and beam are the first two columns, which no heading names
};

/// Names of a table rather than a title between blanks or the numbers of its columns.
bool areWords(const TextLayout& layout) {
    const auto isNumber = [](const std::string& name) { return name.find_first_not_of("0123456789.") == std::string::npos; };
    return layout.names.size() >= 3 && std::ranges::none_of(layout.names, isNumber);
}

/// The heading names something, and not x, y and z in words that are understood: taking the columns by their order would be a guess.
/// Between blanks it may be a title.
bool namesOtherThings(const TextLayout& layout) {
    if (!areWords(layout)) return false;
    return layout.separator == ' ' ? namesOfAxes(layout.names) > 1 : !onlyCount(layout.names);
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

constexpr std::size_t kMostWholeFirst = 4;

/// Without names: how many columns of whole numbers, four at most, precede three with decimals. They are an intensity, a class, a
/// time, colours, or row and column of a grid (FARO), and not x.
std::size_t wholeNumbersFirst(const Source& source, const TextLayout& layout) {
    if (layout.columns < 4 || !layout.names.empty()) return 0;
    std::array<PrintedDigits, kMostWholeFirst + 3> digits;
    const std::size_t first = layout.labels ? 1 : 0;
    std::size_t looked = std::min(digits.size(), layout.columns);
    std::size_t at = layout.firstByte;
    for (std::size_t row = 0; row < kRowsLookedAt && at < source.text().size(); ++row) {
        const TextLine line = textLineAt(source.text(), at);
        at = line.next;
        const auto cells = cellsIn(line.text, layout);
        if (cells.empty()) continue;
        if (cells.size() < first + 4) return 0;
        looked = std::min(looked, cells.size() - first);
        for (std::size_t i = 0; i < looked; ++i) countDigits(cells[first + i], digits[i]);
    }
    const auto isWhole = [](const PrintedDigits& d) { return d.decimals == 0 && !d.powers; };
    const auto hasDecimals = [](const PrintedDigits& d) { return d.decimals >= 2; };
    for (std::size_t whole = 1; whole <= kMostWholeFirst && whole + 3 <= looked && isWhole(digits[whole - 1]); ++whole) {
        if (std::ranges::all_of(std::span(digits).subspan(whole, 3), hasDecimals)) return whole;
    }
    return 0;
}

constexpr const char* kSayColumns = "say which columns are easting (x), northing (y) and elevation (z), by number or name: --columns 2,1,3";

/// The column that a word of --columns means: its number from 1, or its name.
std::optional<std::size_t> columnOfWord(std::string_view word, const TextLayout& layout) {
    if (const auto number = wholeNumber(word)) return *number >= 1 && *number <= layout.columns ? std::optional(*number - 1) : std::nullopt;
    const auto name = std::ranges::find(layout.names, headingLetters(word), [](const std::string& n) { return headingLetters(n); });
    if (name == layout.names.end()) return std::nullopt;
    return static_cast<std::size_t>(name - layout.names.begin());
}

/// x, y and z as the user says them.
Result<std::array<std::size_t, 3>> columnsAsked(const TextLayout& layout, const Source& source) {
    std::array<std::size_t, 3> xyz{};
    std::string_view asked = source.options->columns;
    std::size_t axis = 0;
    for (bool more = true; more; ++axis) {
        const std::size_t comma = asked.find(',');
        const auto column = axis < 3 ? columnOfWord(asked.substr(0, comma), layout) : std::nullopt;
        if (!column) break;
        xyz[axis] = *column;
        more = comma != std::string_view::npos;
        if (more) asked.remove_prefix(comma + 1);
        if (!more && axis == 2 && xyz[0] != xyz[1] && xyz[1] != xyz[2] && xyz[0] != xyz[2]) return xyz;
    }
    return source.refused(withValues("--columns %1 does not name three different ones of its %2%3",
                                     {source.options->columns, counted(layout.columns, "column"),
                                      layout.names.empty() ? std::string() : " (" + joined(layout.names) + ")"}),
                          "give three numbers from 1, or three names, such as --columns 2,1,3");
}

Result<Columns> columnsOf(const TextLayout& layout, const Source& source) {
    if (layout.columns < 3) {
        return source.refusedAtLine(layout.firstLine, withValues("holds %1 where a point needs three", {counted(layout.columns, "number")}),
                                    "choose a point list or a table of ranges");
    }
    Columns columns;
    columns.named = columnsNamed(layout.names);
    if (!source.options->columns.empty()) {
        const auto asked = columnsAsked(layout, source);
        if (!asked) return asked.error();
        columns.named.anglesForPoint = false;
        for (std::size_t axis = 0; axis < 3; ++axis) columns.named.of[axis] = (*asked)[axis];
    } else if (const auto other = contentsNamed(layout.names)) {
        return source.refused(withValues("its heading names %1 (%2), and points need x, y and z in metres", {*other, joined(layout.names)}),
                              std::string("write x, y and z, or ranges as a table with a row per scan line; or ") + kSayColumns);
    } else if (!columns.named.hasPoint() && namesOtherThings(layout)) {
        return source.refused(withValues(namesOfAxes(layout.names) > 0
                                             ? "its heading names axes (%1), and not all of x, y and z are understood"
                                             : "its heading names no x, y and z that are understood (%1)",
                                         {joined(layout.names)}),
                              kSayColumns);
    }
    if (columns.named.hasPoint()) {
        for (std::size_t axis = 0; axis < 3; ++axis) columns.xyz[axis] = *columns.named.of[axis];
    }
    if (const std::size_t whole = wholeNumbersFirst(source, layout); whole > 0) {
        columns.xyz = {whole, whole + 1, whole + 2};
        if (whole == 2) { // FARO: row and column; which of them counts the lines shows itself
            columns.named.of[static_cast<std::size_t>(ColumnRole::Line)] = 1;
            columns.named.of[static_cast<std::size_t>(ColumnRole::Beam)] = 0;
            columns.unnamedCells = true;
        }
    }
    columns.needed = std::max({columns.xyz[0], columns.xyz[1], columns.xyz[2]}) + 1;
    if (const auto& angles = columns.named.angles) columns.needed = std::max({columns.needed, angles->azimuth + 1, angles->elevation + 1});
    for (const auto& column : columns.named.of) {
        const bool mayBeMissing = &column == &columns.named.of[static_cast<std::size_t>(ColumnRole::Intensity)] ||
                                  &column == &columns.named.of[static_cast<std::size_t>(ColumnRole::ReturnNumber)] ||
                                  &column == &columns.named.of[static_cast<std::size_t>(ColumnRole::FilledSdMm)];
        if (column && !mayBeMissing) columns.needed = std::max(columns.needed, *column + 1);
    }
    return columns;
}

/// What was taken for x, y and z where no heading says it; empty where one does, or where numbers are all that there is.
std::optional<std::string> guessedColumns(const Columns& columns, const TextLayout& layout, bool cells) {
    static constexpr std::array<const char*, kMostWholeFirst + 1> kTaken{"", "the second to the fourth", "the third to the fifth",
                                                                         "the fourth to the sixth", "the fifth to the seventh"};
    static constexpr std::array<const char*, kMostWholeFirst + 1> kWhole{"", "the first holds", "the first two hold",
                                                                         "the first three hold", "the first four hold"};
    if (columns.named.hasPoint()) return std::nullopt;
    if (cells)
        return "No heading names the columns: the first two were taken for row and column of the grid, the third to the fifth for x, y and "
               "z.";
    if (const std::size_t whole = columns.xyz[0]; whole > 0) {
        return withValues("No heading names the columns: %1 were taken for x, y and z, as %2 whole numbers only.",
                          {kTaken[whole], kWhole[whole]});
    }
    if (areWords(layout)) {
        return withValues("The header names no x, y and z: the first three columns were taken for them (%1, %2, %3).",
                          {layout.names[0], layout.names[1], layout.names[2]});
    }
    if (!layout.unusedHeading.empty()) {
        return withValues("The heading does not name as many columns as there are (%1): the first three were taken for x, y and z.",
                          {layout.unusedHeading});
    }
    return std::nullopt;
}

/// As many as the text has line ends, and a little more; of long texts by looking at pieces of it.
std::size_t expectedRows(std::string_view text) {
    constexpr std::size_t kPiece = std::size_t{1} << 14U, kPieces = 64;
    const auto lineEnds = [](std::string_view part) { return static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n')); };
    if (text.size() <= 2 * kPiece * kPieces) return lineEnds(text) + 1;
    std::size_t seen = 0;
    for (std::size_t n = 0; n < kPieces; ++n) seen += lineEnds(text.substr((text.size() - kPiece) / (kPieces - 1) * n, kPiece));
    return static_cast<std::size_t>(1.03 * static_cast<double>(seen) * static_cast<double>(text.size()) / (kPiece * kPieces)) + 1;
}

/// Room for the rows expected, but for no more than the text's bytes suffice for.
void reserveRows(PointTable& table, const Source& source, const TextLayout& layout, const NamedColumns& named, bool rangesOnly) {
    const std::string_view text = source.text();
    const std::size_t rows = std::min(expectedRows(text), text.size() / (2 * layout.columns) + 1);
    if (!rangesOnly) table.points.reserve(rows);
    if (named[ColumnRole::RangeMm]) table.rangeMm.reserve(rows);
    if (named[ColumnRole::State]) table.state.reserve(rows);
    if (named[ColumnRole::Intensity]) table.intensity.reserve(rows);
    if (named.hasCell() && !rangesOnly) {
        table.line.reserve(rows);
        table.beam.reserve(rows);
    }
    if (named.hasScannerPoint()) table.scannerPoints.reserve(rows);
}

Result<Done> checkIsText(const Source& source) {
    if (const auto byte = firstByteThatIsNoText(source.text()))
        return source.refusedAtByte(*byte, "this is neither text nor any scan format that is known", kChooseScan);
    return Done{};
}

/// What of a row goes into the table.
struct RowUse {
    NamedColumns named;
    std::array<std::size_t, 3> xyz{};
    std::size_t needed = 0;  ///< columns a row must have
    bool rangesOnly = false; ///< the description says where the points are
    bool givenAway = false;  ///< to Source::receivePlaces
};

RowUse rowUseOf(const Columns& columns, const TextLayout& layout, const Source& source) {
    RowUse use{columns.named, columns.xyz, columns.needed};
    if (source.placesOnly) {
        for (std::size_t role = static_cast<std::size_t>(ColumnRole::Z) + 1; role < kColumnRoles; ++role) use.named.of[role].reset();
        use.needed = std::max({use.xyz[0], use.xyz[1], use.xyz[2]}) + 1;
        if (!use.named.anglesForPoint) use.named.angles.reset();
    }
    use.rangesOnly = use.named[ColumnRole::RangeMm] && use.named[ColumnRole::State] && !use.named[ColumnRole::FilledSdMm] &&
                     needsRangesOnly(layout.description);
    use.givenAway = source.placesOnly && source.receivePlaces && !columns.unnamedCells && !use.named.anglesForPoint;
    return use;
}

void addRow(PointTable& table, std::span<const double> row, const RowUse& use) {
    const NamedColumns& named = use.named;
    const auto value = [&](ColumnRole role) { return row[*named[role]]; };
    if (!use.rangesOnly) table.points.emplace_back(row[use.xyz[0]], row[use.xyz[1]], row[use.xyz[2]]);
    if (named[ColumnRole::RangeMm]) table.rangeMm.push_back(static_cast<float>(value(ColumnRole::RangeMm)));
    if (named[ColumnRole::State]) {
        const double state = value(ColumnRole::State);
        table.state.push_back(state >= 0 && state < 256 ? static_cast<std::uint8_t>(state) : std::uint8_t{255});
    }
    if (const auto intensity = named[ColumnRole::Intensity]) {
        table.intensity.push_back(*intensity < row.size() ? static_cast<float>(row[*intensity]) : std::numeric_limits<float>::quiet_NaN());
    }
    if (const auto filled = named[ColumnRole::FilledSdMm])
        table.filledSdMm.push_back(*filled < row.size() ? static_cast<float>(row[*filled]) : 0.0F);
    if (const auto number = named[ColumnRole::ReturnNumber]) {
        const double counted = *number < row.size() ? row[*number] : 1.0;
        table.returnNumber.push_back(counted >= 0 && counted < 256 ? static_cast<std::uint8_t>(counted) : std::uint8_t{1});
    }
    if (named.hasCell() && !use.rangesOnly) {
        table.line.push_back(indexOf(value(ColumnRole::Line)));
        table.beam.push_back(indexOf(value(ColumnRole::Beam)));
    }
    if (named.hasScannerPoint())
        table.scannerPoints.emplace_back(value(ColumnRole::ScannerX), value(ColumnRole::ScannerY), value(ColumnRole::ScannerZ));
}

Error tooFewNumbers(const RowReader& rows, std::size_t numbers, std::size_t needed, std::size_t rowsRead, const TextLayout& layout,
                    const Source& source) {
    if (layout.promisedRows && numbers == 1 && rowsRead == *layout.promisedRows) {
        return source.refusedAtLine(rows.lineNumber(),
                                    withValues("begins a further list, behind the %1 of the first", {counted(rowsRead, "point")}),
                                    "save each scan in a file of its own");
    }
    return source.refusedAtLine(rows.lineNumber(), withValues("holds %1 where a point needs %2", {counted(numbers, "number"), needed}),
                                "the file may be cut off here, copy it again");
}

/// All rows of the text, and the angles of points that have some. Sets the table's width to their number.
Result<Done> addRows(PointTable& table, RowReader& rows, const RowUse& use, const TextLayout& layout, const Source& source) {
    constexpr std::size_t kGivenAtOnce = 4096;
    const auto giveAway = [&] {
        source.receivePlaces(table.points);
        table.points.clear();
    };
    const bool besides = use.named.angles && !use.named.anglesForPoint && !use.rangesOnly;
    std::vector<Eigen::Vector2d> angles;
    std::span<const double> row;
    std::size_t rowsRead = 0;
    while (rows.next(row)) {
        if (row.size() < use.needed) return tooFewNumbers(rows, row.size(), use.needed, rowsRead, layout, source);
        ++rowsRead;
        addRow(table, row, use);
        if (besides) angles.emplace_back(row[use.named.angles->azimuth], row[use.named.angles->elevation]);
        if (use.givenAway && table.points.size() == kGivenAtOnce) giveAway();
        if (rowsRead % 16384 == 0 && !source.goOn("reading points", rows.fraction() * 0.5)) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    if (layout.promisedRows && *layout.promisedRows != rowsRead) {
        return source.refused(withValues("promises %1 and holds %2", {counted(*layout.promisedRows, "point"), rowsRead}),
                              "copy the file again");
    }
    if (use.givenAway) giveAway();
    table.width = rowsRead;
    if (besides) setCellsFromAngles(table, angles, *use.named.angles);
    return Done{};
}

/// What the heading, the columns and the name of the file say of the points.
void describePoints(PointTable& table, const Columns& columns, const RowUse& use, const TextLayout& layout, const Source& source) {
    table.unitMm = use.named.unitMm;
    table.description = layout.description;
    takeUnitOfComment(table, layout.unitMm, source);
    if (endsWithoutLineEnd(source.text())) table.remarks.emplace_back(kMayBeCutOff);
    const bool cells = columns.unnamedCells && areCells(table);
    if (columns.unnamedCells && !cells) {
        table.line.clear();
        table.beam.clear();
    }
    table.mayBeTurned = !table.line.empty() && (cells || use.named.rowsAndColumns);
    if (auto guess = guessedColumns(columns, layout, cells)) table.remarks.push_back(std::move(*guess));
    if (source.extension() != ".3d") return;
    table.format = "3DTK scan";
    table.unitMm = 10.0; // 3DTK: centimetres, left-handed
    table.leftHanded = true;
}

Result<PointTable> readTextPoints(const Source& source) {
    if (auto text = checkIsText(source); !text) return text.error();
    const auto layout = textLayoutOf(source);
    if (!layout) return layout.error();
    const auto columns = columnsOf(*layout, source);
    if (!columns) return columns.error();
    // A point takes six bytes of text at least and 24 in memory, a little more while it grows and its grid is found.
    if (auto enough = checkMemory(std::uint64_t{source.bytes.size()} * 10, source.path.string()); !enough) return enough.error();
    PointTable table;
    table.format = "point list";
    const RowUse use = rowUseOf(*columns, *layout, source);
    if (!use.givenAway) reserveRows(table, source, *layout, use.named, use.rangesOnly);
    RowReader rows(source, *layout);
    rows.measure(use.xyz);
    if (source.placesOnly) rows.limitColumns(use.needed);
    if (auto added = addRows(table, rows, use, *layout, source); !added) return added.error();
    table.precision = precisionOf(rows.digits());
    if (use.named.anglesForPoint) setPointsFromAngles(table, *use.named.angles);
    describePoints(table, *columns, use, *layout, source);
    return table;
}

/// Rows without a point would not be numbers.
void dropEmptyRows(CloudColumns& cloud) {
    const CloudColumn* state = columnNamed(cloud, "state");
    if (state == nullptr) return;
    std::vector<bool> isPoint(rowsOf(cloud));
    for (std::size_t row = 0; row < isPoint.size(); ++row) isPoint[row] = numberIn(*state, row) == 0 && pointIn(cloud, row).allFinite();
    for (CloudColumn& column : cloud.columns) {
        std::visit(
            [&](auto& values) {
                std::size_t row = 0;
                std::erase_if(values, [&](const auto&) { return !isPoint[row++]; });
            },
            column.values);
    }
    cloud.width = static_cast<std::size_t>(std::ranges::count(isPoint, true));
    cloud.height = 1;
}

/// Lists are read line by line, so the record may be one long line: programs that count rows are off by one only.
/// A spreadsheet cuts the comments of a `table` at their commas too, and would take a part for a formula.
void appendListComments(std::string& text, const CloudColumns& cloud, bool table) {
    const auto written = [&](const std::string& json) { return table ? jsonWithoutFormulas(json) : json; };
    if (cloud.frame != CoordinateFrame::Scanner) text += "# " + frameText(cloud) + "\n";
    for (const std::string& line : commentLines(written(cloud.description))) text += "# " + line + "\n";
    if (!cloud.record.empty()) text += "# " + (kRecordMark + written(cloud.record)) + "\n";
}

void appendNames(std::string& text, const CloudColumns& cloud, char separator) {
    const auto coordinates = coordinateNames(cloud.frame);
    for (std::size_t i = 0; i < cloud.columns.size(); ++i) {
        if (i > 0) text += separator;
        text += i < 3 ? coordinates[i] : cloud.columns[i].name;
    }
    text += '\n';
}

/// Nothing but numbers, as every program takes it; with comments all columns, their names behind a mark of comment.
Result<std::string> xyzBytes(CloudColumns cloud, const std::string& where, bool) {
    if (auto enough = checkRoom(cloud, where, 12); !enough) return enough.error();
    dropColumns(cloud, isColour);
    std::string text;
    if (cloud.choices.comments) {
        appendListComments(text, cloud, false);
        text += "# ";
        appendNames(text, cloud, ' ');
    } else {
        makeAll(cloud);
        dropEmptyRows(cloud);
        cloud.description.clear(); // the sidecar has it
        cloud.columns.erase(cloud.columns.begin() + 3, cloud.columns.end());
    }
    appendRows(text, cloud, ' ');
    return text;
}

/// A plain header row and rows.
Result<std::string> csvBytes(CloudColumns cloud, const std::string& where, bool) {
    if (auto enough = checkRoom(cloud, where, 12); !enough) return enough.error();
    dropColumns(cloud, isColour);
    std::string text;
    if (cloud.choices.comments) {
        appendListComments(text, cloud, true);
    } else {
        makeAll(cloud);
        dropEmptyRows(cloud);
        cloud.description.clear(); // the sidecar has it
        dropColumns(cloud, [](std::string_view name) { return name == "state"; });
    }
    appendNames(text, cloud, ',');
    appendRows(text, cloud, ',');
    return text;
}

} // namespace

Format pointListFormat() {
    return {.title = "Point list",
            .reads = {".xyz", ".txt", ".asc", ".pts"},
            .writes = {".xyz", ".txt", ".asc"},
            .read = readingOf<readTextPoints>,
            .write = xyzBytes,
            .keeps = Keeps::Sidecar,
            .inFloats = {"MeshLab", "PCL", "three.js"},
            .writesByLines = true,
            .options = {"columns"}};
}

Format pointTableFormat() {
    return {.title = "Point table",
            .writes = {".csv"},
            .read = readingOf<readTextPoints>,
            .write = csvBytes,
            .keeps = Keeps::Sidecar,
            .keepsIntensity = true,
            .writesByLines = true,
            .options = {"columns"}};
}

Format scan3dFormat() { return {.title = "3DTK scan", .reads = {".3d"}, .read = readingOf<readTextPoints>, .options = {"columns"}}; }

} // namespace edgescan::files
