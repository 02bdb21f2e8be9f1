// The verdict on a change.
#include "app/lab/families/protocol.h"

#include <gtest/gtest.h>

namespace edgescan::lab {
namespace {

// A scene with this F in thousandths, of all edges and of outlines.
SceneScore sceneWithF(std::size_t all, std::size_t outline) {
    SceneScore score;
    score.edges.emplace();
    score.edges->all = {1000, all, 1000 - all};
    score.edges->outline = {1000, outline, 1000 - outline};
    return score;
}

SceneScore sceneWithCells(std::size_t jumps, CellsByClass SceneScore::*cells = &SceneScore::cells) {
    SceneScore score;
    (score.*cells)[1] = jumps;
    return score;
}

PairedFamily familyWithF(const std::string& name, const std::vector<std::size_t>& before, const std::vector<std::size_t>& after) {
    PairedFamily family{name, Measure::Edges, {}, {}};
    for (const std::size_t f : before) family.before.push_back(sceneWithF(f, 900));
    for (const std::size_t f : after) family.after.push_back(sceneWithF(f, 900));
    return family;
}

TEST(Protocol, TheWorstTenthIsTheMeanOfTheLowest) {
    struct Row {
        std::vector<double> values;
        double worst;
    };
    const std::vector<Row> rows{
        {{}, 0.0}, {{0.5}, 0.5}, {{0.9, 0.7, 0.8}, 0.7}, {{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 1}, {{11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1}, 1.5}};
    for (const Row& row : rows) EXPECT_DOUBLE_EQ(worstTenth(row.values), row.worst) << row.values.size();
}

TEST(Protocol, Verdicts) {
    const std::vector<std::size_t> base{900, 900, 900, 900};
    struct Row {
        const char* what;
        std::vector<std::size_t> first, second; // F of two families after the change
        bool passes;
    };
    const std::vector<Row> rows{{"nothing changes", base, base, true},
                                {"both rise", {910, 910, 910, 910}, {901, 900, 900, 900}, true},
                                {"the mean over families falls", {899, 900, 900, 900}, base, false},
                                {"a family falls by .005", {920, 920, 920, 920}, {895, 895, 895, 895}, true},
                                {"a family falls by more", {920, 920, 920, 920}, {894, 895, 895, 895}, false},
                                {"a worst tenth falls by .01", {920, 920, 920, 920}, {890, 905, 905, 905}, true},
                                {"a worst tenth falls by more", {920, 920, 920, 920}, {889, 905, 905, 905}, false}};
    for (const Row& row : rows) {
        const Verdict verdict = judged({familyWithF("a", base, row.first), familyWithF("b", base, row.second)}, {});
        EXPECT_EQ(verdict.passes, row.passes) << row.what;
    }
}

TEST(Protocol, OutlinesAreJudgedToo) {
    PairedFamily family{"a", Measure::Edges, {sceneWithF(900, 900)}, {sceneWithF(950, 880)}};
    EXPECT_FALSE(judged({family}, {}).passes);
    family.after = {sceneWithF(950, 900)};
    EXPECT_TRUE(judged({family}, {}).passes);
    family.before[0].edges->strictOutline = {1000, 900, 100}; // is reported only
    EXPECT_TRUE(judged({family}, {}).passes);
}

TEST(Protocol, CountsMayChangeByATenthUnlessNamed) {
    struct Row {
        Measure measure;
        std::size_t before, after;
        bool passes;
    };
    const std::vector<Row> rows{{Measure::Counts, 1000, 1100, true},      {Measure::Counts, 1000, 1101, false},
                                {Measure::Counts, 1000, 899, false},      {Measure::Counts, 0, 1, true},
                                {Measure::Counts, 0, 2, false},           {Measure::FalseCells, 1000, 500, true},
                                {Measure::FalseCells, 1000, 1101, false}, {Measure::FalseCells, 0, 2, false}};
    for (const Row& row : rows) {
        const auto cells = row.measure == Measure::Counts ? &SceneScore::cells : &SceneScore::away;
        const PairedFamily family{"walls", row.measure, {sceneWithCells(row.before, cells)}, {sceneWithCells(row.after, cells)}};
        EXPECT_EQ(judged({family}, {}).passes, row.passes) << row.before << " to " << row.after;
        EXPECT_TRUE(judged({family}, {"walls"}).passes);
    }
}

TEST(Protocol, TheIntervalIsOfPairsAndTheSameEachTime) {
    const std::vector<PairedFamily> families{familyWithF("a", {900, 800, 700}, {910, 810, 710}), familyWithF("b", {500, 600}, {520, 610})};
    const GroupChange change = groupChange(families, kScoreGroups[0]);
    EXPECT_NEAR(change.after - change.before, 0.0125, 1e-9);
    EXPECT_NEAR(change.low, 0.01, 1e-9); // scenes differ by far more than pairs
    EXPECT_NEAR(change.high, 0.015, 1e-9);
    EXPECT_EQ(groupChange(families, kScoreGroups[0]).low, change.low);
}

} // namespace
} // namespace edgescan::lab
