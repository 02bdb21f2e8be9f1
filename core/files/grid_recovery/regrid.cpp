// Looks at a cloud from the sensor, chooses a view and a step, and lets the nearest return win each cell.
#include "core/files/grid_recovery/regrid.h"
#include "core/base/translated_text.h"

#include "core/base/angles.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/parts.h"
#include "core/files/grid_recovery/rings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace edgescan::files {
namespace {

using recognition::AxisPoint;
using recognition::kPi;
using recognition::Ring;

/// A return as seen from the sensor. Radians, growing to the right and downwards.
struct Sight {
    double across = 0.0;
    double down = 0.0;
    double range = 0.0;
    std::uint32_t point = 0;
};

struct Window {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    [[nodiscard]] bool holds(const Sight& s) const { return s.across >= left && s.across <= right && s.down >= top && s.down <= bottom; }
};

/// Cells of a step over a window: how many points fill, and how closed the filled area is.
struct Cover {
    std::size_t filled = 0;
    double closed = 0.0; ///< share of the neighbours of filled cells that are filled too
};

// Share of the neighbours of filled cells that are filled. Cells of the points' own spacing, laid askew, give about 0.8; random points, two
// to a cell, 0.86. From 0.91 on surfaces hide what is behind them, and rocks keep their outlines (tried on river boulders, a Livox cloud).
constexpr double kClosed = 0.91;
constexpr double kClosedEnough = 0.85; // where real holes keep the rest open, which so many points to a cell show:
constexpr double kPlentyPerCell = 5;
constexpr double kNearlyBest = 0.95; // of the largest share, where strewn points never come that far
constexpr double kFinest = 64;       // cells per point to begin with, because clouds fill small parts of their windows
constexpr double kMostTried = 5e8;

/// `sidewaysOnly`: neighbours are those in the same line.
Cover coverOf(const std::vector<Sight>& sights, const Window& window, double stepAcross, double stepDown, bool sidewaysOnly) {
    const std::size_t stride = static_cast<std::size_t>(window.width() / stepAcross) + 3; // with an empty cell all around
    std::vector<bool> filled(stride * (static_cast<std::size_t>(window.height() / stepDown) + 3), false);
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

/// The smallest step, radians, at which the filled area closes: between points that are neighbours in angle no cell stays empty.
/// For a fan (`lineStep` > 0) the step along the lines only.
double spacingOf(const std::vector<Sight>& sights, const Window& window, double lineStep) {
    const bool fan = lineStep > 0;
    const double area = fan ? window.width() * (window.height() / lineStep + 1) : window.width() * window.height();
    const double perPoint = std::max(area, 1e-30) / static_cast<double>(sights.size());
    double step = fan ? perPoint / kFinest : std::sqrt(perPoint / kFinest);
    const double longest = std::max(window.width(), fan ? 0.0 : window.height());
    const auto cellCount = [&](double s) { return (window.width() / s + 3) * (window.height() / (fan ? lineStep : s) + 3); };
    while (cellCount(step) > kMostTried) step *= 2;
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

/// Lines of a scanner among the sights of a cloud: rings about the sensor's upright axis (a spinning scanner with several beams), or
/// planes through one of the axes (a fan on a stepper whose beams are uneven). Empty when no lines are distinct.
struct Fan {
    std::vector<Sight> sights;     ///< `down` is the line's number
    std::vector<double> lineAngle; ///< radians, one per line
};

constexpr double kShareOnLines = 0.99;
constexpr std::size_t kFewestLines = 4;
constexpr std::size_t kPointsPerLine = 12; // on average, at least
constexpr std::size_t kSample = 60000;     // points of a first look: lines that do not show here do not exist

std::vector<AxisPoint> axisPointsOf(const LooseCloud& cloud, int axis) {
    std::vector<AxisPoint> seen;
    seen.reserve(cloud.points.size());
    for (const Eigen::Vector3d& p : cloud.points) {
        const Eigen::Vector3d ray = p - cloud.sensor;
        if (isReturn(p) && isReturn(ray))
            seen.push_back({ray[axis], ray[(axis + 1) % 3], ray[(axis + 2) % 3]});
        else
            seen.emplace_back();
    }
    return seen;
}

/// The clearest ring of groups that holds nearly all angles, among every `stride`-th point.
template <class Angle>
std::optional<Ring> linesAmong(const std::vector<AxisPoint>& points, std::size_t stride, double period, Angle angleOf) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < points.size(); k += stride) {
        if (!points[k].missing()) angles.push_back(angleOf(points[k]));
    }
    for (Ring& ring : recognition::ringsIn(angles, period)) {
        if (ring.centres.size() < kFewestLines || angles.size() < ring.centres.size() * kPointsPerLine) continue;
        const auto on = std::count_if(angles.begin(), angles.end(), [&](double angle) {
            const Ring::Nearest near = ring.nearest(angle);
            return near.distance <= 0.25 * near.voidWidth;
        });
        if (static_cast<double>(on) >= kShareOnLines * static_cast<double>(angles.size())) return std::move(ring);
    }
    return std::nullopt;
}

template <class Angle>
std::optional<Ring> linesIn(const std::vector<AxisPoint>& points, double period, Angle angleOf) {
    const std::size_t stride = points.size() / kSample | 1U; // odd, so that no place within a row is skipped
    if (stride > 1 && !linesAmong(points, stride, period, angleOf)) return std::nullopt;
    return linesAmong(points, 1, period, angleOf);
}

/// Rings about the upright axis: cones of one elevation each, as a spinning scanner with several beams leaves them.
std::optional<Fan> rings(const std::vector<AxisPoint>& points) {
    const auto elevation = [](const AxisPoint& p) { return std::asin(std::clamp(p.u / p.range(), -1.0, 1.0)); };
    const auto ring = linesIn(points, 2 * kPi, elevation);
    if (!ring) return std::nullopt;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const AxisPoint& p : points) sum += p.missing() ? Eigen::Vector2d::Zero() : Eigen::Vector2d(p.v, p.w).normalized();
    const double middle = std::atan2(sum.y(), sum.x());
    Fan fan;
    fan.lineAngle.assign(ring->centres.rbegin(), ring->centres.rend()); // the highest first
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        const AxisPoint& p = points[k];
        if (p.missing()) continue;
        const auto line = static_cast<double>(ring->centres.size() - 1 - ring->nearest(elevation(p)).group);
        fan.sights.push_back({-std::remainder(p.plane() - middle, 2 * kPi), line, p.range(), k});
    }
    return fan;
}

