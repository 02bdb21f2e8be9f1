// Range tables (thesis figure 5.7): one text line per scan line, as spreadsheets, pandas and numpy write them.

#include "core/base/translated_text.h"
#include "core/files/formats/format.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/files/formats/range_geometry.h"
#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/point_columns.h"
#include "core/files/point_tables/text_layout.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace edgescan::files {
namespace {

constexpr std::size_t kFewestRangeColumns = 16; // point lists have x y z and a few attributes
constexpr std::size_t kLms511Columns = 1141;
constexpr std::size_t kPeekedRows = 20;

/// A column's name as its number and the text around it: "beam_12", "-4.83", "r7 [m]".
struct NumberedName {
    std::string around;
    double number = std::nan("");
};
NumberedName numberedName(const std::string& name) {
    const std::size_t digit = name.find_first_of("0123456789");
    if (digit == std::string::npos) return {name};
    const std::size_t from = digit == 1 && name[0] == '-' ? 0 : digit; // a sign, where nothing precedes it
    NumberedName found;
    const auto [end, problem] = std::from_chars(name.data() + from, name.data() + name.size(), found.number);
    if (problem != std::errc{}) return {name};
    found.around = name.substr(0, from) + "#" + std::string(end, name.data() + name.size());
    return found;
}

/// Numbers that run evenly.
struct Run {
    double first = 0, step = 0;
    [[nodiscard]] double last(std::size_t count) const { return first + step * static_cast<double>(count - 1); }
    /// Angles in degrees rather than counts, radians or anything else.
    [[nodiscard]] bool isDegrees(std::size_t count) const {
        const double span = std::abs(last(count) - first);
        return step != 1 && span > 7 && span <= 361 && std::abs(first) <= 361;
    }
};

/// The columns of a table that hold ranges.
struct RangeColumns {
    std::size_t first = 0, count = 0;
    Run numbers; ///< in their names; a step of 0: none
};

/// The longest run of names that count, and all columns where there are no names.
RangeColumns rangeColumnsOf(const TextLayout& layout) {
    if (layout.names.empty()) return {0, layout.columns, {}};
    std::vector<NumberedName> names;
    for (const std::string& name : layout.names) names.push_back(numberedName(name));
    RangeColumns best;
    for (std::size_t i = 0; i + 1 < names.size();) {
        const double step = names[i + 1].number - names[i].number;
        std::size_t end = i + 1;
        while (end < names.size() && names[end].around == names[i].around && step != 0 &&
               std::abs(names[end].number - names[i].number - step * static_cast<double>(end - i)) <= 0.05 * std::abs(step))
            ++end;
        if (end - i > best.count) best = {i, end - i, {names[i].number, step}};
        i = std::max(i + 1, end - 1);
    }
    if (best.count >= 2)
        best.numbers.step = (names[best.first + best.count - 1].number - best.numbers.first) / static_cast<double>(best.count - 1);
    return best;
}

/// An empty column behind the last separator is the last beam of an LMS511 that saw nothing.
void countEmptyBeam(TextLayout& layout) {
    if (!layout.trailingSeparator || layout.columns + 1 != kLms511Columns) return;
    layout.trailingSeparator = false;
    ++layout.columns;
}

/// Ranges rather than points: many columns that are numbered or have no names, or few with the geometry given.
bool looksLikeRangeCsv(const Source& source) {
    if (firstByteThatIsNoText(source.text())) return false;
    const auto layout = textLayoutOf(source);
    if (!layout || !layout->description.empty() || columnsNamed(layout->names).hasPoint()) return false;
    const RangeColumns columns = rangeColumnsOf(*layout);
    if (columns.count >= kFewestRangeColumns) return true;
    const ReadingOptions& options = *source.options;
    return source.extension() == ".csv" && columns.count > 0 && options.beamStepDeg && options.lineStepDeg;
}

/// What a table that was given by mistake shows in its first rows, before its angles are asked for.
Result<Done> checkFirstRows(const TextLayout& layout, const RangeColumns& columns, const Source& source) {
    RowReader rows(source, layout);
    std::vector<double> row;
    for (std::size_t i = 0; i < kPeekedRows && rows.next(row); ++i) {
        for (std::size_t j = columns.first; j < std::min(row.size(), columns.first + columns.count); ++j) {
            if (!std::isfinite(row[j]) || row[j] >= 0 || isNoRangeMark(row[j])) continue;
            return source.refusedAtLine(rows.lineNumber(),
                                        withValues("column %1 holds %2, so this is not a table of ranges", {j + 1, shortestText(row[j])}),
                                        "for a list of points call its columns x, y and z in a first row, and leave out --beam-step and "
                                        "--line-step");
        }
    }
    return Done{};
}

Result<Done> checkWidth(const TextLayout& layout, const RangeColumns& columns, const Source& source) {
    auto known = checkAnglesKnown(columns.count, kTable, source);
    if (known) return known;
    const std::string_view text = source.text().substr(layout.firstByte);
    const auto rows = static_cast<std::size_t>(std::ranges::count(text, '\n')) + (endsWithoutLineEnd(text) ? 1 : 0);
    if (rows != kLms511Columns) return known;
    Error error = known.error();
    error.hint += "; or save it with a row per scan line: it has as many rows as an LMS511 has beams";
    return error;
}

struct Table {
    BareRanges ranges;
    std::vector<double> labels; ///< one per line where they are numbers
    bool whole = false;         ///< no number has a point
};

Result<Table> readTable(const Source& source, const TextLayout& layout, const RangeColumns& columns) {
    Table table;
    table.ranges.beams = columns.count;
    RowReader rows(source, layout);
    rows.measureAll();
    std::vector<double> row;
    while (rows.next(row)) {
        if (row.size() != layout.columns) {
            return source.refusedAtLine(
                rows.lineNumber(), withValues("holds %1 where the first line holds %2", {counted(row.size(), "range"), layout.columns}),
                "copy or export the file again");
        }
        const auto from = row.begin() + static_cast<std::ptrdiff_t>(columns.first);
        table.ranges.values.insert(table.ranges.values.end(), from, from + static_cast<std::ptrdiff_t>(columns.count));
        double label = std::nan("");
        const std::string_view text = rows.label();
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), label);
        table.labels.push_back(problem == std::errc{} && end == text.data() + text.size() ? label : std::nan(""));
        ++table.ranges.lines;
        if (table.ranges.lines % 64 == 0 && !source.goOn("reading ranges", rows.fraction())) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    table.whole = rows.digits().decimals == 0;
    table.ranges.precision = precisionOf(rows.digits());
    return table;
}

