// Surpac string files: northing before easting, ends of strings are not points; and numbers in Fortran notation.
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// As Surpac writes it, each line of the scan as a string.
std::string stringsOf(const Scan& scan, const std::string& behindPoint = ",") {
    std::string text =
        "bell_7,21-Nov-26,,\r\n0,           0.000,           0.000,           0.000,           0.000,           0.000,           0.000\r\n";
    std::size_t n = 0;
    for (const auto& p : listOf(scan, {})) {
        text += std::to_string(1 + n % 3) + ", " + numberText("%.6f", p[1]) + ", " + numberText("%.6f", p[0]) + ", " +
                numberText("%.6f", p[2]) + behindPoint + "\r\n";
        if (++n % 50 == 0) text += "0, 0.000, 0.000, 0.000,\r\n";
    }
    return text + "0, 0.000, 0.000, 0.000,\r\n0, 0.000, 0.000, 0.000, END\r\n";
}

bool says(const Scan& scan, const std::string& part) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

} // namespace

TEST(Surpac, StringsOpenAsTheirGrid) {
    const Scan expected = makeScan({});
    for (const char* extension : {".str", ".txt"}) {
        const auto scan = readBytes(stringsOf(expected), extension);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->format, "Surpac strings");
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(scan->state, expected.state);
        EXPECT_FALSE(says(*scan, "END"));
        EXPECT_FALSE(says(*scan, "Descriptions"));
    }
}

TEST(Surpac, SkippedLinesAreReported) {
    const auto described = readBytes(stringsOf(makeScan({}), ", ore, 12.5"), ".str");
    ASSERT_TRUE(described) << described.error().sentence();
    EXPECT_TRUE(says(*described, "Descriptions of points (D1 and further) are not read."));
    std::string cut = stringsOf(makeScan({}));
    cut.resize(cut.rfind("0, 0.000"));
    const auto open = readBytes(cut, ".str");
    ASSERT_TRUE(open) << open.error().sentence();
    EXPECT_TRUE(says(*open, "does not end with END"));
    const auto more = readBytes(stringsOf(makeScan({})) + "1, 2, 3, 4\n", ".str");
    ASSERT_TRUE(more) << more.error().sentence();
    EXPECT_TRUE(says(*more, "behind END"));
}

TEST(Surpac, DamageIsNamedByLine) {
    const std::string head = "bell,21-Nov-26,,\n0, 0.000, 0.000, 0.000\n";
    EXPECT_NE(refusalOf(head + "1, 2, 3, 4,\n1, 2, x, 4,\n0, 0, 0, 0, END\n", ".str").find("line 4: a point of a string needs"),
              std::string::npos);
    EXPECT_NE(refusalOf(head + "1, 2, 3\n", ".str").find("line 3"), std::string::npos);
    EXPECT_NE(refusalOf(head + "0, 0.000, 0.000, 0.000, END\n", ".str").find("no points"), std::string::npos);
}

TEST(Surpac, ATableIsNone) {
    // A header with names and a first row of zeros: easting is first.
    std::string text = "x,y,z,i\n0,0,0,2\n";
    for (const auto& p : listOf(makeScan({}), {}))
        text += numberText("%.6f", p[0]) + "," + numberText("%.6f", p[1]) + "," + numberText("%.6f", p[2]) + ",2\n";
    const auto table = readBytes(text, ".csv");
    ASSERT_TRUE(table) << table.error().sentence();
    EXPECT_EQ(table->format, "point list");
}

TEST(FortranNumbers, ExponentsWithDAreRead) {
    const Scan expected = makeScan({});
    std::string text;
    for (const auto& p : listOf(expected, {})) {
        for (int a = 0; a < 3; ++a) {
            std::string word = numberText("%.12e", p[a]);
            word[word.find('e')] = a == 1 ? 'd' : 'D';
            text += word + "  ";
        }
        text += "\n";
    }
    const auto scan = readBytes(text, ".xyz");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    EXPECT_EQ(scan->state, expected.state);
    EXPECT_NE(refusalOf("1.0D+00 2 3\n1 2 3\n1 2.5Dx 3\n", ".xyz").find("line 3: \"2.5Dx\" is not a number"), std::string::npos);
}
