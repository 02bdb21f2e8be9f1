// Greedy merging of a graph of regions.
#include "core/rocks/segmentation/merge_tree.h"

#include "core/rocks/segmentation/basins.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace edgescan::rocks {
namespace {

class Merging {
public:
    Merging(std::uint32_t segments, std::span<const SegmentBorder> borders, std::span<const OutlineSums> outlines)
        : groups_(static_cast<std::size_t>(segments) + 1), name_(static_cast<std::size_t>(segments) + 1), of_(name_.size()) {
        std::iota(name_.begin(), name_.end(), 0U);
        for (std::size_t n = 0; n < borders.size(); ++n) {
            const SegmentBorder& border = borders[n];
            of_[border.a].emplace(border.b, static_cast<std::uint32_t>(n));
            of_[border.b].emplace(border.a, static_cast<std::uint32_t>(n));
            borders_.push_back({{border, outlines.empty() ? OutlineSums{} : outlines[n]}, 0, false});
        }
    }

    /// From here on the price is that of `rules`, or of mergePrice() where it is null.
    void measureBodies(const Segmentation& segments, const MergeRules* rules) {
        noise_ = segments.inputs.responses->noise;
        rules_ = rules;
        bodies_.resize(name_.size());
        pricedCells_.resize(name_.size());
        std::vector<BodySums> sums = segmentBodies(segments);
        for (std::uint32_t n = 1; n < bodies_.size(); ++n) {
            bodies_[n].sums = std::move(sums[n]);
            measure(n);
        }
    }

    MergeTree run() {
        for (std::uint32_t n = 0; n < borders_.size(); ++n) post(n);
        double height = -std::numeric_limits<double>::infinity();
        while (!waiting_.empty()) {
            const Waiting next = waiting_.top();
            waiting_.pop();
            if (next.version != borders_[next.border].version) continue;
            height = std::max(height, next.price);
            const std::uint32_t one = join(borders_[next.border].of.sums.a, borders_[next.border].of.sums.b, height);
            const bool all = hasGrown(one);
            for (const auto& [neighbour, n] : of_[one]) {
                if (all || borders_[n].changed) post(n);
            }
        }
        return std::move(tree_);
    }

private:
    struct Border {
        BodyBorder of; // a, b: members of the two groups
        std::uint32_t version;
        bool changed = false; // since its price was taken
    };
    struct Waiting {
        double price;
        std::uint32_t a, b; // names of the groups, a < b
        std::uint32_t border, version;
        bool operator<(const Waiting& other) const {
            return std::tie(price, a, b) > std::tie(other.price, other.a, other.b); // the smallest comes first
        }
    };
    using Neighbours = std::map<std::uint32_t, std::uint32_t>; // group -> border

    void measure(std::uint32_t group) {
        bodies_[group].shape = shapeOf(bodies_[group].sums, noise_);
        bodies_[group].sides.clear();
    }
    // No sides: they changed since they were last asked for.
    const Body& bodyOf(std::uint32_t group) {
        std::vector<Body::Side>& sides = bodies_[group].sides;
        if (sides.empty()) {
            for (const auto& [neighbour, n] : of_[group]) sides.push_back({borders_[n].of.sums.meanZ(), borders_[n].of.outline.length});
        }
        return bodies_[group];
    }

    // Whether the prices of all its borders are taken again. A wall gains a piece some hundred times; one piece hardly changes it.
    bool hasGrown(std::uint32_t group) {
        constexpr double kGrowth = 1.1;
        if (bodies_.empty()) return true;
        const double cells = bodies_[group].sums.points.cells;
        if (cells < kGrowth * pricedCells_[group]) return false;
        pricedCells_[group] = cells;
        return true;
    }

    void post(std::uint32_t n) {
        Border& border = borders_[n];
        ++border.version;
        border.changed = false;
        if (border.of.sums.cracks == 0) return;
        const std::uint32_t one = groups_.of(border.of.sums.a), other = groups_.of(border.of.sums.b);
        const std::uint32_t a = std::min(name_[one], name_[other]), b = std::max(name_[one], name_[other]);
        waiting_.push({priceOf(border.of, one, other, a, b), a, b, n, border.version});
    }
    // `a`, `b`: the names of the groups `one` and `other`.
    double priceOf(const BodyBorder& border, std::uint32_t one, std::uint32_t other, std::uint32_t a, std::uint32_t b) {
        if (bodies_.empty()) return border.sums.meanZ();
        const PairFeatures features = pairFeatures(bodyOf(one), bodyOf(other), border, noise_);
        return rules_ != nullptr ? rules_->price(features, a, b) : mergePrice(features);
    }

