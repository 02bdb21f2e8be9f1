// A search per point, on two threads where that is faster.
#include "core/inspect/registration/cloud_distance.h"

#include "core/base/bands.h"
#include "core/base/order_statistic.h"

#include <cmath>
#include <limits>

namespace edgescan::inspect {

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

} // namespace edgescan::inspect