/// Planes through an axis: a fan that was turned step by step.
std::optional<Fan> planes(const std::vector<AxisPoint>& points) {
    const auto plane = [](const AxisPoint& p) { return p.plane(); };
    const auto ring = linesIn(points, kPi, plane);
    if (!ring) return std::nullopt;
    Fan fan;
    fan.lineAngle = ring->centres;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        const AxisPoint& p = points[k];
        if (p.missing()) continue;
        const std::size_t line = ring->nearest(p.plane()).group;
        const double radius = p.radiusIn(std::cos(ring->centres[line]), std::sin(ring->centres[line]));
        fan.sights.push_back({std::atan2(radius, p.u), static_cast<double>(line), p.range(), k});
    }
    return fan;
}

std::optional<Fan> findFan(const LooseCloud& cloud) {
    static constexpr std::array<int, 3> kUprightFirst{2, 0, 1};
    for (const int axis : kUprightFirst) {
        const std::vector<AxisPoint> points = axisPointsOf(cloud, axis);
        if (axis == 2) {
            if (auto fan = rings(points)) return fan;
        }
        if (auto fan = planes(points)) return fan;
    }
    return std::nullopt;
}

constexpr std::size_t kFewestReturns = 64;
constexpr double kNarrowestDeg = 2.0; // all points in less than that: the sensor cannot have been there
constexpr double kLeastClosed = 0.55; // as many neighbours are filled where points are strewn at random, one to every second cell
constexpr double kLeastFill = 0.01;
constexpr double kMostCells = 3e8;
constexpr std::uint64_t kBytesPerCell = 48; // until the cells are a scan: their points alone take 24

