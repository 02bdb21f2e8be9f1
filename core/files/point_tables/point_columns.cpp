// Records to points.
#include "core/files/point_tables/point_columns.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/bytes_behind.h"
#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/description.h"
#include "core/files/point_tables/text_layout.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace edgescan::files {
namespace {

constexpr std::size_t kRecordsAtOnce = 4096; // stay in the cache while their fields are read one after the other

std::uint8_t byteOf(double value, std::uint8_t otherwise) {
    return value >= 0 && value < 256 ? static_cast<std::uint8_t>(value) : otherwise;
}
std::uint8_t stateByte(double value) { return byteOf(value, 255); }

} // namespace

bool addToDescription(std::string_view comment, std::string& description) {
    while (comment.starts_with(' ')) comment.remove_prefix(1);
    while (comment.ends_with(' ') || comment.ends_with('\r')) comment.remove_suffix(1);
    constexpr std::string_view kOurs = "edgescan ";
    if (!comment.starts_with(kOurs)) return false;
    comment.remove_prefix(kOurs.size());
    if (description.empty() && !comment.starts_with('{')) return false;
    description += comment;
    return true;
}

std::optional<PointFields> pickFields(const std::vector<RecordField>& fields) {
    std::vector<std::string> names;
    for (const RecordField& field : fields) names.push_back(field.name);
    const NamedColumns named = columnsNamed(names);
    if (!named.hasPoint() || named.anglesForPoint) return std::nullopt;
    const auto field = [&](ColumnRole role) { return named[role] ? std::optional(fields[*named[role]]) : std::nullopt; };
    PointFields picked{*field(ColumnRole::X),
                       *field(ColumnRole::Y),
                       *field(ColumnRole::Z),
                       field(ColumnRole::RangeMm),
                       field(ColumnRole::State),
                       {},
                       {},
                       field(ColumnRole::Intensity),
                       field(ColumnRole::FilledSdMm),
                       {},
                       named.unitMm,
                       false};
    picked.returnNumber = field(ColumnRole::ReturnNumber);
    if (named.hasCell()) {
        picked.line = field(ColumnRole::Line);
        picked.beam = field(ColumnRole::Beam);
        picked.rowsAndColumns = named.rowsAndColumns;
    }
    if (named.hasScannerPoint())
        picked.scanner = {*field(ColumnRole::ScannerX), *field(ColumnRole::ScannerY), *field(ColumnRole::ScannerZ)};
    return picked;
}

bool givePlaces(PointTable& table, const PointFields& fields, std::size_t points, std::span<const std::byte> bytes, bool bigEndian,
                const Source& source) {
    table.unitMm = fields.unitMm ? fields.unitMm : table.unitMm;
    std::vector<Eigen::Vector3d> piece(std::min(kRecordsAtOnce, points));
    for (std::size_t first = 0; first < points; first += kRecordsAtOnce) {
        const std::size_t count = std::min(kRecordsAtOnce, points - first);
        const auto read = [&](const RecordField& field, Eigen::Index axis) {
            forEachScalar(field.scalar, bytes.data() + field.offset + first * field.stride, field.stride, count, bigEndian,
                          [&](std::size_t n, double value) { piece[n][axis] = value; });
        };
        read(fields.x, 0);
        read(fields.y, 1);
        read(fields.z, 2);
        source.receivePlaces(std::span(piece).first(count));
        if (!source.goOn("reading points", 0.5 * static_cast<double>(first) / static_cast<double>(points))) return false;
    }
    return true;
}

