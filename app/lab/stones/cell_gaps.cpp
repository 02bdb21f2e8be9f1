// Casts rays between neighbouring cells.
#include "app/lab/stones/cell_gaps.h"

#include "app/lab/sim/sweep.h"
#include "core/scan/georef/rotations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan::lab {
namespace {

constexpr std::size_t kBetween = 7; // rays

struct Turn {
    double cosine, sine;
};

Turn turnOf(double deg) { return {std::cos(radians(deg)), std::sin(radians(deg))}; }

Eigen::Vector3f directionOf(Axis axis, const Turn& beam, const Turn& line) {
    const Eigen::Vector3d direction = axis == Axis::Spin ? Eigen::Vector3d(beam.cosine * line.cosine, beam.cosine * line.sine, beam.sine)
                                                         : Eigen::Vector3d(beam.cosine, -beam.sine * line.sine, beam.sine * line.cosine);
    return direction.cast<float>();
}

/// Turns at the angles, and after each one the seven to the next.
std::vector<Turn> turnsBetween(const std::vector<double>& angles) {
    std::vector<Turn> turns;
    for (std::size_t n = 0; n < angles.size(); ++n) {
        const double step = n + 1 < angles.size() ? angles[n + 1] - angles[n] : 0.0;
        for (std::size_t k = 0; k <= kBetween; ++k) turns.push_back(turnOf(angles[n] + step * static_cast<double>(k) / (kBetween + 1)));
    }
    return turns;
}

double largestStepRad(const std::vector<double>& angles) {
    double largest = 0;
    for (std::size_t n = 1; n < angles.size(); ++n) largest = std::max(largest, std::abs(angles[n] - angles[n - 1]));
    return radians(largest);
}

/// The rays as the lanes of one bundle: first the middle one.
template <class DirectionAt>
sim::RayBundle bundleOf(DirectionAt at) {
    static_assert(kBetween < sim::kLanes);
    sim::RayBundle bundle{};
    for (std::size_t i = 0; i < sim::kLanes; ++i) {
        const std::size_t ray = i == 0 || i > kBetween ? (kBetween + 1) / 2 : i;
        const Eigen::Vector3f direction = at(ray);
        bundle.dx[i] = direction.x();
        bundle.dy[i] = direction.y();
        bundle.dz[i] = direction.z();
    }
    return bundle;
}

CellGap gapOf(const sim::BundleHits& hits, float fromM, float toM) {
    std::array<float, kBetween + 2> ranges{};
    ranges.front() = fromM;
    ranges.back() = toM;
    for (std::size_t k = 1; k <= kBetween; ++k) ranges[k] = hits.surface[k] < 0 ? 0.0F : hits.distanceM[k];
    CellGap gap;
    std::array<float, kBetween + 1> steps{};
    for (std::size_t k = 0; k + 1 < ranges.size(); ++k) {
        if (ranges[k] > 0.0F && ranges[k + 1] > 0.0F) steps[k] = std::abs(ranges[k + 1] - ranges[k]);
    }
    gap.open = std::ranges::find(ranges, 0.0F) != ranges.end();
    std::ranges::nth_element(steps, steps.begin() + 2, std::greater<>{});
    gap.thirdM = steps[2];
    gap.largestM = std::max(steps[0], steps[1]);
    return gap;
}

} // namespace

CellGaps cellGaps(const sim::Scene& scene, const PolarGeometry& angles, const Grid<float>& cleanMm,
                  const sim::SimulationSettings& settings) {
    // All rays are within 3/8 of a step of the middle one; the caster takes half of the divergence.
    const double step = std::max(largestStepRad(angles.beamDeg), largestStepRad(angles.lineDeg));
    const sim::RayCaster caster(scene, {0.0, 0.75 * step});
    const std::vector<Turn> beams = turnsBetween(angles.beamDeg), lines = turnsBetween(angles.lineDeg);
    CellGaps gaps{{cleanMm.lines, cleanMm.beams}, {cleanMm.lines, cleanMm.beams}};
    const auto castLine = [&](int line) {
        for (int beam = 0; beam < cleanMm.beams; ++beam) {
            const std::size_t k = cleanMm.index(line, beam);
            const std::size_t i = static_cast<std::size_t>(line) * (kBetween + 1), j = static_cast<std::size_t>(beam) * (kBetween + 1);
            const auto between = [&](std::size_t other, auto at) {
                if (cleanMm[k] == 0.0F && cleanMm[other] == 0.0F) return CellGap{0, 0, true};
                return gapOf(caster.cast(bundleOf(at)), 0.001F * cleanMm[k], 0.001F * cleanMm[other]);
            };
            if (beam + 1 < cleanMm.beams)
                gaps.toNextBeam[k] = between(k + 1, [&](std::size_t n) { return directionOf(angles.axis, beams[j + n], lines[i]); });
            if (line + 1 < cleanMm.lines)
                gaps.toNextLine[k] = between(k + static_cast<std::size_t>(cleanMm.beams),
                                             [&](std::size_t n) { return directionOf(angles.axis, beams[j], lines[i + n]); });
        }
    };
    sim::forAllLines(settings, {}, castLine);
    return gaps;
}

} // namespace edgescan::lab
