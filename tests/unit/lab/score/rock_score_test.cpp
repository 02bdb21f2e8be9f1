// Regions compared with true rocks: by hand-made examples, and by a slow second implementation of the rules (docs/method/edges.md, "Truth
// and score").
#include "app/lab/score/rock_evaluation.h"
#include "app/lab/sim/truth/truth_files.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <random>

namespace edgescan::lab {
namespace {

using Labels = Grid<std::uint32_t>;

/// Fills lines [l0, l1) x beams [b0, b1).
void fill(Labels& grid, int l0, int l1, int b0, int b1, std::uint32_t label) {
    for (int i = l0; i < l1; ++i)
        for (int j = b0; j < b1; ++j) grid.at(i, j) = label;
}

Grid<std::uint8_t> allCells(const Labels& like) { return {like.lines, like.beams, std::uint8_t{1}}; }

RockMatch matched(const Labels& rock, const Labels& region, RockRules rules = {}, const std::vector<std::uint8_t>& isRock = {}) {
    return matchRocks(overlapsOf(allCells(rock), rock, region), isRock, rules);
}

TEST(RockScore, ThePerfectAnswerIsPerfect) {
    Labels rock(40, 60);
    fill(rock, 5, 15, 5, 15, 1);
    fill(rock, 15, 35, 5, 25, 2);
    for (const bool strict : {false, true}) {
        const RockMatch match = matched(rock, rock, {100, strict});
        EXPECT_EQ(match.counts.found, 2U);
        EXPECT_EQ(match.counts.missed + match.counts.falseRegions, 0U);
        EXPECT_DOUBLE_EQ(match.counts.pq(), 1.0);
        EXPECT_DOUBLE_EQ(match.counts.f1(), 1.0);
    }
    const auto classes = byCells(matched(rock, rock));
    EXPECT_EQ(classes[0].rocks, 1U);
    EXPECT_EQ(classes[2].rocks, 1U);
    EXPECT_EQ(classes[2].found, 1U);
}

TEST(RockScore, HalfIsNotEnoughAndMoreThanHalfIs) {
    Labels rock(20, 40);
    fill(rock, 0, 10, 0, 20, 1); // 200 cells
    Labels region = rock;
    fill(region, 0, 5, 0, 20, 0); // 100 of them: IoU 0.5
    EXPECT_EQ(matched(rock, region).counts.found, 0U);
    region.at(4, 0) = 1;
    const RockMatch match = matched(rock, region);
    EXPECT_EQ(match.counts.found, 1U);
    EXPECT_DOUBLE_EQ(match.counts.iou, 101.0 / 200.0);
    EXPECT_DOUBLE_EQ(match.counts.pq(), 101.0 / 200.0);
}

TEST(RockScore, MissesAreDistinguished) {
    Labels rock(60, 100);
    fill(rock, 0, 10, 0, 20, 1); // merged with 2
    fill(rock, 0, 10, 20, 45, 2);
    fill(rock, 20, 30, 0, 20, 3);  // part of a large region of wall
    fill(rock, 20, 40, 60, 80, 4); // split into four
    fill(rock, 45, 55, 0, 20, 5);  // no region there
    Labels region(60, 100);
    fill(region, 0, 10, 0, 45, 1);
    fill(region, 18, 40, 0, 50, 2);
    fill(region, 20, 25, 60, 80, 3);
    fill(region, 25, 30, 60, 80, 4);
    fill(region, 30, 35, 60, 80, 5);
    fill(region, 35, 40, 60, 80, 6);
    const RockMatch match = matched(rock, region, {100, false});
    const auto miss = [&](std::size_t n) { return match.rocks.at(n).miss; };
    EXPECT_FALSE(match.rocks[0].found);
    EXPECT_EQ(miss(0), RockMiss::Merged);
    EXPECT_TRUE(match.rocks[1].found); // 250 of 450 cells
    EXPECT_EQ(miss(2), RockMiss::Wall);
    EXPECT_EQ(miss(3), RockMiss::Split);
    EXPECT_EQ(miss(4), RockMiss::Other);
    // The wall's region is ignored in lenient mode; the four pieces are false.
    EXPECT_EQ(match.falseRegions, (std::vector<std::uint32_t>{3, 4, 5, 6}));
    EXPECT_EQ(matched(rock, region, {100, true}).falseRegions, (std::vector<std::uint32_t>{2, 3, 4, 5, 6}));
    const std::vector<std::uint8_t> isRock{0, 0, 0, 1, 1, 1, 1};
    const RockMatch called = matched(rock, region, {100, true}, isRock);
    EXPECT_EQ(called.falseRegions, (std::vector<std::uint32_t>{3, 4, 5, 6}));
    EXPECT_EQ(called.rocks[1].miss, RockMiss::Dropped);
    EXPECT_EQ(called.rocks[0].miss, RockMiss::Other);
    EXPECT_EQ(matched(rock, region, {100, false}, isRock).counts.found, 1U) << "leniently nobody asks what a region is called";
}

TEST(RockScore, SmallRocksAreNeitherMissedNorMakeARegionFalse) {
    Labels rock(60, 60);
    fill(rock, 0, 9, 0, 11, 1);   // 99 cells
    fill(rock, 20, 29, 0, 11, 2); // four rocks of 99 cells below one region
    fill(rock, 20, 29, 11, 22, 3);
    fill(rock, 29, 38, 0, 11, 4);
    fill(rock, 29, 38, 11, 22, 5);
    Labels region(60, 60);
    fill(region, 0, 10, 0, 11, 1);  // matches the small one
    fill(region, 20, 38, 0, 22, 2); // is on small ones
    fill(region, 50, 60, 0, 9, 3);  // 90 cells of background: too small to be false
    for (const bool strict : {false, true}) {
        const RockMatch match = matched(rock, region, {100, strict});
        EXPECT_TRUE(match.rocks.empty());
        EXPECT_TRUE(match.falseRegions.empty());
        EXPECT_DOUBLE_EQ(match.counts.pq(), 0.0);
    }
    EXPECT_EQ(matched(rock, region, {99, false}).counts.found, 1U);
}

TEST(RockScore, CellsThatDoNotCountAreNobodys) {
    Labels rock(20, 20);
    fill(rock, 0, 20, 0, 10, 1);
    Labels region = rock;
    fill(region, 0, 20, 10, 20, 1);
    Grid<std::uint8_t> counts(20, 20, std::uint8_t{1});
    for (int i = 0; i < 20; ++i)
        for (int j = 10; j < 20; ++j) counts.at(i, j) = 0;
    const RockMatch match = matchRocks(overlapsOf(counts, rock, region), {}, {});
    EXPECT_DOUBLE_EQ(match.counts.pq(), 1.0);
    EXPECT_EQ(match.rocks.at(0).cells, 200U);
}

/// The rules again, one pair at a time; every count is a loop over all cells.
struct Slow {
    const Grid<std::uint8_t>& counts;
    const Labels& rock;
    const Labels& region;
    const std::vector<std::uint8_t>& isRock;
    RockRules rules;
    std::uint32_t numbers = 0;

