// Finds out how a text of numbers is laid out from its first lines.
#include "core/points/text_layout.h"

#include "core/points/point_table.h"

#include <algorithm>
#include <charconv>

namespace edgescan {
namespace {

constexpr std::size_t kMostHeadLines = 2000;
constexpr std::size_t kSampleRows = 20;

bool isSeparator(char c) { return isBlank(c) || c == ',' || c == ';'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

/// What stands behind the comment sign; empty optional when the line is no comment.
std::optional<std::string_view> commentIn(std::string_view line) {
    const std::string_view text = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (text.starts_with("//")) return text.substr(2);
    if (text.starts_with('#') || text.starts_with('%') || text.starts_with('!')) return text.substr(1);
    return std::nullopt;
}

bool isNumber(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    return problem != std::errc::invalid_argument && (end == word.data() + word.size() || *end == '#');
}

/// Words between any of blank, comma, semicolon.
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

bool isRowOfNumbers(std::string_view line) {
    const auto words = wordsIn(line);
    return !words.empty() && std::all_of(words.begin(), words.end(), isNumber);
}

/// "1,5" between blanks or tabs: every word has one comma with a digit on both sides, and no point.
bool hasDecimalCommas(std::string_view row, char separator) {
    std::size_t words = 0;
    std::size_t at = 0;
    while (at < row.size()) {
        std::size_t end = at;
        while (end < row.size() && row[end] != separator && !(separator == ' ' && row[end] == '\t')) ++end;
        const std::string_view word = trimmed(row.substr(at, end - at));
        at = end + 1;
        if (word.empty()) continue;
        const std::size_t comma = word.find(',');
        if (comma == 0 || comma == std::string_view::npos || comma + 1 == word.size() ||
            word.find(',', comma + 1) != std::string_view::npos)
            return false;
        if (word.find('.') != std::string_view::npos) return false;
        ++words;
    }
    return words >= 2;
}

void chooseSeparator(const std::vector<std::string_view>& rows, TextLayout& layout) {
    const auto anyHas = [&](char c) {
        return std::any_of(rows.begin(), rows.end(), [&](auto row) { return row.find(c) != std::string_view::npos; });
    };
    const auto allAre = [&](char c) { return std::all_of(rows.begin(), rows.end(), [&](auto row) { return hasDecimalCommas(row, c); }); };
    if (anyHas(';')) {
        layout.separator = ';';
        layout.decimalComma = anyHas(',') && !anyHas('.');
    } else if (anyHas(',') && !allAre(' ')) {
        layout.separator = ',';
    } else {
        layout.decimalComma = anyHas(',');
        const bool emptyCells = std::any_of(rows.begin(), rows.end(), [](auto row) { return row.find("\t\t") != std::string_view::npos; });
        layout.separator = emptyCells ? '\t' : ' ';
    }
    layout.trailingSeparator = layout.separator != ' ' && std::all_of(rows.begin(), rows.end(), [&](auto row) {
                                   while (row.ends_with(' ')) row.remove_suffix(1);
                                   return row.ends_with(layout.separator);
                               });
}

std::size_t countColumns(std::string_view row, const TextLayout& layout) {
    if (layout.separator == ' ' || layout.separator == '\t') {
        if (layout.separator == ' ' && layout.decimalComma) {
            std::string blanks(row);
            std::replace(blanks.begin(), blanks.end(), ',', '.');
            return wordsIn(blanks).size();
        }
        if (layout.separator == ' ') return wordsIn(row).size();
    }
    const auto separators = static_cast<std::size_t>(std::count(row.begin(), row.end(), layout.separator));
    return separators + (layout.trailingSeparator ? 0 : 1);
}

std::vector<std::string> namesIn(std::string_view header, const TextLayout& layout) {
    std::vector<std::string> names;
    const auto add = [&](std::string_view word) {
        std::string name(trimmed(word));
        std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        names.push_back(std::move(name));
    };
    if (layout.separator == ' ') {
        for (const auto word : wordsIn(header)) add(word);
        return names;
    }
    std::size_t at = 0;
    while (at <= header.size()) {
        const std::size_t end = std::min(header.find(layout.separator, at), header.size());
        add(header.substr(at, end - at));
        at = end + 1;
    }
    if (layout.trailingSeparator && !names.empty() && names.back().empty()) names.pop_back();
    return names;
}

/// What stands before the first row of numbers.
struct Head {
    std::size_t firstByte = 0;
    std::size_t firstLine = 0;
    std::string_view header; ///< last line that is neither blank nor numbers, comment sign removed
    std::optional<std::size_t> promisedRows;
    std::string description;
    bool found = false;
};

Head readHead(std::string_view text) {
    Head head;
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    std::size_t headLines = 0; // comments do not count: our own can be long
    for (std::size_t number = 1; at < text.size() && headLines <= kMostHeadLines; ++number) {
        const TextLine line = textLineAt(text, at);
        const auto comment = commentIn(line.text);
        if (!comment) ++headLines;
        if (comment) {
            if (!addToDescription(*comment, head.description)) head.header = *comment;
        } else if (isRowOfNumbers(line.text)) {
            const auto words = wordsIn(line.text);
            const std::string_view next = line.next < text.size() ? textLineAt(text, line.next).text : std::string_view();
            std::size_t count = 0;
            const auto [end, problem] = std::from_chars(words[0].data(), words[0].data() + words[0].size(), count);
            const bool isCount =
                words.size() == 1 && problem == std::errc{} && end == words[0].data() + words[0].size() && wordsIn(next).size() > 1;
            if (!isCount) {
                head.firstByte = at;
                head.firstLine = number;
                head.found = true;
                return head;
            }
            head.promisedRows = count;
        } else if (!trimmed(line.text).empty()) {
            head.header = line.text;
        }
        at = line.next;
    }
    return head;
}

} // namespace

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
    Head head = readHead(text);
    if (!head.found) {
        return source.refused("this is text without a row of numbers, so no scan", "choose a scan: raw grid, PCD, PLY, XYZ, CSV or .3d");
    }
    TextLayout layout;
    layout.firstByte = head.firstByte;
    layout.firstLine = head.firstLine;
    layout.promisedRows = head.promisedRows;
    layout.description = std::move(head.description);
    std::vector<std::string_view> rows;
    for (std::size_t at = head.firstByte; at < text.size() && rows.size() < kSampleRows;) {
        const TextLine line = textLineAt(text, at);
        if (isRowOfNumbers(line.text)) rows.push_back(line.text);
        at = line.next;
    }
    chooseSeparator(rows, layout);
    layout.columns = countColumns(rows.front(), layout);
    if (!head.header.empty()) {
        layout.names = namesIn(head.header, layout);
        // A comment about something else is no header.
        if (layout.names.size() != layout.columns) layout.names.clear();
    }
    return layout;
}

} // namespace edgescan
