// Columns to turns, and a turn to a grid.
#include "core/robots/spinning/turns.h"
#include "core/base/number_text.h"

#include "core/base/order_statistic.h"
#include "core/base/utc_time.h"
#include "core/scan/grid/acquisition.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace edgescan::robots {
namespace {

constexpr double kTurnDeg = 360.0;
constexpr double kGap = 1.5;            // steps from column to column: others are missing between them
constexpr std::size_t kMostLost = 4096; // lines of a turn

double aheadDeg(const SpinningColumn& from, const SpinningColumn& to) {
    const double ahead = std::fmod(to.azimuthDeg - from.azimuthDeg, kTurnDeg);
    return ahead < 0 ? ahead + kTurnDeg : ahead;
}

double usualStepDeg(const std::vector<SpinningColumn>& columns, std::size_t first, std::size_t last) {
    std::vector<double> steps;
    for (std::size_t n = first + 1; n < last; ++n) steps.push_back(aheadDeg(columns[n - 1], columns[n]));
    return median(std::move(steps));
}

/// Degrees per second over a turn; 0: not known.
double rateOf(const std::vector<SpinningColumn>& columns, std::size_t first, std::size_t last, double turnedDeg) {
    const auto seconds = static_cast<double>(columns[last - 1].timeNs - columns[first].timeNs) * 1e-9;
    return seconds > 0 ? turnedDeg / seconds : 0.0;
}

} // namespace

std::vector<std::size_t> turnsOf(const std::vector<SpinningColumn>& columns) {
    std::vector<std::size_t> firsts;
    for (std::size_t n = 0; n < columns.size(); ++n) {
        if (n == 0 || columns[n].azimuthDeg < columns[n - 1].azimuthDeg - kTurnDeg / 2) firsts.push_back(n);
    }
    return firsts;
}

Scan scanOfTurn(const std::vector<SpinningColumn>& columns, std::size_t first, std::size_t last, const SpinningBeams& beams) {
    const double step = usualStepDeg(columns, first, last);
    std::vector<std::size_t> columnOf; // by line; `last`: lost
    PolarGeometry polar;
    std::size_t lost = 0;
    double deg = columns[first].azimuthDeg;
    for (std::size_t n = first; n < last; ++n) {
        const double ahead = n > first ? aheadDeg(columns[n - 1], columns[n]) : 0.0;
        const bool gap = n > first && step > 0 && ahead > kGap * step && ahead < kTurnDeg / 2;
        const auto missing = gap ? static_cast<std::size_t>(std::lround(ahead / step)) - 1 : 0;
        for (std::size_t m = 1; m <= missing && lost < kMostLost; ++m, ++lost) {
            columnOf.push_back(last);
            polar.lineDeg.push_back(deg + ahead * static_cast<double>(m) / static_cast<double>(missing + 1));
        }
        deg += ahead < kTurnDeg / 2 ? ahead : 0.0;
        columnOf.push_back(n);
        polar.lineDeg.push_back(deg);
    }
    const auto lines = static_cast<int>(columnOf.size()), count = static_cast<int>(beams.elevationDeg.size());
    Scan scan;
    scan.unitMm = beams.unitMm;
    scan.rangeMm = Grid<float>(lines, count);
    scan.state = Grid<CellState>(lines, count);
    scan.intensity = Grid<float>(lines, count);
    for (int i = 0; i < lines; ++i) {
        const std::size_t n = columnOf[static_cast<std::size_t>(i)];
        for (int j = 0; j < count; ++j) {
            const auto beam = static_cast<std::size_t>(j);
            const float range = n < last ? columns[n].rangeMm[beam] : 0.0F;
            scan.rangeMm.at(i, j) = range;
            scan.state.at(i, j) = n == last ? CellState::Lost : range > 0 ? CellState::Valid : CellState::NoReturn;
            scan.intensity.at(i, j) = range > 0 ? columns[n].reflection[beam] : std::nanf("");
        }
    }
    const double rate = rateOf(columns, first, last, deg - columns[first].azimuthDeg);
    polar.beamDeg = beams.elevationDeg;
    polar.axis = Axis::Spin;
    polar.lineDirection = beams.clockwise ? -1.0 : 1.0;
    for (std::size_t j = 0; j < beams.elevationDeg.size() && (!beams.laterS.empty() || !beams.azimuthDeg.empty()); ++j)
        polar.lineSkewDeg.push_back((beams.laterS.empty() ? 0.0 : rate * beams.laterS[j]) +
                                    (beams.azimuthDeg.empty() ? 0.0 : beams.azimuthDeg[j]));
    scan.geometry = std::move(polar);
    if (lost > 0)
        scan.warnings.push_back(counted(lost, "line of the turn is missing in the capture and is shown as lost.",
                                        "lines of the turn are missing in the capture and are shown as lost."));
    auto device = std::make_shared<Acquisition>();
    device->vendor = beams.vendor;
    device->model = beams.model;
    device->startUtc = utcText(static_cast<double>(columns[first].timeNs) * 1e-9);
    device->endUtc = utcText(static_cast<double>(columns[last - 1].timeNs) * 1e-9);
    device->clockSource = "the capturing computer's clock, carried on by the scanner's";
    scan.acquisition = std::move(device);
    return scan;
}

} // namespace edgescan::robots