std::string number(double value) { return significantText(value, 3); }

/// The axes of the picture: forward, left, up as rows. Up is the z axis unless the cloud is above or below the sensor.
Eigen::Matrix3d viewOf(const std::vector<Eigen::Vector3d>& directions) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t steep = 0;
    for (const Eigen::Vector3d& d : directions) {
        sum += d;
        steep += std::abs(d.z()) > 0.77 ? 1 : 0; // more than 50 degrees up or down
    }
    const Eigen::Vector3d mean = sum / static_cast<double>(directions.size());
    const Eigen::Vector3d level(mean.x(), mean.y(), 0.0);
    const bool allRound = mean.norm() < 0.35;
    const bool upright = allRound || steep * 50 < directions.size();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d forward = level.norm() > 0.2 ? Eigen::Vector3d(level.normalized()) : Eigen::Vector3d::UnitX();
    if (!upright) {
        forward = mean.normalized();
        // Looking down (or up) the picture is oriented like a map: x to the right.
        if (std::abs(forward.z()) > 0.95) up = Eigen::Vector3d::UnitY();
        up = (up - up.dot(forward) * forward).normalized();
    }
    Eigen::Matrix3d view;
    view << forward.transpose(), up.cross(forward).transpose(), up.transpose();
    return view;
}

struct Directions {
    std::vector<Eigen::Vector3d> unit;
    std::vector<double> range;
    std::vector<std::uint32_t> point;
};
Directions directionsOf(const LooseCloud& cloud) {
    Directions seen;
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        const Eigen::Vector3d ray = cloud.points[k] - cloud.sensor;
        if (!isReturn(cloud.points[k]) || !isReturn(ray)) continue;
        seen.range.push_back(ray.norm());
        seen.unit.push_back(ray / seen.range.back());
        seen.point.push_back(static_cast<std::uint32_t>(k));
    }
    return seen;
}

std::vector<Sight> sightsOf(const Directions& seen, const Eigen::Matrix3d& view) {
    std::vector<Sight> sights;
    sights.reserve(seen.unit.size());
    for (std::size_t n = 0; n < seen.unit.size(); ++n) {
        const Eigen::Vector3d d = view * seen.unit[n];
        sights.push_back({-std::atan2(d.y(), d.x()), -std::asin(std::clamp(d.z(), -1.0, 1.0)), seen.range[n], seen.point[n]});
    }
    return sights;
}

template <class Value>
std::array<double, 4> extentOf(const std::vector<Sight>& sights, Value value) {
    std::vector<double> values;
    values.reserve(sights.size());
    for (const Sight& s : sights) values.push_back(value(s));
    return {quantile(values, 0.0), quantile(values, 0.0005), quantile(values, 0.9995), quantile(values, 1.0)};
}

/// All points, unless a few strays would at least double the window.
Window windowOf(const std::vector<Sight>& sights) {
    const auto across = extentOf(sights, [](const Sight& s) { return s.across; });
    const auto down = extentOf(sights, [](const Sight& s) { return s.down; });
    const Window all{across[0], across[3], down[0], down[3]};
    const double marginAcross = 0.05 * (across[2] - across[1]);
    const double marginDown = 0.05 * (down[2] - down[1]);
    const Window most{std::max(all.left, across[1] - marginAcross), std::min(all.right, across[2] + marginAcross),
                      std::max(all.top, down[1] - marginDown), std::min(all.bottom, down[2] + marginDown)};
    return most.width() * most.height() * 2 < all.width() * all.height() ? most : all;
}

