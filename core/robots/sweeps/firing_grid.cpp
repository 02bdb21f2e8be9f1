// Finds the period of the firings from the ring with most points, and the delay of each ring in it.
#include "core/robots/sweeps/firing_grid.h"
#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace edgescan::robots {
namespace {

constexpr std::size_t kFewestPoints = 8; // of the ring with most points
constexpr double kSameShot = 0.1;        // of a period: a second return of one shot
constexpr double kMostFirings = 10'000'000;

/// A period and the time of the first firing.
struct Clock {
    double first = 0, period = 0;
};

std::optional<Clock> clockOf(std::vector<double> times) {
    std::ranges::sort(times);
    std::vector<double> steps;
    for (std::size_t n = 1; n < times.size(); ++n) {
        if (times[n] > times[n - 1]) steps.push_back(times[n] - times[n - 1]);
    }
    if (steps.size() < kFewestPoints) return std::nullopt;
    const double usual = valueInOrder(steps, steps.size() / 4); // points that are missing make longer steps
    double firings = 0;
    for (std::size_t n = 1; n < times.size(); ++n) {
        const double step = (times[n] - times[n - 1]) / usual;
        if (step > kSameShot) firings += std::max(1.0, std::round(step));
    }
    const Clock clock{times.front(), (times.back() - times.front()) / firings};
    return firings < kMostFirings && clock.period > 0 ? std::optional(clock) : std::nullopt;
}

/// A firing begins behind the pause of all rings.
double behindWidestGap(std::vector<double> phases) {
    std::ranges::sort(phases);
    double begin = phases.front(), widest = phases.front() + 1 - phases.back();
    for (std::size_t n = 1; n < phases.size(); ++n) {
        if (phases[n] - phases[n - 1] <= widest) continue;
        widest = phases[n] - phases[n - 1];
        begin = phases[n];
    }
    return begin;
}

} // namespace

std::optional<std::vector<std::uint32_t>> firingsOf(std::span<const std::uint32_t> rings, std::span<const double> times) {
    struct Ring {
        std::vector<double> times;
        double cosine = 0, sine = 0; // sums of the phases
        double phase = 0;            // 0..1 of a period
    };
    std::map<std::uint32_t, Ring> all;
    for (std::size_t n = 0; n < rings.size(); ++n) {
        if (!std::isfinite(times[n])) return std::nullopt;
        all[rings[n]].times.push_back(times[n]);
    }
    if (all.size() < 2) return std::nullopt;
    const auto longest = std::ranges::max_element(all, {}, [](const auto& ring) { return ring.second.times.size(); });
    const auto clock = clockOf(longest->second.times);
    if (!clock) return std::nullopt;
    constexpr double kTurn = 2 * std::numbers::pi;
    double least = 0;
    for (auto& [number, ring] : all) {
        for (const double time : ring.times) {
            const double phase = kTurn * (time - clock->first) / clock->period;
            if (std::abs(phase) > kTurn * kMostFirings) return std::nullopt;
            ring.cosine += std::cos(phase);
            ring.sine += std::sin(phase);
        }
    }
    std::vector<double> phases;
    for (auto& [number, ring] : all) {
        const double phase = std::atan2(ring.sine, ring.cosine) / kTurn;
        phases.push_back(ring.phase = phase - std::floor(phase));
    }
    const double begin = behindWidestGap(phases);
    std::vector<double> firings(rings.size());
    for (std::size_t n = 0; n < rings.size(); ++n) {
        const double phase = all[rings[n]].phase - begin;
        firings[n] = std::round((times[n] - clock->first) / clock->period - begin - (phase - std::floor(phase)));
        least = std::min(least, firings[n]);
    }
    std::vector<std::uint32_t> numbers(rings.size());
    for (std::size_t n = 0; n < rings.size(); ++n) numbers[n] = static_cast<std::uint32_t>(firings[n] - least);
    return numbers;
}

} // namespace edgescan::robots
