// Compares how much the ranges along both possible axes differ from line to line.
#include "core/scan/grid/axis_from_ranges.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan {
namespace {

constexpr double kForwardDeg = 90.0, kEnd0Deg = 0.0, kEnd180Deg = 180.0;
constexpr double kOffAxisDeg = 0.5;      // beams that count as along the axis
constexpr int kFewestLines = 80;         // with a return along the axis
constexpr double kMostAlongAxisMm = 400; // lever arm and boresight turn the beam about the axis
constexpr double kLeastOtherMm = 500;    // of the beams across the axis
constexpr double kTimesMore = 5;

/// The difference between the 10th and the 90th percentile of the ranges at this angle, one per line; empty: fewer than half of the lines
/// have a return there.
std::optional<double> spreadMm(const Grid<float>& rangeMm, const Grid<CellState>& state, const std::vector<double>& beamDeg, double atDeg) {
    std::vector<int> near;
    for (std::size_t j = 0; j < beamDeg.size(); ++j) {
        if (std::abs(beamDeg[j] - atDeg) <= kOffAxisDeg) near.push_back(static_cast<int>(j));
    }
    std::vector<float> ofLines;
    for (int i = 0; i < rangeMm.lines; ++i) {
        std::vector<float> ofBeams;
        for (const int j : near) {
            if (state.at(i, j) == CellState::Valid) ofBeams.push_back(rangeMm.at(i, j));
        }
        if (!ofBeams.empty()) ofLines.push_back(median(std::move(ofBeams)));
    }
    const std::size_t count = ofLines.size();
    if (count < kFewestLines || 2 * count < static_cast<std::size_t>(rangeMm.lines)) return std::nullopt;
    return valueInOrder(ofLines, count - 1 - count / 10) - valueInOrder(ofLines, count / 10);
}

bool isAlongAxis(double spread, double other) {
    return spread <= kMostAlongAxisMm && other >= kLeastOtherMm && other >= kTimesMore * spread;
}

} // namespace

std::optional<Axis> axisFromRanges(const Grid<float>& rangeMm, const Grid<CellState>& state, const std::vector<double>& beamDeg) {
    const auto forward = spreadMm(rangeMm, state, beamDeg, kForwardDeg);
    const auto at0 = spreadMm(rangeMm, state, beamDeg, kEnd0Deg), at180 = spreadMm(rangeMm, state, beamDeg, kEnd180Deg);
    if (!forward || (!at0 && !at180)) return std::nullopt;
    const double least = std::min(at0.value_or(*at180), at180.value_or(*at0)), most = std::max(at0.value_or(*at180), at180.value_or(*at0));
    if (isAlongAxis(*forward, least)) return Axis::Spin;
    if (isAlongAxis(most, *forward)) return Axis::Sweep;
    return std::nullopt;
}

} // namespace edgescan
