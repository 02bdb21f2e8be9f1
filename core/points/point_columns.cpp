// Records to points.
#include "core/points/point_columns.h"

#include "core/points/text_layout.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace edgescan {
namespace {

std::uint8_t stateByte(double value) { return value >= 0 && value < 256 ? static_cast<std::uint8_t>(value) : std::uint8_t{255}; }

} // namespace

std::optional<PointFields> pickFields(const std::vector<RecordField>& fields) {
    const auto named = [&](const char* name) -> std::optional<RecordField> {
        const auto found = std::find_if(fields.begin(), fields.end(), [&](const RecordField& field) { return field.name == name; });
        return found == fields.end() ? std::nullopt : std::optional(*found);
    };
    const auto x = named("x");
    const auto y = named("y");
    const auto z = named("z");
    if (!x || !y || !z) return std::nullopt;
    PointFields picked{*x, *y, *z, named("range_mm"), named("state"), {}};
    for (const char* name : {"scanner_x", "scanner_y", "scanner_z"}) {
        if (const auto field = named(name)) picked.scanner.push_back(*field);
    }
    if (picked.scanner.size() != 3) picked.scanner.clear();
    return picked;
}

bool readRecords(PointTable& table, const PointFields& fields, std::size_t points, std::span<const std::byte> bytes, bool bigEndian,
                 const Source& source) {
    table.points.reserve(points);
    const auto value = [&](const RecordField& field, std::size_t n) {
        return readScalar(field.scalar, bytes.data() + field.offset + n * field.stride, bigEndian);
    };
    for (std::size_t n = 0; n < points; ++n) {
        table.points.emplace_back(value(fields.x, n), value(fields.y, n), value(fields.z, n));
        if (fields.rangeMm) table.rangeMm.push_back(static_cast<float>(value(*fields.rangeMm, n)));
        if (fields.state) table.state.push_back(stateByte(value(*fields.state, n)));
        if (const auto& s = fields.scanner; !s.empty()) table.scannerPoints.emplace_back(value(s[0], n), value(s[1], n), value(s[2], n));
        if (n % 65536 == 0 && !source.goOn("reading points", 0.5 * static_cast<double>(n) / static_cast<double>(points))) return false;
    }
    return true;
}

Result<Done> readRows(PointTable& table, const PointFields& fields, std::size_t points, std::size_t columns, std::size_t firstByte,
                      std::size_t firstLine, const Source& source) {
    TextLayout layout;
    layout.firstByte = firstByte;
    layout.firstLine = firstLine;
    layout.columns = columns;
    RowReader rows(source, layout);
    rows.measure({fields.x.column, fields.y.column, fields.z.column});
    std::vector<double> row;
    while (table.points.size() < points && rows.next(row)) {
        if (row.size() != columns) {
            return source.refusedAtLine(
                rows.lineNumber(), "holds " + std::to_string(row.size()) + " numbers where the header promises " + std::to_string(columns),
                "copy the file again");
        }
        table.points.emplace_back(row[fields.x.column], row[fields.y.column], row[fields.z.column]);
        if (fields.rangeMm) table.rangeMm.push_back(static_cast<float>(row[fields.rangeMm->column]));
        if (fields.state) table.state.push_back(stateByte(row[fields.state->column]));
        if (const auto& s = fields.scanner; !s.empty())
            table.scannerPoints.emplace_back(row[s[0].column], row[s[1].column], row[s[2].column]);
        if (table.points.size() % 16384 == 0 && !source.goOn("reading points", rows.fraction() * 0.5)) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    if (table.points.size() != points) {
        return source.refused("the header promises " + std::to_string(points) + " points and the file holds " +
                                  std::to_string(table.points.size()),
                              "copy the file again, it may be cut off");
    }
    table.precision = precisionOf(rows.digits());
    return Done{};
}

Precision precisionOf(const PrintedDigits& digits) {
    const double absolute = 0.5 * std::pow(10.0, -std::min(digits.decimals, 300));
    if (digits.fixedDecimals()) return {absolute, kFloatError};
    return {absolute, std::max(kFloatError, 0.5 * std::pow(10.0, 1 - std::max(digits.significant, 1)))};
}

bool HeaderLines::next() {
    if (nextByte_ >= text_.size()) return false;
    std::size_t end = text_.find('\n', nextByte_);
    if (end == std::string_view::npos) end = text_.size();
    line_ = text_.substr(nextByte_, end - nextByte_);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    nextByte_ = std::min(end + 1, text_.size());
    ++number_;
    return true;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t at = 0;
    while (at < line.size()) {
        while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) ++at;
        const std::size_t from = at;
        while (at < line.size() && line[at] != ' ' && line[at] != '\t') ++at;
        if (at > from) words.push_back(line.substr(from, at - from));
    }
    return words;
}

std::optional<std::uint64_t> wholeNumber(std::string_view word) {
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

} // namespace edgescan
