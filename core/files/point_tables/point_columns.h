// Picks the columns that matter out of a format's fields and reads them into a point table.
#pragma once

#include "core/files/point_tables/binary_field.h"
#include "core/files/point_tables/point_table.h"
#include "core/files/point_tables/text_layout.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace edgescan::files {

inline constexpr const char* kCopyAgain = "copy the file again, it may be cut off"; ///< what to do about fewer bytes than promised
inline constexpr std::uint64_t kMostPoints = 0xFFFFFFF0;                            ///< that a header may promise

/// One field of a record. In text `column` counts numbers, in binary record n of the field starts at offset + n * stride.
struct RecordField {
    std::string name;
    Scalar scalar = Scalar::Float32;
    std::size_t column = 0;
    std::size_t offset = 0;
    std::size_t stride = 0;
};

/// Fields x y z by any of their usual names, line and beam where both are present, intensity, and our own range_mm, state, filled_sd_mm and
/// scanner_x scanner_y scanner_z.
struct PointFields {
    RecordField x, y, z;
    std::optional<RecordField> rangeMm, state, line, beam, intensity, filledSdMm;
    std::vector<RecordField> scanner; ///< three or zero
    std::optional<double> unitMm;     ///< where the names of x y z say it
    bool rowsAndColumns = false;      ///< line and beam are called row and column
    std::optional<RecordField> returnNumber{};
};

/// Empty when x, y or z is missing.
[[nodiscard]] std::optional<PointFields> pickFields(const std::vector<RecordField>& fields);

/// Reads `points` records out of checked bytes. False when the user cancelled.
bool readRecords(PointTable& table, const PointFields& fields, std::size_t points, std::span<const std::byte> bytes, bool bigEndian,
                 const Source& source);

/// The same where only places are asked for and are given away (Source::receivePlaces); the table stays empty.
bool givePlaces(PointTable& table, const PointFields& fields, std::size_t points, std::span<const std::byte> bytes, bool bigEndian,
                const Source& source);

/// Rows of numbers as a header promises them.
struct PromisedRows {
    std::size_t points = 0, columns = 0;
    std::size_t firstByte = 0, firstLine = 1; ///< of the file
    bool last = true;                         ///< nothing else follows: more rows are an error
};
/// Reads exactly these rows. Error: fewer, more, or other columns.
Result<Done> readRows(PointTable& table, const PointFields& fields, const PromisedRows& promised, const Source& source);

/// What follows the records that a header promises, in the bytes `held` from the first record on. Error: as much as a further record, so
/// that the header is wrong; less is a remark, and padding with zeros is neither.
Result<Done> checkRest(PointTable& table, std::uint64_t promised, std::uint64_t recordBytes, std::span<const std::byte> held,
                       const Source& source);

/// The unit that a comment of the file states, where its columns state none. A remark says so.
void takeUnitOfComment(PointTable& table, std::optional<double> unitMm, const Source& source);

/// Rounding errors of numbers printed like that.
[[nodiscard]] Precision precisionOf(const PrintedDigits& digits);

/// The lines of a header, one at a time.
class HeaderLines {
public:
    explicit HeaderLines(std::string_view text) : text_(text) {}
    /// False when there is no further line.
    bool next();
    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t number() const { return number_; } ///< of line(), from 1
    [[nodiscard]] std::size_t nextByte() const { return nextByte_; }

private:
    std::string_view text_, line_;
    std::size_t number_ = 0;
    std::size_t nextByte_ = 0;
    char lineEnd_ = '\n';
};

/// Words between blanks.
[[nodiscard]] std::vector<std::string_view> wordsOf(std::string_view line);

/// A whole number without sign; empty when the word is not one, or is too large.
[[nodiscard]] std::optional<std::uint64_t> wholeNumber(std::string_view word);

} // namespace edgescan::files
