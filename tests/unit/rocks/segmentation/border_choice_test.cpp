// The network of borders: it moves cells to the rock that they belong to, and the same ones however the work is divided.
#include "core/rocks/segmentation/border_choice.h"

#include "tests/support/rock_scene.h"

#include <gtest/gtest.h>

#include <map>

namespace edgescan::rocks {
namespace {

struct Fitted {
    test::RockScene scene;
    Inputs inputs;
    FittedSegments fitted;
    std::vector<std::uint32_t> groups;
};

Fitted fittedScene(const std::string& name, std::uint64_t seed) {
    Fitted f;
    f.scene = test::rockScene(name, seed, 300, 343);
    f.inputs = rockInputs(*edges::detectEdges(f.scene.scan, edges::Settings{}, edges::KeepFor::Rocks));
    f.fitted = fittedSegments(f.inputs);
    f.groups = settledGroups(f.fitted.borders, f.fitted.count);
    return f;
}

// Cells that are not on the object of most cells of their segment.
std::size_t wrongCells(const Grid<std::uint32_t>& segment, const Grid<std::uint16_t>& object) {
    std::map<std::uint32_t, std::map<std::uint16_t, std::size_t>> cells;
    for (std::size_t k = 0; k < segment.size(); ++k) {
        if (segment[k] != kNoSegment) ++cells[segment[k]][object[k]];
    }
    std::size_t wrong = 0;
    for (const auto& [number, objects] : cells) {
        std::size_t all = 0, most = 0;
        for (const auto& [of, count] : objects) {
            all += count;
            most = std::max(most, count);
        }
        wrong += all - most;
    }
    return wrong;
}

TEST(BorderChoice, LeavesFewerCellsOnTheWrongRock) {
    for (const auto& [name, seed] : {std::pair{"hangup", 61U}, {"pile", 62U}}) {
        const Fitted f = fittedScene(name, seed);
        Grid<std::uint32_t> segment = f.fitted.segment;
        chooseBorders(f.inputs, f.groups, learnedBorders(), kBorderPasses, segment);
        const std::size_t before = wrongCells(f.fitted.segment, f.scene.truth.object);
        const std::size_t after = wrongCells(segment, f.scene.truth.object);
        EXPECT_LT(static_cast<double>(after), 0.92 * static_cast<double>(before)) << name;
    }
}

TEST(BorderChoice, IsTheSameForAnyNumberOfThreads) {
    const Fitted f = fittedScene("pile", 63);
    Grid<std::uint32_t> one = f.fitted.segment;
    chooseBorders(f.inputs, f.groups, learnedBorders(), kBorderPasses, one, 1);
    EXPECT_NE(one, f.fitted.segment);
    for (const int threads : {2, 5}) {
        Grid<std::uint32_t> several = f.fitted.segment;
        chooseBorders(f.inputs, f.groups, learnedBorders(), kBorderPasses, several, threads);
        EXPECT_EQ(several, one) << threads;
    }
    Grid<std::uint32_t> watched = f.fitted.segment;
    std::size_t questions = 0;
    chooseBorders(f.inputs, f.groups, learnedBorders(), kBorderPasses, watched, 2, [&](const BorderQuestion& question) {
        ++questions;
        EXPECT_NE(f.groups[question.own], f.groups[question.other]);
    });
    EXPECT_EQ(watched, one);
    EXPECT_GT(questions, 1000U);
}

TEST(BorderChoice, WithoutWeightsNothingMoves) {
    const Fitted f = fittedScene("pile", 63);
    Grid<std::uint32_t> segment = f.fitted.segment;
    chooseBorders(f.inputs, f.groups, BorderNetwork{}, kBorderPasses, segment);
    EXPECT_EQ(segment, f.fitted.segment);
}

// Cells without a segment stay without, and no segment takes a void.
TEST(BorderChoice, OnlyCellsOfSegmentsMove) {
    const Fitted f = fittedScene("hangup", 64);
    Grid<std::uint32_t> segment = f.fitted.segment;
    chooseBorders(f.inputs, f.groups, learnedBorders(), kBorderPasses, segment);
    for (std::size_t k = 0; k < segment.size(); ++k) ASSERT_EQ(segment[k] == kNoSegment, f.fitted.segment[k] == kNoSegment) << k;
}

} // namespace
} // namespace edgescan::rocks
