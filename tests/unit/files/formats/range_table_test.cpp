// Range tables as spreadsheets, pandas, R and numpy write them: header rows, index columns, empty cells, units; and files that are not
// range tables.
#include "core/files/open_save/open_scan.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

constexpr int kLines = 24;
constexpr int kBeams = 1141;

/// Whole millimetres with holes; optionally the first line and the last beam have no returns.
std::vector<double> measuredMm(bool emptyEdges = false) {
    std::vector<double> mm;
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) {
            const bool hole = (i * 7 + j * 3) % 11 == 0 || (emptyEdges && (i == 0 || j == kBeams - 1));
            mm.push_back(hole ? std::nan("") : 3000.0 + (j * 37) % 1471 + i * 5);
        }
    }
    return mm;
}

/// Table formats of pandas.DataFrame.to_csv, numpy.savetxt and R's write.table.
struct TableStyle {
    bool index = true, header = true, headerOfIndex = true;
    double unitMm = 1;
    std::string separator = ",";
    std::string missing{};
    const char* format = "%.10g";
    bool decimalComma = false;
    std::string columnName{}, indexName{}, lineEnd = "\n", comment{};
    double columnFirst = 0, columnStep = 1, indexFirst = 0, indexStep = 1;
    std::string indexText{}; ///< instead of the number: "2026-11-20 00:00:0"
    bool quotes = false;
};

std::string tableText(const std::vector<double>& mm, const TableStyle& style) {
    std::string text = style.comment;
    const auto number = [&](double value, const char* format) {
        std::string digits = numberText(format, value);
        if (style.decimalComma) std::replace(digits.begin(), digits.end(), '.', ',');
        return style.quotes ? "\"" + digits + "\"" : digits;
    };
    if (style.header) {
        if (style.index && style.headerOfIndex) text += style.indexName + style.separator;
        for (int j = 0; j < kBeams; ++j)
            text += (j > 0 ? style.separator : "") + style.columnName + numberText("%.15g", style.columnFirst + j * style.columnStep);
        text += style.lineEnd;
    }
    for (int i = 0; i < kLines; ++i) {
        if (style.index) {
            text += style.indexText.empty() ? number(style.indexFirst + i * style.indexStep, "%.10g") : style.indexText + std::to_string(i);
            text += style.separator;
        }
        for (int j = 0; j < kBeams; ++j) {
            const double value = mm[static_cast<std::size_t>(i) * kBeams + static_cast<std::size_t>(j)] / style.unitMm;
            text += (j > 0 ? style.separator : "") + (std::isnan(value) ? style.missing : number(value, style.format));
        }
        text += style.lineEnd;
    }
    return text;
}

void expectRanges(const std::vector<double>& mm, const Result<Scan>& scan) {
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_EQ(scan->lines(), kLines);
    ASSERT_EQ(scan->beams(), kBeams);
    std::size_t different = 0;
    for (std::size_t k = 0; k < mm.size(); ++k) {
        const bool valid = !std::isnan(mm[k]);
        different += (scan->state[k] == CellState::Valid) != valid || (valid && scan->rangeMm[k] != static_cast<float>(mm[k])) ? 1 : 0;
    }
    EXPECT_EQ(different, 0U);
}

bool isTold(const Scan& scan, const std::string& what) {
    return std::any_of(scan.warnings.begin(), scan.warnings.end(), [&](const auto& w) { return w.find(what) != std::string::npos; });
}

} // namespace

