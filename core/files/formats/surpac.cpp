// Surpac string files (.str): lines between commas, "string number, northing, easting, elevation, descriptions". The first line names the
// file, the second holds an axis, string number 0 ends a string, and a last one with END ends the file (Surpac string file specification).

#include "core/base/number_text.h"
#include "core/files/formats/format.h"

#include "core/base/memory.h"
#include "core/files/point_tables/point_columns.h"
#include "core/files/point_tables/text_layout.h"
#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace edgescan::files {
namespace {

constexpr std::size_t kNumbers = 4; ///< string number, northing, easting, elevation

/// The first cells of a line between commas, and what follows them.
struct StringRow {
    std::array<std::string_view, kNumbers> cells{};
    std::size_t count = 0;
    std::string_view rest;

    /// The end of a string, or of the file.
    [[nodiscard]] bool ends() const { return count > 0 && cells[0] == "0"; }
    [[nodiscard]] bool endsFile() const { return ends() && rest.starts_with("END"); }
};

StringRow rowOf(std::string_view line) {
    StringRow row;
    std::size_t at = 0;
    while (at <= line.size() && row.count < kNumbers) {
        const std::size_t comma = std::min(line.find(',', at), line.size());
        row.cells[row.count++] = trimmed(line.substr(at, comma - at));
        at = comma + 1;
    }
    row.rest = at < line.size() ? trimmed(line.substr(at)) : std::string_view();
    return row;
}

std::optional<double> coordinateIn(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    return problem == std::errc{} && end == word.data() + word.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The line that ends the file is in its last bytes.
bool hasLastLine(std::string_view text) {
    const std::string_view tail = text.substr(text.size() - std::min<std::size_t>(text.size(), 4096));
    for (std::size_t at = 0; at < tail.size();) {
        const TextLine line = textLineAt(tail, at);
        at = line.next;
        if (rowOf(line.text).endsFile()) return true;
    }
    return false;
}

/// A first line with a name and no number, a second one with an axis of string 0; by their END, or by the extension.
bool looksLikeSurpac(const Source& source) {
    const std::string_view text = source.text();
    const TextLine first = textLineAt(text, 0);
    const StringRow name = rowOf(first.text);
    if (name.count < 2 || coordinateIn(name.cells[0])) return false;
    const StringRow axis = rowOf(textLineAt(text, std::min(first.next, text.size())).text);
    if (!axis.ends() || axis.count < kNumbers || !coordinateIn(axis.cells[1])) return false;
    return source.extension() == ".str" || hasLastLine(text);
}

Result<Done> addPoint(PointTable& table, const StringRow& row, PrintedDigits& digits, std::size_t lineNumber, const Source& source) {
    const auto northing = coordinateIn(row.cells[1]);
    const auto easting = coordinateIn(row.cells[2]);
    const auto elevation = coordinateIn(row.cells[3]);
    if (!northing || !easting || !elevation)
        return source.refusedAtLine(lineNumber, "a point of a string needs its number, northing, easting and elevation",
                                    "copy the file again, it may be cut off or damaged here");
    table.points.emplace_back(*easting, *northing, *elevation);
    for (std::size_t i = 1; i < kNumbers && table.points.size() < 20000; ++i) countDigits(row.cells[i], digits);
    return Done{};
}

Result<PointTable> readSurpacPoints(const Source& source) {
    if (const auto byte = firstByteThatIsNoText(source.text()))
        return source.refusedAtByte(*byte, "a Surpac string file is text, and this is none", "copy the file again");
    // A point takes ten bytes of text at least ("1,2,3,4" and its end) and 24 in memory, twice while it grows.
    if (auto enough = checkMemory(std::uint64_t{source.bytes.size()} * 6, source.path.string()); !enough) return enough.error();
    PointTable table;
    table.format = "Surpac strings";
    PrintedDigits digits;
    HeaderLines lines(source.text());
    lines.next();
    lines.next();
    bool described = false;
    bool ended = false;
    while (!ended && lines.next()) {
        if (trimmed(lines.line()).empty()) continue;
        const StringRow row = rowOf(lines.line());
        ended = row.endsFile();
        if (row.ends()) continue;
        if (auto added = addPoint(table, row, digits, lines.number(), source); !added) return added.error();
        described = described || !row.rest.empty();
        if (table.points.size() % 16384 == 0 &&
            !source.goOn("reading points", 0.5 * static_cast<double>(lines.nextByte()) / static_cast<double>(source.bytes.size())))
            return source.cancelled();
    }
    if (table.points.empty()) return source.refused("this Surpac file has no points", "choose another file");
    if (!ended) table.remarks.emplace_back("The file does not end with END: it may have been cut off; compare it with the original.");
    if (described) table.remarks.emplace_back("Descriptions of points (D1 and further) are not read.");
    std::size_t behind = 0;
    while (lines.next()) behind += trimmed(lines.line()).empty() ? 0 : 1;
    if (behind > 0) table.remarks.push_back(counted(behind, "line behind END was not read.", "lines behind END were not read."));
    table.width = table.points.size();
    table.precision = precisionOf(digits);
    return table;
}

} // namespace

Format surpacFormat() {
    return {.title = "Surpac strings", .reads = {".str"}, .recognises = looksLikeSurpac, .read = readingOf<readSurpacPoints>};
}

} // namespace edgescan::files
