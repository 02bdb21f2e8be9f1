// One-to-one matching of edge cells.
#include "app/lab/score/match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace edgescan::lab {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Steps within the tolerance, shortest first.
std::vector<std::array<int, 2>> stepsWithin(double tolerance) {
    const int reach = static_cast<int>(std::floor(tolerance));
    std::vector<std::array<int, 2>> steps;
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            if (i * i + j * j <= tolerance * tolerance + 1e-9) steps.push_back({i, j});
        }
    }
    std::stable_sort(steps.begin(), steps.end(),
                     [](const auto& a, const auto& b) { return a[0] * a[0] + a[1] * a[1] < b[0] * b[0] + b[1] * b[1]; });
    return steps;
}

// The bipartite graph: candidates of detection d are candidate[first[d]] .. candidate[first[d + 1]].
struct Graph {
    std::vector<std::uint32_t> detected, truth; // cells
    std::vector<std::size_t> first;
    std::vector<std::uint32_t> candidate; // index into truth
};

Graph graphOf(const Grid<std::uint8_t>& detected, const Grid<std::uint8_t>& truth, double tolerance) {
    Graph graph;
    Grid<std::uint32_t> place(truth.lines, truth.beams, kNone);
    for (std::size_t k = 0; k < truth.size(); ++k) {
        if (truth[k] == 0) continue;
        place[k] = static_cast<std::uint32_t>(graph.truth.size());
        graph.truth.push_back(static_cast<std::uint32_t>(k));
    }
    const auto steps = stepsWithin(tolerance);
    const auto beams = static_cast<std::size_t>(detected.beams);
    for (std::size_t k = 0; k < detected.size(); ++k) {
        if (detected[k] == 0) continue;
        graph.detected.push_back(static_cast<std::uint32_t>(k));
        graph.first.push_back(graph.candidate.size());
        for (const auto& step : steps) {
            const int i = static_cast<int>(k / beams) + step[0];
            const int j = static_cast<int>(k % beams) + step[1];
            if (place.contains(i, j) && place.at(i, j) != kNone) graph.candidate.push_back(place.at(i, j));
        }
    }
    graph.first.push_back(graph.candidate.size());
    return graph;
}

class Matcher {
public:
    explicit Matcher(const Graph& graph)
        : graph_(graph), truthOf_(graph.detected.size(), kNone), detectionOf_(graph.truth.size(), kNone), level_(graph.detected.size()) {}

    const std::vector<std::uint32_t>& run() {
        // Greedy, nearest first: this finds most of the pairs.
        for (std::uint32_t d = 0; d < truthOf_.size(); ++d) {
            for (std::size_t c = graph_.first[d]; c < graph_.first[d + 1] && truthOf_[d] == kNone; ++c) {
                if (detectionOf_[graph_.candidate[c]] == kNone) pair(d, graph_.candidate[c]);
            }
        }
        while (layer()) {
            next_ = std::vector<std::size_t>(graph_.first.begin(), graph_.first.end() - 1);
            for (std::uint32_t d = 0; d < truthOf_.size(); ++d) {
                if (truthOf_[d] == kNone) augment(d);
            }
        }
        return truthOf_;
    }

private:
    void pair(std::uint32_t d, std::uint32_t t) {
        truthOf_[d] = t;
        detectionOf_[t] = d;
    }

    // Breadth first from the unmatched detections; true if an unmatched true cell was reached.
    bool layer() {
        std::fill(level_.begin(), level_.end(), kNone);
        std::vector<std::uint32_t> queue;
        for (std::uint32_t d = 0; d < truthOf_.size(); ++d) {
            if (truthOf_[d] != kNone) continue;
            level_[d] = 0;
            queue.push_back(d);
        }
        bool reached = false;
        for (std::size_t at = 0; at < queue.size(); ++at) {
            const std::uint32_t d = queue[at];
            for (std::size_t c = graph_.first[d]; c < graph_.first[d + 1]; ++c) {
                const std::uint32_t other = detectionOf_[graph_.candidate[c]];
                if (other == kNone) {
                    reached = true;
                } else if (level_[other] == kNone) {
                    level_[other] = level_[d] + 1;
                    queue.push_back(other);
                }
            }
        }
        return reached;
    }

    // Depth first along the layers, without recursion, because paths can be as long as an edge.
    bool augment(std::uint32_t root) {
        std::vector<std::uint32_t> path{root};
        while (!path.empty()) {
            const std::uint32_t d = path.back();
            if (next_[d] == graph_.first[d + 1]) {
                level_[d] = kNone;
                path.pop_back();
                continue;
            }
            const std::uint32_t t = graph_.candidate[next_[d]];
            const std::uint32_t other = detectionOf_[t];
            if (other == kNone) {
                flip(path);
                return true;
            }
            if (level_[other] != kNone && level_[other] == level_[d] + 1)
                path.push_back(other);
            else
                ++next_[d];
        }
        return false;
    }

    // Each detection of the path gets the true cell that its cursor points to.
    void flip(const std::vector<std::uint32_t>& path) {
        for (auto d = path.rbegin(); d != path.rend(); ++d) {
            pair(*d, graph_.candidate[next_[*d]]);
            ++next_[*d];
        }
    }

    const Graph& graph_;
    std::vector<std::uint32_t> truthOf_, detectionOf_, level_;
    std::vector<std::size_t> next_;
};

} // namespace

std::vector<MatchedPair> matchEdges(const Grid<std::uint8_t>& detected, const Grid<std::uint8_t>& truth, double tolerance) {
    const Graph graph = graphOf(detected, truth, tolerance);
    Matcher matcher(graph);
    const std::vector<std::uint32_t>& truthOf = matcher.run();
    std::vector<MatchedPair> pairs;
    for (std::size_t d = 0; d < truthOf.size(); ++d) {
        if (truthOf[d] != kNone) pairs.push_back({graph.detected[d], graph.truth[truthOf[d]]});
    }
    return pairs;
}

} // namespace edgescan::lab
