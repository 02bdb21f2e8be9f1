// How a text of numbers is laid out: separators, decimal comma, comments, header and count lines. And its rows, read fast.
#pragma once

#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/source.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

/// White space within a row; quotes count as such.
[[nodiscard]] constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '"'; }

struct TextLayout {
    std::size_t firstByte = 0;      ///< where the first row of numbers begins
    std::size_t firstLine = 1;      ///< its line number, from 1
    char separator = ' ';           ///< ' ' = any white space; ',' ';' '\t' may leave cells empty
    bool decimalComma = false;      ///< 1,5;2,25
    bool trailingSeparator = false; ///< every row ends with a separator that begins no cell
    bool labels = false;            ///< every row begins with a label or a count (the index of pandas) and not with one of its numbers
    std::size_t columns = 0;        ///< numbers of the first row
    std::vector<std::string> names; ///< of the columns, from the header, lower case; empty when there is none
    std::string unusedHeading;      ///< a heading that does not name as many columns as there are
    std::vector<bool> mayBeWords;   ///< by column: its text is not needed; empty: all are numbers
    std::optional<std::size_t> promisedRows; ///< a line with one whole number before the rows (.pts)
    std::string description;                 ///< JSON of our own "# edgescan " comment lines
    std::optional<double> unitMm;            ///< millimetres per number by a line of comment before the rows
};

/// Length of the line that starts at `from`, without its end; and where the next one starts. CR, LF and CRLF end a line.
struct TextLine {
    std::string_view text;
    std::size_t next = 0;
};
[[nodiscard]] TextLine textLineAt(std::string_view text, std::size_t from);

/// What tables write in place of a missing number: "NA", "null", "None" ...; "nan" is a number already.
[[nodiscard]] bool isMissingMark(std::string_view word);

/// Byte offset of the first byte that no text has (NUL, control characters); empty for text.
[[nodiscard]] std::optional<std::size_t> firstByteThatIsNoText(std::string_view text);

/// Rows without a line end behind the last one, and what to say of it.
[[nodiscard]] constexpr bool endsWithoutLineEnd(std::string_view text) { return !text.ends_with('\n') && !text.ends_with('\r'); }
inline constexpr const char* kMayBeCutOff =
    "The last row has no line end: the file may have been cut off there; compare it with the original.";

/// Error: there is no row of numbers.
Result<TextLayout> textLayoutOf(const Source& source);

/// How exactly numbers were printed.
struct PrintedDigits {
    int decimals = 0;    ///< most digits after the point
    int significant = 0; ///< most digits from the first that is not 0
    int whole = 0;       ///< most digits before the point
    bool powers = false; ///< some numbers have a power of ten

    /// 3 decimals whatever the size, or 6 digits whatever the size?
    [[nodiscard]] bool fixedDecimals() const { return !powers && decimals + whole <= significant; }
};
/// Adds one printed number to what is known of them.
void countDigits(std::string_view word, PrintedDigits& digits);

/// Rows of numbers one after the other. An empty cell, "nan" and what tables write for nothing ("NA", "null") are NaN.
class RowReader {
public:
    RowReader(const Source& source, const TextLayout& layout);

    /// The next row's numbers, there until the next call; false at the end or when something is wrong.
    bool next(std::span<const double>& numbers);
    bool next(std::vector<double>& numbers);
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
    [[nodiscard]] std::size_t lineNumber() const { return line_; } ///< of the row that next() gave
    [[nodiscard]] double fraction() const;                         ///< of the text that has been read
    /// Which columns digits() is about; the first three by default.
    void measure(std::array<std::size_t, 3> columns) { measured_ = columns; }
    void measureAll() { measured_.reset(); }
    /// Only the first so many numbers of a row are read; the rest is not looked at.
    void limitColumns(std::size_t columns) { mostNumbers_ = columns; }
    /// The text before the numbers of the row that next() gave, where the layout has labels.
    [[nodiscard]] std::string_view label() const { return label_; }
    /// Of the measured columns of the rows read so far.
    [[nodiscard]] const PrintedDigits& digits() const { return digits_; }

private:
    bool readPlainRow(std::span<const double>& numbers);
    bool readNextRow(std::vector<double>& numbers);
    bool readRow(std::vector<double>& numbers);
    bool skipLabel();
    bool passRestOf(const char* cell, std::vector<double>& numbers);
    const char* endOfRow();
    bool readCell(std::vector<double>& numbers);
    std::from_chars_result parseNumber(const char* from, double& value) const;
    bool readUsualCell(std::vector<double>& numbers);
    void measureCell(std::size_t column, const char* from, const char* to);
    void countDigits(const char* from, const char* to);

    const Source* source_;
    const char* begin_;
    const char* at_;
    const char* end_;
    const TextLayout* layout_;
    const char* rowEnd_ = nullptr;
    const char* newline_ = nullptr; // the next one, or the end
    std::size_t mostNumbers_ = std::numeric_limits<std::size_t>::max();
    std::size_t line_;
    std::size_t nextLine_;
    bool mayBePlain_;
    std::array<double, 32> plain_{};
    std::vector<double> cells_;
    std::size_t measuredNumbers_ = 0;
    std::optional<std::array<std::size_t, 3>> measured_{{0, 1, 2}};
    std::string_view label_;
    PrintedDigits digits_;
    std::optional<Error> problem_;
};

/// Rows at the beginning of a text that are looked at to find out how it is laid out.
inline constexpr std::size_t kSampleRows = 20;

/// The names in a heading, in lower case; a unit in separate brackets belongs to the name before it.
[[nodiscard]] std::vector<std::string> namesIn(std::string_view header, const TextLayout& layout);

struct RowBelowNames {
    std::vector<std::string> names; ///< of the heading, lower case
    NamedColumns named;             ///< x, y and z among them
    std::vector<std::string_view> cells;
    std::size_t firstByte = 0; ///< where the row begins
    std::size_t firstLine = 0; ///< its number, from 1
};

/// The first row of cells below a heading that names x, y and z between such separators; empty: not among the first kSampleRows lines.
/// Rows beyond kLongestRowLookedAt bytes are passed over. The text must outlive the cells.
[[nodiscard]] std::optional<RowBelowNames> rowBelowNames(std::string_view text, char separator);

} // namespace edgescan::files
