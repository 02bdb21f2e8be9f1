// What is cut by hand: its parts are rocks, and everything else is as before.
#include "core/rocks/attributes/study.h"
#include "core/rocks/selection/preset.h"
#include "core/rocks/selection/strokes.h"
#include "tests/support/rock_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace edgescan::rocks {
namespace {

constexpr int kSceneLines = 300, kSceneBeams = 343;

const Inputs& cutInputs() {
    static const Inputs inputs = rockInputs(
        *edges::detectEdges(test::rockScene("hangup", 815, kSceneLines, kSceneBeams).scan, edges::Settings{}, edges::KeepFor::Rocks));
    return inputs;
}
const Study& whole() {
    static const Study study = studyRocks(cutInputs(), {});
    return study;
}

/// Cells of a straight line through the middle of the rock, 3 cells past its outline at both ends.
CutLine lineThrough(const Grid<std::uint32_t>& labels, std::uint32_t label, double angle) {
    double line = 0, beam = 0, cells = 0;
    for (int i = 0; i < labels.lines; ++i) {
        for (int j = 0; j < labels.beams; ++j) {
            if (labels.at(i, j) != label) continue;
            line += i;
            beam += j;
            ++cells;
        }
    }
    line /= cells;
    beam /= cells;
    const auto end = [&](double sign) {
        double last = 0;
        for (double way = 0; way < 200; ++way) {
            const int i = static_cast<int>(std::lround(line + sign * way * std::sin(angle)));
            const int j = static_cast<int>(std::lround(beam + sign * way * std::cos(angle)));
            if (labels.contains(i, j) && labels.at(i, j) == label) last = way;
        }
        const double way = sign * (last + 3);
        return static_cast<std::uint32_t>(
            labels.index(std::clamp(static_cast<int>(std::lround(line + way * std::sin(angle))), 0, labels.lines - 1),
                         std::clamp(static_cast<int>(std::lround(beam + way * std::cos(angle))), 0, labels.beams - 1)));
    };
    return {end(-1), end(1)};
}

/// Each rock before is a whole rock after, or several whole rocks. Returns which are several.
std::map<std::uint32_t, std::set<std::uint32_t>> dividedRocks(const Grid<std::uint32_t>& before, const Grid<std::uint32_t>& after) {
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> parts;
    std::map<std::uint32_t, std::set<std::uint32_t>> sources, several;
    for (std::size_t k = 0; k < before.size(); ++k) {
        ++parts[before[k]][after[k]];
        if (after[k] != 0) sources[after[k]].insert(before[k]);
    }
    for (const auto& [rock, from] : sources) EXPECT_EQ(from.size(), 1U) << "rock " << rock << " has cells of several";
    for (auto& [rock, to] : parts) {
        if (to.size() == 1) continue;
        EXPECT_NE(rock, 0U) << "what was not a rock is one";
        EXPECT_FALSE(to.contains(0)) << "a part of rock " << rock << " is not a rock";
        for (const auto& [part, cells] : to) several[rock].insert(part);
    }
    return several;
}

TEST(RockCuts, ALineDividesARockIntoRocksAndChangesNothingElse) {
    const Grid<std::uint32_t> labels = rockLabels(*whole().segmentation, whole().map);
    int cuts = 0, rocksCut = 0;
    for (std::uint32_t label = 1; label <= whole().map.rocks; label += 2) { // some lines cross several
        const double angle = 0.7 * label;
        const std::vector<Edit> edits = cutAlong(*whole().segmentation, whole().map, lineThrough(labels, label, angle));
        if (edits.empty()) continue; // a part would be too small
        const Study after = studyRocks(cutInputs(), {}, edits, &whole());
        SCOPED_TRACE("rock " + std::to_string(label));
        const auto divided = dividedRocks(labels, rockLabels(*after.segmentation, after.map));
        rocksCut += divided.contains(label) ? 1 : 0;
        for (const auto& [rock, parts] : divided) {
            for (const std::uint32_t part : parts) {
                ASSERT_NE(part, 0U);
                EXPECT_GE(after.rocks[part - 1].cells, 25U);
                EXPECT_TRUE(after.rocks[part - 1].apart.empty()) << "one piece";
            }
        }
        // Undone, all is as before.
        if (++cuts % 8 == 1) {
            const Study undone = studyRocks(cutInputs(), {}, {}, &after);
            EXPECT_EQ(rockLabels(*undone.segmentation, undone.map), labels);
        }
    }
    EXPECT_GT(cuts, 12);
    EXPECT_EQ(rocksCut, cuts);
}

TEST(RockCuts, PartsAreCutAgainAndStoredEditsGiveTheSameLabels) {
    Study study = whole();
    for (const double angle : {0.3, 1.9, 1.0}) {
        const Grid<std::uint32_t> labels = rockLabels(*study.segmentation, study.map);
        const std::vector<Edit> cut = cutAlong(*study.segmentation, study.map, lineThrough(labels, 1, angle));
        ASSERT_FALSE(cut.empty());
        std::vector<Edit> edits = study.edits;
        edits.insert(edits.end(), cut.begin(), cut.end());
        const Study after = studyRocks(cutInputs(), {}, edits, &study);
        EXPECT_TRUE(dividedRocks(labels, rockLabels(*after.segmentation, after.map)).contains(1));
        study = after;
    }
    const auto read = rockPresetFromText(rockPresetText({std::nullopt, study.edits, ""}, kSceneLines, kSceneBeams), kSceneLines,
                                         kSceneBeams, "", "edits");
    ASSERT_TRUE(read);
    const Study again = studyRocks(cutInputs(), {}, read->edits);
    EXPECT_EQ(rockLabels(*again.segmentation, again.map), rockLabels(*study.segmentation, study.map));
}

// A line over two rocks divides the chosen one, or the one that has most of it; both can be divided by it.
TEST(RockCuts, OneRockIsCut) {
    const Grid<std::uint32_t> labels = rockLabels(*whole().segmentation, whole().map);
    int lines = 0;
    for (std::uint32_t label = 1; label <= whole().map.rocks && lines < 3; ++label) {
        CutLine line = lineThrough(labels, label, 0.4 * label);
        for (std::uint32_t other = 1; other <= whole().map.rocks && lines < 3; ++other) {
            if (other == label) continue;
            CutLine both = line;
            const CutLine second = lineThrough(labels, other, 1.1 * other);
            both.insert(both.end(), second.begin(), second.end());
            const auto cutBy = [&](std::optional<std::uint32_t> chosen) {
                const Study after = studyRocks(cutInputs(), {}, cutAlong(*whole().segmentation, whole().map, both, chosen), &whole());
                return dividedRocks(labels, rockLabels(*after.segmentation, after.map));
            };
            const auto ofLabel = cutBy(whole().rocks[label - 1].cell), ofOther = cutBy(whole().rocks[other - 1].cell);
            if (!ofLabel.contains(label) || !ofOther.contains(other)) continue;
            EXPECT_EQ(ofLabel.size() + ofOther.size(), 2U);
            const std::vector<std::uint32_t> drawn = strokeCells(both, labels.lines, labels.beams);
            const auto cellsIn = [&](std::uint32_t rock) {
                return std::ranges::count_if(drawn, [&](auto k) { return labels[k] == rock; });
            };
            const auto unchosen = cutBy(std::nullopt);
            EXPECT_EQ(unchosen.size(), 1U);
            if (cellsIn(label) == cellsIn(other)) continue;
            EXPECT_TRUE(unchosen.contains(cellsIn(label) > cellsIn(other) ? label : other));
            ++lines;
        }
    }
    EXPECT_EQ(lines, 3);
}

TEST(RockCuts, ALineThatEndsInTheRockOrIsOutsideDividesNothing) {
    const Rock& rock = whole().rocks.front();
    EXPECT_TRUE(cutAlong(*whole().segmentation, whole().map, {rock.cell, rock.cell + 3}).empty());
    EXPECT_TRUE(cutAlong(*whole().segmentation, whole().map, {}).empty());
}

} // namespace
} // namespace edgescan::rocks
