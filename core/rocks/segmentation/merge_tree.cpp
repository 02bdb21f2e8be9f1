// Greedy merging of a graph of regions.
#include "core/rocks/segmentation/merge_tree.h"

#include "core/rocks/segmentation/basins.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace edgescan::rocks {
namespace {

class Merging {
public:
    Merging(std::uint32_t segments, std::span<const SegmentBorder> borders, std::span<const SegmentPair> pairs)
        : groups_(static_cast<std::size_t>(segments) + 1), name_(static_cast<std::size_t>(segments) + 1), of_(name_.size()) {
        std::iota(name_.begin(), name_.end(), 0U);
        for (const SegmentBorder& border : borders) {
            of_[border.a].emplace(border.b, static_cast<std::uint32_t>(borders_.size()));
            of_[border.b].emplace(border.a, static_cast<std::uint32_t>(borders_.size()));
            borders_.push_back({border, false, 0});
        }
        take(pairs);
    }

    MergeTree run() {
        for (std::uint32_t n = 0; n < borders_.size(); ++n) post(n);
        double height = -std::numeric_limits<double>::infinity();
        while (!waiting_.empty()) {
            const Waiting next = waiting_.top();
            waiting_.pop();
            if (next.version != borders_[next.border].version) continue;
            height = std::max(height, next.meanZ);
            join(borders_[next.border].sums.a, borders_[next.border].sums.b, height);
        }
        return std::move(tree_);
    }

private:
    struct Border {
        SegmentBorder sums; // a, b: members of the two groups
        bool apart;
        std::uint32_t version;
    };
    struct Waiting {
        double meanZ;
        std::uint32_t a, b; // names of the groups, a < b
        std::uint32_t border, version;
        bool operator<(const Waiting& other) const {
            return std::tie(meanZ, a, b) > std::tie(other.meanZ, other.a, other.b); // the smallest comes first
        }
    };
    using Neighbours = std::unordered_map<std::uint32_t, std::uint32_t>; // group -> border

    void post(std::uint32_t n) {
        Border& border = borders_[n];
        ++border.version;
        if (border.apart || border.sums.cracks == 0) return;
        const std::uint32_t a = name_[groups_.of(border.sums.a)];
        const std::uint32_t b = name_[groups_.of(border.sums.b)];
        waiting_.push({border.sums.meanZ(), std::min(a, b), std::max(a, b), n, border.version});
    }

    // Marks the border as removed.
    static void end(Border& border) {
        border.sums.cracks = 0;
        ++border.version;
    }

    // The smaller neighbourhood is added to the larger one.
    void join(std::uint32_t one, std::uint32_t other, double height) {
        one = groups_.of(one);
        other = groups_.of(other);
        tree_.merges.push_back({height, std::min(name_[one], name_[other]), std::max(name_[one], name_[other])});
        if (of_[one].size() < of_[other].size()) std::swap(one, other);
        const bool renamed = name_[other] < name_[one];
        name_[one] = std::min(name_[one], name_[other]);
        const Neighbours moved = std::move(of_[other]);
        of_[other].clear();
        groups_.join(one, other);
        for (const auto& [neighbour, n] : moved) {
            of_[neighbour].erase(other);
            if (neighbour == one) {
                end(borders_[n]);
                continue;
            }
            const auto [place, isNew] = of_[one].emplace(neighbour, n);
            if (isNew) {
                of_[neighbour].emplace(one, n);
                if (!renamed) post(n);
            } else {
                borders_[place->second].sums.add(borders_[n].sums);
                borders_[place->second].apart = borders_[place->second].apart || borders_[n].apart;
                end(borders_[n]);
                if (!renamed) post(place->second);
            }
        }
        if (!renamed) return;
        for (const auto& [neighbour, n] : of_[one]) post(n);
    }

    void keepApart(std::uint32_t a, std::uint32_t b) {
        const auto [place, isNew] = of_[a].emplace(b, static_cast<std::uint32_t>(borders_.size()));
        if (isNew) {
            of_[b].emplace(a, place->second);
            borders_.push_back({{a, b, 0, 0, 0, 0, 0}, true, 0});
        }
        borders_[place->second].apart = true;
    }

    // Separate from all others, not from one.
    static bool isAlone(const SegmentPair& pair) { return !pair.joined && pair.b == kNoSegment; }

    // Accepts pairs from the last to the first, unless they contradict those already accepted.
    void take(std::span<const SegmentPair> pairs) {
        JoinedGroups joined(name_.size());
        std::vector<SegmentPair> taken;
        for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
            const std::uint32_t a = joined.of(pair->a);
            const std::uint32_t b = joined.of(pair->b);
            const auto keepsThemApart = [&](const SegmentPair& other) {
                const std::uint32_t c = joined.of(other.a);
                const std::uint32_t d = joined.of(other.b);
                if (isAlone(other)) return a == c || b == c;
                return !other.joined && ((a == c && b == d) || (a == d && b == c));
            };
            if (a == b || (pair->joined && std::any_of(taken.begin(), taken.end(), keepsThemApart))) continue;
            if (pair->joined) joined.join(pair->a, pair->b);
            taken.push_back(*pair);
        }
        for (const SegmentPair& pair : taken) {
            if (!pair.joined && !isAlone(pair)) keepApart(pair.a, pair.b);
        }
        std::reverse(taken.begin(), taken.end());
        for (const SegmentPair& pair : taken) {
            if (pair.joined && groups_.of(pair.a) != groups_.of(pair.b)) join(pair.a, pair.b, -std::numeric_limits<double>::infinity());
        }
        for (const SegmentPair& pair : taken) {
            if (!isAlone(pair)) continue;
            for (const auto& [neighbour, n] : of_[groups_.of(pair.a)]) borders_[n].apart = true;
        }
    }

    JoinedGroups groups_;
    std::vector<std::uint32_t> name_; // smallest segment, by group
    std::vector<Neighbours> of_;      // borders, by group
    std::vector<Border> borders_;
    std::priority_queue<Waiting> waiting_;
    MergeTree tree_;
};

} // namespace

MergeTree mergeTree(std::uint32_t segments, std::span<const SegmentBorder> borders, std::span<const SegmentPair> pairs) {
    return Merging(segments, borders, pairs).run();
}

std::vector<std::uint32_t> groupsAt(const MergeTree& tree, std::uint32_t segments, double level) {
    std::vector<std::uint32_t> group(static_cast<std::size_t>(segments) + 1);
    std::iota(group.begin(), group.end(), 0U);
    for (const Merge& merge : tree.merges) {
        if (merge.height > level) break;
        group[merge.gone] = merge.remaining;
    }
    // A group was merged into one with a smaller number, which already has its final number.
    for (std::uint32_t n = 1; n < group.size(); ++n) group[n] = group[group[n]];
    return group;
}

} // namespace edgescan::rocks