std::string windowText(const Window& window) {
    return withValues("%1 x %2 degrees", {number(window.width() * kDegreesPerRadian), number(window.height() * kDegreesPerRadian)});
}

/// Two digits are enough for a step that is estimated.
double tidyStep(double radians) {
    const double degrees = radians * kDegreesPerRadian;
    const double scale = std::pow(10.0, std::floor(std::log10(degrees)) - 1);
    return std::round(degrees / scale) * scale / kDegreesPerRadian;
}

struct Lattice {
    Window window;
    double across = 0.0, down = 0.0; ///< steps, radians; of a fan `down` is 1 line
    int lines = 0, beams = 0;

    [[nodiscard]] std::size_t cellOf(const Sight& s) const {
        const int i = std::min(lines - 1, static_cast<int>((s.down - window.top) / down));
        const int j = std::min(beams - 1, static_cast<int>((s.across - window.left) / across));
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(beams) + static_cast<std::size_t>(j);
    }
};

Result<Lattice> latticeOver(const Window& window, double across, double down) {
    Lattice lattice{window, across, down, 0, 0};
    const double lines = std::max(1.0, std::ceil(window.height() / down - 1e-9));
    const double beams = std::max(1.0, std::ceil(window.width() / across - 1e-9));
    if (lines * beams > kMostCells) {
        return Error{withValues("cells of %1 degrees over %2 would be %3 million cells",
                                {number(across * kDegreesPerRadian), windowText(window), number(lines * beams / 1e6)}),
                     "", "give a larger --grid-step"};
    }
    if (auto enough = checkMemory(static_cast<std::uint64_t>(lines * beams) * kBytesPerCell, ""); !enough) return enough.error();
    lattice.lines = static_cast<int>(lines);
    lattice.beams = static_cast<int>(beams);
    return lattice;
}

void fillCells(Regridded& grid, const std::vector<Sight>& sights, const Lattice& lattice) {
    grid.pointOf = Grid<std::uint32_t>(lattice.lines, lattice.beams, Regridded::kNoPoint);
    std::vector<std::uint32_t> winner(grid.pointOf.size(), Regridded::kNoPoint); // index into sights
    for (std::uint32_t n = 0; n < sights.size(); ++n) {
        if (!lattice.window.holds(sights[n])) {
            ++grid.outside;
            continue;
        }
        std::uint32_t& cell = winner[lattice.cellOf(sights[n])];
        if (cell == Regridded::kNoPoint || sights[n].range < sights[cell].range) cell = n;
    }
    for (std::uint32_t n = 0; n < sights.size(); ++n) {
        if (!lattice.window.holds(sights[n])) continue;
        const std::size_t k = lattice.cellOf(sights[n]);
        if (winner[k] == n)
            grid.pointOf[k] = sights[n].point;
        else
            grid.hidden.push_back({static_cast<std::uint32_t>(k), sights[n].point});
    }
    std::stable_sort(grid.hidden.begin(), grid.hidden.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
    grid.filled = sights.size() - grid.outside - grid.hidden.size();
    const auto [nearest, farthest] = std::minmax_element(sights.begin(), sights.end(), [](auto& a, auto& b) { return a.range < b.range; });
    grid.nearest = nearest->range;
    grid.farthest = farthest->range;
}

Result<Regridded> onFan(const LooseCloud& cloud, const Fan& fan) {
    const Window window = windowOf(fan.sights);
    Window lines = window; // lines stay whole, however few points they have
    lines.top = -0.5;
    lines.bottom = static_cast<double>(fan.lineAngle.size()) - 0.5;
    const double step = cloud.stepDeg ? *cloud.stepDeg / kDegreesPerRadian : tidyStep(spacingOf(fan.sights, lines, 1.0));
    const auto lattice = latticeOver(lines, step, 1.0);
    if (!lattice) return lattice.error();
    Regridded grid;
    grid.fan = true;
    grid.returns = fan.sights.size();
    grid.beamStepDeg = step * kDegreesPerRadian;
    grid.lineStepDeg =
        std::abs(fan.lineAngle.back() - fan.lineAngle.front()) * kDegreesPerRadian / static_cast<double>(fan.lineAngle.size() - 1);
    grid.closed = coverOf(fan.sights, lines, step, 1.0, true).closed;
    fillCells(grid, fan.sights, *lattice);
    return grid;
}

Result<Regridded> onSphere(const LooseCloud& cloud, const Directions& seen) {
    const std::vector<Sight> sights = sightsOf(seen, viewOf(seen.unit));
    const Window window = windowOf(sights);
    if (std::max(window.width(), window.height()) * kDegreesPerRadian < kNarrowestDeg) {
        const auto [nearest, farthest] = std::minmax_element(seen.range.begin(), seen.range.end());
        return Error{withValues("all %1 points lie in one direction from there, within %2 and %3 to %4 away",
                                {sights.size(), windowText(window), significantText(*nearest, 6), significantText(*farthest, 6)}),
                     "", kGiveSensor};
    }
    const double step = cloud.stepDeg ? *cloud.stepDeg / kDegreesPerRadian : tidyStep(spacingOf(sights, window, 0.0));
    const auto lattice = latticeOver(window, step, step);
    if (!lattice) return lattice.error();
    Regridded grid;
    grid.returns = sights.size();
    grid.beamStepDeg = grid.lineStepDeg = step * kDegreesPerRadian;
    grid.closed = coverOf(sights, window, step, step, false).closed;
    fillCells(grid, sights, *lattice);
    return grid;
}

} // namespace

