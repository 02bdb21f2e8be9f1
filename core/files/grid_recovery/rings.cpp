// Rings of angle groups.
#include "core/files/grid_recovery/rings.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace edgescan::files::recognition {
namespace {

constexpr std::size_t kThresholdsTried = 4;
constexpr double kSmallestVoid = 1e-9; // radians; closer angles are the same in any file

} // namespace

Ring::Nearest Ring::nearest(double angle) const {
    if (centres.size() == 1) return {0, std::abs(std::remainder(angle - centres[0], period)), period};
    const double at = centres[0] + std::fmod(std::fmod(angle - centres[0], period) + period, period);
    const auto right = static_cast<std::size_t>(std::upper_bound(centres.begin(), centres.end(), at) - centres.begin()); // at least 1
    const double left = at - centres[right - 1];
    const double next = (right < centres.size() ? centres[right] : centres[0] + period);
    const bool toLeft = left <= next - at;
    return {toLeft ? right - 1 : right % centres.size(), toLeft ? left : next - at, next - centres[right - 1]};
}

std::vector<double> Ring::voids() const {
    std::vector<double> widths;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        widths.push_back(i + 1 < centres.size() ? centres[i + 1] - centres[i] : centres[0] + period - centres[i]);
    }
    return widths;
}

void Ring::beginAt(std::size_t first) {
    std::rotate(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(first), centres.end());
    for (std::size_t i = 1; i < centres.size(); ++i) {
        while (centres[i] < centres[i - 1]) centres[i] += period;
    }
}

bool Ring::cutAtWidestVoid() {
    if (centres.size() < 2) return true;
    const std::vector<double> widths = voids();
    const auto widest = std::max_element(widths.begin(), widths.end());
    const double usual = median(widths);
    if (*widest > 1.3 * usual) {
        beginAt(static_cast<std::size_t>(widest - widths.begin() + 1) % centres.size());
        return true;
    }
    std::size_t first = 0;
    const auto fromZero = [&](double centre) { return std::fmod(centre + usual / 2 + 2 * period, period); };
    for (std::size_t i = 1; i < centres.size(); ++i) {
        if (fromZero(centres[i]) < fromZero(centres[first])) first = i;
    }
    const double start = fromZero(centres[first]) - usual / 2;
    beginAt(first);
    const double shift = start - centres[0];
    for (double& centre : centres) centre += shift;
    return false;
}

std::vector<Ring> ringsIn(std::vector<double> angles, double period) {
    std::vector<Ring> rings;
    if (angles.size() < 4) return rings;
    for (double& angle : angles) angle = std::fmod(std::fmod(angle, period) + period, period);
    std::sort(angles.begin(), angles.end());
    std::vector<double> voids(angles.size());
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) voids[i] = angles[i + 1] - angles[i];
    voids.back() = angles.front() + period - angles.back();
    std::vector<double> widest = voids;
    const std::size_t most = angles.size() / kPointsPerGroup;
    const auto needed = widest.begin() + static_cast<std::ptrdiff_t>(most + 1);
    std::nth_element(widest.begin(), needed - 1, widest.end(), std::greater<>());
    std::sort(widest.begin(), needed, std::greater<>()); // twice as fast as a partial sort of a third
    std::vector<std::pair<double, std::size_t>> steps;   // how much narrower the next void is, number of groups
    for (std::size_t i = 0; i < most; ++i)
        steps.emplace_back(std::max(widest[i], kSmallestVoid) / std::max(widest[i + 1], kSmallestVoid), i + 1);
    const std::size_t tried = std::min(kThresholdsTried, steps.size());
    std::partial_sort(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(tried), steps.end(), std::greater<>());
    for (std::size_t t = 0; t < tried && steps[t].first > 1.5; ++t) {
        const double threshold = widest[steps[t].second - 1];
        Ring ring;
        ring.period = period;
        const auto from =
            static_cast<std::size_t>(std::find_if(voids.begin(), voids.end(), [&](double v) { return v >= threshold; }) - voids.begin()) +
            1;
        double sum = 0;
        double count = 0;
        for (std::size_t n = 0; n < angles.size(); ++n) {
            const std::size_t i = (from + n) % angles.size();
            sum += angles[i] + (from + n >= angles.size() ? period : 0.0);
            ++count;
            if (voids[i] < threshold) continue;
            ring.centres.push_back(sum / count);
            sum = count = 0;
        }
        ring.cutAtWidestVoid();
        rings.push_back(std::move(ring));
    }
    return rings;
}

} // namespace edgescan::files::recognition
