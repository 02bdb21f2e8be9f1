// Numbers with grouped thousands, as spreadsheets of several countries write them: each is refused with the right reason, and no other text
// is refused for this.
#include "core/files/open_save/open_scan.h"
#include "core/files/point_tables/number_groups.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// A number with `decimals` decimals, its thousands separated by `mark`, its decimals by `point`.
std::string groupedText(double value, const std::string& mark, const std::string& point, int decimals = 3) {
    std::string text = numberText(("%." + std::to_string(decimals) + "f").c_str(), value);
    const std::size_t dot = std::min(text.find('.'), text.size());
    std::string whole = text.substr(0, dot);
    const std::size_t first = whole.starts_with('-') ? 1 : 0;
    for (std::size_t at = whole.size(); at > first + 3;) whole.insert(at -= 3, mark);
    return whole + (dot < text.size() ? point + text.substr(dot + 1) : "");
}

struct Country {
    const char* mark;
    const char* point;
};
constexpr Country kCountries[]{
    {" ", ","}, {" ", "."}, {"\xC2\xA0", ","}, {"\xA0", ","}, {"\xE2\x80\xAF", ","}, {"\xE2\x80\x89", ","}, {"\xE2\x80\x99", "."},
    {"'", "."}, {"'", ","}, {".", ","},        {",", "."}};

class NumberGroups : public testing::Test {
protected:
    std::string refusalOf(const std::string& text, const std::string& name = "list.csv") {
        writeText(folder_ / name, text);
        const auto scan = openScan(folder_ / name);
        return scan ? "" : scan.error().sentence();
    }
    /// Millimetres, most of them above a thousand.
    std::string list(const Country& country, const std::string& separator, bool quoted) const {
        const std::string quote = quoted ? "\"" : "";
        std::string text;
        for (const Eigen::Vector3d& p : points_) {
            for (int axis = 0; axis < 3; ++axis)
                text += (axis > 0 ? separator : "") + quote + groupedText(p[axis], country.mark, country.point) + quote;
            text += "\n";
        }
        return text;
    }

    const Folder folder_;
    const std::vector<Eigen::Vector3d> points_ = listOf(makeScan({}), {.perMetre = 1000, .keepMissing = false});
};

TEST_F(NumberGroups, AreRefusedForWhatTheyAreBetweenAnySeparators) {
    for (const Country& country : kCountries) {
        for (const std::string separator : {";", "\t", " ", ","}) {
            const bool inside = separator == country.mark || separator == country.point;
            if (inside && separator == " ") continue; // ambiguous
            for (const char* heading : {"", "X?Y?Z\n"}) {
                std::string text = heading;
                std::ranges::replace(text, '?', separator[0]);
                text += list(country, separator, inside);
                const std::string sentence = refusalOf(text);
                SCOPED_TRACE(text.substr(0, 80));
                EXPECT_NE(sentence.find("thousands are set apart"), std::string::npos) << sentence;
                EXPECT_NE(sentence.find("list.csv: line "), std::string::npos) << sentence;
                EXPECT_NE(sentence.find("plain numbers"), std::string::npos) << sentence;
            }
        }
    }
}

TEST_F(NumberGroups, AreRefusedWhereTheyBeginLate) {
    std::string text = "X;Y;Z\n";
    for (int row = 0; row < 1000; ++row) text += "1,5;" + std::to_string(row) + ",25;3,5\n";
    const std::string sentence = refusalOf(text + "1 001,5;2,5;3,5\n");
    EXPECT_NE(sentence.find("line 1002: holds \"1 001,5\", a number whose thousands are set apart"), std::string::npos) << sentence;
}

TEST_F(NumberGroups, AreDoubtedWhereTheyMayBeDecimals) {
    std::string text = "X;Y;Z\n";
    for (int row = 0; row < 100; ++row)
        text += groupedText(900 + row * 7, ".", ",", 0) + ";" + groupedText(-2000 - row, ".", ",", 0) + ";" +
                groupedText(990 + row, ".", ",", 0) + "\n";
    const std::string sentence = refusalOf(text);
    EXPECT_NE(sentence.find("may separate decimals or thousands"), std::string::npos) << sentence;
}