    // Marks the border as removed.
    static void end(Border& border) {
        border.of.sums.cracks = 0;
        ++border.version;
    }

    void addBorder(Border& to, const Border& from) {
        const bool reversed = groups_.of(to.of.sums.a) != groups_.of(from.of.sums.a);
        to.of.sums.add(reversed ? from.of.sums.reversed() : from.of.sums);
        to.of.outline.add(from.of.outline);
    }

    // The smaller neighbourhood is added to the larger one. Returns the joined group.
    std::uint32_t join(std::uint32_t one, std::uint32_t other, double height) {
        one = groups_.of(one);
        other = groups_.of(other);
        tree_.merges.push_back({height, std::min(name_[one], name_[other]), std::max(name_[one], name_[other])});
        if (rules_ != nullptr && rules_->merged) rules_->merged(tree_.merges.back());
        if (of_[one].size() < of_[other].size()) std::swap(one, other);
        name_[one] = std::min(name_[one], name_[other]);
        const Neighbours moved = std::exchange(of_[other], {});
        groups_.join(one, other);
        for (const auto& [neighbour, n] : moved) {
            of_[neighbour].erase(other);
            if (neighbour == one) {
                end(borders_[n]);
                continue;
            }
            const auto [place, isNew] = of_[one].emplace(neighbour, n);
            borders_[place->second].changed = true;
            if (isNew) {
                of_[neighbour].emplace(one, n);
            } else {
                addBorder(borders_[place->second], borders_[n]);
                end(borders_[n]);
            }
        }
        if (bodies_.empty()) return one;
        bodies_[one].sums.add(bodies_[other].sums);
        bodies_[other] = {};
        measure(one);
        for (const auto& [neighbour, n] : moved) bodies_[neighbour].sides.clear();
        return one;
    }

    RangeNoise noise_{};
    const MergeRules* rules_ = nullptr;
    JoinedGroups groups_;
    std::vector<std::uint32_t> name_; // smallest segment, by group
    std::vector<Neighbours> of_;      // borders, by group
    std::vector<Body> bodies_;        // by group; empty if the mean z is the price
    std::vector<double> pricedCells_; // by group: its measured cells when all its prices were last taken
    std::vector<Border> borders_;
    std::priority_queue<Waiting> waiting_;
    MergeTree tree_;
};

/// Follows the merges of a tree, and leaves out what pairs forbid.
class PairedMerging {
public:
    PairedMerging(const Segmentation& segments, std::span<const SegmentPair> pairs)
        : groups_(segments.sums.size()), name_(segments.sums.size()), of_(name_.size()), parts_(name_.size()), guarded_(name_.size()) {
        std::iota(name_.begin(), name_.end(), 0U);
        for (const SegmentBorder& border : segments.borders) {
            of_[border.a].insert(border.b);
            of_[border.b].insert(border.a);
        }
        accept(pairs);
        for (const SegmentPair& pair : joined_) join(pair.a, pair.b, -std::numeric_limits<double>::infinity());
        for (std::uint32_t n = 1; n < name_.size(); ++n) parts_[segments.cutFrom[n]].push_back(n);
        for (std::uint32_t n = 1; n < name_.size(); ++n) {
            if (parts_[n].size() > 1) parts_[n] = united(parts_[n], -std::numeric_limits<double>::infinity());
        }
    }

    MergeTree run(const std::vector<Merge>& merges) {
        for (const Merge& merge : merges) {
            std::vector<std::uint32_t>& parts = parts_[merge.remaining];
            parts.insert(parts.end(), parts_[merge.gone].begin(), parts_[merge.gone].end());
            parts_[merge.gone].clear();
            parts = united(parts, merge.height);
        }
        return std::move(tree_);
    }

private:
    // Separate from all others, not from one.
    static bool isAlone(const SegmentPair& pair) { return pair.b == kNoSegment; }

