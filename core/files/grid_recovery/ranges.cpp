// Intervals of range that rounding allows, and the whole numbers in them.
#include "core/files/grid_recovery/ranges.h"

#include <algorithm>
#include <cmath>

namespace edgescan::files {
namespace {

constexpr double kOfOthers = 0.25; // of the points that have a whole number in reach only by chance: at most so many do not have one
constexpr double kByChance = 0.9;  // where more have one anyway, nothing is shown
constexpr std::size_t kFewest = 60;
constexpr double kSlack = 0.02; // of the rounding: directions are known this well

struct Interval {
    double low = 0.0, high = 0.0;
};
Interval allowed(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, const Precision& precision) {
    Interval reach{0.0, 1e12};
    for (int axis = 0; axis < 3; ++axis) {
        const double error = (precision.absolute + precision.relative * std::abs(point[axis])) * (1 + kSlack);
        const double along = std::abs(direction[axis]);
        if (along < 1e-3) continue; // nearly at right angles: shows the direction, not the range
        const double middle = point[axis] / direction[axis];
        reach.low = std::max(reach.low, middle - error / along);
        reach.high = std::min(reach.high, middle + error / along);
    }
    return reach;
}

} // namespace

std::vector<float> wholeRangesMm(const DirectedPoints& points) {
    std::vector<float> whole;
    if (points.pointMm.size() < kFewest) return whole;
    whole.reserve(points.pointMm.size());
    std::size_t may = 0;
    double chance = 0;
    for (std::size_t k = 0; k < points.pointMm.size(); ++k) {
        const Interval reach = allowed(points.pointMm[k], points.direction[k], points.precision);
        const double measured = points.pointMm[k].dot(points.direction[k]);
        const double first = std::ceil(reach.low);
        const double last = std::floor(reach.high);
        may += first <= last ? 1 : 0;
        chance += std::clamp(reach.high - reach.low, 0.0, 1.0);
        whole.push_back(static_cast<float>(first <= last ? std::clamp(std::round(measured), first, last) : measured));
    }
    const auto all = static_cast<double>(points.pointMm.size());
    if (all - static_cast<double>(may) > kOfOthers * (all - chance) || chance > kByChance * all) return {};
    return whole;
}

} // namespace edgescan::files
