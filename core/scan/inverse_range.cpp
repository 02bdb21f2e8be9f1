// The sweep in inverse range.
#include "core/scan/inverse_range.h"

#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/scan/cartesian.h"
#include "core/scan/line_window.h"
#include "core/scan/marked_cells.h"
#include "core/scan/missing_cells.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace edgescan {
namespace {

constexpr float kVoidU = 1.0F / 60.0F;
constexpr float kLeastRangeMm = 0.001F; // nearer there is nothing to measure, and 1 / r stays a number
constexpr int kLongestGap = 4;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kQuantile = 0.40;
constexpr double kQuantileOfNormal = 0.524; // 40 % of |N(0, 1)| lie below
constexpr std::size_t kFewestPerBin = 400;
constexpr double kBinM = 1.0;
constexpr std::size_t kBins = 60;
constexpr std::size_t kCellsForNoise = 250000;
constexpr std::size_t kCellsForSpacing = 50000;

// What was measured becomes inverse range; `isolated`: 255 where a cell stands alone.
EDGESCAN_SIMD void takeMeasured(const float* rangeMm, const CellState* state, const std::uint8_t* isolated, int beams, float* __restrict u,
                                std::uint8_t* __restrict measured, Support* __restrict support) {
    for (int j = 0; j < beams; ++j) {
        const bool valid = (state[j] == CellState::Valid) & (isolated[j] == 0) & (rangeMm[j] >= kLeastRangeMm);
        measured[j] = valid ? 1 : 0;
        support[j] = valid ? Support::Measured : Support::Void;
        u[j] = valid ? 1000.0F / rangeMm[j] : kVoidU;
    }
}

// 1 at measured cells that end a gap of 1 to 4 cells.
EDGESCAN_SIMD void findGapEnds(const std::uint8_t* measured, std::ptrdiff_t step, int beams, std::uint8_t* __restrict ends) {
    static_assert(kLongestGap == 4);
    for (int j = 0; j < beams; ++j) {
        const int before = measured[j - 2 * step] | measured[j - 3 * step] | measured[j - 4 * step] | measured[j - 5 * step];
        ends[j] = static_cast<std::uint8_t>(measured[j] & ~measured[j - step] & before);
    }
}

// How far apart the two ends of a filled gap along the beams are, 1/m.
float apartAlongBeams(const InverseRange& inverse, std::size_t hole) {
    std::size_t before = hole;
    std::size_t after = hole;
    while (inverse.support[before] != Support::Measured) --before;
    while (inverse.support[after] != Support::Measured) ++after;
    return std::abs(inverse.u[after] - inverse.u[before]);
}

// Fills the gap before cell `end`; cells are `step` apart. A hole that was filled along the beams already keeps the filling whose ends are
// more alike.
void fillGap(InverseRange& inverse, std::size_t end, std::size_t step) {
    std::size_t gap = 1;
    while (inverse.support[end - (gap + 1) * step] != Support::Measured) ++gap;
    const std::size_t start = end - (gap + 1) * step;
    const float from = inverse.u[start];
    const float apart = std::abs(inverse.u[end] - from);
    const float slope = (inverse.u[end] - from) / static_cast<float>(gap + 1);
    for (std::size_t g = 1; g <= gap; ++g) {
        const std::size_t hole = start + g * step;
        if (inverse.support[hole] == Support::Filled && apartAlongBeams(inverse, hole) <= apart) continue;
        inverse.u[hole] = from + slope * static_cast<float>(g);
        inverse.support[hole] = Support::Filled;
    }
}

AngularSteps polarSteps(const PolarGeometry& polar) {
    const auto stepOf = [](const std::vector<double>& deg, std::size_t i) {
        if (deg.size() < 2) return 1.0;
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = i + 1 == deg.size() ? i : i + 1;
        return std::max(1e-6, std::abs(deg[b] - deg[a]) / static_cast<double>(b - a));
    };
    AngularSteps steps;
    for (std::size_t j = 0; j < polar.beamDeg.size(); ++j) {
        const double a = polar.beamDeg[j] * kRadPerDeg;
        steps.beam.push_back(static_cast<float>(stepOf(polar.beamDeg, j) * kRadPerDeg));
        steps.fromAxis.push_back(static_cast<float>(std::max(std::abs(polar.axis == Axis::Sweep ? std::sin(a) : std::cos(a)), 0.02)));
    }
    for (std::size_t i = 0; i < polar.lineDeg.size(); ++i) steps.line.push_back(static_cast<float>(stepOf(polar.lineDeg, i) * kRadPerDeg));
    return steps;
}

// How far the inner cells of a line lie off the straight line of their neighbours, metres, and the bin of their range: the one after the
// last where one of the three was not measured or is too far.
EDGESCAN_SIMD void offStraight(const float* u, const Support* support, int beams, float* __restrict off, std::uint8_t* __restrict bin) {
    static_assert(kBinM == 1 && kBins < 256);
    for (int j = 1; j < beams - 1; ++j) {
        const float range = 1.0F / u[j];
        const bool measured =
            (support[j - 1] == Support::Measured) & (support[j] == Support::Measured) & (support[j + 1] == Support::Measured);
        off[j] = std::abs(u[j - 1] - 2 * u[j] + u[j + 1]) * range * range;
        const int metres = static_cast<int>(range < static_cast<float>(kBins) ? range : static_cast<float>(kBins));
        bin[j] = static_cast<std::uint8_t>(measured ? metres : static_cast<int>(kBins));
    }
}

// The end of the run of cells that begins at `from`, all of one bin.
std::size_t endOfRun(const std::vector<std::uint8_t>& bins, std::size_t from, std::size_t end) {
    std::uint64_t eight = 0;
    const std::uint64_t all = bins[from] * 0x0101010101010101U;
    std::size_t j = from;
    for (; j + sizeof eight <= end; j += sizeof eight) {
        std::memcpy(&eight, bins.data() + j, sizeof eight);
        if (eight != all) break;
    }
    while (j < end && bins[j] == bins[from]) ++j;
    return j;
}

float medianAngle(std::vector<float>& angles) { return std::max(median(std::move(angles), static_cast<float>(0.5 * kRadPerDeg)), 1e-6F); }

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
            std::vector<float>(static_cast<std::size_t>(scan.lines()), medianAngle(alongLines)),
            std::vector<float>(static_cast<std::size_t>(scan.beams()), 1.0F)};
}

} // namespace