    template <class Holds>
    std::size_t cells(Holds holds) const {
        std::size_t n = 0;
        for (std::size_t k = 0; k < counts.size(); ++k) n += counts[k] != 0 && holds(k) ? 1 : 0;
        return n;
    }
    std::size_t rockCells(std::uint32_t r) const {
        return cells([&](std::size_t k) { return rock[k] == r; });
    }
    std::size_t regionCells(std::uint32_t g) const {
        return cells([&](std::size_t k) { return region[k] == g; });
    }
    std::size_t common(std::uint32_t r, std::uint32_t g) const {
        return cells([&](std::size_t k) { return rock[k] == r && region[k] == g; });
    }
    double iou(std::uint32_t r, std::uint32_t g) const {
        const std::size_t either = cells([&](std::size_t k) { return rock[k] == r || region[k] == g; });
        return either == 0 ? 0.0 : static_cast<double>(common(r, g)) / static_cast<double>(either);
    }
    bool isGone(std::uint32_t g) const { return rules.strict && isRock[g] == 0; }

    RockCounts all() const {
        RockCounts total;
        std::vector<std::uint8_t> isRight(numbers);
        for (std::uint32_t r = 1; r < numbers; ++r) {
            if (rockCells(r) < rules.leastCells) continue;
            bool found = false;
            for (std::uint32_t g = 1; g < numbers; ++g) {
                if (isGone(g) || !(iou(r, g) > 0.5)) continue;
                found = true;
                isRight[g] = 1;
                total.iou += iou(r, g);
            }
            ++(found ? total.found : total.missed);
            if (!found) ++total.missedBy[static_cast<std::size_t>(missOf(r))];
        }
        for (std::uint32_t g = 1; g < numbers; ++g) total.falseRegions += isRight[g] == 0 && isFalse(g) ? 1 : 0;
        return total;
    }

