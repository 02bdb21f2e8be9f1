// The tree compared with a version that adds up all borders again before each merge.
#include "core/rocks/segmentation/merge_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

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

// `apart`: pairs of segments that must never be in one group. `joined` come first.
MergeTree slowTree(std::uint32_t segments, const std::vector<SegmentBorder>& borders, const std::vector<SegmentPair>& pairs) {
    std::vector<std::uint32_t> group(segments + 1);
    for (std::uint32_t n = 0; n <= segments; ++n) group[n] = n;
    MergeTree tree;
    const auto merge = [&](std::uint32_t x, std::uint32_t y, double height) {
        const auto [kept, gone] = std::minmax(group[x], group[y]);
        const Merge made{height, kept, gone};
        std::replace(group.begin(), group.end(), made.gone, made.remaining);
        tree.merges.push_back(made);
    };
    for (const SegmentPair& pair : pairs) {
        if (pair.joined && group[pair.a] != group[pair.b]) merge(pair.a, pair.b, kNever);
    }
    double height = kNever;
    while (true) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, SegmentBorder> sums;
        for (const SegmentBorder& border : borders) {
            const auto [a, b] = std::minmax(group[border.a], group[border.b]);
            if (a != b) sums[{a, b}].add(border);
        }
        for (const SegmentPair& pair : pairs) {
            if (!pair.joined) sums.erase(std::minmax(group[pair.a], group[pair.b]));
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
        expectSame(mergeTree(segments, borders), slowTree(segments, borders, {}));
    }
}

TEST(MergeTree, PairsAreJoinedFirstAndKeptApartForGood) {
    std::mt19937 random(11);
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t segments = 8 + static_cast<std::uint32_t>(random()) % 30;
        const std::vector<SegmentBorder> borders = randomBorders(random, segments, 50);
        // Segments 1 and 2 with some others to be separated from, and joins among the rest: no contradiction.
        const std::vector<SegmentPair> pairs{{1, 2, false}, {3, 4, true}, {1, 3, false}, {5, 6, true}};
        const MergeTree tree = mergeTree(segments, borders, pairs);
        expectSame(tree, slowTree(segments, borders, pairs));
        const std::vector<std::uint32_t> group = groupsAt(tree, segments, 1e9);
        EXPECT_NE(group[1], group[2]);
        EXPECT_NE(group[1], group[3]);
        EXPECT_EQ(groupsAt(tree, segments, -1e9)[3], groupsAt(tree, segments, -1e9)[4]);
    }
}

TEST(MergeTree, OfTwoWordsThatContradictTheLaterHolds) {
    const std::vector<SegmentBorder> borders{{1, 2, 65536, 1, 0, 0, 0}, {2, 3, 65536, 1, 0, 0, 0}};
    const auto together = [&](const std::vector<SegmentPair>& pairs, std::uint32_t a, std::uint32_t b) {
        const auto group = groupsAt(mergeTree(3, borders, pairs), 3, 5);
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
