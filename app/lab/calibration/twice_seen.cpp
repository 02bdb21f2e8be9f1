// Finds the two views of one place.
#include "app/lab/calibration/twice_seen.h"

#include "app/lab/calibration/surface_fits.h"
#include "core/base/angles.h"
#include "core/scan/georef/rotations.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr double kHalfTurnDeg = 180.0;
constexpr double kOffAxisDeg = 4.0;                      // closer to the axis the line angle is undefined
constexpr int kNewtonSteps = 4, kNewtonStepsAtEnds = 16; // spin; sweep, where a small shift changes the line angle by much
constexpr double kLongestStep = 0.1;                     // radians

double skewAt(const PolarGeometry& polar, int beam) {
    return polar.lineSkewDeg.empty() ? 0.0 : polar.lineSkewDeg[static_cast<std::size_t>(beam)];
}

// A fixed permutation that looks random.
std::uint32_t scattered(std::size_t k) {
    std::uint64_t x = (k + 1) * 0x9E3779B97F4A7C15ULL;
    x ^= x >> 29U;
    return static_cast<std::uint32_t>((x * 0xBF58476D1CE4E5B9ULL) >> 32U);
}

} // namespace

int nearestAngle(const std::vector<double>& deg, double at) {
    const bool ascends = deg.back() >= deg.front();
    const auto place = ascends ? std::lower_bound(deg.begin(), deg.end(), at)
                               : std::lower_bound(deg.begin(), deg.end(), at, [](double a, double b) { return a > b; });
    if (place == deg.begin()) return 0;
    if (place == deg.end()) return static_cast<int>(deg.size()) - 1;
    const bool before = std::abs(*(place - 1) - at) < std::abs(*place - at);
    return static_cast<int>(place - deg.begin()) - (before ? 1 : 0);
}

double lineDegAt(const PolarGeometry& polar, int line, int beam) {
    return polar.lineDeg[static_cast<std::size_t>(line)] + skewAt(polar, beam);
}

int nearestLine(const PolarGeometry& polar, int beam, double atDeg) { return nearestAngle(polar.lineDeg, atDeg - skewAt(polar, beam)); }

SeenCell seenCell(const PolarGeometry& polar, int line, int beam, double rangeM) {
    const double a = radians(polar.beamDeg[static_cast<std::size_t>(beam)]);
    return {line, beam, lineDegAt(polar, line, beam), {rangeM * std::cos(a), 0, rangeM * std::sin(a)}};
}

double turnOf(const PolarGeometry& polar) {
    const auto [least, most] = std::minmax_element(polar.lineDeg.begin(), polar.lineDeg.end());
    return polar.lineDeg.empty() ? 0.0 : *most - *least;
}

LineSpan lateLines(const PolarGeometry& polar) {
    if (polar.lineDeg.empty()) return {};
    const double first = *std::min_element(polar.lineDeg.begin(), polar.lineDeg.end());
    const auto isLate = [&](double deg) { return deg - first >= kHalfTurnDeg && deg - first <= 2 * kHalfTurnDeg; };
    const auto from = std::find_if(polar.lineDeg.begin(), polar.lineDeg.end(), isLate);
    const auto to = std::find_if(polar.lineDeg.rbegin(), polar.lineDeg.rend(), isLate).base();
    return from < to ? LineSpan{static_cast<int>(from - polar.lineDeg.begin()), static_cast<int>(to - from)} : LineSpan{};
}

std::vector<SeenCell> cellsSeenTwice(const PolarGeometry& polar, const InverseRange& inverse, View view, std::size_t most) {
    const double first = *std::min_element(polar.lineDeg.begin(), polar.lineDeg.end());
    const double turn = turnOf(polar);
    // Beyond a full turn the same line angles come again; only the first turn is used.
    const double from = view == View::Late ? kHalfTurnDeg : 0.0;
    const double to = view == View::Late ? std::min(turn, 2 * kHalfTurnDeg) : std::min(turn - kHalfTurnDeg, kHalfTurnDeg);
    SurfaceFits smooth(inverse, 1);
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    for (int i = 0; i < inverse.u.lines; ++i) {
        const double at = polar.lineDeg[static_cast<std::size_t>(i)] - first;
        if (at < from || at > to) continue;
        for (int j = 0; j < inverse.u.beams; ++j) {
            const double offAxis = std::abs(polar.beamDeg[static_cast<std::size_t>(j)] - 90.0);
            if (inverse.isMeasured(i, j) && offAxis > kOffAxisDeg)
                order.emplace_back(scattered(inverse.u.index(i, j)), inverse.u.index(i, j));
        }
    }
    std::sort(order.begin(), order.end());
    std::vector<SeenCell> cells;
    for (const auto& [unused, k] : order) {
        if (cells.size() == most) break;
        const int i = static_cast<int>(k / static_cast<std::size_t>(inverse.u.beams));
        const int j = static_cast<int>(k % static_cast<std::size_t>(inverse.u.beams));
        if (!smooth.at(i, j).usable) continue;
        cells.push_back(seenCell(polar, i, j, 1.0 / static_cast<double>(inverse.u[k])));
    }
    return cells;
}

MountingWithErrors mountingWithErrors(const PolarGeometry& polar, const AssemblyErrors& errors) {
    return {polar.axis, sensorInMover(polar.axis, errors), polar.lineDirection * errors.turnFactor()};
}

std::optional<OtherView> otherViewOf(const SeenCell& cell, View view, const MountingWithErrors& mounting) {
    const auto& [axis, mount, turnedDeg] = mounting;
    const Eigen::Vector3d inMover = mount * cell.inSensorM;
    const double half = view == View::Late ? -kHalfTurnDeg : kHalfTurnDeg;
    // Only the stepper's angle between the two views matters: `apart` rotates the mover from the cell's line to the other one.
    double apart = radians(turnedDeg * half);
    Eigen::Vector3d inSensor;
    const int steps = axis == Axis::Spin ? kNewtonSteps : kNewtonStepsAtEnds;
    for (int step = 0; step <= steps; ++step) {
        const double c = std::cos(apart), s = std::sin(apart);
        const Eigen::Vector3d p = axis == Axis::Spin
                                      ? Eigen::Vector3d(c * inMover.x() + s * inMover.y(), c * inMover.y() - s * inMover.x(), inMover.z())
                                      : Eigen::Vector3d(inMover.x(), c * inMover.y() + s * inMover.z(), c * inMover.z() - s * inMover.y());
        inSensor = mount.rotation.transpose() * (p - mount.translationM);
        if (step == steps) break;
        const Eigen::Vector3d moves = axis == Axis::Spin ? Eigen::Vector3d(p.y(), -p.x(), 0) : Eigen::Vector3d(0, p.z(), -p.y());
        const double slope = mount.rotation.col(1).dot(moves);
        if (!(std::abs(slope) > 1e-6)) return std::nullopt;
        apart -= std::clamp(inSensor.y() / slope, -kLongestStep, kLongestStep);
    }
    if (!(std::abs(inSensor.y()) < 1e-4 * (1.0 + cell.inSensorM.norm()))) return std::nullopt;
    double beamDeg = degrees(std::atan2(inSensor.z(), inSensor.x()));
    if (beamDeg < -90.0) beamDeg += 360.0;
    return OtherView{cell.lineDeg + degrees(apart) / turnedDeg, beamDeg, inSensor.norm()};
}

} // namespace edgescan::inspect
