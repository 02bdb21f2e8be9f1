// Contradictions between headers and content, and impossible numbers: refused or reported, never half a scan without a warning.
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/recording/save_recording.h"
#include "core/scan/grid/placement.h"
#include "tests/support/bytes.h"
#include "tests/support/folders.h"
#include "tests/support/placements.h"
#include "tests/support/seed_files.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// The text of a reading: the refusal, or all warnings.
std::string saidOf(const std::string& bytes, const std::string& extension, const ReadingOptions& options = {}) {
    const auto scan = readBytes(bytes, extension, options);
    if (!scan) return scan.error().sentence();
    std::string all = "opened.";
    for (const std::string& warning : scan->warnings) all += " " + warning;
    return all;
}

void expectSaid(const std::string& bytes, const std::string& extension, const std::string& words, const ReadingOptions& options = {}) {
    const std::string said = saidOf(bytes, extension, options);
    EXPECT_NE(said.find(words), std::string::npos) << said;
}

std::string rows(int count, const char* tail = "") {
    std::string text;
    for (int n = 0; n < count; ++n)
        text += numberText("%.3f", 2 + n % 7 * 0.1) + " " + numberText("%.3f", n * 0.01 - 1) + " " + numberText("%.3f", n % 5 * 0.2) +
                tail + "\n";
    return text;
}

std::string pcd(int width, int height, const std::string& data, const std::string& points, const char* size = "4 4 4") {
    return "VERSION 0.7\nFIELDS x y z\nSIZE " + std::string(size) + "\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + std::to_string(width) +
           "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(width * height) + "\nDATA " + data +
           "\n" + points;
}

std::string floats(int count) {
    std::string bytes;
    for (int n = 0; n < 3 * count; ++n) putAt(bytes, bytes.size(), static_cast<float>(2 + n % 11 * 0.1));
    return bytes;
}

std::string ply(int count, const std::string& format, const std::string& points, const std::string& more = "") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(count) +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more + "end_header\n" + points;
}

std::string ptx(int columns, int rowCount, const std::string& points, const std::string& place = "0 0 0") {
    return std::to_string(columns) + "\n" + std::to_string(rowCount) + "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n" + place +
           " 1\n" + points;
}

} // namespace

TEST(Promises, MoreRowsThanAHeaderPromises) {
    expectSaid(pcd(200, 1, "ascii", rows(400)), ".pcd", "line 211: the header promises 200 points, and more text follows them here");
    expectSaid(pcd(20, 10, "ascii", rows(201)), ".pcd", "the header promises 200 points");
    expectSaid(pcd(20, 10, "ascii", rows(200) + "# a comment\n\n  \n"), ".pcd", "opened");
    expectSaid(pcd(200, 1, "binary", floats(400)), ".pcd",
               "promises 200 points of 12 bytes and the file holds 4800 bytes of them, which is more");
    expectSaid(pcd(20, 10, "binary", floats(200) + "\n"), ".pcd", "1 byte behind the points");
    expectSaid(replaced(pcd(200, 1, "binary", floats(200), "1 1 1"), "TYPE F F F", "TYPE I I I"), ".pcd", "which is more"); // wrong SIZE
    expectSaid(ply(200, "ascii", rows(400)), ".ply", "the header promises 200 points");
    expectSaid(ply(200, "binary_little_endian", floats(201)), ".ply", "which is more");
    const std::string camera = "element camera 1\nproperty float view_px\n"; // behind the vertices, of a known length
    expectSaid(ply(200, "binary_little_endian", floats(200) + "1234", camera), ".ply", "not what follows them: 1 camera");
    expectSaid(ply(200, "binary_little_endian", floats(201) + "1234", camera), ".ply", "which is more");
    const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
    EXPECT_EQ(saidOf(ply(200, "ascii", rows(200) + "3 0 1 2\n3 1 2 3\n", faces), ".ply").find("promises"), std::string::npos);
}

TEST(Promises, PtxColumnsAndRows) {
    const std::string whole = rows(600, " 0.5");
    expectSaid(ptx(20, 30, whole), ".ptx", "opened");
    expectSaid(ptx(19, 30, whole), ".ptx", "behind the 19 columns of 30 points that the header promises there are more");
    expectSaid(ptx(20, 29, whole), ".ptx", "there are more");
    expectSaid(ptx(21, 30, whole), ".ptx", "the file ends before them");
    expectSaid(ptx(20, 30, whole) + ptx(20, 30, whole), ".ptx", "The file holds 2 scans");
    expectSaid(ptx(20, 30, whole) + ptx(19, 30, whole), ".ptx", "Behind the last of these scans there is text that is none.");
    std::string empty;
    for (int n = 0; n < 600; ++n) empty += "0 0 0 0.5\n";
    expectSaid(ptx(20, 30, empty), ".ptx", "holds 0 points with a return, out of 600");
}

