// Words of a line, then their meaning.
#include "core/scan/georef/survey_line.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kPlaceNumbers = 3; // easting, northing, elevation
constexpr const char* kSurveyHint = "write easting, northing and level, such as 498765.432; 5150123.456; 287.654";

Words split(std::string_view text, std::string_view separators) {
    Words words;
    while (true) {
        const std::size_t from = text.find_first_not_of(separators);
        if (from == text.npos) return words;
        text.remove_prefix(from);
        const std::size_t to = std::min(text.find_first_of(separators), text.size());
        words.emplace_back(text.substr(0, to));
        text.remove_prefix(to);
    }
}

std::optional<double> finiteNumber(std::string_view word) {
    const auto number = numberOf(word);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

/// With a decimal comma as well.
std::optional<double> commaNumber(std::string word) {
    if (const auto comma = word.find(','); comma != word.npos && word.find('.') == word.npos) word[comma] = '.';
    return finiteNumber(word);
}

bool isDigits(std::string_view word) {
    return !word.empty() && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

/// A comma is decimal if the text has no point, and if each word between blanks is a number with at most one comma.
bool hasDecimalCommas(std::string_view text) {
    if (text.find('.') != text.npos || text.find(',') == text.npos) return false;
    const Words words = split(text, " \t\r\n");
    const auto commas = [](const std::string& word) { return std::ranges::count(word, ','); };
    const auto isOne = [&](const std::string& word) { return commas(word) == 0 || (commas(word) == 1 && commaNumber(word)); };
    return words.size() > 1 && std::ranges::all_of(words, isOne);
}

Words wordsOf(std::string_view text) {
    const bool marked = text.find_first_of(";\t") != text.npos;
    if (marked && text.find('.') == text.npos) return split(text, "; \t\r\n"); // commas are decimal
    Words words = split(text, hasDecimalCommas(text) ? " \t\r\n" : ";, \t\r\n");
    return words;
}

/// 0 easting, 1 northing, 2 elevation.
std::optional<int> letterOf(const std::string& word) {
    static const std::array<Words, kPlaceNumbers> kNames{Words{"e", "east", "easting"}, Words{"n", "north", "northing"},
                                                         Words{"rl", "el", "elev", "elevation", "z", "h", "level"}};
    const std::string lower = asciiLower(word);
    for (std::size_t n = 0; n < kPlaceNumbers; ++n) {
        if (std::ranges::find(kNames[n], lower) != kNames[n].end()) return static_cast<int>(n);
    }
    return std::nullopt;
}

/// "E=498765" and "E:498765" as two words.
Words withoutSigns(const Words& words) {
    Words all;
    for (const std::string& word : words) {
        for (const std::string& part : split(word, "=:")) all.push_back(part);
    }
    return all;
}

/// By letters; empty if the words have fewer than the three.
std::optional<SurveyLine> lettered(const Words& words) {
    SurveyLine line;
    std::array<bool, kPlaceNumbers> known{};
    for (std::size_t n = 0; n + 1 < words.size(); ++n) {
        const auto letter = letterOf(words[n]);
        const auto value = letter ? commaNumber(words[n + 1]) : std::nullopt;
        if (!value || known[static_cast<std::size_t>(*letter)]) continue;
        line.enhM[*letter] = *value;
        known[static_cast<std::size_t>(*letter)] = true;
    }
    if (!std::ranges::all_of(known, [](bool one) { return one; })) return std::nullopt;
    if (!letterOf(words.front()) && !finiteNumber(words.front())) line.name = words.front();
    return line;
}

/// "312,345.678": one number with a comma for thousands, or two numbers. A text without a point has decimal commas.
std::optional<std::string> thousands(std::string_view text) {
    if (text.find('.') == text.npos) return std::nullopt;
    for (const std::string& word : split(text, "; \t\r\n=:")) {
        const Words parts = split(word, ",");
        for (std::size_t n = 1; n < parts.size(); ++n) {
            const std::string whole = parts[n].substr(0, parts[n].find('.'));
            const std::string before = parts[n - 1].substr(parts[n - 1].front() == '-' ? 1 : 0);
            if (isDigits(before) && before.size() <= 3 && isDigits(whole) && whole.size() == 3) return parts[n - 1] + "," + parts[n];
        }
    }
    return std::nullopt;
}

Error countError(std::size_t count) {
    return {withValues("the line holds %1 and a place has three, with a heading four, with pitch and roll six", {counted(count, "number")}),
            "", kSurveyHint};
}

} // namespace

Result<SurveyLine> parseSurveyLine(std::string_view text, SurveyOrder order) {
    Words words = wordsOf(text);
    if (words.empty()) return Error{"the line is empty", "", kSurveyHint};
    if (const auto doubtful = thousands(text))
        return Error{withValues("%1 may be one number with a comma for thousands, or two numbers", {*doubtful}), "",
                     "leave that comma out, or write blanks between the numbers"};
    if (const auto line = lettered(withoutSigns(words))) return *line;
    SurveyLine line;
    if (!commaNumber(words.front())) {
        line.name = words.front();
        words.erase(words.begin());
    }
    const auto word = std::ranges::find_if(words, [](const std::string& one) { return !commaNumber(one); });
    words.erase(word, words.end()); // what the surveyor calls the point
    if (line.name.empty() && (words.size() == 4 || words.size() == 7) && isDigits(words.front())) {
        if (words.size() == 4 && std::all_of(words.begin() + 1, words.end(), [](const std::string& one) { return isDigits(one); }))
            return Error{"the first of four whole numbers may be the point's or the easting", "",
                         "leave the point's number out, or write decimals"};
        line.name = words.front();
        words.erase(words.begin());
    }
    if (words.size() != 3 && words.size() != 4 && words.size() != 6) return countError(words.size());
    std::vector<double> numbers;
    for (const std::string& one : words) numbers.push_back(*commaNumber(one));
    line.enhM = {numbers[0], numbers[1], numbers[2]};
    if (order == SurveyOrder::NorthingFirst) std::swap(line.enhM.x(), line.enhM.y());
    if (numbers.size() > 3) line.headingDeg = numbers[3];
    if (numbers.size() == 6) {
        line.pitchDeg = numbers[4];
        line.rollDeg = numbers[5];
    }
    return line;
}

std::vector<double> typedNumbers(std::string_view text, std::size_t count) {
    for (const char* separators : {";, \t\r\n", "; \t\r\n"}) { // first with commas between numbers, then with decimal commas
        const Words words = split(text, separators);
        std::vector<double> numbers;
        for (const std::string& word : words) {
            if (const auto number = commaNumber(word)) numbers.push_back(*number);
        }
        if (words.size() == count && numbers.size() == count) return numbers;
    }
    return {};
}

} // namespace edgescan