InverseRange inverseRange(const Scan& scan) {
    const auto beams = static_cast<std::size_t>(scan.beams());
    InverseRange inverse{Grid<float>(scan.lines(), scan.beams(), std::vector<float>()), Grid<Support>(scan.lines(), scan.beams())};
    inverse.u.cells.reserve(scan.cells());
    IsolatedLines isolatedLines(scan);
    std::vector<std::uint8_t> isolated(beams);
    LineWindow<std::uint8_t> measured(scan.beams(), kLongestGap + 2); // 1 or 0
    std::vector<std::uint8_t> gapEnds(beams);
    for (int i = 0; i < scan.lines(); ++i) {
        isolatedLines.next(isolated.data());
        std::uint8_t* line = measured.next();
        inverse.u.cells.resize(inverse.u.index(i + 1, 0));
        takeMeasured(scan.rangeMm.line(i), scan.state.line(i), isolated.data(), scan.beams(), inverse.u.line(i), line,
                     inverse.support.line(i));
        const auto fillGaps = [&](std::ptrdiff_t stepOfMeasured, std::size_t step) {
            findGapEnds(line, stepOfMeasured, scan.beams(), gapEnds.data());
            forEachMarked(gapEnds, [&](std::size_t beam) { fillGap(inverse, inverse.u.index(i, 0) + beam, step); });
        };
        fillGaps(1, 1);
        fillGaps(measured.stride, beams);
    }
    return inverse;
}

AngularSteps angularSteps(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar != nullptr) return polarSteps(*polar);
    const auto& angles = std::get<PointGeometry>(scan.geometry).angles;
    return angles ? polarSteps(*angles) : cameraSteps(scan);
}

RangeNoise rangeNoise(const InverseRange& inverse) {
    std::vector<std::vector<float>> bins(kBins);
    // A quarter of a million cells tell it well enough.
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCellsForNoise));
    const auto beams = static_cast<std::size_t>(inverse.u.beams);
    std::vector<float> off(beams);
    std::vector<std::uint8_t> binOf(beams);
    for (int i = std::min(every, inverse.u.lines) / 2; i < inverse.u.lines; i += every) {
        offStraight(inverse.u.line(i), inverse.support.line(i), inverse.u.beams, off.data(), binOf.data());
        for (std::size_t from = 1, end = 0; from + 1 < beams; from = end) {
            end = endOfRun(binOf, from, beams - 1);
            if (binOf[from] == kBins) continue;
            std::vector<float>& values = bins[binOf[from]];
            values.insert(values.end(), off.begin() + static_cast<std::ptrdiff_t>(from), off.begin() + static_cast<std::ptrdiff_t>(end));
        }
    }
    double weight = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (std::size_t b = 0; b < kBins; ++b) {
        const std::vector<float>& values = bins[b];
        if (values.size() < kFewestPerBin) continue;
        const float quantile = nthSmallest(values, static_cast<std::size_t>(kQuantile * static_cast<double>(values.size())));
        const double sigmaMm = 1000.0 * quantile / std::sqrt(6.0) / kQuantileOfNormal;
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
    return {std::max(0.0, (sumY - slope * sumX) / weight), slope, 0};
}

double pointSpacingMm(const InverseRange& inverse, const AngularSteps& steps) {
    std::vector<float> areas; // m2
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCellsForSpacing));
    for (int i = std::min(every, inverse.u.lines) / 2; i < inverse.u.lines; i += every) {
        const float* u = inverse.u.line(i);
        const Support* support = inverse.support.line(i);
        for (int j = 0; j < inverse.u.beams; ++j) {
            if (support[j] == Support::Measured)
                areas.push_back(steps.beam[static_cast<std::size_t>(j)] * steps.lineAt(i, j) / (u[j] * u[j]));
        }
    }
    return areas.empty() ? 0 : 1000.0 * std::sqrt(static_cast<double>(nthSmallest(areas, areas.size() / 2)));
}

} // namespace edgescan
