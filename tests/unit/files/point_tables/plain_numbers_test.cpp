// Numbers of texts: read as std::from_chars reads them, to the last bit.
#include "core/files/point_tables/text_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace edgescan::files {
namespace {

double asFromChars(const std::string& word) {
    double value = 0;
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
}

void expectReadAsFromChars(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += word + " 1\n";
    const Source source{"numbers.xyz", std::as_bytes(std::span(text))};
    const TextLayout layout;
    RowReader rows(source, layout);
    std::vector<double> row;
    for (const std::string& word : words) {
        ASSERT_TRUE(rows.next(row)) << word;
        ASSERT_EQ(row.size(), 2U) << word;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(row[0]), std::bit_cast<std::uint64_t>(asFromChars(word))) << word;
    }
    EXPECT_FALSE(rows.next(row));
}

TEST(PlainNumbers, AreReadAsFromCharsReadsThem) {
    expectReadAsFromChars({"0",
                           "-0",
                           "0.0",
                           "-0.000",
                           "5.",
                           ".5",
                           "-.5",
                           "00012.50",
                           "1e5",
                           "1.5E-3",
                           "0.1",
                           "0.3",
                           "999999999999999",
                           "9999999999999999",
                           "123456789012345.6",
                           "0.000000000000001",
                           "0.0000000000000001",
                           "-4503599627370497.5",
                           "1.7976931348623157e308",
                           "9007199254740993",
                           "inf",
                           "-inf"});
}

TEST(PlainNumbers, AreReadAsFromCharsReadsThemWhateverTheirDigits) {
    std::mt19937_64 random(16);
    std::vector<std::string> words;
    for (int n = 0; n < 200000; ++n) {
        std::string digits = std::to_string(random() >> (random() % 60));
        if (random() % 4 != 0) digits.insert(random() % (digits.size() + 1), ".");
        words.push_back((random() % 2 == 0 ? "-" : "") + digits);
    }
    expectReadAsFromChars(words);
}

// Long texts are read by rows after the number format is known, short ones cell by cell: each row must be the same in both cases.
struct ReadRows {
    std::vector<std::vector<std::uint64_t>> rows;
    std::string problem;
};
ReadRows readAll(const std::string& text, const TextLayout& layout, std::size_t most) {
    const Source source{"numbers.xyz", std::as_bytes(std::span(text))};
    RowReader reader(source, layout);
    reader.limitColumns(most);
    ReadRows read;
    std::vector<double> row;
    while (reader.next(row)) {
        read.rows.emplace_back();
        for (const double value : row) read.rows.back().push_back(std::bit_cast<std::uint64_t>(value));
    }
    if (reader.problem()) read.problem = reader.problem()->what;
    return read;
}

std::string randomRow(std::mt19937_64& random, char separator) {
    static const std::array<const char*, 24> kOdd{"nan",  "NaN", "-nan", "inf",   "1e5", "-",  ".",  "1.2.3",
                                                  "1-2",  "+5",  "1/2",  "nano",  "NA",  "",   "5.", ".5",
                                                  "-.25", "#",   "1,5",  "\"7\"", "\t3", " 4", "5 ", "12345678901234567"};
    const std::size_t numbers = 1 + random() % 9;
    const std::string blank = separator == ' ' && random() % 8 == 0 ? "   " : std::string(1, separator);
    std::string row = random() % 16 == 0 ? " " : "";
    for (std::size_t n = 0; n < numbers; ++n) {
        if (n > 0) row += blank;
        if (random() % 40 == 0) {
            row += kOdd[random() % kOdd.size()];
            continue;
        }
        std::string digits = std::to_string(random() >> (8 + random() % 54));
        if (random() % 4 != 0) digits.insert(random() % (digits.size() + 1), ".");
        row += (random() % 3 == 0 ? "-" : "") + digits;
    }
    if (random() % 16 == 0) row += ' ';
    static const std::array<const char*, 4> kEnds{"\n", "\n", "\r\n", "\r"};
    return row + kEnds[random() % 16 == 0 ? random() % 4 : 0];
}

TEST(PlainNumbers, RowsOfLongTextsAreReadAsThoseOfShortOnes) {
    std::string before;
    for (int n = 0; n < 20001; ++n) before += "0.5 1.5 2.5\n"; // enough rows to learn the number format
    std::mt19937_64 random(1611);
    for (int n = 0; n < 300; ++n) {
        TextLayout layout;
        layout.separator = std::array{' ', ' ', ',', '\t'}[random() % 4];
        layout.trailingSeparator = random() % 4 == 0;
        const std::size_t most = random() % 2 == 0 ? 3 : std::numeric_limits<std::size_t>::max();
        std::string rows;
        for (int row = 0; row < 80; ++row) rows += randomRow(random, layout.separator);
        std::string head = before;
        if (layout.separator != ' ') std::ranges::replace(head, ' ', layout.separator);
        const ReadRows slow = readAll(rows, layout, most);
        ReadRows fast = readAll(head + rows, layout, most);
        ASSERT_GE(fast.rows.size(), 20001U);
        fast.rows.erase(fast.rows.begin(), fast.rows.begin() + 20001);
        ASSERT_EQ(fast.rows, slow.rows) << rows;
        ASSERT_EQ(fast.problem, slow.problem) << rows;
    }
}

} // namespace
} // namespace edgescan::files
