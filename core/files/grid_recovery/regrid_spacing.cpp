// Finds the step at which points seen from the sensor close to a surface.
#include "core/files/grid_recovery/regrid_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace edgescan::files::regridding {
namespace {

// Share of the neighbours of filled cells that are filled. Cells of the points' own spacing, laid askew, give about 0.8; random points, two
// to a cell, 0.86. From 0.91 on surfaces hide what is behind them, and rocks keep their outlines (tried on river boulders, a Livox cloud).
constexpr double kClosed = 0.91;
constexpr double kClosedEnough = 0.85; // where real holes keep the rest open, which so many points to a cell show:
constexpr double kPlentyPerCell = 5;
constexpr double kNearlyBest = 0.95; // of the largest share, where strewn points never come that far
constexpr double kFinest = 64;       // cells per point to begin with, because clouds fill small parts of their windows
constexpr double kMostCells = 5e8;

struct Cells {
    std::size_t across = 0, down = 0;
};
Cells cellsOf(const Window& window, double stepAcross, double stepDown) {
    return {static_cast<std::size_t>(window.width() / stepAcross) + 1, static_cast<std::size_t>(window.height() / stepDown) + 1};
}

} // namespace

Cover coverOf(const std::vector<Sight>& sights, const Window& window, double stepAcross, double stepDown, bool sidewaysOnly) {
    const Cells cells = cellsOf(window, stepAcross, stepDown);
    const std::size_t stride = cells.across + 2; // an empty cell all around
    std::vector<bool> filled(stride * (cells.down + 2), false);
    std::vector<std::size_t> first;
    for (const Sight& s : sights) {
        if (!window.holds(s)) continue;
        const auto i = static_cast<std::size_t>((s.down - window.top) / stepDown) + 1;
        const auto j = static_cast<std::size_t>((s.across - window.left) / stepAcross) + 1;
        const std::size_t at = i * stride + j;
        if (filled[at]) continue;
        filled[at] = true;
        first.push_back(at);
    }
    std::size_t neighbours = 0;
    for (const std::size_t at : first) {
        neighbours += (filled[at - 1] ? 1U : 0U) + (filled[at + 1] ? 1U : 0U);
        if (sidewaysOnly) continue;
        for (const std::size_t row : {at - stride, at + stride})
            neighbours += (filled[row - 1] ? 1U : 0U) + (filled[row] ? 1U : 0U) + (filled[row + 1] ? 1U : 0U);
    }
    const double all = static_cast<double>(first.size()) * (sidewaysOnly ? 2 : 8);
    return {first.size(), all > 0 ? static_cast<double>(neighbours) / all : 0.0};
}

double spacingOf(const std::vector<Sight>& sights, const Window& window, double lineStep) {
    const bool fan = lineStep > 0;
    const double area = fan ? window.width() * (window.height() / lineStep + 1) : window.width() * window.height();
    const double perPoint = std::max(area, 1e-30) / static_cast<double>(sights.size());
    double step = fan ? perPoint / kFinest : std::sqrt(perPoint / kFinest);
    const double longest = std::max(window.width(), fan ? 0.0 : window.height());
    const auto cellCount = [&](double s) { return (window.width() / s + 3) * (window.height() / (fan ? lineStep : s) + 3); };
    while (cellCount(step) > kMostCells) step *= 2;
    std::vector<std::pair<double, double>> tried; // step, closed
    for (; step < longest / 8; step *= std::numbers::sqrt2) {
        const auto [filled, closed] = coverOf(sights, window, step, fan ? lineStep : step, fan);
        if (closed < kClosed) {
            if (closed >= kClosedEnough && static_cast<double>(sights.size()) >= kPlentyPerCell * static_cast<double>(filled)) return step;
            tried.emplace_back(step, closed);
            continue;
        }
        if (tried.empty()) return step;
        return step / std::pow(std::numbers::sqrt2, (closed - kClosed) / std::max(closed - tried.back().second, 1e-9));
    }
    if (tried.empty()) return step;
    const double best = std::max_element(tried.begin(), tried.end(), [](auto& a, auto& b) { return a.second < b.second; })->second;
    return std::find_if(tried.begin(), tried.end(), [&](auto& t) { return t.second >= kNearlyBest * best; })->first;
}

} // namespace edgescan::files::regridding
