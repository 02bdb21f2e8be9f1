// Finds out how a text of numbers is laid out from its first lines.
#include "core/base/number_text.h"
#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/number_groups.h"
#include "core/files/point_tables/text_refusals.h"
#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostHeading = 120; ///< bytes of a heading that a message quotes
constexpr std::size_t kWide = 16;         ///< more columns than a point has

/// Blanks behind it do not count.
bool endsWith(std::string_view row, char separator) {
    while (row.ends_with(' ')) row.remove_suffix(1);
    return row.ends_with(separator);
}

/// "1,5" between blanks or tabs: most words have one comma with a digit on both sides, the others have no comma, and no word has a point.
bool hasDecimalCommas(std::string_view row) {
    std::size_t words = 0;
    std::size_t commas = 0;
    std::size_t at = 0;
    while (at < row.size()) {
        const std::size_t end = std::min(row.find_first_of(" \t", at), row.size());
        const std::string_view word = trimmed(row.substr(at, end - at));
        at = end + 1;
        if (word.empty()) continue;
        const std::size_t comma = word.find(',');
        if (comma == 0 || (comma != word.npos && (comma + 1 == word.size() || word.find(',', comma + 1) != word.npos))) return false;
        if (word.find('.') != word.npos) return false;
        commas += comma == word.npos ? 0 : 1;
        ++words;
    }
    return commas >= 2 && 2 * commas > words;
}

/// Tabs between cells that are empty or have no blank inside, as many in every row; not tabs among blanks.
bool tabsSeparate(const std::vector<std::string_view>& rows) {
    const auto tabsIn = [](std::string_view row) { return std::ranges::count(row, '\t'); };
    TextLayout tabs;
    tabs.separator = '\t';
    return tabsIn(rows.front()) > 0 && std::ranges::all_of(rows, [&](std::string_view row) {
               return tabsIn(row) == tabsIn(rows.front()) &&
                      std::ranges::none_of(cellsIn(row, tabs), [](std::string_view cell) { return cell.find(' ') != cell.npos; });
           });
}

void chooseSeparator(const std::vector<std::string_view>& rows, TextLayout& layout) {
    const auto anyHas = [](std::span<const std::string_view> in, char c) {
        return std::ranges::any_of(in, [&](std::string_view row) { return row.find(c) != row.npos; });
    };
    const auto measured = std::span(rows).subspan(rows.size() > 1 ? 1 : 0); // the first row may be the numbers of the columns
    if (anyHas(rows, ';')) {
        layout.separator = ';';
        layout.decimalComma = anyHas(measured, ',') && !anyHas(measured, '.');
    } else if (anyHas(rows, ',') &&
               !std::ranges::all_of(rows, [](auto row) { return row.find(',') == row.npos || hasDecimalCommas(row); })) {
        layout.separator = ',';
    } else {
        layout.decimalComma = anyHas(measured, ',');
        layout.separator = tabsSeparate(rows) ? '\t' : ' ';
    }
    layout.trailingSeparator =
        layout.separator != ' ' && std::ranges::all_of(rows, [&](auto row) { return endsWith(row, layout.separator); });
}

double numberOf(std::string_view cell) {
    if (cell.starts_with('+')) cell.remove_prefix(1);
    double value = std::nan("");
    const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return problem == std::errc{} && end == cell.data() + cell.size() ? value : std::nan("");
}

/// First number and step of numbers that rise evenly.
struct Even {
    double first = 0, step = 0;
    [[nodiscard]] bool counts() const { return step == 1 && (first == 0 || first == 1); }
};
std::optional<Even> evenlyRising(std::span<const std::string_view> cells) {
    if (cells.size() < 2) return std::nullopt;
    const double first = numberOf(cells.front());
    const double step = (numberOf(cells.back()) - first) / static_cast<double>(cells.size() - 1);
    if (!std::isfinite(first) || !(step > 0) || !std::isfinite(step)) return std::nullopt;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double off = numberOf(cells[i]) - (first + static_cast<double>(i) * step);
        if (!(std::abs(off) < 0.05 * step)) return std::nullopt; // as far as rounding moves them
    }
    return Even{first, step};
}

/// The numbers of the columns instead of their names, as pandas writes them: rising evenly, as no row of measured numbers does.
bool isHeaderOfNumbers(std::span<const std::string_view> cells, std::span<const std::string_view> below, const TextLayout& layout) {
    const bool labelled = cells.front().empty();
    const auto numbers = cells.subspan(labelled ? 1 : 0);
    const auto even = evenlyRising(numbers);
    if (!even || numbers.size() < 3) return false;
    if (numbers.size() >= kWide) return labelled || even->counts() || even->first <= 0;
    const char point = layout.decimalComma ? ',' : '.';
    const auto whole = [&](std::string_view row) { return row.find(point) == std::string_view::npos; };
    const bool amongOthers = !below.empty() && std::ranges::none_of(below, whole); // else it may be the point 0 1 2
    return even->counts() && even->first == 0 && (labelled || amongOthers);
}