/// Evenly running labels; a step of 0 when they do not.
Run runOf(const std::vector<double>& labels) {
    if (labels.size() < 2) return {};
    const Run run{labels.front(), (labels.back() - labels.front()) / static_cast<double>(labels.size() - 1)};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!(std::abs(labels[i] - run.first - run.step * static_cast<double>(i)) <= 0.05 * std::abs(run.step))) return {};
    }
    return run;
}

/// Takes angles from the labels around the table, where the user gave none. What was taken, as a sentence; empty when nothing was.
std::string applyLabelAngles(const Run& run, std::size_t count, const char* sentence, std::optional<double>& start,
                             std::optional<double>& step) {
    if (start || step || count < 2 || run.step == 0 || !run.isDegrees(count)) return {};
    start = run.first;
    step = run.step;
    return withValues(sentence, {significantText(run.first, 6), significantText(run.last(count), 6)});
}

std::string leftOutText(const TextLayout& layout, const RangeColumns& columns) {
    std::string names;
    std::size_t others = 0;
    for (std::size_t j = 0; j < layout.names.size(); ++j) {
        if (j >= columns.first && j < columns.first + columns.count) continue;
        if (++others <= 6) names += (names.empty() ? "" : ", ") + layout.names[j];
    }
    if (others == 0) return {};
    return withValues(counted(others, "column is not ranges, by the header, and not read: %1.",
                              "columns are not ranges, by the header, and not read: %1."),
                      {names + (others > 6 ? " ..." : "")});
}

/// 0 and empty cells are missing returns. Geometry from the options or the table's own header and index, or the LMS511 defaults.
Result<Scan> readRangeCsv(const Source& source) {
    auto found = textLayoutOf(source);
    if (!found) return found.error();
    TextLayout& layout = *found;
    countEmptyBeam(layout);
    const RangeColumns columns = rangeColumnsOf(layout);
    if (auto fits = checkFirstRows(layout, columns, source); !fits) return fits.error();
    // A cell takes a byte of text at least; in memory eight that may double while growing, five in the scan, and eight more of a range,
    // which takes two bytes. A row of labels eight, a row being read eight each.
    if (auto enough = checkMemory(std::uint64_t{source.bytes.size()} * 41, source.path.string()); !enough) return enough.error();
    ReadingOptions options = *source.options;
    Source asked = source;
    asked.options = &options;
    std::vector<std::string> warnings;
    const auto warn = [&](std::string sentence) {
        if (!sentence.empty()) warnings.push_back(std::move(sentence));
    };
    warn(applyLabelAngles(columns.numbers, columns.count, "The angles of the beams were taken from the header: %1 to %2 degrees.",
                          options.beamStartDeg, options.beamStepDeg));
    auto table = readTable(source, layout, columns);
    if (!table) return table.error();
    warn(applyLabelAngles(runOf(table->labels), table->labels.size(),
                          "The angles of the lines were taken from the first column: %1 to %2 degrees.", options.lineStartDeg,
                          options.lineStepDeg));
    if (auto known = checkWidth(layout, columns, asked); !known) return known.error();
    if (layout.unitMm && !options.unitMm)
        warn(withValues("Unit taken from a comment of the file: %1 mm per number.", {significantText(*layout.unitMm, 8)}));
    if (!options.unitMm) options.unitMm = layout.unitMm ? layout.unitMm : table->whole ? std::optional(1.0) : std::nullopt;
    auto scan = scanFromRanges(std::move(table->ranges), kTable, asked, [&](std::size_t line, std::size_t beam) {
        return withValues("line %1, beam %2", {line, beam});
    });
    if (!scan) return scan;
    scan->format = "range CSV";
    scan->unitMm = source.options->unitMm.value_or(1.0);
    warn(leftOutText(layout, columns));
    if (endsWithoutLineEnd(source.text())) warn(kMayBeCutOff);
    scan->warnings.insert(scan->warnings.end(), warnings.begin(), warnings.end());
    return scan;
}

} // namespace

Format rangeTableFormat() {
    return {.title = "Range or point table", .reads = {".csv"}, .recognises = looksLikeRangeCsv, .read = readingOf<readRangeCsv>};
}

} // namespace edgescan::files
