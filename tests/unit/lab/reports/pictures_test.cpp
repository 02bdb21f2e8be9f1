// Sheets of pictures: every marked cell is drawn at its place, in its colour and shape.
#include "app/lab/reports/comparison_pictures.h"
#include "tests/support/scans.h"
#include "tests/support/scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace edgescan::lab {
namespace {

constexpr Rgb kRed{250, 0, 0};
constexpr Rgb kBlue{0, 0, 250};
constexpr Rgb kGreen{0, 250, 0};

exports::SheetLook look(int tilePixels) {
    return {1,
            tilePixels,
            "sheet",
            {{"square", kRed, exports::MarkShape::Square},
             {"ring", kBlue, exports::MarkShape::Ring},
             {"cross", kGreen, exports::MarkShape::Cross}}};
}

// One tile with these marks; returns the pixels of the tile alone, which ends one gap above the bottom and before the right side.
Grid<Rgb> tileOf(const Grid<std::uint8_t>& marks, int tilePixels) {
    const Grid<Rgb> sheet =
        exports::contactSheet({{Grid<std::uint8_t>(marks.lines, marks.beams, 120), marks, "tile", ""}}, look(tilePixels));
    const int lines = marks.lines * tilePixels / marks.beams;
    Grid<Rgb> tile(lines, tilePixels);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < tilePixels; ++j) tile.at(i, j) = sheet.at(sheet.lines - 10 - lines + i, 10 + j);
    }
    return tile;
}

TEST(ContactSheet, MarksHaveTheirShapesInTheirCells) {
    Grid<std::uint8_t> marks(8, 10);
    marks.at(1, 2) = 1;
    marks.at(4, 5) = 2;
    marks.at(6, 8) = 3;
    const Grid<Rgb> tile = tileOf(marks, 50);
    const Rgb paper = tile.at(0, 0);
    for (int i = 0; i < tile.lines; ++i) {
        for (int j = 0; j < tile.beams; ++j) {
            const int inLine = i % 5;
            const int inBeam = j % 5;
            const bool rim = inLine == 0 || inLine == 4 || inBeam == 0 || inBeam == 4;
            const bool diagonal = inLine == inBeam || inLine + inBeam == 4;
            Rgb expected = paper;
            switch (marks.at(i / 5, j / 5)) {
            case 1:
                expected = kRed;
                break;
            case 2:
                expected = rim ? kBlue : paper;
                break;
            case 3:
                expected = diagonal ? kGreen : paper;
                break;
            default:
                break;
            }
            EXPECT_EQ(tile.at(i, j), expected) << i << ' ' << j;
        }
    }
}

TEST(ContactSheet, NoMarkIsLostWhereATileHasFewerPixelsThanCells) {
    Grid<std::uint8_t> marks(90, 100);
    marks.at(44, 70) = 1;
    marks.at(44, 71) = 3; // a later kind covers an earlier one
    marks.at(10, 20) = 2;
    const Grid<Rgb> tile = tileOf(marks, 40);
    EXPECT_EQ(tile.at(44 * 36 / 90, 70 * 40 / 100), kGreen);
    EXPECT_EQ(tile.at(10 * 36 / 90, 20 * 40 / 100), kBlue);
    EXPECT_EQ(std::ranges::count(tile.cells, kRed), 0);
}

TEST(ContactSheet, ASweepOfFewBeamsMakesNoTower) {
    for (const int lines : {200, 30000}) {
        const Grid<std::uint8_t> picture(lines, 1, 120);
        const Grid<Rgb> sheet = exports::contactSheet({{picture, {}, "a", ""}, {picture, {}, "b", ""}}, look(1100));
        EXPECT_LT(sheet.size(), std::size_t{1200} * 9200) << lines;
        EXPECT_GT(std::count_if(sheet.cells.begin(), sheet.cells.end(),
                                [](const Rgb& pixel) {
                                    return pixel == Rgb{120, 120, 120};
                                }),
                  4000);
    }
}

TEST(ContactSheet, NothingMakesNoSheet) {
    EXPECT_EQ(exports::contactSheet({}, {}).size(), 0U);
    EXPECT_EQ(exports::contactSheet({{}}, {}).size(), 0U);
}

