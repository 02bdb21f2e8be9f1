// Numbers of text are read as std::from_chars reads them, in every kind of row.
#include "core/files/point_tables/text_layout.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cstring>
#include <random>

using namespace edgescan;
using namespace edgescan::files;

namespace {

struct Words {
    std::vector<std::string> words;
    std::string text;
};

// Rows of four numbers of all lengths.
Words randomRows(const char* lineEnd, unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&random](unsigned n) { return static_cast<unsigned>(random() % n); };
    const auto digits = [&](unsigned count) {
        std::string text;
        for (unsigned n = 0; n < count; ++n) text += static_cast<char>('0' + below(10));
        return text;
    };
    Words made;
    for (int row = 0; row < 20000; ++row) {
        for (int column = 0; column < 4; ++column) {
            std::string word = below(2) == 0 ? "-" : "";
            const unsigned whole = below(12);
            word += digits(whole);
            if (whole == 0 || below(4) > 0) word += "." + digits(whole == 0 ? 1 + below(12) : below(12));
            if (below(20) == 0) word += "e" + std::to_string(static_cast<int>(below(40)) - 20);
            made.words.push_back(word);
            made.text += word + (column == 3 ? lineEnd : " ");
        }
    }
    return made;
}

void expectAsLibrary(const Words& made) {
    const ReadingOptions options;
    const Source source{"numbers.xyz", std::as_bytes(std::span(made.text)), &options};
    TextLayout layout;
    layout.columns = 4;
    RowReader rows(source, layout);
    std::vector<double> row;
    std::size_t n = 0;
    while (rows.next(row)) {
        ASSERT_EQ(row.size(), 4U) << "row " << n / 4;
        for (const double value : row) {
            const std::string& word = made.words[n++];
            double expected = 0;
            std::from_chars(word.data(), word.data() + word.size(), expected);
            ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << word << " read as " << value;
        }
    }
    EXPECT_FALSE(rows.problem());
    EXPECT_EQ(n, made.words.size());
}

} // namespace

TEST(TextNumbers, AreReadAsTheLibraryReadsThem) {
    expectAsLibrary(randomRows("\n", 1));
    expectAsLibrary(randomRows("\r\n", 2));
    expectAsLibrary(randomRows("\r", 3));
    expectAsLibrary(randomRows(" \n\n", 4));
}

TEST(TextNumbers, OfTheFirstColumnsAlone) {
    const std::string text = "1.5 -2 3 word 7\n4 5.25 -6.125 8\n";
    const ReadingOptions options;
    const Source source{"numbers.xyz", std::as_bytes(std::span(text)), &options};
    TextLayout layout;
    layout.columns = 5;
    RowReader rows(source, layout);
    rows.limitColumns(3);
    std::vector<double> row;
    ASSERT_TRUE(rows.next(row));
    EXPECT_EQ(row, (std::vector<double>{1.5, -2, 3}));
    ASSERT_TRUE(rows.next(row));
    EXPECT_EQ(row, (std::vector<double>{4, 5.25, -6.125}));
    EXPECT_FALSE(rows.next(row));
    EXPECT_FALSE(rows.problem());
}
