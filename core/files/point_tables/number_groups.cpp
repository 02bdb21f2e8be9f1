// Thousands that are set apart.
#include "core/files/point_tables/number_groups.h"

#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <array>
#include <vector>

namespace edgescan::files {
namespace {

constexpr std::size_t kRowsSearched = 200;
constexpr std::size_t kMostColumnsSearched = 64;
// A column is doubtful where so many of its numbers have three digits behind a mark, and so many have none.
constexpr std::size_t kFewestWithMark = 20, kFewestWithout = 2;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsAt(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size() && isDigit(text[at])) ++at;
    return at - from;
}

/// The text between groups of digits; empty: another one. Blanks that do not break are C2 A0 and E2 80 AF in UTF-8, A0 in Latin-1.
std::string_view markAt(std::string_view text) {
    static constexpr std::array<std::string_view, 9> kMarks{
        "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "\xE2\x80\x99", "\xA0", " ", "'", ".", ","};
    const auto* const found = std::ranges::find_if(kMarks, [&](std::string_view mark) { return text.starts_with(mark); });
    return found == kMarks.end() ? std::string_view() : *found;
}

bool isPointOrComma(std::string_view mark) { return mark == "." || mark == ","; }

std::vector<std::string_view> cutAt(std::string_view line, char separator) {
    TextLayout layout;
    layout.separator = separator;
    return cellsIn(line, layout);
}

/// With a point or a comma before its decimals, or with its thousands set apart.
bool isAnyNumber(std::string_view cell) {
    if (isNumber(cell) || groupsOf(cell) != Grouped::No) return true;
    std::string copy(cell);
    std::ranges::replace(copy, ',', '.');
    return copy != cell && isNumber(copy);
}

/// The ways in which a row may be cut into cells, the likeliest first.
std::vector<std::vector<std::string_view>> waysToCut(std::string_view line) {
    if (line.find(';') != line.npos) return {cutAt(line, ';')};
    if (line.find('\t') != line.npos) return {cutAt(line, '\t')};
    std::vector<std::vector<std::string_view>> ways{cutAt(line, ' ')};
    const bool commasSeparate = line.find('"') != line.npos || line.find('.') != line.npos || line.find(' ') == line.npos;
    if (commasSeparate && line.find(',') != line.npos) ways.push_back(cutAt(line, ','));
    return ways;
}

/// How the numbers of a column look.
struct ColumnLook {
    std::size_t withMark = 0, without = 0;
    bool decimals = false; ///< some number has decimals for sure, or four digits in a row
    std::string word;      ///< with a mark
    std::size_t line = 0;
};

void lookAt(ColumnLook& look, std::string_view cell, std::size_t line) {
    if (cell.empty() || !isAnyNumber(cell)) return;
    if (groupsOf(cell) == Grouped::Maybe) {
        if (look.withMark++ == 0) {
            look.word = std::string(cell);
            look.line = line;
        }
        return;
    }
    const std::string_view digits = cell.substr(cell.starts_with('-') || cell.starts_with('+') ? 1 : 0);
    const bool shortWhole = digits.size() <= 3 && digitsAt(digits, 0) == digits.size();
    look.without += shortWhole ? 1 : 0;
    look.decimals = look.decimals || !shortWhole;
}

} // namespace

Grouped groupsOf(std::string_view cell) {
    if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
    std::size_t at = digitsAt(cell, 0);
    if (at == 0 || at > 3 || cell[0] == '0') return Grouped::No;
    const std::string_view mark = markAt(cell.substr(at));
    std::size_t groups = 0;
    while (!mark.empty() && cell.substr(at).starts_with(mark) && digitsAt(cell, at + mark.size()) == 3) {
        at += mark.size() + 3;
        ++groups;
    }
    if (groups == 0) return Grouped::No;
    if (at == cell.size()) return isPointOrComma(mark) && groups == 1 ? Grouped::Maybe : Grouped::Yes;
    const std::string_view point = cell.substr(at, 1);
    const std::size_t decimals = digitsAt(cell, at + 1);
    return isPointOrComma(point) && point != mark && decimals > 0 && at + 1 + decimals == cell.size() ? Grouped::Yes : Grouped::No;
}

std::optional<GroupedNumber> findGroupedNumber(std::string_view text) {
    std::array<ColumnLook, kMostColumnsSearched> columns;
    std::size_t rows = 0;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size() && rows < kRowsSearched && number < 4 * kRowsSearched;) {
        const TextLine line = textLineAt(text, at);
        at = line.next;
        ++number;
        if (line.text.size() > kLongestRowLookedAt || line.text.starts_with('#') || line.text.starts_with('%') ||
            line.text.starts_with('/'))
            continue;
        const auto ways = waysToCut(line.text);
        for (const auto& cells : ways) {
            if (std::ranges::count_if(cells, isAnyNumber) < 3) continue;
            const auto found = std::ranges::find(cells, Grouped::Yes, groupsOf);
            if (found != cells.end()) return GroupedNumber{std::string(*found), number, false};
        }
        if (ways.empty() || std::ranges::count_if(ways.back(), isAnyNumber) < 3) continue;
        ++rows;
        for (std::size_t i = 0; i < std::min(ways.back().size(), columns.size()); ++i) lookAt(columns[i], ways.back()[i], number);
    }
    for (const ColumnLook& look : columns) {
        if (look.withMark >= kFewestWithMark && look.without >= kFewestWithout && !look.decimals)
            return GroupedNumber{look.word, look.line, true};
    }
    return std::nullopt;
}

} // namespace edgescan::files