sim::EdgeTruth randomTruth(std::mt19937& random, bool withIgnored) {
    sim::EdgeTruth truth{Grid<std::uint8_t>(40, 50), Grid<std::uint8_t>(40, 50)};
    for (int line = 3; line < 40; line += 6) {
        for (int j = 0; j < 50; ++j) truth.edgeClass.at(line, j) = static_cast<std::uint8_t>(random() % 5);
    }
    if (withIgnored) {
        for (int k = 0; k < 500; ++k) truth.ignore[random() % truth.ignore.size()] = 255;
    }
    return truth;
}

TEST(TruthMarks, AreAsManyAsTheScoreCounts) {
    std::mt19937 random(5);
    for (int round = 0; round < 8; ++round) {
        const sim::EdgeTruth truth = randomTruth(random, round % 2 == 1);
        Grid<std::uint8_t> mask(40, 50);
        for (int k = 0; k < 300; ++k) mask[random() % mask.size()] = 255;
        const EdgeCounts all = test::scoreEdges(mask, truth, 1.0).all;
        const Grid<std::uint8_t> marks = truthMarks(mask, truth, 1.0);
        EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(marks.cells, kMarkFound)), all.found);
        EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(marks.cells, kMarkFalse)), all.false_);
        // A true cell that was missed can lie under a detection of its neighbour.
        EXPECT_LE(static_cast<std::size_t>(std::ranges::count(marks.cells, kMarkMissed)), all.truth - all.found);
    }
}

TEST(TruthMarks, SayWhereSomethingWasFoundMissedOrInvented) {
    sim::EdgeTruth truth{Grid<std::uint8_t>(9, 9), Grid<std::uint8_t>(9, 9)};
    Grid<std::uint8_t> mask(9, 9);
    truth.edgeClass.at(2, 2) = 1;
    mask.at(2, 3) = 255;
    truth.edgeClass.at(6, 2) = 3;
    mask.at(6, 7) = 255;
    truth.edgeClass.at(8, 8) = 1; // not scored
    truth.ignore.at(8, 8) = 255;
    Grid<std::uint8_t> expected(9, 9);
    expected.at(2, 3) = kMarkFound;
    expected.at(6, 2) = kMarkMissed;
    expected.at(6, 7) = kMarkFalse;
    EXPECT_EQ(truthMarks(mask, truth, 1.5), expected);
}

TEST(TruthSheet, DrawsTheThesisAtItsBestThresholdAndEdgeScanPlusAsItIsSet) {
    const Scan scan = test::boxesScan(30, 40, 3);
    sim::EdgeTruth truth{Grid<std::uint8_t>(30, 40), Grid<std::uint8_t>(30, 40)};
    for (int j = 0; j < 40; ++j) truth.edgeClass.at(15, j) = 1;
    Grid<std::uint8_t> whole(30, 40);
    for (int j = 0; j < 40; ++j) whole.at(15, j) = 255;
    const Grid<std::uint8_t> nothing(30, 40);
    const auto method = [&](edges::Method m, const Grid<std::uint8_t>& set, const Grid<std::uint8_t>& best) {
        ComparedMethod one;
        one.name = "one";
        one.settings = edges::Settings{};
        one.settings->method = m;
        one.mask = set;
        one.score = Evaluation{};
        one.best = BestThreshold{"lower", 3.0, {}, best};
        return one;
    };
    const auto missed = [&](const ComparedMethod& one) {
        const Grid<Rgb> sheet = truthSheet(scan, {one}, truth, 2.0);
        // A row of the tile through the true line: rings where it was missed, filled squares where it was found.
        const int cell = (sheet.beams - 20) / 40;
        const int line = sheet.lines - 10 - 30 * cell + 15 * cell + cell / 2;
        return sheet.at(line, 10 + 20 * cell + cell / 2) == sheet.at(line + 2 * cell, 10 + 20 * cell + cell / 2);
    };
    EXPECT_FALSE(missed(method(edges::Method::Canny, nothing, whole)));
    EXPECT_TRUE(missed(method(edges::Method::Canny, whole, nothing)));
    EXPECT_TRUE(missed(method(edges::Method::EdgeScanPlus, nothing, whole)));
    EXPECT_FALSE(missed(method(edges::Method::EdgeScanPlus, whole, nothing)));
    EXPECT_EQ(truthSheet(scan, {ComparedMethod{}}, truth, 2.0).size(), 0U); // without a score
}

} // namespace
} // namespace edgescan::lab