/// The first cell of each row counts the rows, from the first to the last.
bool firstCellsCount(std::string_view text, const TextLayout& layout) {
    std::size_t rows = 0;
    double first = 0;
    for (std::size_t at = layout.firstByte; at < text.size();) {
        const TextLine line = textLineAt(text, at);
        at = line.next;
        std::string_view row = trimmed(line.text);
        if (row.empty() || row.starts_with('#')) continue;
        const char* const ends = layout.separator == ' ' ? " \t" : nullptr;
        row = row.substr(0, ends != nullptr ? row.find_first_of(ends) : row.find(layout.separator));
        const double number = numberOf(trimmed(row));
        if (rows == 0) first = number;
        if (rows == 0 && first != 0 && first != 1) return false;
        if (number != first + static_cast<double>(rows)) return false;
        ++rows;
    }
    return rows >= 2;
}

bool allRowsEndWith(std::string_view text, std::size_t from, char separator) {
    while (from < text.size()) {
        const TextLine line = textLineAt(text, from);
        from = line.next;
        const bool comment = line.text.starts_with('#') || line.text.starts_with('%') || line.text.starts_with('!');
        if (!comment && !trimmed(line.text).empty() && !endsWith(line.text, separator)) return false;
    }
    return true;
}

/// A separator after the last cell of the sample may precede a column that is empty there.
bool endsInEmptyColumn(std::string_view text, std::string_view header, std::string_view row, TextLayout layout) {
    if (!allRowsEndWith(text, layout.firstByte, layout.separator)) return true;
    layout.trailingSeparator = false;
    const auto names = cellsIn(header, layout);
    return names.size() == cellsIn(row, layout).size() && !names.back().empty();
}

/// Names of `cells` columns, a label included; empty where the line is about something else.
std::vector<std::string> namesOf(std::string_view header, std::size_t cells, const TextLayout& layout) {
    if (trimmed(header).empty()) return {};
    auto names = namesIn(header, layout);
    if (names.size() != cells && !(layout.labels && names.size() + 1 == cells)) { // a header between blanks over rows between commas
        TextLayout blanks = layout;
        blanks.separator = ' ';
        std::string text(header);
        std::ranges::replace(text, ',', ' ');
        std::ranges::replace(text, ';', ' ');
        names = namesIn(text, blanks);
    }
    return names;
}

/// "x" above "[mm]" is "x [mm]".
void addUnits(std::vector<std::string>& names, std::string_view units, const TextLayout& layout) {
    const auto words = cellsIn(units, layout);
    if (words.size() != names.size()) return;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!words[i].empty()) names[i] += " [" + std::string(words[i]) + "]";
    }
}

/// The label's own name goes; R leaves it out itself.
void nameColumns(const TextHead& head, std::size_t cells, std::string_view text, TextLayout& layout) {
    const std::string_view header = head.header;
    auto names = namesOf(header, cells, layout);
    addUnits(names, head.units, layout);
    if (names.size() != cells && names.size() + 1 != cells) names.clear(); // a line about something else is not a header
    const bool pandas = names.size() == cells && cells > 2 && (names[0].empty() || names[0].starts_with("unnamed: 0"));
    const bool counted = names.size() != cells && cells > 3 && firstCellsCount(text, layout);
    layout.labels = layout.labels || pandas || counted;
    if (layout.labels && names.size() == cells) names.erase(names.begin());
    layout.columns = cells - (layout.labels ? 1 : 0);
    layout.names = names.size() == layout.columns ? std::move(names) : std::vector<std::string>();
    const bool isHeading = layout.separator != ' ' && header.find(layout.separator) != header.npos;
    if (layout.names.empty() && isHeading) layout.unusedHeading = std::string(trimmed(header).substr(0, kMostHeading));
}

/// Columns that nothing is read from.
std::vector<bool> unreadColumns(const std::vector<std::string>& names) {
    const NamedColumns named = columnsNamed(names);
    if (!named.hasPoint()) return {};
    std::vector<bool> unread(names.size(), true);
    for (const auto& column : named.of) {
        if (column) unread[*column] = false;
    }
    if (named.angles) unread[named.angles->azimuth] = unread[named.angles->elevation] = false;
    return unread;
}