bool readRecords(PointTable& table, const PointFields& all, std::size_t points, std::span<const std::byte> bytes, bool bigEndian,
                 const Source& source) {
    PointFields fields = all;
    if (source.placesOnly) fields = {all.x, all.y, all.z, {}, {}, {}, {}, {}, {}, {}, all.unitMm, false};
    const bool rangesOnly = !source.placesOnly && all.rangeMm && all.state && !all.filledSdMm && needsRangesOnly(table.description);
    if (rangesOnly) {
        fields.line.reset();
        fields.beam.reset();
    }
    table.mayBeTurned = fields.rowsAndColumns;
    table.unitMm = fields.unitMm ? fields.unitMm : table.unitMm;
    if (!rangesOnly) table.points.resize(points);
    if (fields.rangeMm) table.rangeMm.resize(points);
    if (fields.state) table.state.resize(points);
    if (fields.intensity) table.intensity.resize(points);
    if (fields.filledSdMm) table.filledSdMm.resize(points);
    if (fields.returnNumber) table.returnNumber.resize(points);
    if (fields.line) table.line.resize(points);
    if (fields.beam) table.beam.resize(points);
    if (!fields.scanner.empty()) table.scannerPoints.resize(points);
    for (std::size_t first = 0; first < points; first += kRecordsAtOnce) {
        const auto read = [&](const RecordField& field, auto put) {
            forEachScalar(field.scalar, bytes.data() + field.offset + first * field.stride, field.stride,
                          std::min(kRecordsAtOnce, points - first), bigEndian, [&](std::size_t n, double value) { put(first + n, value); });
        };
        const auto readPoint = [&](std::vector<Eigen::Vector3d>& to, const RecordField& x, const RecordField& y, const RecordField& z) {
            read(x, [&](std::size_t n, double value) { to[n].x() = value; });
            read(y, [&](std::size_t n, double value) { to[n].y() = value; });
            read(z, [&](std::size_t n, double value) { to[n].z() = value; });
        };
        if (!rangesOnly) readPoint(table.points, fields.x, fields.y, fields.z);
        if (const auto& s = fields.scanner; !s.empty()) readPoint(table.scannerPoints, s[0], s[1], s[2]);
        if (fields.rangeMm) read(*fields.rangeMm, [&](std::size_t n, double value) { table.rangeMm[n] = static_cast<float>(value); });
        if (fields.state) read(*fields.state, [&](std::size_t n, double value) { table.state[n] = stateByte(value); });
        if (fields.intensity) read(*fields.intensity, [&](std::size_t n, double value) { table.intensity[n] = static_cast<float>(value); });
        if (fields.filledSdMm)
            read(*fields.filledSdMm, [&](std::size_t n, double value) { table.filledSdMm[n] = static_cast<float>(value); });
        if (fields.returnNumber) read(*fields.returnNumber, [&](std::size_t n, double value) { table.returnNumber[n] = byteOf(value, 1); });
        if (fields.line) read(*fields.line, [&](std::size_t n, double value) { table.line[n] = indexOf(value); });
        if (fields.beam) read(*fields.beam, [&](std::size_t n, double value) { table.beam[n] = indexOf(value); });
        if (first % 65536 == 0 && !source.goOn("reading points", 0.5 * static_cast<double>(first) / static_cast<double>(points)))
            return false;
    }
    return true;
}

Result<Done> checkRest(PointTable& table, std::uint64_t promised, std::uint64_t recordBytes, std::span<const std::byte> held,
                       const Source& source) {
    const auto rest = held.subspan(promised * recordBytes); // the caller has checked that so many are there
    if (rest.size() >= recordBytes && !isPadding(rest)) {
        return source.refused(withValues("the header promises %1 of %2 bytes and the file holds %3 bytes of them, which is more",
                                         {counted(promised, "point"), recordBytes, held.size()}),
                              "export the file again");
    }
    if (auto behind = bytesBehind(rest, "the points")) table.remarks.push_back(std::move(*behind));
    constexpr std::uint64_t kFewestEmpty = 16, kShare = 10;
    const auto isZero = [](std::byte byte) { return byte == std::byte{0}; };
    const auto records = held.first(promised * recordBytes);
    const auto last = std::ranges::find_if_not(records.rbegin(), records.rend(), isZero);
    const auto empty = static_cast<std::uint64_t>(last - records.rbegin()) / recordBytes;
    if (empty >= kFewestEmpty && empty * kShare >= promised)
        table.remarks.push_back(
            withValues("The last %1 of %2 points hold zeros in all bytes, as a power cut leaves them where a file was not written to its "
                       "end: they count as no return.",
                       {empty, promised}));
    return Done{};
}