std::string accountOf(const Regridded& grid) {
    const auto cells = std::to_string(grid.pointOf.lines) + " x " + std::to_string(grid.pointOf.beams);
    std::string text =
        withValues(counted(grid.returns,
                           "point in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells "
                           "around a filled one %6 %), %7 attached to a cell with a nearer one",
                           "points in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells "
                           "around a filled one %6 %), %7 attached to a cell with a nearer one"),
                   {number(grid.beamStepDeg * grid.pointOf.beams), number(grid.lineStepDeg * grid.pointOf.lines), grid.filled, cells,
                    fixedText(100 * grid.fillRatio(), 1), fixedText(100 * grid.closed, 0), counted(grid.hidden.size(), "point")});
    if (grid.outside > 0) text += ", " + counted(grid.outside, "point far from all others left out", "points far from all others left out");
    return text;
}

Result<Regridded> regrid(const LooseCloud& cloud) {
    if (cloud.points.size() >= Regridded::kNoPoint) return Error{"holds more points than can be put on a grid", "", "split the file"};
    if (cloud.stepDeg && !(*cloud.stepDeg > 0 && *cloud.stepDeg <= 45))
        return Error{withValues("a grid step of %1 degrees makes no grid", {number(*cloud.stepDeg)}), "",
                     "give --grid-step between 0 and 45 degrees"};
    const Directions seen = directionsOf(cloud);
    if (seen.unit.size() < kFewestReturns) {
        return Error{
            withValues("only %1 a return, too few to make a grid of them", {counted(seen.unit.size(), "point has", "points have")}), "",
            "check that the file is complete"};
    }
    if (cloud.progress && !cloud.progress("projecting the points", 0.3)) return Error{"cancelled", "", ""};
    const auto fan = findFan(cloud);
    auto grid = fan ? onFan(cloud, *fan) : onSphere(cloud, seen);
    if (!grid) return grid;
    if (grid->closed < (cloud.stepDeg ? 0.0 : kLeastClosed) || grid->fillRatio() < kLeastFill) {
        return Error{withValues("seen from there the points make no picture: %1", {accountOf(*grid)}), "",
                     cloud.stepDeg ? "give a larger --grid-step, or another --sensor" : kGiveSensor};
    }
    if (cloud.progress && !cloud.progress("projecting the points", 1.0)) return Error{"cancelled", "", ""};
    return grid;
}

} // namespace edgescan::files