    // Accepts pairs from the last to the first, unless they contradict those already accepted.
    void accept(std::span<const SegmentPair> pairs) {
        JoinedGroups joined(name_.size());
        std::vector<SegmentPair> apart;
        for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
            const std::uint32_t a = joined.of(pair->a), b = joined.of(pair->b);
            const auto keepsThemApart = [&](const SegmentPair& other) {
                const std::uint32_t c = joined.of(other.a), d = joined.of(other.b);
                return isAlone(other) ? a == c || b == c : (a == c && b == d) || (a == d && b == c);
            };
            if (a == b || (pair->joined && std::ranges::any_of(apart, keepsThemApart))) continue;
            if (pair->joined) joined.join(pair->a, pair->b);
            (pair->joined ? joined_ : apart).push_back(*pair);
        }
        std::ranges::reverse(joined_);
        for (const SegmentPair& pair : apart) {
            guarded_[pair.a] = guarded_[pair.b] = 1;
            (isAlone(pair) ? alone_ : apart_).push_back(pair);
        }
        guarded_[kNoSegment] = 0;
    }

    [[nodiscard]] bool mayJoin(std::uint32_t one, std::uint32_t other) {
        if (guarded_[one] == 0 && guarded_[other] == 0) return true;
        for (const SegmentPair& pair : alone_) {
            const std::uint32_t alone = groups_.of(pair.a);
            if (alone == one || alone == other) return false;
        }
        return std::ranges::none_of(apart_, [&](const SegmentPair& pair) {
            const std::uint32_t a = groups_.of(pair.a), b = groups_.of(pair.b);
            return (a == one && b == other) || (a == other && b == one);
        });
    }

    // The groups of the parts, after all of them joined that touch and may. Of a tree's group that no pair touches there is one part.
    std::vector<std::uint32_t> united(const std::vector<std::uint32_t>& parts, double height) {
        std::vector<std::uint32_t> groups;
        const auto collect = [&] {
            groups.clear();
            for (const std::uint32_t part : parts) groups.push_back(groups_.of(part));
            std::ranges::sort(groups, {}, [this](std::uint32_t group) { return name_[group]; });
            groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
        };
        collect();
        const auto joinOne = [&] {
            for (std::size_t n = 0; n < groups.size(); ++n) {
                for (std::size_t m = n + 1; m < groups.size(); ++m) {
                    if (!of_[groups[n]].contains(groups[m]) || !mayJoin(groups[n], groups[m])) continue;
                    join(groups[n], groups[m], height);
                    return true;
                }
            }
            return false;
        };
        while (groups.size() > 1 && joinOne()) collect();
        return groups;
    }

    // The smaller neighbourhood is added to the larger one.
    void join(std::uint32_t one, std::uint32_t other, double height) {
        one = groups_.of(one);
        other = groups_.of(other);
        if (one == other) return;
        tree_.merges.push_back({height, std::min(name_[one], name_[other]), std::max(name_[one], name_[other])});
        if (of_[one].size() < of_[other].size()) std::swap(one, other);
        name_[one] = std::min(name_[one], name_[other]);
        guarded_[one] |= guarded_[other];
        groups_.join(one, other);
        for (const std::uint32_t neighbour : std::exchange(of_[other], {})) {
            of_[neighbour].erase(other);
            if (neighbour == one) continue;
            of_[one].insert(neighbour);
            of_[neighbour].insert(one);
        }
    }

    JoinedGroups groups_;
    std::vector<std::uint32_t> name_;               // smallest segment, by group
    std::vector<std::set<std::uint32_t>> of_;       // neighbours, by group
    std::vector<std::vector<std::uint32_t>> parts_; // members of the parts that there are of a group of the tree, by its number
    std::vector<std::uint8_t> guarded_;             // by group: named by a pair that keeps apart
    std::vector<SegmentPair> joined_, apart_, alone_;
    MergeTree tree_;
};

} // namespace

MergeTree mergeTree(const Segmentation& segments) {
    Merging merging(segments.count(), segments.borders, segments.outlines);
    merging.measureBodies(segments, nullptr);
    return merging.run();
}

MergeTree mergeTree(std::uint32_t segments, std::span<const SegmentBorder> borders) { return Merging(segments, borders, {}).run(); }

MergeTree mergeTree(const Segmentation& segments, const MergeRules& rules) {
    Merging merging(segments.count(), segments.borders, segments.outlines);
    merging.measureBodies(segments, &rules);
    return merging.run();
}

MergeTree withPairs(const MergeTree& tree, const Segmentation& segments, std::span<const SegmentPair> pairs) {
    const auto plain = tree.plain ? tree.plain : std::make_shared<const std::vector<Merge>>(tree.merges);
    MergeTree made = PairedMerging(segments, pairs).run(*plain);
    made.plain = plain;
    return made;
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
