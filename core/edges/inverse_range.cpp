// The sweep in inverse range.
#include "core/edges/inverse_range.h"

#include "core/edges/holes.h"
#include "core/scan/cartesian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan {
namespace {

constexpr float kVoidU = 1.0F / 60.0F;
constexpr int kLongestGap = 4;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kQuantile = 0.40;
constexpr double kQuantileOfNormal = 0.524; // 40 % of |N(0, 1)| lie below
constexpr std::size_t kFewestPerBin = 400;
constexpr double kBinM = 1.0;
constexpr std::size_t kBins = 60;
constexpr std::size_t kCellsForNoise = 250000;
constexpr std::size_t kCellsForSpacing = 50000;

// Inverse ranges that short gaps between two measured cells of a line would get, and how far apart its two ends are.
struct Filling {
    Grid<float> u;
    Grid<float> apart; // 1/m; negative: no filling
};

// `count` cells from `first`, `stride` apart; the filling whose ends are more alike stays.
void fillGaps(const InverseRange& inverse, std::size_t first, std::size_t stride, int count, Filling& filling) {
    int last = -1; // place of the last cell with a value
    for (int n = 0; n < count; ++n) {
        const std::size_t k = first + static_cast<std::size_t>(n) * stride;
        if (inverse.support[k] != Support::Measured) continue;
        const int gap = n - last - 1;
        if (last >= 0 && gap > 0 && gap <= kLongestGap) {
            const float from = inverse.u[first + static_cast<std::size_t>(last) * stride];
            const float apart = std::abs(inverse.u[k] - from);
            const float step = (inverse.u[k] - from) / static_cast<float>(gap + 1);
            for (int g = 1; g <= gap; ++g) {
                const std::size_t hole = first + static_cast<std::size_t>(last + g) * stride;
                if (filling.apart[hole] >= 0 && filling.apart[hole] <= apart) continue;
                filling.apart[hole] = apart;
                filling.u[hole] = from + step * static_cast<float>(g);
            }
        }
        last = n;
    }
}

AngularSteps polarSteps(const Scan& scan, const PolarGeometry& polar) {
    const auto stepOf = [](const std::vector<double>& deg, std::size_t i) {
        if (deg.size() < 2) return 1.0;
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = i + 1 == deg.size() ? i : i + 1;
        return std::max(1e-6, std::abs(deg[b] - deg[a]) / static_cast<double>(b - a));
    };
    AngularSteps steps{std::vector<float>(static_cast<std::size_t>(scan.beams())), Grid<float>(scan.lines(), scan.beams())};
    for (std::size_t j = 0; j < steps.beam.size(); ++j) steps.beam[j] = static_cast<float>(stepOf(polar.beamDeg, j) * kRadPerDeg);
    std::vector<float> fromAxis;
    for (const double deg : polar.beamDeg) {
        const double a = deg * kRadPerDeg;
        fromAxis.push_back(static_cast<float>(std::max(std::abs(polar.axis == Axis::Sweep ? std::sin(a) : std::cos(a)), 0.02)));
    }
    for (int i = 0; i < scan.lines(); ++i) {
        const auto lineStep = static_cast<float>(stepOf(polar.lineDeg, static_cast<std::size_t>(i)) * kRadPerDeg);
        float* line = steps.line.line(i);
        for (std::size_t j = 0; j < fromAxis.size(); ++j) line[j] = lineStep * fromAxis[j];
    }
    return steps;
}

float medianAngle(std::vector<float>& angles) {
    if (angles.empty()) return static_cast<float>(0.5 * kRadPerDeg);
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    return std::max(*middle, 1e-6F);
}

// A camera's rays are nearly evenly apart: one angle per direction does.
AngularSteps cameraSteps(const Scan& scan) {
    const CartesianTables tables(scan);
    std::vector<float> alongBeams;
    std::vector<float> alongLines;
    const auto angle = [&](int i, int j, int i2, int j2) {
        const Eigen::Vector3d a = tables.direction(i, j);
        const Eigen::Vector3d b = tables.direction(i2, j2);
        return static_cast<float>((a - b).norm());
    };
    for (int i = 0; i + 1 < scan.lines(); i += 3) {
        for (int j = 0; j + 1 < scan.beams(); j += 3) {
            const float right = angle(i, j, i, j + 1);
            const float below = angle(i, j, i + 1, j);
            if (std::isfinite(right)) alongBeams.push_back(right);
            if (std::isfinite(below)) alongLines.push_back(below);
        }
    }
    return {std::vector<float>(static_cast<std::size_t>(scan.beams()), medianAngle(alongBeams)),
            Grid<float>(scan.lines(), scan.beams(), medianAngle(alongLines))};
}

} // namespace