TEST(RangeTable, EveryWayOfWritingGivesTheSameRanges) {
    const Folder folder;
    std::vector<std::pair<const char*, TableStyle>> styles{
        {"pandas", {}},
        {"pandas, index only", {.header = false}},
        {"pandas, header only", {.index = false}},
        {"pandas, numbers only", {.index = false, .header = false}},
        {"pandas, counted from 1", {.columnFirst = 1, .indexFirst = 1}},
        {"pandas, floats", {.format = "%.1f"}},
        {"pandas, metres", {.unitMm = 1000}},
        {"pandas, metres, numbers only", {.index = false, .header = false, .unitMm = 1000}},
        {"pandas, three decimals", {.unitMm = 1000, .format = "%.3f"}},
        {"pandas, NA", {.missing = "NA"}},
        {"pandas, NaN", {.missing = "NaN"}},
        {"pandas, null", {.missing = "null"}},
        {"pandas, semicolons", {.unitMm = 1000, .separator = ";", .decimalComma = true}},
        {"pandas, semicolons, numbers only", {.index = false, .header = false, .unitMm = 1000, .separator = ";", .decimalComma = true}},
        {"pandas, tabs", {.unitMm = 1000, .separator = "\t"}},
        {"pandas, tabs and decimal commas", {.unitMm = 1000, .separator = "\t", .format = "%.3f", .decimalComma = true}},
        {"pandas, CRLF", {.lineEnd = "\r\n"}},
        {"pandas, all quoted", {.missing = "\"\"", .quotes = true}},
        {"pandas, names", {.columnName = "beam_"}},
        {"pandas, names only", {.index = false, .columnName = "r"}},
        {"pandas, index with a name", {.columnName = "beam_", .indexName = "line"}},
        {"pandas, index with a name over numbers", {.indexName = "line"}},
        {"pandas, times", {.indexText = "2026-11-20 00:00:0"}},
        {"pandas, times and tabs", {.separator = "\t", .indexText = "2026-11-20 00:00:0"}},
        {"pandas, angles", {.columnFirst = -5, .columnStep = 1.0 / 6, .indexStep = 0.18}},
        {"pandas, angles, no index", {.index = false, .columnFirst = -5, .columnStep = 1.0 / 6}},
        {"read and written by pandas again", {.indexName = "Unnamed: 0"}},
        {"R", {.headerOfIndex = false, .separator = " ", .missing = "NA", .columnName = "V", .columnFirst = 1, .indexFirst = 1}},
        {"numpy.savetxt", {.index = false, .header = false, .separator = " ", .missing = "nan", .format = "%.18e"}},
        {"numpy.savetxt, metres", {.index = false, .header = false, .unitMm = 1000, .missing = "nan", .format = "%.18e"}},
        {"numpy.savetxt, comment", {.index = false, .header = false, .comment = "# ranges of a scan\n"}},
    };
    for (const auto& [name, style] : styles) {
        for (const bool emptyEdges : {false, true}) {
            if (emptyEdges && style.separator == " " && style.missing.empty()) continue;
            SCOPED_TRACE(std::string(name) + (emptyEdges ? ", an empty line and an empty beam" : ""));
            const std::vector<double> mm = measuredMm(emptyEdges);
            writeText(folder / "table.csv", tableText(mm, style));
            expectRanges(mm, openScan(folder / "table.csv"));
        }
    }
}

TEST(RangeTable, TheLastBeamMayBeEmptyForLong) {
    const Folder folder;
    std::vector<double> mm = measuredMm(true);
    mm.back() = 4000; // only the last line has a value there, behind the rows that are examined first
    writeText(folder / "table.csv", tableText(mm, {.index = false, .header = false}));
    expectRanges(mm, openScan(folder / "table.csv"));
}

TEST(RangeTable, HeaderAndIndexGiveTheAngles) {
    const Folder folder;
    writeText(folder / "table.csv", tableText(measuredMm(), {.columnFirst = 10, .columnStep = 0.125, .indexFirst = -12, .indexStep = 0.5}));
    const auto scan = openScan(folder / "table.csv");
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    EXPECT_NEAR(polar.beamDeg.front(), 10, 1e-9);
    EXPECT_NEAR(polar.beamDeg.back(), 10 + 0.125 * (kBeams - 1), 1e-9);
    EXPECT_NEAR(polar.lineDeg.front(), -12, 1e-9);
    EXPECT_NEAR(polar.lineDeg.back(), -12 + 0.5 * (kLines - 1), 1e-9);
    EXPECT_TRUE(isTold(*scan, "angles of the beams were taken from the header: 10 to 152.5 degrees"));
    EXPECT_TRUE(isTold(*scan, "angles of the lines were taken from the first column: -12 to -0.5 degrees"));
    ReadingOptions options;
    options.beamStartDeg = 0; // the user's value has priority
    const auto said = openScan(folder / "table.csv", options);
    ASSERT_TRUE(said);
    EXPECT_NEAR(std::get<PolarGeometry>(said->geometry).beamDeg.back(), (kBeams - 1) / 6.0, 1e-9);
}

