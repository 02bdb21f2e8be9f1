// Text of every kind: separators, commas, comments, headers, line ends; and the range table of the thesis.
#include "core/files/open_save/open_scan.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
}

/// The rows of a synthetic scan, whole millimetres, in metres.
std::string rows(const char* separator = " ", const char* suffix = "\n") {
    ListStyle style{.format = "%.7f", .separator = separator, .lineEnd = suffix};
    return textOf(listOf(makeScan({}), style), style);
}

} // namespace

TEST(PointText, EveryWayOfWritingGivesTheSameScan) {
    const Folder folder;
    const Scan expected = makeScan({});
    std::string comma = rows(";");
    replaceAll(comma, ".", ",");
    std::string commaTabs = rows("\t");
    replaceAll(commaTabs, ".", ",");
    std::string commaBlanks = rows();
    replaceAll(commaBlanks, ".", ",");
    std::string minusZero = rows();
    replaceAll(minusZero, "\n0.0000000 0.0000000 0.0000000\n", "\n-0 0 -0\n");
    std::string nans = rows();
    replaceAll(nans, "\n0.0000000 0.0000000 0.0000000\n", "\nnan NaN -nan\n");
    std::string microsoft = rows();
    replaceAll(microsoft, "\n0.0000000 0.0000000 0.0000000\n", "\n1.#QNAN -1.#IND 1.#QNAN\n");
    std::string empty = rows(",");
    replaceAll(empty, "\n0.0000000,0.0000000,0.0000000\n", "\n,,\n");
    std::string noEnd = rows();
    noEnd.pop_back();
    std::string oldMac = rows(" ", "\r");
    std::string commented = rows();
    replaceAll(commented, "\n1", "\n# a comment in between\n\n1");
    std::string faro = "12 7 " + rows(); // row and column of FARO's text
    faro.pop_back();
    replaceAll(faro, "\n", "\n12 7 ");
    const std::vector<std::pair<const char*, std::string>> texts{
        {"blanks", rows()},
        {"row and column before them", faro},
        {"many blanks", rows("   \t ")},
        {"commas", rows(",")},
        {"comma and blank", rows(", ")},
        {"semicolons", rows(";")},
        {"tabs", rows("\t")},
        {"CRLF", rows(" ", "\r\n")},
        {"CR", oldMac},
        {"BOM", "\xEF\xBB\xBF" + rows()},
        {"header", "x,y,z\n" + rows(",")},
        {"header in units", "X [m];Y [m];Z [m]\n" + rows(";")},
        {"header of CloudCompare", "//X Y Z\n" + rows()},
        {"title lines", "My scan of 2026\nmade by hand\n" + rows()},
        {"comments", "# one\n% two\n// three\n" + rows()},
        {"comments between", commented},
        {"count", std::to_string(expected.cells()) + "\n" + rows()},
        {"colours", rows(" ", " 12 200 34\n")},
        {"intensity", "x y z intensity\n" + rows(" ", " 0.25\n")},
        {"trailing commas", rows(",", ",\n")},
        {"trailing blanks", rows(" ", "  \n")},
        {"quotes", "\"x\",\"y\",\"z\"\n" + rows(",")},
        {"decimal commas", comma},
        {"decimal commas and tabs", commaTabs},
        {"decimal commas and blanks", commaBlanks},
        {"minus zero", minusZero},
        {"nan", nans},
        {"Microsoft's nan", microsoft},
        {"empty cells", empty},
        {"no last line end", noEnd},
    };
    for (const auto& [name, text] : texts) {
        SCOPED_TRACE(name);
        writeText(folder / "list.xyz", text);
        const auto scan = openScan(folder / "list.xyz");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(scan->state, expected.state);
        EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
    }
}

TEST(PointText, ColumnsAreFoundByName) {
    const Folder folder;
    const Scan expected = makeScan({});
    const auto points = listOf(expected, {});
    std::string text = "id;z_mm;intensity;x_mm;y_mm\n";
    for (std::size_t k = 0; k < points.size(); ++k) {
        text += std::to_string(k);
        for (const double v : {points[k].z() * 1000, 0.5, points[k].x() * 1000, points[k].y() * 1000}) text += ";" + numberText("%.4f", v);
        text += "\n";
    }
    writeText(folder / "list.csv", text);
    const auto scan = openScan(folder / "list.csv");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    ASSERT_EQ(scan->warnings.size(), 1U); // the header gave the unit
    EXPECT_TRUE(scan->warnings.front().starts_with("The file lists only points: ")) << scan->warnings.front();
}