InverseRange inverseRange(const Scan& scan) {
    InverseRange inverse{Grid<float>(scan.lines(), scan.beams(), kVoidU), Grid<Support>(scan.lines(), scan.beams(), Support::Void)};
    const Grid<std::uint8_t> isolated = isolatedCells(scan);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid || isolated[k] != 0 || scan.rangeMm[k] <= 0) continue;
        inverse.u[k] = 1000.0F / scan.rangeMm[k];
        inverse.support[k] = Support::Measured;
    }
    const auto beams = static_cast<std::size_t>(scan.beams());
    Filling filling{Grid<float>(scan.lines(), scan.beams()), Grid<float>(scan.lines(), scan.beams(), -1.0F)};
    for (int i = 0; i < scan.lines(); ++i) fillGaps(inverse, static_cast<std::size_t>(i) * beams, 1, scan.beams(), filling);
    for (int j = 0; j < scan.beams(); ++j) fillGaps(inverse, static_cast<std::size_t>(j), beams, scan.lines(), filling);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (inverse.support[k] == Support::Measured || filling.apart[k] < 0) continue;
        inverse.u[k] = filling.u[k];
        inverse.support[k] = Support::Filled;
    }
    return inverse;
}

AngularSteps angularSteps(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    return polar != nullptr ? polarSteps(scan, *polar) : cameraSteps(scan);
}

RangeNoise rangeNoise(const InverseRange& inverse) {
    std::vector<std::vector<float>> bins(kBins);
    // A quarter of a million cells tell it well enough.
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCellsForNoise));
    for (int i = every / 2; i < inverse.u.lines; i += every) {
        const float* u = inverse.u.line(i);
        const Support* support = inverse.support.line(i);
        for (int j = 1; j + 1 < inverse.u.beams; ++j) {
            if (support[j - 1] != Support::Measured || support[j] != Support::Measured || support[j + 1] != Support::Measured) continue;
            const float rangeM = 1.0F / u[j];
            const auto bin = static_cast<std::size_t>(rangeM / kBinM);
            if (bin < kBins) bins[bin].push_back(std::abs(u[j - 1] - 2 * u[j] + u[j + 1]) * rangeM * rangeM);
        }
    }
    double weight = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (std::size_t b = 0; b < kBins; ++b) {
        std::vector<float>& values = bins[b];
        if (values.size() < kFewestPerBin) continue;
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(values.size()));
        std::nth_element(values.begin(), place, values.end());
        const double sigmaMm = 1000.0 * *place / std::sqrt(6.0) / kQuantileOfNormal;
        const double x = (static_cast<double>(b) + 0.5) * kBinM;
        const auto w = static_cast<double>(values.size());
        weight += w;
        sumX += w * x;
        sumY += w * sigmaMm;
        sumXX += w * x * x;
        sumXY += w * x * sigmaMm;
    }
    if (weight == 0) return {};
    const double spread = weight * sumXX - sumX * sumX;
    const double slope = spread > 1e-9 * weight * weight ? std::max(0.0, (weight * sumXY - sumX * sumY) / spread) : 0.0;
    return {std::max(0.0, (sumY - slope * sumX) / weight), slope};
}

double pointSpacingMm(const InverseRange& inverse, const AngularSteps& steps) {
    std::vector<float> areas; // m2
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCellsForSpacing));
    for (int i = every / 2; i < inverse.u.lines; i += every) {
        const float* u = inverse.u.line(i);
        const Support* support = inverse.support.line(i);
        const float* across = steps.line.line(i);
        for (int j = 0; j < inverse.u.beams; ++j) {
            if (support[j] == Support::Measured) areas.push_back(steps.beam[static_cast<std::size_t>(j)] * across[j] / (u[j] * u[j]));
        }
    }
    if (areas.empty()) return 0.0;
    const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    return 1000.0 * std::sqrt(static_cast<double>(*middle));
}

} // namespace edgescan
