// Rows and columns of a grid, with these names or without names: whichever of them counts the lines, the same cells result.
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/placement.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <random>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct CellPoint {
    int line = 0, beam = 0;
    Eigen::Vector3d point;
};

/// The valid cells, some left out, optionally shuffled.
std::vector<CellPoint> cellsOf(const Scan& scan, double leftOut, bool shuffled) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    const CartesianTables tables(scan);
    std::vector<CellPoint> cells;
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            const bool corner = (i == 0 && j == 0) || (i == scan.lines() - 1 && j == scan.beams() - 1); // these preserve the shape
            if (scan.state.at(i, j) == CellState::Valid && (corner || unit(random) >= leftOut)) cells.push_back({i, j, tables.point(i, j)});
        }
    }
    if (shuffled) std::shuffle(cells.begin(), cells.end(), random);
    return cells;
}

std::string pointText(const Eigen::Vector3d& p, const std::string& separator) {
    return numberText("%.6f", p.x()) + separator + numberText("%.6f", p.y()) + separator + numberText("%.6f", p.z());
}

std::size_t validIn(const Scan& scan) { return countCells(scan)[static_cast<std::size_t>(CellState::Valid)]; }

class RowAndColumn : public testing::Test {
protected:
    Result<Scan> opened(const std::string& text) {
        writeText(folder_ / "list.csv", text);
        return openScan(folder_ / "list.csv");
    }
    static bool tells(const Scan& scan, const std::string& words) {
        return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(words) != w.npos; });
    }

    const Folder folder_;
    const Scan expected_ = makeScan({.noReturns = 0});
};

TEST_F(RowAndColumn, WithoutNamesTheyAreTheGridEitherWay) {
    for (const bool linesFirst : {true, false}) {
        for (const bool shuffled : {false, true}) {
            for (const int from : {0, 1, 1500}) {
                std::string text;
                for (const CellPoint& cell : cellsOf(expected_, 0.1, shuffled)) {
                    const int first = from + (linesFirst ? cell.line : cell.beam);
                    const int second = from + (linesFirst ? cell.beam : cell.line);
                    text += std::to_string(first) + " " + std::to_string(second) + " " + pointText(cell.point, " ") + " 900\n";
                }
                SCOPED_TRACE(text.substr(0, 40));
                const auto scan = opened(text);
                ASSERT_TRUE(scan) << scan.error().sentence();
                EXPECT_TRUE(tells(*scan, "the first two were taken for row and column"));
                EXPECT_EQ(scan->lines(), expected_.lines());
                EXPECT_EQ(scan->beams(), expected_.beams());
                EXPECT_EQ(scan->pointsLeftOut, 0U);
                EXPECT_TRUE(std::holds_alternative<PolarGeometry>(scan->geometry));
                EXPECT_FALSE(tells(*scan, "recovered from the angles"));
            }
        }
    }
}

TEST_F(RowAndColumn, CalledSoTheyAreTheGridEitherWay) {
    for (const bool linesFirst : {true, false}) {
        std::string text = "Row,Column,X,Y,Z\n";
        for (const CellPoint& cell : cellsOf(expected_, 0.1, true)) {
            text += std::to_string(linesFirst ? cell.line : cell.beam) + "," + std::to_string(linesFirst ? cell.beam : cell.line) + "," +
                    pointText(cell.point, ",") + "\n";
        }
        const auto scan = opened(text);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->lines(), expected_.lines());
        EXPECT_EQ(scan->beams(), expected_.beams());
        EXPECT_TRUE(std::holds_alternative<PolarGeometry>(scan->geometry));
        EXPECT_EQ(tells(*scan, "Lines and beams were exchanged"), !linesFirst);
    }
}

TEST_F(RowAndColumn, LinesAndBeamsAreNeverExchanged) {
    std::string text = "beam,line,x,y,z\n"; // in the opposite order on purpose
    for (const CellPoint& cell : cellsOf(expected_, 0, false))
        text += std::to_string(cell.line) + "," + std::to_string(cell.beam) + "," + pointText(cell.point, ",") + "\n";
    const auto scan = opened(text);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), expected_.beams());
}

