// Words, cells and the head of a text of numbers.
#include "core/files/point_tables/text_words.h"

#include "core/base/number_text.h"
#include "core/files/point_tables/axis_words.h"
#include "core/files/point_tables/point_table.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostHeadLines = 2000;

bool isSeparator(char c) { return isBlank(c) || c == ',' || c == ';'; }

/// The text after the comment sign; empty optional when the line is not a comment.
std::optional<std::string_view> commentIn(std::string_view line) {
    const std::string_view text = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (text.starts_with("//")) return text.substr(2);
    if (text.starts_with('#') || text.starts_with('%') || text.starts_with('!')) return text.substr(1);
    return std::nullopt;
}

/// A line with one whole number and nothing else.
std::optional<std::size_t> countIn(std::string_view line) {
    const std::string_view word = trimmed(line);
    std::size_t count = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (problem != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return count;
}

/// "m,m,m" or "[mm] [mm] [mm] -": the row below the names in tables of measuring programs.
bool isRowOfUnits(std::string_view line) {
    static constexpr std::array<std::string_view, 17> kUnits{"m", "mm", "cm", "km", "ft", "usft", "in",   "deg", "rad",
                                                             "s", "ms", "us", "ns", "db", "-",    "none", "1"};
    const auto words = wordsIn(line);
    return words.size() >= 3 && std::ranges::all_of(words, [](std::string_view word) {
               if (word.size() > 2 && (word.front() == '[' || word.front() == '(')) word = word.substr(1, word.size() - 2);
               return std::ranges::find(kUnits, asciiLower(word)) != kUnits.end();
           });
}

/// Behind a label, and two numbers at least.
bool isLabelledRow(std::string_view line) {
    const std::size_t cut = std::min({line.find(';'), line.find(','), line.find('\t')});
    if (cut == std::string_view::npos || trimmed(line.substr(0, cut)).empty()) return false;
    const std::string_view rest = line.substr(cut + 1);
    return isRowOfNumbers(rest) && wordsIn(rest).size() >= 2;
}

} // namespace

bool isMissingMark(std::string_view word) {
    static constexpr std::array<std::string_view, 14> kMarks{"na",  "n/a",   "<na>", "#n/a", "#na", "null", "none",
                                                             "nil", "empty", "-",    "--",   "?",   "nat",  "missing"};
    if (word.size() > 7) return false;
    return std::ranges::find(kMarks, asciiLower(word)) != kMarks.end();
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

bool isNumber(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem == std::errc::invalid_argument) return false;
    const char* const wordEnd = word.data() + word.size();
    if (end == wordEnd || *end == '#') return true;
    return (*end == 'D' || *end == 'd') && numberWithFortranExponent(word.data(), wordEnd, value).ptr == wordEnd;
}

std::vector<std::string_view> wordsIn(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t at = 0;
    while (at < line.size()) {
        while (at < line.size() && isSeparator(line[at])) ++at;
        const std::size_t from = at;
        while (at < line.size() && !isSeparator(line[at])) ++at;
        if (at > from) words.push_back(line.substr(from, at - from));
    }
    return words;
}

void countDigits(std::string_view word, PrintedDigits& digits) {
    int decimals = 0;
    int significant = 0;
    int whole = 0;
    bool point = false;
    for (const char c : word) {
        if (c == 'e' || c == 'E') {
            digits.powers = true;
            break;
        }
        if (c == '.') point = true;
        if (c < '0' || c > '9') continue;
        ++(point ? decimals : whole);
        if (significant > 0 || c != '0') ++significant;
    }
    digits.decimals = std::max(digits.decimals, decimals);
    digits.significant = std::max(digits.significant, significant);
    digits.whole = std::max(digits.whole, whole);
}

std::from_chars_result numberWithFortranExponent(const char* from, const char* to, double& value) {
    constexpr std::size_t kLongest = 64;
    std::array<char, kLongest> copy{};
    const auto length = std::min(static_cast<std::size_t>(to - from), kLongest);
    const auto* const end = std::transform(from, from + length, copy.begin(), [](char c) { return c == 'D' || c == 'd' ? 'e' : c; });
    const auto [parsed, problem] = std::from_chars(copy.data(), end, value);
    return {from + (parsed - copy.data()), problem};
}

bool isRowOfNumbers(std::string_view line) {
    bool some = false;
    for (const std::string_view word : wordsIn(line)) {
        const bool number = isNumber(word);
        if (!number && !isMissingMark(word)) return false;
        some = some || number;
    }
    return some;
}

bool isEmptyRow(std::string_view line) {
    return line.find_first_of(",;\t") != std::string_view::npos && std::ranges::all_of(wordsIn(line), isMissingMark);
}

const char* endOfCell(const char* from, const char* to, char separator) {
    const char* at = from;
    while (at < to && *at == ' ') ++at;
    while (at < to && *at == '"') { // a quote within the text is written twice: its second half opens another text
        const char* const closing = std::find(at + 1, to, '"');
        if (closing == to) break; // of an inch, say
        from = at = closing + 1;
    }
    return std::find(from, to, separator);
}

std::vector<std::string_view> cellsIn(std::string_view line, const TextLayout& layout) {
    std::vector<std::string_view> cells;
    const bool blanks = layout.separator == ' ';
    std::size_t at = 0;
    while (at <= line.size()) {
        if (blanks) {
            while (at < line.size() && isBlank(line[at])) ++at;
            if (at == line.size()) return cells;
        }
        std::size_t end = at;
        while (blanks && end < line.size() && !isBlank(line[end])) ++end;
        if (!blanks) end = static_cast<std::size_t>(endOfCell(line.data() + at, line.data() + line.size(), layout.separator) - line.data());
        cells.push_back(trimmed(line.substr(at, end - at)));
        at = end + 1;
    }
    if (layout.trailingSeparator && !cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
}

TextHead readHead(std::string_view text, bool labels) {
    TextHead head;
    std::size_t emptyRows = 0; // without any number, before the first row with one
    std::size_t firstEmpty = 0;
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    std::size_t headLines = 0; // comments do not count: our own can be long
    for (std::size_t number = 1; at < text.size() && headLines <= kMostHeadLines; ++number) {
        const TextLine line = textLineAt(text, at);
        const auto comment = commentIn(line.text);
        if (!comment) ++headLines;
        if (comment) {
            if (!addToDescription(*comment, head.description)) {
                head.header = *comment;
                if (const auto unit = unitInComment(*comment)) head.unitMm = unit;
            }
        } else if (isRowOfNumbers(line.text) || (labels && isLabelledRow(line.text))) {
            const std::string_view next = line.next < text.size() ? textLineAt(text, line.next).text : std::string_view();
            const auto count = wordsIn(next).size() > 1 ? countIn(line.text) : std::nullopt;
            if (!count) {
                head.firstByte = emptyRows > 0 ? firstEmpty : at;
                head.firstLine = number - emptyRows;
                head.found = true;
                return head;
            }
            head.promisedRows = count;
        } else if (isEmptyRow(line.text)) {
            if (emptyRows++ == 0) firstEmpty = at;
        } else if (!head.header.empty() && isRowOfUnits(line.text)) {
            head.units = line.text;
        } else if (!trimmed(line.text).empty()) {
            head.header = line.text;
            head.units = {};
            if (const auto unit = unitInComment(line.text)) head.unitMm = unit;
            emptyRows = 0;
        } else if (emptyRows > 0) {
            emptyRows = 0; // a blank line among them
        }
        at = line.next;
    }
    return head;
}

} // namespace edgescan::files