    RockMiss missOf(std::uint32_t r) const {
        for (std::uint32_t g = 1; g < numbers; ++g) {
            if (isGone(g) && iou(r, g) > 0.5) return RockMiss::Dropped;
        }
        std::size_t inside = 0;
        for (std::uint32_t g = 1; g < numbers; ++g) {
            if (isGone(g)) continue;
            const std::size_t both = common(r, g);
            if (2 * both >= rockCells(r) && both > 0) return 2 * common(0, g) > regionCells(g) - both ? RockMiss::Wall : RockMiss::Merged;
            if (2 * both >= regionCells(g)) inside += both;
        }
        return 2 * inside >= rockCells(r) ? RockMiss::Split : RockMiss::Other;
    }

    bool isFalse(std::uint32_t g) const {
        const std::size_t size = regionCells(g);
        if (size < rules.leastCells || isGone(g)) return false;
        std::size_t onSmall = 0;
        for (std::uint32_t r = 1; r < numbers; ++r) {
            if (rockCells(r) >= rules.leastCells) continue;
            onSmall += common(r, g);
            if (iou(r, g) > 0.5) return false;
        }
        return 2 * onSmall < size && (rules.strict || 2 * common(0, g) < size);
    }
};

TEST(RockScore, AgreesWithASlowSecondReadingOfTheRules) {
    std::mt19937 dice(13);
    const auto upTo = [&](int most) { return static_cast<int>(dice() % static_cast<unsigned>(most + 1)); };
    std::array<std::size_t, kMisses> seen{};
    std::size_t falseSeen = 0;
    for (int round = 0; round < 150; ++round) {
        Labels rock(24, 24);
        Labels region(24, 24);
        constexpr std::uint32_t kNumbers = 9;
        for (std::uint32_t n = 1; n < kNumbers; ++n) {
            const int l = upTo(20);
            const int b = upTo(20);
            const int height = 3 + upTo(9);
            const int width = 3 + upTo(9);
            const auto shifted = [&](int at, int by) { return std::clamp(at + by, 0, 24); };
            fill(rock, l, shifted(l, height), b, shifted(b, width), n);
            const int slip = upTo(3);
            if (upTo(3) == 0) fill(region, shifted(l, -8), shifted(l, height + 8), shifted(b, -8), shifted(b, width + 8), 1 + n % 3);
            fill(region, shifted(l, slip), shifted(l, height), b, shifted(b, width - upTo(2)),
                 1 + n % (2 + static_cast<std::uint32_t>(upTo(6))));
            if (upTo(3) == 0) fill(region, l, shifted(l, height), b, shifted(b, width / 2), 1 + (n + 3) % 8);
        }
        Grid<std::uint8_t> counts = allCells(rock);
        for (std::uint8_t& cell : counts.cells) cell = upTo(9) > 0 ? 1 : 0;
        std::vector<std::uint8_t> isRock(kNumbers);
        for (std::uint8_t& one : isRock) one = upTo(2) > 0 ? 1 : 0;
        const RockRules rules{static_cast<std::size_t>(20 + upTo(30)), round % 2 == 0};
        const RockCounts fast = matchRocks(overlapsOf(counts, rock, region), isRock, rules).counts;
        const RockCounts slow = Slow{counts, rock, region, isRock, rules, kNumbers}.all();
        EXPECT_EQ(fast.found, slow.found) << round;
        EXPECT_EQ(fast.missed, slow.missed) << round;
        EXPECT_EQ(fast.falseRegions, slow.falseRegions) << round;
        EXPECT_NEAR(fast.iou, slow.iou, 1e-12) << round;
        EXPECT_EQ(fast.missedBy, slow.missedBy) << round;
        for (std::size_t n = 0; n < kMisses; ++n) seen[n] += slow.missedBy[n];
        falseSeen += slow.falseRegions;
    }
    for (std::size_t n = 0; n < kMisses; ++n) EXPECT_GT(seen[n], 0U) << "no case of miss " << n << " was tried";
    EXPECT_GT(falseSeen, 0U);
}

TEST(RockTruth, PartsOfARockBehindAnotherAreTwo) {
    Labels rock(10, 12);
    fill(rock, 0, 10, 0, 12, 1);
    fill(rock, 0, 10, 5, 7, 2);
    const Labels parts = visibleParts(rock);
    EXPECT_EQ(*std::ranges::max_element(parts.cells), 3U);
    EXPECT_NE(parts.at(0, 0), parts.at(0, 11));
    Labels corner(2, 2);
    corner.at(0, 0) = corner.at(1, 1) = 4;
    EXPECT_EQ(visibleParts(corner).at(0, 0), visibleParts(corner).at(1, 1)) << "corners touch";
}

TEST(RockTruth, SpansAreThoseOfTheCalipers) {
    // A sheet of 0.6 x 0.25 m at right angles to the line of sight, rotated in its plane, 7 m away in an oblique direction.
    const Eigen::Vector3d sight = Eigen::Vector3d(0.3, -0.8, 0.5).normalized();
    const Eigen::Vector3d right = sight.unitOrthogonal();
    const Eigen::Vector3d up = sight.cross(right);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= 60; ++i) {
        for (int j = 0; j <= 25; ++j) {
            const Eigen::Vector2d flat = Eigen::Rotation2Dd(0.7) * Eigen::Vector2d(0.01 * i - 0.3, 0.01 * j - 0.125);
            points.emplace_back(7.0 * sight + flat.x() * right + flat.y() * up);
        }
    }
    const VisibleSpans spans = spansAcrossSight(points);
    EXPECT_NEAR(spans.aM, std::hypot(0.6, 0.25), 1e-5);
    EXPECT_NEAR(spans.bM, 0.25, 1e-5);
    for (Eigen::Vector3d& p : points) p += 0.2 * std::sin(50.0 * p.x()) * sight;
    EXPECT_NEAR(spansAcrossSight(points).bM, 0.25, 0.003) << "depth is no span";
    EXPECT_EQ(spansAcrossSight({points[0], points[1]}).aM, 0.0);
}

TEST(RockTruth, SurvivesItsFilesAndScoresItselfPerfect) {
    sim::SimulationSettings settings;
    settings.lines = 120;
    settings.beams = 140;
    settings.truth = true;
    const sim::Simulation bell = *sim::simulate(settings);
    const auto folder = std::filesystem::path(testing::TempDir()) / "truth-of-rocks";
    ASSERT_TRUE(sim::writeTruth(bell, settings, folder));
    const Result<TrueRocks> read = readTrueRocks(folder);
    ASSERT_TRUE(read) << read.error().sentence();
    const TrueRocks made = trueRocksOf(bell);
    EXPECT_EQ(read->rock, made.rock);
    EXPECT_EQ(read->cleanMm, made.cleanMm);
    EXPECT_EQ(read->tearToBeamMm, made.tearToBeamMm);
    EXPECT_EQ(read->tearToLineMm, made.tearToLineMm);
    ASSERT_EQ(read->rocks.size(), made.rocks.size());
    EXPECT_NEAR((read->rocks[3].centreM - made.rocks[3].centreM).norm(), 0.0, 1e-6);

    const RockScene scene = *rockScene(bell.scan, made, "here");
    RockDetection answer;
    answer.region = made.rock;
    answer.isRock.assign(made.rocks.size() + 1, 1);
    answer.claims.resize(made.rocks.size() + 1);
    for (std::size_t n = 0; n < made.rocks.size(); ++n)
        answer.claims[n + 1] = RockClaim{scene.spans[n].aM, scene.spans[n].bM, 0.01, n % 2 == 0 ? 0.9 : 1.0};
    answer.pairs = scene.pairs;
    const auto json = rockScoreJson({scoreRocks(scene, answer)});
    EXPECT_GT(json["at_least_100_cells"]["strict"]["rocks"], 5);
    EXPECT_DOUBLE_EQ(json["at_least_100_cells"]["strict"]["pq"], 1.0);
    EXPECT_DOUBLE_EQ(json["spans"]["b"]["within_1_u"], 1.0);
    EXPECT_LT(json["spans"]["a"]["median_against_whole_rock"], 0.0);
    EXPECT_DOUBLE_EQ(json["order"]["precision"], 1.0);
    EXPECT_DOUBLE_EQ(json["order"]["right_where_both_decide"], 1.0);
    EXPECT_DOUBLE_EQ(json["contacts"]["recall"], 1.0);
    EXPECT_NEAR(json["confidence"]["calibration_error"].get<double>(), 0.05, 0.04);

    ASSERT_TRUE(std::filesystem::remove(folder / "tear_beam.png"));
    EXPECT_FALSE(readTrueRocks(folder)) << "half of the tears is a damaged truth";
    ASSERT_TRUE(std::filesystem::remove(folder / "tear_line.png"));
    EXPECT_TRUE(readTrueRocks(folder)) << "a truth from before tears were written";
    EXPECT_TRUE(truePairs(*readTrueRocks(folder)).empty());
    ASSERT_TRUE(std::filesystem::remove(folder / "object.png"));
    EXPECT_FALSE(readTrueRocks(folder));
    std::filesystem::remove_all(folder);
}

/// Two rocks next to each other over 10 lines, the left one nearer.
TrueRocks sideBySide(int torn) {
    TrueRocks truth;
    truth.rock = Labels(10, 10);
    fill(truth.rock, 0, 10, 0, 5, 2);
    fill(truth.rock, 0, 10, 5, 10, 1);
    truth.cleanMm = Grid<std::uint16_t>(10, 10, std::uint16_t{3000});
    truth.tearToBeamMm = truth.tearToLineMm = Grid<std::uint16_t>(10, 10);
    for (int i = 0; i < 10; ++i) {
        for (int j = 5; j < 10; ++j) truth.cleanMm.at(i, j) = 3100;
        truth.tearToBeamMm.at(i, 4) = i < torn ? 51 : 50;
    }
    return truth;
}

TEST(RockPairs, OrderAndContactFollowTheCracksBetweenTwoRocks) {
    const auto only = [](int torn) {
        const auto pairs = truePairs(sideBySide(torn));
        EXPECT_EQ(pairs.size(), 1U);
        return pairs.front();
    };
    EXPECT_EQ(only(2).front, 0U);
    EXPECT_TRUE(only(2).contact);
    EXPECT_EQ(only(3).front, 2U);
    EXPECT_TRUE(only(5).contact);
    EXPECT_FALSE(only(6).contact);
    EXPECT_EQ(only(6).front, 2U);
    TrueRocks crossed = sideBySide(10);
    for (int i = 0; i < 3; ++i) crossed.cleanMm.at(i, 4) = 3200;
    EXPECT_EQ(truePairs(crossed).front().front, 0U) << "seven of ten are not 80 %";
    crossed.cleanMm.at(0, 4) = 3000;
    EXPECT_EQ(truePairs(crossed).front().front, 2U);
}

TEST(RockPairs, StatementsAreComparedByTheRocksOfTheRegions) {
    RockMatch match;
    for (std::uint32_t n = 1; n <= 3; ++n) match.rocks.push_back({.rock = n, .cells = 100, .found = true, .region = 10 - n, .iou = 1.0});
    match.rocks.push_back({.rock = 4, .cells = 100, .found = false});
    const std::vector<RockPair> truth{{1, 2, 1, true}, {2, 3, 2, false}, {1, 4, 1, true}};
    const std::vector<RockPair> told{{8, 9, 9, false}, {7, 8, 7, true}, {7, 9, 9, false}, {1, 9, 9, true}};
    const PairScore score = scorePairs(truth, told, match);
    EXPECT_EQ(score.order.known, 2U) << "the pair with a missed rock is left out";
    EXPECT_EQ(score.order.reported, 3U) << "so is the one with a region that is no rock";
    EXPECT_EQ(score.order.reportedKnown, 2U);
    EXPECT_EQ(score.order.right, 1U);
    EXPECT_EQ(score.contacts.known, 1U);
    EXPECT_EQ(score.contacts.reported, 1U);
    EXPECT_EQ(score.contacts.reportedKnown, 0U);
    EXPECT_EQ(score.contacts.rocksClose, 3U);
}

} // namespace
} // namespace edgescan::lab