TEST_F(RowAndColumn, NumbersClassesAndColoursAreNoCells) {
    std::mt19937 random(5);
    for (const char* kind : {"number and class", "class and return", "colours", "all the same"}) {
        std::string text;
        int n = 0;
        for (const CellPoint& cell : cellsOf(expected_, 0, false)) {
            ++n;
            const std::string what = kind;
            const int first = what == "number and class"   ? n + 4
                              : what == "class and return" ? n % 5
                              : what == "colours"          ? static_cast<int>(random() % 256)
                                                           : 7;
            const int second = what == "number and class"   ? n % 3
                               : what == "class and return" ? 1
                               : what == "colours"          ? static_cast<int>(random() % 256)
                                                            : 7;
            text += std::to_string(first) + " " + std::to_string(second) + " " + pointText(cell.point, " ") + "\n";
        }
        SCOPED_TRACE(kind);
        const auto scan = opened(text);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_TRUE(tells(*scan, "as the first two hold whole numbers only"));
        EXPECT_EQ(scan->lines(), expected_.lines());
        EXPECT_EQ(validIn(*scan), expected_.cells());
    }
}

// The row's number counts from 1, like an index, and is removed first: a class and the point remain.
TEST_F(RowAndColumn, BehindAnIndexTheWholeNumbersAreCountedAgain) {
    for (const int wholes : {1, 3, 4}) {
        std::string text;
        int n = 0;
        for (const CellPoint& cell : cellsOf(expected_, 0, false)) {
            text += std::to_string(++n);
            for (int i = 0; i < wholes; ++i) text += " " + std::to_string(n * (i + 3) % 7);
            text += " " + pointText(cell.point, " ") + "\n";
        }
        SCOPED_TRACE(wholes);
        const auto scan = opened(text);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->lines(), expected_.lines());
        EXPECT_EQ(validIn(*scan), expected_.cells());
    }
}

TEST_F(RowAndColumn, CoordinatesOfAMineNeedTheScannersPlaceUnlessTheirLinesShowIt) {
    const Eigen::Vector3d place(402000, 7401000, -800);
    std::mt19937 random(11);
    std::normal_distribution<double> bend(0.0, 0.3);
    for (const char* heading : {"line,beam,x,y,z\n", ""}) {
        const std::string separator = *heading == '\0' ? " " : ",";
        std::string text = heading, bent = heading;
        for (const CellPoint& cell : cellsOf(expected_, 0, false)) {
            const std::string names = std::to_string(cell.line) + separator + std::to_string(cell.beam) + separator;
            const Eigen::Vector3d off(bend(random), bend(random), bend(random));
            text += names + pointText(cell.point + place, separator) + "\n";
            bent += names + pointText(cell.point + place + off, separator) + "\n";
        }
        const auto scan = opened(bent);
        ASSERT_FALSE(scan);
        EXPECT_NE(scan.error().sentence().find("in one direction from"), std::string::npos) << scan.error().sentence();
        EXPECT_NE(scan.error().sentence().find("--sensor"), std::string::npos);
        const auto shown = opened(text);
        ASSERT_TRUE(shown) << shown.error().sentence();
        ASSERT_TRUE(shown->placement);
        EXPECT_LT((shown->placement->originEnhM + shown->placement->poses.front().translationM - place).norm(), 0.005);
        ReadingOptions options;
        options.sensorM = place;
        const auto placed = openScan(folder_ / "list.csv", options);
        ASSERT_TRUE(placed) << placed.error().sentence();
        for (const Scan& read : {*shown, *placed}) {
            EXPECT_EQ(read.lines(), expected_.lines());
            EXPECT_EQ(read.beams(), expected_.beams());
            EXPECT_EQ(validIn(read), expected_.cells());
        }
    }
}

} // namespace