TEST(Promises, ALastRowWithoutItsLineEndMayBeCut) {
    const auto cut = [](std::string text) { return text.substr(0, text.size() - 2); };
    expectSaid(cut(pcd(20, 10, "ascii", rows(200))), ".pcd", "may have been cut off there");
    expectSaid(cut(ptx(20, 30, rows(600, " 0.5"))), ".ptx", "may have been cut off there");
    std::string vertices;
    for (int n = 0; n < 600; ++n) vertices += "v " + rows(n + 1).substr(rows(n).size());
    expectSaid(cut(vertices), ".obj", "may have been cut off there");
}

TEST(Promises, PointsOutOfReachAreReported) {
    std::string far, oneWay;
    for (int n = 0; n < 200; ++n) {
        far += std::to_string(1200000 + n % 20 * 100000) + ".5 " + std::to_string(n / 20 * 100000) + ".5 300.5\n";
        oneWay += std::to_string(698700 + n % 20) + ".5 " + std::to_string(5150000 + n / 20) + ".5 300.5\n";
    }
    ReadingOptions metres;
    metres.unitMm = 1000;
    expectSaid(pcd(20, 10, "ascii", far), ".pcd", "200 points lie farther than 1000 km from the sensor", metres);
    expectSaid(pcd(20, 10, "ascii", oneWay), ".pcd", "200 points of its grid lie in one direction from the origin", metres);
}

TEST(Promises, APlaceIsOnEarth) {
    const std::string whole = rows(600, " 0.5");
    for (const char* place : {"1e300 1e300 1e300", "1e9 0 0", "0 0 1e6", "0 -2e8 0"}) {
        expectSaid(ptx(20, 30, whole, place), ".ptx", "not a place on earth");
        EXPECT_EQ(readBytes(ptx(20, 30, whole, place), ".ptx")->placement, nullptr);
    }
    const auto placed = readBytes(ptx(20, 30, whole, "698700 5150000 300"), ".ptx");
    ASSERT_TRUE(placed);
    EXPECT_NE(placed->placement, nullptr);
}

TEST(Promises, ALasFileCutInItsTailSaysSo) {
    const Folder folder;
    Scan scan = makeScan({.lines = 12, .beams = 20});
    ASSERT_TRUE(saveScan(scan, folder / "whole.las"));
    const std::string whole = readText(folder / "whole.las");
    ASSERT_EQ(saidOf(whole, ".las"), "opened.");
    const auto tail = valueAt<std::uint64_t>(whole, 235);
    ASSERT_GT(tail, 375U);
    ASSERT_LT(tail, whole.size());
    for (std::size_t end = tail; end < whole.size(); end += 1 + (whole.size() - tail) / 40)
        expectSaid(whole.substr(0, end), ".las", "records behind the points cannot be read");
    std::string fewer = smallLas(listOf(makeScan({}), {}));
    const auto count = valueAt<std::uint32_t>(fewer, 107);
    putAt(fewer, 107, count / 2);
    expectSaid(fewer, ".las", "points that the header promises were not read");
    for (const double scale : {0.0, 1e-300, 1e300, -1e-13}) {
        putAt(fewer, 131, scale);
        expectSaid(fewer, ".las", "the scale or offset in the LAS header");
    }
}

