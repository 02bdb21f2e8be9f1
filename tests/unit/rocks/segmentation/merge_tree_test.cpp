// The tree compared with a version that adds up all borders again before each merge.
#include "core/rocks/segmentation/merge_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>
#include <utility>

namespace edgescan::rocks {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

std::vector<SegmentBorder> randomBorders(std::mt19937& random, std::uint32_t segments, int values) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, SegmentBorder> borders;
    for (std::uint32_t n = 0; n < 3 * segments; ++n) {
        const std::uint32_t a = 1 + static_cast<std::uint32_t>(random()) % segments;
        const std::uint32_t b = 1 + static_cast<std::uint32_t>(random()) % segments;
        if (a >= b) continue;
        SegmentBorder border{a, b, 0, 0, 0, 0, 0};
        border.cracks = 1 + random() % 4;
        border.sumZ = (static_cast<std::int64_t>(random() % static_cast<unsigned>(values)) - values / 2) * 65536 * border.cracks;
        borders[{a, b}] = border;
    }
    std::vector<SegmentBorder> list;
    for (const auto& [pair, border] : borders) list.push_back(border);
    return list;
}

MergeTree slowTree(std::uint32_t segments, const std::vector<SegmentBorder>& borders) {
    std::vector<std::uint32_t> group(segments + 1);
    for (std::uint32_t n = 0; n <= segments; ++n) group[n] = n;
    MergeTree tree;
    const auto merge = [&](std::uint32_t x, std::uint32_t y, double height) {
        const auto [kept, gone] = std::minmax(group[x], group[y]);
        const Merge made{height, kept, gone};
        std::replace(group.begin(), group.end(), made.gone, made.remaining);
        tree.merges.push_back(made);
    };
    double height = kNever;
    while (true) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, SegmentBorder> sums;
        for (const SegmentBorder& border : borders) {
            const auto [a, b] = std::minmax(group[border.a], group[border.b]);
            if (a != b) sums[{a, b}].add(border);
        }
        if (sums.empty()) return tree;
        const auto least = std::min_element(sums.begin(), sums.end(), [](const auto& x, const auto& y) {
            return std::tuple(x.second.meanZ(), x.first) < std::tuple(y.second.meanZ(), y.first);
        });
        height = std::max(height, least->second.meanZ());
        merge(least->first.first, least->first.second, height);
    }
}

void expectSame(const MergeTree& one, const MergeTree& other) {
    ASSERT_EQ(one.merges.size(), other.merges.size());
    for (std::size_t n = 0; n < one.merges.size(); ++n) {
        ASSERT_EQ(one.merges[n].remaining, other.merges[n].remaining) << "merge " << n;
        ASSERT_EQ(one.merges[n].gone, other.merges[n].gone) << "merge " << n;
        ASSERT_DOUBLE_EQ(one.merges[n].height, other.merges[n].height) << "merge " << n;
    }
}

TEST(MergeTree, EqualsTheSlowOneAlsoWithManyTies) {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t segments = 2 + static_cast<std::uint32_t>(random()) % 40;
        const std::vector<SegmentBorder> borders = randomBorders(random, segments, round % 2 == 0 ? 5 : 2000);
        expectSame(mergeTree(segments, borders), slowTree(segments, borders));
    }
}

/// Uncut segments with these borders.
Segmentation segmentsWith(std::uint32_t count, std::vector<SegmentBorder> borders) {
    Segmentation segments;
    segments.borders = std::move(borders);
    segments.sums.resize(count + 1);
    segments.cutFrom.resize(count + 1);
    std::iota(segments.cutFrom.begin(), segments.cutFrom.end(), 0U);
    return segments;
}

/// The groups without the numbers that they have.
std::set<std::set<std::uint32_t>> groupSets(const MergeTree& tree, std::uint32_t segments, double level) {
    std::map<std::uint32_t, std::set<std::uint32_t>> sets;
    const std::vector<std::uint32_t> group = groupsAt(tree, segments, level);
    for (std::uint32_t n = 1; n <= segments; ++n) sets[group[n]].insert(n);
    std::set<std::set<std::uint32_t>> all;
    for (const auto& [name, members] : sets) all.insert(members);
    return all;
}

TEST(MergeTree, WithoutPairsIsTheSameAgain) {
    std::mt19937 random(5);
    for (int round = 0; round < 40; ++round) {
        const std::uint32_t count = 2 + static_cast<std::uint32_t>(random()) % 40;
        const Segmentation segments = segmentsWith(count, randomBorders(random, count, 300));
        const MergeTree plain = mergeTree(count, segments.borders);
        expectSame(withPairs(plain, segments, {}), plain);
        const std::vector<SegmentPair> some{{1, 2, false}};
        expectSame(withPairs(withPairs(plain, segments, some), segments, {}), plain);
    }
}