TEST_F(NumberGroups, OfRangesAreRefusedToo) {
    std::string text;
    for (int line = 0; line < 30; ++line) {
        for (int beam = 0; beam < 20; ++beam) text += (beam > 0 ? ";" : "") + groupedText(1500 + 13 * line + 7 * beam, "\xC2\xA0", ",", 0);
        text += "\n";
    }
    EXPECT_NE(refusalOf(text).find("thousands are set apart"), std::string::npos);
}

TEST_F(NumberGroups, NumbersWithThreeDecimalsAreNone) {
    const auto opens = [&](const ListStyle& style, bool commas) {
        std::string text = textOf(listOf(makeScan({}), style), style);
        if (commas) std::ranges::replace(text, '.', ',');
        SCOPED_TRACE(text.substr(0, 60));
        EXPECT_EQ(refusalOf(text), "");
    };
    for (const char* separator : {" ", ";", "\t"}) {
        opens({.format = "%.3f", .separator = separator}, false);
        opens({.format = "%.3f", .separator = separator}, true);
    }
    opens({.format = "%.6g", .separator = ";"}, true);
    opens({.format = "%.3f", .separator = ","}, false);
    opens({.format = "%.3f", .separator = ", "}, false);
    opens({.perMetre = 1000, .format = "%.0f", .separator = ","}, false);
    opens({.perMetre = 1000, .format = "%.0f", .separator = " "}, false);
}

TEST_F(NumberGroups, ACellIsJudged) {
    for (const char* cell : {"1 234", "12 345,6", "-402 100.25", "1.234,5", "1,234.5", "1.234.567", "1'234",
                             "+7\xC2\xA0"
                             "401\xC2\xA0"
                             "000,1"})
        EXPECT_EQ(groupsOf(cell), Grouped::Yes) << cell;
    for (const char* cell : {"1.234", "1,234", "-999,000"}) EXPECT_EQ(groupsOf(cell), Grouped::Maybe) << cell;
    for (const char* cell :
         {"", "1", "1234", "0.123", "0 123", "1 23", "1 2345", "12.34", "1,2,3", "1.234e5", "1 234,", "1 234 5", "2026-11-21", "a"})
        EXPECT_EQ(groupsOf(cell), Grouped::No) << cell;
}

// A blank between digits must not be skipped together with the digit behind it.
TEST_F(NumberGroups, TwoNumbersInACellAreNotOne) {
    std::string text = "x;y;z\n";
    for (int row = 0; row < 300; ++row) text += "1.5;2.5;" + std::to_string(row) + ".5\n";
    EXPECT_NE(refusalOf(text + "1.5 2.5;3.5;4.5\n").find("line 302: \"1.5 2.5\" is more than one number between two separators"),
              std::string::npos);
    EXPECT_NE(refusalOf(text + "1.5;2.5 m;3.5\n").find("line 302: \"2.5 m\" is not a number"), std::string::npos);
}

TEST_F(NumberGroups, RowsWithoutEndAreNotCutUp) {
    std::string text;
    while (text.size() < 4 * kLongestRowLookedAt) text += "1 234,5 ";
    EXPECT_FALSE(findGroupedNumber(text));
    EXPECT_TRUE(findGroupedNumber("1;2;3\n1 234,5;1;2\n" + text));
}

TEST_F(NumberGroups, ColumnsThatAreNotReadDoNotMatter) {
    const ListStyle style{.separator = ";"};
    const Scan expected = makeScan({});
    std::string text = "id;x;y;z\n";
    std::size_t n = 0;
    for (const Eigen::Vector3d& p : listOf(expected, style)) text += std::to_string(++n) + " A;" + textOf({p}, style);
    writeText(folder_ / "list.csv", text);
    const auto scan = openScan(folder_ / "list.csv");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
}

} // namespace
