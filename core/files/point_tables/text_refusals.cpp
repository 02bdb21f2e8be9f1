// The causes, the likeliest first.
#include "core/files/point_tables/text_refusals.h"
#include "core/base/translated_text.h"

#include "core/files/point_tables/text_layout.h"
#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostQuoted = 40; ///< bytes of a cell that a message quotes
constexpr const char* kPlainNumbers = "save the file with plain numbers, without separators of thousands";

std::string inQuotes(std::string_view cell) {
    std::string word(trimmed(cell).substr(0, kMostQuoted));
    std::ranges::replace_if(
        word, [](char c) { return static_cast<unsigned char>(c) < 32; }, '?');
    return '"' + word + '"';
}

/// Numbers and words in one row, as total stations write points: "12,350012.33,7650004.10,-812.4,ROCK".
bool isNumbersAmongWords(std::string_view line) { return std::ranges::count_if(wordsIn(line), isNumber) >= 3; }

/// The text between the numbers of a row, where it is not a separator that is read: "1.5|2.5|3.5", "[1.5 2.5 3.5]".
std::optional<char> oddSeparatorIn(std::string_view line) {
    static constexpr std::string_view kOdd = "|:/&=()[]{}<>'";
    std::string bare(line);
    const std::size_t first = bare.find_first_of(kOdd);
    if (first == std::string::npos) return std::nullopt;
    std::ranges::replace_if(
        bare, [](char c) { return kOdd.find(c) != std::string_view::npos; }, ' ');
    const auto words = wordsIn(bare);
    const bool numbers = words.size() >= 3 && std::ranges::all_of(words, isNumber);
    return numbers ? std::optional(line[first]) : std::nullopt;
}

/// Below a heading that names x, y and z: the first cell of these columns that is not a number.
struct WrongCell {
    std::string cell;
    std::size_t line = 0;
};
std::optional<WrongCell> wrongCellBelowNames(std::string_view text) {
    for (const char separator : {',', ';', '\t', ' '}) {
        const auto row = rowBelowNames(text, separator);
        for (std::size_t axis = 0; row && axis < 3; ++axis) {
            const std::size_t column = *row->named.of[axis];
            if (column < row->cells.size() && !isNumber(row->cells[column]))
                return WrongCell{std::string(row->cells[column]), row->firstLine};
        }
    }
    return std::nullopt;
}

} // namespace

Error thousandsApart(const Source& source, const GroupedNumber& number) {
    if (number.mayBeDecimals) {
        return source.refusedAtLine(number.line,
                                    withValues("holds %1 in a column whose numbers have three digits behind their mark or no mark at all, "
                                               "so that it may separate decimals or thousands",
                                               {inQuotes(number.word)}),
                                    "save the file with the same count of decimals in each number, or without separators of thousands");
    }
    return source.refusedAtLine(number.line, withValues("holds %1, a number whose thousands are set apart", {inQuotes(number.word)}),
                                kPlainNumbers);
}

Error noNumber(const Source& source, std::size_t line, std::string_view cell) {
    if (cell.find('\0') != std::string_view::npos)
        return source.refusedAtLine(line, "holds bytes of zero, as a file does that was not written to its end",
                                    "copy the file or export it again");
    if (groupsOf(trimmed(cell)) == Grouped::Yes) return thousandsApart(source, {std::string(trimmed(cell)), line, false});
    std::string withPoint(trimmed(cell));
    std::ranges::replace(withPoint, ',', '.');
    if (withPoint != trimmed(cell) && isNumber(withPoint))
        return source.refusedAtLine(line, withValues("%1 has a decimal comma", {inQuotes(cell)}), "save the file with decimal points");
    const auto words = wordsIn(cell);
    if (words.size() > 1 && std::ranges::all_of(words, isNumber))
        return source.refusedAtLine(line, withValues("%1 is more than one number between two separators", {inQuotes(cell)}),
                                    "correct the line or export the file again");
    return source.refusedAtLine(line, withValues("%1 is not a number", {inQuotes(cell)}), "correct the line or export the file again");
}

Error textWithoutNumbers(const Source& source) {
    const std::string_view text = source.text();
    if (const auto wrong = wrongCellBelowNames(text))
        return source.refusedAtLine(wrong->line, withValues("%1 is below x, y or z and is not a number", {inQuotes(wrong->cell)}),
                                    "save the file with plain numbers in these columns, without units or marks");
    std::size_t at = 0;
    for (std::size_t number = 1; at < text.size() && number <= kSampleRows; ++number) {
        const TextLine line = textLineAt(text, at);
        at = line.next;
        if (line.text.size() > kLongestRowLookedAt) continue;
        if (isNumbersAmongWords(line.text)) {
            return source.refusedAtLine(number, "there are words among the numbers of its rows, and no heading names x, y and z",
                                        "write a first row with the names of the columns, such as id,x,y,z,code");
        }
        if (const auto odd = oddSeparatorIn(line.text)) {
            return source.refusedAtLine(
                number, withValues("its numbers are separated by \"%1\", which separates none here", {std::string(1, *odd)}),
                "save the file with commas, semicolons, tabs or blanks between its numbers");
        }
    }
    return source.refused("this is text without a row of numbers, so no scan", kChooseScan);
}

} // namespace edgescan::files