TEST(MergeTree, PairsAreJoinedFirstAndKeptApartForGood) {
    std::mt19937 random(11);
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t count = 8 + static_cast<std::uint32_t>(random()) % 30;
        const Segmentation segments = segmentsWith(count, randomBorders(random, count, 50));
        // Segments 1 and 2 with some others to be separated from, and joins among the rest: no contradiction.
        const std::vector<SegmentPair> pairs{{1, 2, false}, {3, 4, true}, {1, 3, false}, {5, 6, true}};
        const MergeTree tree = withPairs(mergeTree(count, segments.borders), segments, pairs);
        const std::vector<std::uint32_t> group = groupsAt(tree, count, 1e9);
        EXPECT_NE(group[1], group[2]);
        EXPECT_NE(group[1], group[3]);
        EXPECT_EQ(groupsAt(tree, count, -1e9)[3], groupsAt(tree, count, -1e9)[4]);
        EXPECT_TRUE(std::ranges::is_sorted(tree.merges, {}, &Merge::height));
        const MergeTree alone = withPairs(tree, segments, std::vector<SegmentPair>{{7, kNoSegment, false}});
        EXPECT_TRUE(groupSets(alone, count, 1e9).contains({7}));
    }
}

// A person who joins two rocks changes these two and no others.
TEST(MergeTree, AJoinChangesNoOtherGroupAtItsLevel) {
    std::mt19937 random(23);
    for (int round = 0; round < 200; ++round) {
        const std::uint32_t count = 12 + static_cast<std::uint32_t>(random()) % 40;
        const Segmentation segments = segmentsWith(count, randomBorders(random, count, 1000));
        const MergeTree plain = mergeTree(count, segments.borders);
        const double level = static_cast<double>(random() % 600) - 300;
        const std::vector<std::uint32_t> group = groupsAt(plain, count, level);
        const std::uint32_t a = 1 + static_cast<std::uint32_t>(random()) % count, b = 1 + static_cast<std::uint32_t>(random()) % count;
        if (group[a] == group[b]) continue;
        std::vector<SegmentPair> pairs;
        std::set<std::uint32_t> both;
        for (std::uint32_t n = 1; n <= count; ++n) {
            if (group[n] != group[a] && group[n] != group[b]) continue;
            both.insert(n);
            pairs.push_back({a, n, true});
        }
        auto wanted = groupSets(plain, count, level);
        std::erase_if(wanted, [&](const auto& each) { return both.contains(*each.begin()); });
        wanted.insert(both);
        EXPECT_EQ(groupSets(withPairs(plain, segments, pairs), count, level), wanted);
    }
}

TEST(MergeTree, OfTwoWordsThatContradictTheLaterHolds) {
    const Segmentation segments = segmentsWith(3, {{1, 2, 65536, 1, 0, 0, 0}, {2, 3, 65536, 1, 0, 0, 0}});
    const auto together = [&](const std::vector<SegmentPair>& pairs, std::uint32_t a, std::uint32_t b) {
        const auto group = groupsAt(withPairs(mergeTree(3, segments.borders), segments, pairs), 3, 5);
        return group[a] == group[b];
    };
    EXPECT_TRUE(together({{1, 2, false}, {1, 2, true}}, 1, 2));
    EXPECT_FALSE(together({{1, 2, true}, {1, 2, false}}, 1, 2));
    // 1 and 3 were joined through 2; then they must be separate.
    EXPECT_FALSE(together({{1, 2, true}, {2, 3, true}, {1, 3, false}}, 1, 3));
    EXPECT_TRUE(together({{1, 2, true}, {2, 3, true}, {1, 3, false}}, 2, 3));
    EXPECT_TRUE(together({{1, 3, false}, {1, 2, true}, {2, 3, true}}, 1, 3));
}

TEST(MergeTree, GroupsAtALevelAreTheMergesUpToIt) {
    std::mt19937 random(3);
    const std::vector<SegmentBorder> borders = randomBorders(random, 30, 400);
    const MergeTree tree = mergeTree(30, borders);
    for (const double level : {-500.0, -3.0, 0.0, 40.0, 500.0}) {
        std::vector<std::uint32_t> slow(31);
        for (std::uint32_t n = 0; n <= 30; ++n) slow[n] = n;
        for (const Merge& merge : tree.merges) {
            if (merge.height <= level) std::replace(slow.begin(), slow.end(), merge.gone, merge.remaining);
        }
        EXPECT_EQ(groupsAt(tree, 30, level), slow);
    }
}

} // namespace
} // namespace edgescan::rocks