Result<Done> readRows(PointTable& table, const PointFields& fields, const PromisedRows& promised, const Source& source) {
    const auto& [points, columns, firstByte, firstLine, last] = promised;
    table.unitMm = fields.unitMm ? fields.unitMm : table.unitMm;
    table.mayBeTurned = fields.rowsAndColumns;
    TextLayout layout;
    layout.firstByte = firstByte;
    layout.firstLine = firstLine;
    layout.columns = columns;
    RowReader rows(source, layout);
    rows.measure({fields.x.column, fields.y.column, fields.z.column});
    std::span<const double> row;
    while (table.points.size() < points && rows.next(row)) {
        if (row.size() != columns) {
            return source.refusedAtLine(rows.lineNumber(),
                                        withValues("holds %1 where the header promises %2", {counted(row.size(), "number"), columns}),
                                        "copy the file again");
        }
        table.points.emplace_back(row[fields.x.column], row[fields.y.column], row[fields.z.column]);
        if (fields.rangeMm) table.rangeMm.push_back(static_cast<float>(row[fields.rangeMm->column]));
        if (fields.state) table.state.push_back(stateByte(row[fields.state->column]));
        if (fields.intensity) table.intensity.push_back(static_cast<float>(row[fields.intensity->column]));
        if (fields.filledSdMm) table.filledSdMm.push_back(static_cast<float>(row[fields.filledSdMm->column]));
        if (fields.returnNumber) table.returnNumber.push_back(byteOf(row[fields.returnNumber->column], 1));
        if (fields.line) table.line.push_back(indexOf(row[fields.line->column]));
        if (fields.beam) table.beam.push_back(indexOf(row[fields.beam->column]));
        if (const auto& s = fields.scanner; !s.empty())
            table.scannerPoints.emplace_back(row[s[0].column], row[s[1].column], row[s[2].column]);
        if (table.points.size() % 16384 == 0 && !source.goOn("reading points", rows.fraction() * 0.5)) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    if (table.points.size() != points) {
        return source.refused(withValues("the header promises %1 and the file holds %2", {counted(points, "point"), table.points.size()}),
                              "copy the file again, it may be cut off");
    }
    if (last && (rows.next(row) || rows.problem())) {
        return source.refusedAtLine(rows.lineNumber(),
                                    withValues("the header promises %1, and more text follows them here", {counted(points, "point")}),
                                    "export the file again");
    }
    if (last && endsWithoutLineEnd(source.text())) table.remarks.emplace_back(kMayBeCutOff);
    table.precision = precisionOf(rows.digits());
    return Done{};
}

void takeUnitOfComment(PointTable& table, std::optional<double> unitMm, const Source& source) {
    if (table.unitMm || !unitMm || !table.description.empty()) return; // our own description has the unit
    table.unitMm = unitMm;
    if (!source.options->unitMm)
        table.remarks.push_back(withValues("Unit taken from a comment of the file: %1 mm per number.", {significantText(*unitMm, 8)}));
}

Precision precisionOf(const PrintedDigits& digits) {
    const double absolute = 0.5 * std::pow(10.0, -std::min(digits.decimals, 300));
    if (digits.fixedDecimals()) return {absolute, kFloatError};
    return {absolute, std::max(kFloatError, 0.5 * std::pow(10.0, 1 - std::max(digits.significant, 1)))};
}

bool HeaderLines::next() {
    if (nextByte_ >= text_.size()) return false;
    if (number_ == 0) { // a CR alone ends all lines where it ends the first one
        const std::size_t first = text_.find_first_of("\r\n");
        const bool alone = first != std::string_view::npos && text_[first] == '\r' && !text_.substr(first).starts_with("\r\n");
        lineEnd_ = alone ? '\r' : '\n';
    }
    std::size_t end = text_.find(lineEnd_, nextByte_);
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

} // namespace edgescan::files