// Survey and spreadsheet programs write names, codes and dates in any column.
TEST(PointText, ColumnsOfWordsAreNoneOfThePoint) {
    const Folder folder;
    const Scan expected = makeScan({});
    for (const char* separator : {",", ";", "\t"}) {
        ListStyle style{.format = "%.7f", .separator = separator, .lineEnd = "\n"};
        const std::string s = separator;
        std::string text = "Code" + s + "X" + s + "Y" + s + "Z" + s + "When" + s + "\"Seen by\"\n";
        bool comma = false;
        for (const Eigen::Vector3d& p : listOf(expected, style)) {
            std::string numbers;
            for (int axis = 0; axis < 3; ++axis) numbers += numberText("%.7f", p[axis]) + s;
            if (s == ";") replaceAll(numbers, ".", ",");
            text += (comma ? "17" : "\"CREST" + s + " A\"") + s + numbers; // a code may be a number, and hold the separator in quotes
            text += (comma ? "2026-11-21 04:05" : "\"21" + s + " 11\"") + s + "\"Jo" + s + " \"\"the eye\"\"\"\n";
            comma = !comma;
        }
        writeText(folder / "survey.csv", text);
        const auto opened = openScan(folder / "survey.csv");
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(opened->rangeMm, expected.rangeMm);
        EXPECT_EQ(opened->state, expected.state);
    }
}

TEST(PointText, UnitsInTheHeaderAreTheUnit) {
    const Folder folder;
    const Scan expected = makeScan({});
    for (const auto& [unit, mm] : {std::pair("ft", 304.8), std::pair("mm", 1.0), std::pair("cm", 10.0), std::pair("in", 25.4)}) {
        ListStyle style{.perMetre = 1000.0 / mm, .format = "%.8f", .separator = ",", .lineEnd = "\n"};
        writeText(folder / "list.csv",
                  "X [" + std::string(unit) + "],Y [" + unit + "],Z [" + unit + "]\n" + textOf(listOf(expected, style), style));
        const auto opened = openScan(folder / "list.csv");
        ASSERT_TRUE(opened) << opened.error().sentence();
        ASSERT_EQ(opened->state, expected.state) << unit;
        for (std::size_t k = 0; k < expected.cells(); ++k) ASSERT_NEAR(opened->rangeMm[k], expected.rangeMm[k], 0.01) << unit;
    }
}

TEST(PointText, LocaleChangesNothing) {
    const Folder folder;
    writeText(folder / "list.xyz", rows());
    const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
    const auto scan = openScan(folder / "list.xyz");
    if (set != nullptr) std::setlocale(LC_ALL, "C");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, makeScan({}).rangeMm);
}

TEST(PointText, LeftHandedFilesAreMirroredAndReported) {
    const Folder folder;
    const ListStyle style{.perMetre = 100};
    const Scan expected = makeScan({});
    writeText(folder / "scan.3d", textOf(listOf(expected, style), style));
    const auto scan = openScan(folder / "scan.3d");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    EXPECT_EQ(polar.lineDeg, std::get<PolarGeometry>(expected.geometry).lineDeg);
    EXPECT_EQ(polar.lineDirection, -1.0);
    EXPECT_TRUE(std::any_of(scan->warnings.begin(), scan->warnings.end(),
                            [](const auto& w) { return w.find("left-handed") != std::string::npos; }));
    const Eigen::Vector3d a = CartesianTables(expected).point(5, 30);
    const Eigen::Vector3d b = CartesianTables(*scan).point(5, 30);
    EXPECT_NEAR((a - Eigen::Vector3d(b.x(), -b.y(), b.z())).norm(), 0, 1e-9);
}