/// The first row behind a header that names x, y and z among other columns, some of which are words.
struct RowAmongWords {
    RowBelowNames row;
    bool decimalComma = false;
};
std::optional<RowAmongWords> rowAmongWords(std::string_view text, char separator) {
    auto row = rowBelowNames(text, separator);
    if (!row || row->cells.size() < row->names.size()) return std::nullopt;
    bool decimalComma = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::string cell(row->cells[*row->named.of[axis]]);
        decimalComma = decimalComma || cell.find(',') != cell.npos;
        std::ranges::replace(cell, ',', '.');
        if (!isNumber(cell)) return std::nullopt;
    }
    return RowAmongWords{std::move(*row), decimalComma};
}

std::optional<TextLayout> layoutAmongWords(std::string_view text) {
    for (const char separator : {',', ';', '\t'}) {
        auto found = rowAmongWords(text, separator);
        if (!found) continue;
        TextLayout layout;
        layout.firstByte = found->row.firstByte;
        layout.firstLine = found->row.firstLine;
        layout.separator = separator;
        layout.decimalComma = found->decimalComma;
        layout.columns = found->row.names.size();
        layout.names = std::move(found->row.names);
        layout.mayBeWords = unreadColumns(layout.names);
        return layout;
    }
    return std::nullopt;
}

/// The text before the number at the end of a name, and the number: "field.ranges12".
std::optional<std::pair<std::string_view, std::uint64_t>> countedName(std::string_view name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    std::uint64_t number = 0;
    const auto [end, problem] = std::from_chars(name.data() + digits, name.data() + name.size(), number);
    if (digits == 0 || digits == name.size() || problem != std::errc{}) return std::nullopt;
    return std::pair(name.substr(0, digits), number);
}

/// Which columns are among many that one name counts: ranges0, ranges1 ... as a table of messages has them.
std::vector<bool> countedColumns(const std::vector<std::string>& names) {
    std::vector<bool> counted(names.size(), false);
    for (std::size_t first = 0, end = 0; first < names.size(); first = std::max(end, first + 1)) {
        const auto start = countedName(names[first]);
        for (end = first + 1; start && end < names.size(); ++end) {
            const auto next = countedName(names[end]);
            if (!next || next->first != start->first || next->second != start->second + (end - first)) break;
        }
        if (start && end - first >= kWide)
            std::fill(counted.begin() + static_cast<std::ptrdiff_t>(first), counted.begin() + static_cast<std::ptrdiff_t>(end), true);
    }
    return counted;
}

/// Rows of a table of messages, words among their numbers, below a heading with many columns that one name counts.
std::optional<TextLayout> layoutOfMessages(std::string_view text) {
    const TextLine heading = textLineAt(text, 0);
    std::string_view names = heading.text;
    const bool comment = names.starts_with('%') || names.starts_with('#');
    if (comment) names.remove_prefix(1);
    if (std::ranges::count(names, ',') < static_cast<std::ptrdiff_t>(kWide)) return std::nullopt;
    TextLayout layout;
    layout.separator = ',';
    layout.firstByte = heading.next;
    layout.firstLine = 2;
    layout.names = namesIn(names, layout);
    layout.columns = layout.names.size();
    const std::vector<bool> counted = countedColumns(layout.names);
    if (std::ranges::none_of(counted, [](bool one) { return one; }) || heading.next >= text.size()) return std::nullopt;
    const auto cells = cellsIn(textLineAt(text, heading.next).text, layout);
    if (cells.size() != layout.columns) return std::nullopt;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (counted[i] && !isNumber(cells[i]) && !isMissingMark(cells[i])) return std::nullopt;
        layout.mayBeWords.push_back(!counted[i]);
    }
    return layout;
}

/// "3,48,-0,30,0,0" below "x,y,z": a comma is both, and twice as many cells as names.
bool hasCommasForBoth(std::string_view header, std::span<const std::string_view> cells, const TextLayout& layout) {
    const auto whole = [](std::string_view cell) { return isNumber(cell) && cell.find_first_of(".eE") == std::string_view::npos; };
    const std::size_t names = namesIn(header, layout).size();
    return layout.separator == ',' && names >= 3 && cells.size() == 2 * names && std::ranges::all_of(cells, whole);
}

/// "3,5","3,6": a comma is both.
bool hasQuotedCommas(std::string_view row) {
    for (std::size_t at = row.find('"'); at != std::string_view::npos;) {
        const std::size_t end = row.find('"', at + 1);
        if (end == std::string_view::npos) return false;
        const std::string_view cell = row.substr(at + 1, end - at - 1);
        if (cell.find(',') != std::string_view::npos && isRowOfNumbers(cell)) return true;
        at = row.find('"', end + 1);
    }
    return false;
}

} // namespace