TEST(RangeTable, ColumnsWithoutRangesAreReported) {
    const Folder folder;
    std::string text = "time,temperature";
    for (int j = 0; j < kBeams; ++j) text += ",beam_" + std::to_string(j);
    text += ",contamination\n";
    const std::vector<double> mm = measuredMm();
    for (int i = 0; i < kLines; ++i) {
        text += std::to_string(i * 0.04) + ",-3.5";
        for (int j = 0; j < kBeams; ++j) {
            const double value = mm[static_cast<std::size_t>(i) * kBeams + static_cast<std::size_t>(j)];
            text += "," + (std::isnan(value) ? std::string() : numberText("%.0f", value));
        }
        text += ",7\n";
    }
    writeText(folder / "table.csv", text);
    const auto scan = openScan(folder / "table.csv");
    expectRanges(mm, scan);
    ASSERT_TRUE(scan);
    EXPECT_TRUE(isTold(*scan, "3 columns are not ranges, by the header, and not read: time, temperature, contamination"));
}

TEST(RangeTable, OneNumberBelowZeroIsNoReturnAndSeveralAreRefused) {
    const Folder folder;
    const std::vector<double> mm = measuredMm();
    for (const char* mark : {"-1", "-999"}) {
        writeText(folder / "table.csv", tableText(mm, {.missing = mark}));
        const auto scan = openScan(folder / "table.csv");
        expectRanges(mm, scan);
        ASSERT_TRUE(scan);
        EXPECT_TRUE(isTold(*scan, " ranges below 0, all the same number, were taken as no return."));
    }
    std::string text = tableText(mm, {.index = false, .header = false, .missing = "-1"});
    text.replace(text.rfind("-1"), 2, "-9");
    writeText(folder / "table.csv", text);
    const auto two = openScan(folder / "table.csv");
    ASSERT_FALSE(two);
    EXPECT_NE(two.error().sentence().find("line 23, beam "), std::string::npos) << two.error().sentence();
    EXPECT_NE(two.error().sentence().find("holds -9, which is not a range"), std::string::npos) << two.error().sentence();
}

TEST(RangeTable, FilesThatAreNoneAreNamed) {
    const Folder folder;
    const auto refused = [&](const std::string& text, const char* expected, const ReadingOptions& options = {}) {
        writeText(folder / "table.csv", text);
        const auto scan = openScan(folder / "table.csv", options);
        ASSERT_FALSE(scan) << expected;
        EXPECT_NE(scan.error().sentence().find(expected), std::string::npos) << scan.error().sentence();
    };
    ReadingOptions steps;
    steps.beamStartDeg = steps.lineStartDeg = 0;
    steps.beamStepDeg = steps.lineStepDeg = 1;
    steps.axis = Axis::Spin;
    std::string points;
    for (int n = 0; n < 60; ++n) points += numberText("%.3f", n * 0.1 - 3) + ",2.5,1.25\n";
    refused(points, "line 1: column 1 holds -3, so this is not a table of ranges; for a list of points", steps);
    std::string wide;
    for (int n = 0; n < 60; ++n) {
        for (int j = 0; j < 20; ++j) wide += numberText("%.3f", n * 0.1 + (j * 7) % 11 - 7.5) + (j < 19 ? "," : "\n");
    }
    refused(wide, "line 1: column 1 holds -7.5, so this is not a table of ranges");
    refused("\n<!DOCTYPE html>\n<html><body>\n1,2,3\n4,5,6\n</body></html>\n", "this is a web page (HTML), not a scan");
    refused("<?xml version=\"1.0\"?>\n<a>\n1,2,3\n</a>\n", "this is an XML document");
    refused(std::string("BM\x36\0\0\0", 6), "this is a BMP picture");
    refused(std::string("RIFF\x24\0\0\0WEBP", 12), "this is a picture, sound or film");
    refused("x,y,z\nBerlin,Rome,Paris\n", "\"Berlin\" is below x, y or z and is not a number");
    refused("place,a,b\nBerlin,1,2\nRome,3,4\n", "text without a row of numbers"); // labels without x, y and z do not make points
    refused("\"3,5\",\"3,6\",\"3,7\"\n\"3,5\",\"3,6\",\"3,7\"\n", "decimal commas in quotes between commas");
    std::string turned; // a beam per row
    for (int j = 0; j < kBeams; ++j) {
        for (int i = 0; i < kLines; ++i) turned += std::to_string(3000 + (i * 31 + j * 7) % 500) + (i + 1 < kLines ? "," : "\n");
    }
    refused(turned, "or save it with a row per scan line: it has as many rows as an LMS511 has beams");
}