TEST(PointText, SentencesNameTheLine) {
    const Folder folder;
    const auto refused = [&](const std::string& text, const char* expected) {
        writeText(folder / "list.xyz", text);
        const auto scan = openScan(folder / "list.xyz");
        ASSERT_FALSE(scan) << expected;
        EXPECT_NE(scan.error().sentence().find(expected), std::string::npos) << scan.error().sentence();
    };
    refused("1 2 3\n4 5 6\n7 abc 9\n", "line 3: \"abc\" is not a number");
    std::string rows;
    for (int k = 0; k < 30000; ++k) rows += "1 2 3\n";
    refused(rows + std::string(512, '\0') + "\n1 2 3\n", "line 30001: holds bytes of zero, as a file does that was not written to its end");
    refused(rows + std::string(512, '\0'), "512 bytes of zero (NUL) follow the last row");
    refused("1 2 3\n4 5 6\n7 8\n", "line 3: holds 2 numbers");
    refused("5\n1 2 3\n4 5 6\n", "promises 5 points and holds 2");
    refused("1 2\n3 4\n", "line 1: holds 2 numbers where a point needs three");
    refused("1.5|2.5|3.5\n1.5|2.5|4.5\n", "line 1: its numbers are separated by \"|\"");
    refused("[1.5 2.5 3.5]\n", "line 1: its numbers are separated by \"[\"");
    refused("x,y,z\n1.5 m,2.5 m,3.5 m\n", "line 2: \"1.5 m\" is below x, y or z and is not a number");
    refused("3\n1 2 3\n1 2 4\n1 2 5\n2\n1 2 6\n1 2 7\n", "line 5: begins a further list, behind the 3 points of the first");
    refused("only words here\n", "without a row of numbers");
    refused("1 2 3\n", "too few");
    refused("0 0 0\n0 0 0\n", "holds 0 points with a return");
}

TEST(PointText, CancelStopsAndSaysSo) {
    const Folder folder;
    writeText(folder / "list.xyz", rows());
    int calls = 0;
    ReadingOptions options;
    options.progress = [&](const char*, double fraction) {
        EXPECT_GE(fraction, 0);
        EXPECT_LE(fraction, 1);
        return ++calls < 3;
    };
    const auto scan = openScan(folder / "list.xyz", options);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().what, "cancelled");
}

TEST(PointText, AxisAndUnitOptionsAreObeyed) {
    const Folder folder;
    writeText(folder / "list.xyz", rows());
    ReadingOptions options;
    options.unitMm = 1;
    const auto scan = openScan(folder / "list.xyz", options);
    ASSERT_TRUE(scan);
    EXPECT_LT(rangeLimits(*scan).maxMm, 10);
    options.axis = Axis::Spin;
    EXPECT_FALSE(openScan(folder / "list.xyz", options));
}

TEST(RangeCsv, Lms511DefaultsForItsWidth) {
    const Folder folder;
    std::string text;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 1141; ++j)
            text += (j > 0 ? "," : "") + (j == 7 ? std::string() : std::to_string(j == 5 ? 0 : 1707 + i * 10 + j));
        text += "\r\n";
    }
    writeText(folder / "ranges.csv", text);
    const auto scan = openScan(folder / "ranges.csv");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->format, "range CSV");
    EXPECT_EQ(scan->lines(), 4);
    EXPECT_EQ(scan->beams(), 1141);
    EXPECT_EQ(countCells(*scan)[1], 8U);
    EXPECT_EQ(scan->rangeMm.at(3, 100), 1837.0F);
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    EXPECT_DOUBLE_EQ(polar.beamDeg.front(), -5);
    EXPECT_NEAR(polar.beamDeg.back(), 185, 1e-9);
    EXPECT_DOUBLE_EQ(polar.lineDeg[2], 0.36);
    EXPECT_EQ(scan->warnings.size(), 1U);
}

TEST(RangeCsv, OtherWidthsNeedTheirGeometry) {
    const Folder folder;
    std::string text;
    for (int i = 0; i < 3; ++i)
        text += "1000,1001,1002,1003,1004,1005,1006,1007,1008,1009,1010,1011,1012,1013,1014,1015,1016,1017,1018,1019\n";
    writeText(folder / "ranges.csv", text);
    ReadingOptions options;
    options.beamStartDeg = 10;
    const auto missing = openScan(folder / "ranges.csv", options);
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().sentence().find("give --beam-step --line-start --line-step --axis"), std::string::npos)
        << missing.error().sentence();
    options.beamStepDeg = 2;
    options.lineStartDeg = 3;
    options.lineStepDeg = 4;
    options.axis = Axis::Sweep;
    options.unitMm = 10;
    const auto scan = openScan(folder / "ranges.csv", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(scan->warnings.empty());
    EXPECT_EQ(std::get<PolarGeometry>(scan->geometry).lineDeg, (std::vector<double>{3, 7, 11}));
    EXPECT_EQ(scan->rangeMm.at(0, 1), 10010.0F);
    writeText(folder / "ranges.csv", text + "1000,1001\n");
    const auto ragged = openScan(folder / "ranges.csv", options);
    ASSERT_FALSE(ragged);
    EXPECT_NE(ragged.error().sentence().find("line 4: holds 2 ranges"), std::string::npos) << ragged.error().sentence();
    replaceAll(text, "1003", "-3");
    writeText(folder / "ranges.csv", text);
    EXPECT_FALSE(openScan(folder / "ranges.csv", options));
}