TEST(Promises, RawGridsOfNumbersThatNobodyMeasures) {
    const auto grid = [](const std::string& keys, int lines = 2, int beams = 3) {
        return R"({"format":"edgescan-raw-grid/1","lines":)" + std::to_string(lines) + R"(,"beams":)" + std::to_string(beams) + "," + keys +
               "}" + '\0' + std::string(static_cast<std::size_t>(2 * lines * beams), '\x7f');
    };
    const std::string angles = R"("beam_deg":{"start":0,"step":1},"line_deg":{"start":0,"step":1},"axis":"spin")";
    expectSaid(grid(angles), ".json", "opened");
    expectSaid(grid(angles + R"(,"unit_mm":1e300)"), ".json", "\"unit_mm\" holds a number out of all reason");
    for (const char* unit : {"1e-300", "1e-7", "1e7"}) expectSaid(grid(angles + R"(,"unit_mm":)" + unit), ".json", "\"unit_mm\" is");
    expectSaid(grid(angles + R"(,"unit_mm":1e6)"), ".json", "3.2639e+10 mm at line 0, beam 0 cannot be a measured range"); // 0x7f7f km
    for (const char* step : {"0", "1e-300", "1e-9"})
        expectSaid(grid(R"("beam_deg":{"start":0,"step":)" + std::string(step) + R"(},"line_deg":[0,1],"axis":"spin")"), ".json",
                   "all 3 beams look the same way");
    expectSaid(grid(R"("beam_deg":[5,5,5],"line_deg":[0,1],"axis":"spin")"), ".json", "all 3 beams look the same way");
    expectSaid(grid(R"("beam_deg":{"start":0,"step":1e12},"line_deg":[0,1],"axis":"spin")"), ".json", "\"beam_deg.step\"");
    expectSaid(grid(R"("beam_deg":{"start":0,"step":170},"line_deg":[0,1],"axis":"spin")", 2, 4), ".json", "at beam 3");
    expectSaid(grid(R"("beam_deg":[0,1,1e11],"line_deg":[0,1],"axis":"spin")"), ".json", "\"beam_deg\" is");
    expectSaid(grid(R"("beam_deg":[0,1,2],"line_deg":[0,1e11],"axis":"spin")"), ".json", "\"line_deg\" is");
    expectSaid(grid(angles + R"(,"line_skew_deg":[0,0,1e11])"), ".json", "\"line_skew_deg\" is");
    expectSaid(grid(R"("beam_deg":[5],"line_deg":[0,0],"axis":"spin")", 2, 1), ".json", "opened"); // a stepper that does not move
    // A cell has one state.
    expectSaid(grid(angles + R"(,"state_runs":[["lost",0,6],["masked",5,1]])"), ".json", "names cell 5 twice");
    expectSaid(grid(angles + R"(,"state_runs":[["lost",4,2],["masked",0,4],["lost",2,0]])"), ".json", "opened");
    expectSaid(grid(angles + R"(,"state_runs":[["lost",18446744073709551615,2]])"), ".json", "leaves the grid");
    std::string codes = "0";
    for (int n = 0; n < 70000; ++n) codes += ",7";
    expectSaid(grid(angles + R"(,"status_codes":[)" + codes + "]"), ".json", "\"status_codes\" holds 70001 counts");
    expectSaid(grid(angles + R"(,"no_return":[-1])"), ".json", "\"no_return\" is -1");
}

TEST(Promises, OptionsAreWithinTheTable) {
    for (const ReadingOption& option : readingOptionTable()) {
        if (option.kind != ReadingOption::Kind::Number && option.kind != ReadingOption::Kind::ThreeNumbers) continue;
        ASSERT_NE(option.limit, nullptr) << option.key;
        const std::string more = option.kind == ReadingOption::Kind::ThreeNumbers ? ",0,0" : "";
        for (const char* text : {"1e308", "-1e308", "1e12", "nan", "inf", "-inf", ""})
            EXPECT_FALSE(checked(option, text + more)) << option.key;
        EXPECT_TRUE(checked(option, "1" + more)) << option.key;
        if (!option.limit->zero) {
            EXPECT_FALSE(checked(option, "0")) << option.key;
        }
        const std::string list = more.empty() ? "1e12" : "[1e12,0,0]";
        EXPECT_FALSE(parseReadingOptions("{\"" + std::string(option.key) + "\":" + list + "}", "x")) << option.key;
    }
    EXPECT_FALSE(parseReadingOptions(R"({"beam-step":0})", "x"));
    EXPECT_TRUE(parseReadingOptions(R"({"beam-step":0.5})", "x"));
}

TEST(Promises, BombsAreNotUnpacked) {
    const ReadingOptions options = seedOptions();
    // 16-bit gray, all black: very small for its size.
    const Grid<std::uint16_t> black(4000, 4000);
    const auto png = containers::png16Bytes(black, "x");
    ASSERT_TRUE(png);
    ASSERT_LT(png->size(), 100'000U);
    expectSaid(*png, ".png", "promises more pixels than a file", options);
    const auto small = containers::png16Bytes(Grid<std::uint16_t>(40, 40, 1000), "x");
    expectSaid(*small, ".png", "opened", options);
    // A header whose size overflows 64 bits: 2^30 x 2^30 x 32 bits.
    std::string tiff = smallTiff(makeScan({.lines = 4, .beams = 5}));
    expectSaid(tiff, ".tif", "opened", options);
    for (std::size_t at = 10; at + 12 <= tiff.size(); at += 12) {
        const auto tag = valueAt<std::uint16_t>(tiff, at);
        if (tag == 256 || tag == 257 || tag == 278) putAt(tiff, at + 8, std::uint32_t{1} << 30U);
        if (tag == 258) putAt(tiff, at + 8, std::uint32_t{32});
        if (tag == 339) putAt(tiff, at + 8, std::uint32_t{3});
    }
    expectSaid(tiff, ".tif", "promises more pixels than a file", options);
}

TEST(Promises, TheDocumentShowsTheTable) {
    const std::string document = readText(test::sourceFolder() + "/docs/reference/formats.md");
    const auto shown = [](double value) {
        std::string text;
        appendShortest(text, value);
        return text;
    };
    for (const PhysicalLimit& row : kPhysicalLimits) {
        const std::string line = std::string("| ") + row.what + " | " + shown(row.limits.least) + " | " + shown(row.limits.most) + " | " +
                                 row.unit + " | " + row.why + " |";
        EXPECT_NE(document.find(line), std::string::npos) << line;
    }
}