TEST(PointText, IndexAndHeaderOfPandasAreNoNumbers) {
    const Folder folder;
    const Scan expected = makeScan({});
    const auto points = listOf(expected, {});
    const auto text = [&](const char* header, bool index) {
        std::string rows = header;
        for (std::size_t k = 0; k < points.size(); ++k) {
            if (index) rows += std::to_string(k) + ",";
            rows += numberText("%.7f", points[k].x()) + "," + numberText("%.7f", points[k].y()) + "," + numberText("%.7f", points[k].z()) +
                    "\n";
        }
        return rows;
    };
    for (const auto& [header, index] : std::vector<std::pair<const char*, bool>>{
             {",0,1,2\n", true}, {"0,1,2\n", false}, {"", true}, {"", false}, {",x,y,z\n", true}, {",a,b,c\n", true}, {"a,b,c\n", false}}) {
        SCOPED_TRACE(header);
        writeText(folder / "list.csv", text(header, index));
        const auto scan = openScan(folder / "list.csv");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(scan->state, expected.state);
        EXPECT_EQ(isTold(*scan, "The header names no x, y and z: the first three columns were taken for them (a, b, c)."),
                  std::string(header).find('a') != std::string::npos);
    }
}

TEST(RangeTable, PandasAndNumpyThemselves) {
    std::string python;
    for (const char* candidate : {"python3", "/usr/bin/python3"}) {
        if (python.empty() && std::system((candidate + std::string(" -c 'import pandas' >/dev/null 2>&1")).c_str()) == 0)
            python = candidate;
    }
    if (python.empty()) GTEST_SKIP() << "python3 with pandas is not there";
    const Folder folder;
    const std::vector<double> mm = measuredMm(true);
    writeText(folder / "plain.csv", tableText(mm, {.index = false, .header = false, .missing = "nan"}));
    writeText(folder / "make.py", R"(
import numpy, pandas, sys
folder = sys.argv[1]
mm = numpy.loadtxt(folder + '/plain.csv', delimiter=',')
n = 0
def to_csv(table, **options):
    global n
    table.to_csv(f'{folder}/{n}.csv', **options)
    n += 1
for scale in (1, 1000):
    table = pandas.DataFrame(mm / scale)
    for index in (True, False):
        for header in (True, False):
            to_csv(table, index=index, header=header)
            to_csv(table, index=index, header=header, sep=';', decimal=',')
            to_csv(table, index=index, header=header, sep='\t', na_rep='NA')
            to_csv(table, index=index, header=header, quoting=1)
numpy.savetxt(f'{folder}/{n}.csv', mm / 1000)
numpy.savetxt(f'{folder}/{n + 1}.csv', mm, delimiter=',', header='ranges')
)");
    ASSERT_EQ(std::system((python + " " + (folder / "make.py").string() + " " + (folder / "").string()).c_str()), 0);
    for (int n = 0; n < 34; ++n) {
        SCOPED_TRACE(n);
        expectRanges(mm, openScan(folder / (std::to_string(n) + ".csv")));
    }
}
