// A k-d tree.
#include "core/inspect/registration/point_index.h"

#include "core/base/bands.h"
#include "core/base/order_statistic.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr std::uint32_t kPointsOfEnd = 10;
constexpr std::size_t kDeepest = 64; // a tree of 2^32 points has 32 levels

} // namespace

std::vector<float> cloudDistances(std::span<const Eigen::Vector3d> points, const PointIndex& other, double mostM) {
    constexpr std::size_t kPerBand = 4096;
    constexpr std::size_t kPointsForTwo = 50000;
    std::vector<float> distances(points.size(), std::numeric_limits<float>::quiet_NaN());
    const auto work = [&](std::size_t from) {
        for (std::size_t n = from; n < std::min(points.size(), from + kPerBand); ++n) {
            if (points[n].allFinite()) distances[n] = static_cast<float>(other.distance(points[n], mostM));
        }
    };
    const auto bands = static_cast<int>((points.size() + kPerBand - 1) / kPerBand);
    if (points.size() >= kPointsForTwo)
        runInParallel(bands, [&](int band) { work(static_cast<std::size_t>(band) * kPerBand); });
    else
        for (int band = 0; band < bands; ++band) work(static_cast<std::size_t>(band) * kPerBand);
    return distances;
}

DistanceHistogram distanceHistogram(std::span<const float> distances, double mostM, int steps) {
    DistanceHistogram histogram;
    histogram.stepM = mostM / steps;
    histogram.counts.resize(static_cast<std::size_t>(steps));
    std::vector<float> known;
    for (const float distance : distances) {
        if (std::isnan(distance)) continue;
        known.push_back(distance);
        const double step = std::floor(static_cast<double>(distance) / histogram.stepM);
        if (step < steps)
            ++histogram.counts[static_cast<std::size_t>(step)];
        else
            ++histogram.beyond;
    }
    histogram.points = known.size();
    histogram.medianM = static_cast<double>(median(std::move(known)));
    return histogram;
}

PointIndex::PointIndex(std::span<const Eigen::Vector3d> points) {
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (points[n].allFinite()) order_.push_back(static_cast<std::uint32_t>(n));
    }
    if (order_.empty()) return;
    nodes_.reserve(4 * order_.size() / kPointsOfEnd + 1);
    halve(0, static_cast<std::uint32_t>(order_.size()), points);
    ordered_.reserve(order_.size());
    for (const std::uint32_t n : order_) ordered_.push_back(points[n]);
}

void PointIndex::halve(std::uint32_t first, std::uint32_t count, std::span<const Eigen::Vector3d> points) {
    const std::size_t own = nodes_.size();
    nodes_.push_back({first, count});
    if (count <= kPointsOfEnd) return;
    const auto begin = order_.begin() + first, end = begin + count, middle = begin + count / 2;
    Eigen::Array3d least = points[*begin], most = least;
    for (auto n = begin; n != end; ++n) {
        least = least.min(points[*n].array());
        most = most.max(points[*n].array());
    }
    int axis = 0;
    (most - least).maxCoeff(&axis);
    std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
        return points[a][axis] < points[b][axis] || (points[a][axis] == points[b][axis] && a < b);
    });
    const double split = points[*middle][axis];
    halve(first, count / 2, points);
    nodes_[own] = {first, count, static_cast<std::uint32_t>(nodes_.size()), axis, split};
    halve(first + count / 2, count - count / 2, points);
}

template <class Visit, class Limit>
void PointIndex::search(const Eigen::Vector3d& p, Visit visit, Limit limit) const {
    if (nodes_.empty()) return;
    struct Pending {
        std::uint32_t node;
        double square; ///< no point of the node is nearer than its root
    };
    std::array<Pending, kDeepest> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, 0.0};
    while (depth > 0) {
        Pending at = stack[--depth];
        if (at.square > limit()) continue;
        while (nodes_[at.node].upper != 0) {
            const Node& node = nodes_[at.node];
            const double off = p[node.axis] - node.split;
            const std::uint32_t lower = at.node + 1;
            stack[depth++] = {off < 0 ? node.upper : lower, std::max(at.square, off * off)};
            at.node = off < 0 ? lower : node.upper;
        }
        visit(nodes_[at.node].first, nodes_[at.node].count);
    }
}

std::vector<std::uint32_t> PointIndex::nearest(const Eigen::Vector3d& p, unsigned count) const {
    using Found = std::pair<double, std::uint32_t>; // square of the distance, index
    std::vector<Found> found;                       // a heap with the farthest on top
    if (count == 0) return {};
    found.reserve(count + 1);
    search(
        p,
        [&](std::uint32_t first, std::uint32_t points) {
            for (std::uint32_t n = first; n < first + points; ++n) {
                const Found one{(ordered_[n] - p).squaredNorm(), order_[n]};
                if (found.size() == count && !(one < found.front())) continue;
                found.push_back(one);
                std::ranges::push_heap(found);
                if (found.size() <= count) continue;
                std::ranges::pop_heap(found);
                found.pop_back();
            }
        },
        [&] { return found.size() < count ? std::numeric_limits<double>::infinity() : found.front().first; });
    std::ranges::sort_heap(found);
    std::vector<std::uint32_t> indices;
    for (const Found& one : found) indices.push_back(one.second);
    return indices;
}

std::optional<std::uint32_t> PointIndex::nearest(const Eigen::Vector3d& p) const {
    std::pair<double, std::uint32_t> best{std::numeric_limits<double>::infinity(), 0};
    search(
        p,
        [&](std::uint32_t first, std::uint32_t points) {
            for (std::uint32_t n = first; n < first + points; ++n) best = std::min(best, {(ordered_[n] - p).squaredNorm(), order_[n]});
        },
        [&] { return best.first; });
    return std::isfinite(best.first) ? std::optional(best.second) : std::nullopt;
}

double PointIndex::distance(const Eigen::Vector3d& p, double mostM) const {
    const double limit = mostM * mostM;
    double least = std::numeric_limits<double>::infinity();
    search(
        p,
        [&](std::uint32_t first, std::uint32_t points) {
            for (std::uint32_t n = first; n < first + points; ++n) least = std::min(least, (ordered_[n] - p).squaredNorm());
        },
        [&] { return std::min(limit, least); });
    return least <= limit ? std::sqrt(least) : std::numeric_limits<double>::infinity();
}

} // namespace edgescan::inspect
