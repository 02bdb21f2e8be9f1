// Searches rings of buckets around the place until no farther ring can hold a nearer point.
#include "app/lab/calibration/plane_buckets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgescan::inspect {
namespace {

constexpr double kPointsPerBucket = 8;
constexpr int kMostBuckets = 512; // along one side

} // namespace

PlaneBuckets::PlaneBuckets(const std::vector<Eigen::Vector2d>& points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!points_.empty()) {
        Eigen::Vector2d high = low_ = points_.front();
        for (const Eigen::Vector2d& p : points_) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
        const Eigen::Vector2d size = high - low_;
        const double wanted = std::sqrt(size.x() * size.y() * kPointsPerBucket / static_cast<double>(points_.size()));
        side_ = std::max({wanted, size.maxCoeff() / kMostBuckets, 1e-12});
        columns_ = static_cast<int>(size.x() / side_) + 1;
        rows_ = static_cast<int>(size.y() / side_) + 1;
    }
    const auto bucketOf = [&](std::size_t n) {
        return static_cast<std::size_t>(row(points_[n].y())) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column(points_[n].x()));
    };
    std::ranges::stable_sort(order_, {}, bucketOf);
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (std::size_t n = 0; n < points_.size(); ++n) ++first_[bucketOf(n) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

int PlaneBuckets::column(double x) const { return static_cast<int>(std::clamp((x - low_.x()) / side_, 0.0, columns_ - 1.0)); }
int PlaneBuckets::row(double y) const { return static_cast<int>(std::clamp((y - low_.y()) / side_, 0.0, rows_ - 1.0)); }

std::vector<std::size_t> PlaneBuckets::nearest(const Eigen::Vector2d& at, std::size_t count) const {
    count = std::min(count, points_.size());
    if (count == 0) return {};
    std::vector<std::pair<double, std::size_t>> found;
    const int middleColumn = column(at.x()), middleRow = row(at.y());
    const auto addBucket = [&](int r, int c) {
        if (r < 0 || r >= rows_ || c < 0 || c >= columns_) return;
        const std::size_t bucket = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        for (std::size_t n = first_[bucket]; n < first_[bucket + 1]; ++n)
            found.emplace_back((points_[order_[n]] - at).squaredNorm(), order_[n]);
    };
    // A point beyond ring n is at least n bucket sides away; from a place outside the points it is farther still.
    const int last = std::max(columns_, rows_);
    for (int ring = 0; ring <= last; ++ring) {
        if (found.size() >= count && ring > 0) {
            const auto kth = found.begin() + static_cast<std::ptrdiff_t>(count) - 1;
            std::nth_element(found.begin(), kth, found.end());
            const double sure = (ring - 1) * side_;
            if (kth->first <= sure * sure) break;
        }
        for (int c = middleColumn - ring; c <= middleColumn + ring; ++c) {
            addBucket(middleRow - ring, c);
            if (ring > 0) addBucket(middleRow + ring, c);
        }
        for (int r = middleRow - ring + 1; r <= middleRow + ring - 1; ++r) {
            addBucket(r, middleColumn - ring);
            addBucket(r, middleColumn + ring);
        }
    }
    std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
    std::vector<std::size_t> indices(count);
    std::transform(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), indices.begin(),
                   [](const auto& one) { return one.second; });
    return indices;
}

} // namespace edgescan::inspect
