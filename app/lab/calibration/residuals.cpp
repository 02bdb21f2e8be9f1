// Residuals by the chain rule: only the place of the other view is differentiated numerically. Differences of the residual itself would
// jump wherever the nearest cell changes.
#include "app/lab/calibration/residuals.h"

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr std::array<double, AssemblyErrors::kCount> kSteps{0.5, 0.5, 0.01, 0.01, 0.01}; // mm and degrees
constexpr double kFarthestBeam = 1.0; // cells from the middle of a fit: with extrapolation the estimate for a turn of 180 degrees fails
constexpr double kFarthestLine = 1.5;
constexpr double kAngleSdDeg = 0.015;

/// The step from each angle to the next one, never 0.
std::vector<double> stepsOf(const std::vector<double>& deg) {
    std::vector<double> steps(deg.size(), 1.0);
    for (std::size_t i = 0; i < deg.size() && deg.size() > 1; ++i) {
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = std::min(i + 1, deg.size() - 1);
        const double step = (deg[b] - deg[a]) / static_cast<double>(b - a);
        steps[i] = std::abs(step) > 1e-6 ? step : 1e-6;
    }
    return steps;
}

/// The assembly with the assumed errors, and with each error a step larger and smaller.
struct Mountings {
    MountingWithErrors here;
    std::array<MountingWithErrors, AssemblyErrors::kCount> greater, smaller;
};

Mountings mountingsOf(const PolarGeometry& polar, const AssemblyErrors& errors) {
    Mountings all{mountingWithErrors(polar, errors), {}, {}};
    for (std::size_t q = 0; q < AssemblyErrors::kCount; ++q) {
        AssemblyErrors more = errors, less = errors;
        more.values[q] += kSteps[q];
        less.values[q] -= kSteps[q];
        all.greater[q] = mountingWithErrors(polar, more);
        all.smaller[q] = mountingWithErrors(polar, less);
    }
    return all;
}

std::optional<Residual> residualOf(const PreparedSweep& sweep, SurfaceFits& fits, const SeenCell& cell, View view,
                                   const Mountings& mountings) {
    const std::optional<OtherView> seen = otherViewOf(cell, view, mountings.here);
    if (!seen) return std::nullopt;
    const int beam = nearestAngle(sweep.polar.beamDeg, seen->beamDeg);
    const int line = nearestLine(sweep.polar, beam, seen->lineDeg);
    const double lineStep = sweep.lineSteps[static_cast<std::size_t>(line)];
    const double beamStep = sweep.beamSteps[static_cast<std::size_t>(beam)];
    const double dx = (seen->beamDeg - sweep.polar.beamDeg[static_cast<std::size_t>(beam)]) / beamStep;
    const double dy = (seen->lineDeg - lineDegAt(sweep.polar, line, beam)) / lineStep;
    if (std::abs(dx) > kFarthestBeam || std::abs(dy) > kFarthestLine) return std::nullopt;
    const SurfaceFit& fit = fits.at(line, beam);
    if (!fit.usable) return std::nullopt;

    Residual residual;
    residual.line = residual.shares = cell.line;
    residual.beam = cell.beam;
    const Eigen::Vector3d x(1.0, dx, dy);
    const double toMm = 1000.0 * seen->rangeM * seen->rangeM;
    residual.apartMm = (fit.c.dot(x) - 1.0 / seen->rangeM) * toMm;
    const double perDegree = std::hypot(fit.c[1] / beamStep, fit.c[2] / lineStep) * toMm;
    const double leverage = x.dot(fit.inverseNormal * x);
    residual.sigmaMm = std::sqrt(std::pow(std::max(1.0, sweep.noise.at(seen->rangeM)), 2) + fit.misfitMm * fit.misfitMm * (1.0 + leverage) +
                                 std::pow(perDegree * kAngleSdDeg, 2));
    for (std::size_t q = 0; q < AssemblyErrors::kCount; ++q) {
        const std::optional<OtherView> above = otherViewOf(cell, view, mountings.greater[q]);
        const std::optional<OtherView> below = otherViewOf(cell, view, mountings.smaller[q]);
        if (!above || !below) return std::nullopt;
        const double slope = fit.c[1] * (above->beamDeg - below->beamDeg) / beamStep +
                             fit.c[2] * (above->lineDeg - below->lineDeg) / lineStep - (1.0 / above->rangeM - 1.0 / below->rangeM);
        residual.slope[static_cast<Eigen::Index>(q)] = slope * toMm / (2 * kSteps[q]);
    }
    return residual;
}

} // namespace

PreparedSweep preparedSweep(const Scan& scan, const PolarGeometry& polar) {
    PreparedSweep sweep{polar, inverseRange(scan), {}, stepsOf(polar.lineDeg), stepsOf(polar.beamDeg)};
    sweep.noise = noiseByRange(sweep.inverse);
    return sweep;
}

std::vector<Residual> residualsOf(const PreparedSweep& sweep, SurfaceFits& fits, const std::vector<SeenCell>& cells, View view,
                                  const AssemblyErrors& errors) {
    std::vector<Residual> residuals;
    const Mountings mountings = mountingsOf(sweep.polar, errors);
    for (const SeenCell& cell : cells) {
        if (std::optional<Residual> residual = residualOf(sweep, fits, cell, view, mountings)) residuals.push_back(*residual);
    }
    return residuals;
}

} // namespace edgescan::inspect