std::vector<std::string> namesIn(std::string_view header, const TextLayout& layout) {
    std::vector<std::string> names;
    for (const std::string_view cell : cellsIn(header, layout)) {
        const bool unit = layout.separator == ' ' && (cell.starts_with('(') || cell.starts_with('[')) && !names.empty(); // "x (m)"
        if (unit) {
            names.back() += cell;
            continue;
        }
        names.push_back(asciiLower(cell));
    }
    return names;
}

std::optional<RowBelowNames> rowBelowNames(std::string_view text, char separator) {
    TextLayout layout;
    layout.separator = separator;
    RowBelowNames found;
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (std::size_t number = 1; at < text.size() && number <= kSampleRows; ++number) {
        const TextLine line = textLineAt(text, at);
        const std::size_t from = std::exchange(at, line.next);
        if (line.text.size() > kLongestRowLookedAt || trimmed(line.text).empty()) continue;
        if (!found.named.hasPoint()) {
            found.names = namesIn(line.text, layout);
            found.named = columnsNamed(found.names);
            continue;
        }
        found.cells = cellsIn(line.text, layout);
        found.firstByte = from;
        found.firstLine = number;
        return found;
    }
    return std::nullopt;
}

TextLine textLineAt(std::string_view text, std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
    std::size_t next = end;
    if (next < text.size()) next += text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n' ? 2 : 1;
    return {text.substr(from, end - from), next};
}

std::optional<std::size_t> firstByteThatIsNoText(std::string_view text) {
    const std::size_t looked = std::min<std::size_t>(text.size(), 1U << 16U);
    for (std::size_t i = 0; i < looked; ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (c < 32 && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != 26) return i;
    }
    return std::nullopt;
}

Result<TextLayout> textLayoutOf(const Source& source) {
    const std::string_view text = source.text();
    if (const auto grouped = findGroupedNumber(text)) return thousandsApart(source, *grouped);
    TextHead head = readHead(text, false);
    const bool labels = !head.found;
    if (labels) head = readHead(text, true);
    if (auto layout = head.found ? std::nullopt : layoutAmongWords(text)) return std::move(*layout);
    if (auto messages = head.found && !labels ? std::nullopt : layoutOfMessages(text)) return std::move(*messages);
    if (!head.found) return textWithoutNumbers(source);
    TextLayout layout;
    layout.firstByte = head.firstByte;
    layout.firstLine = head.firstLine;
    layout.promisedRows = head.promisedRows;
    layout.description = std::move(head.description);
    layout.unitMm = head.unitMm;
    layout.labels = labels;
    std::vector<std::string_view> rows;
    std::vector<std::string_view> numbers;  // the rows without their labels
    std::size_t firstNumbers = text.size(); // behind the first row that has some
    for (std::size_t at = head.firstByte; at < text.size() && rows.size() < kSampleRows;) {
        const TextLine line = textLineAt(text, at);
        at = line.next;
        const std::string_view cells = line.text.substr(labels ? std::min(line.text.find_first_of(",;\t"), line.text.size()) : 0);
        if (!isRowOfNumbers(cells)) continue;
        if (rows.empty()) firstNumbers = at;
        rows.push_back(line.text);
        numbers.push_back(cells);
    }
    chooseSeparator(numbers, layout);
    if (layout.separator == ',' && hasQuotedCommas(rows.back())) {
        return source.refusedAtLine(layout.firstLine, "holds decimal commas in quotes between commas",
                                    "save the table with semicolons, or with decimal points");
    }
    layout.trailingSeparator = layout.trailingSeparator && !endsInEmptyColumn(text, head.header, rows.front(), layout);
    const auto cells = cellsIn(rows.front(), layout);
    if (hasCommasForBoth(head.header, cells, layout)) {
        return source.refusedAtLine(layout.firstLine, "holds decimal commas between commas",
                                    "save the table with semicolons, or with decimal points");
    }
    if (!labels && isHeaderOfNumbers(cells, std::span(rows).subspan(1), layout)) {
        for (std::size_t at = layout.firstByte; at < firstNumbers; at = textLineAt(text, at).next) ++layout.firstLine;
        layout.firstByte = firstNumbers;
        head.header = rows.front();
    }
    nameColumns(head, cells.size(), text, layout);
    if (labels && layout.columns < kWide && !columnsNamed(layout.names).hasPoint()) return textWithoutNumbers(source);
    layout.mayBeWords = unreadColumns(layout.names);
    return layout;
}

} // namespace edgescan::files
