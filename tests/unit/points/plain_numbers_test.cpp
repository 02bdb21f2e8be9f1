// Numbers of texts: read as std::from_chars reads them, to the last bit.
#include "core/points/text_layout.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace edgescan {
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

} // namespace
} // namespace edgescan
