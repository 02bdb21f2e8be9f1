// Converts the sweep to inverse range.
#include "core/scan/grid/inverse_range.h"

#include "core/base/bands.h"
#include "core/base/order_statistic.h"
#include "core/base/portable_math.h"
#include "core/base/simd.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/marked_cells.h"
#include "core/scan/grid/missing_cells.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>

namespace edgescan {
namespace {

constexpr float kVoidU = 1.0F / 60.0F;
constexpr float kLeastRangeMm = 0.001F; // smaller ranges are not measurements, and 1 / r stays finite
constexpr int kLongestGap = 4;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kQuantile = 0.40;
constexpr double kQuantileOfNormal = 0.524; // the quantile of |N(0, 1)| at 40 %
constexpr std::size_t kFewestPerBin = 400;
constexpr double kBinM = 1.0;
constexpr std::size_t kBins = 60;
constexpr std::size_t kCellsForNoise = 250000;
constexpr std::size_t kCellsForSpacing = 50000;

// Converts measured ranges to inverse range; `isolated`: 255 at isolated cells.
EDGESCAN_INLINE void invertMeasured(const float* rangeMm, const CellState* state, const std::uint8_t* isolated, int beams,
                                    float* __restrict u, Support* __restrict support) {
    for (int j = 0; j < beams; ++j) {
        const bool valid = (state[j] == CellState::Valid) & (isolated[j] == 0) & (rangeMm[j] >= kLeastRangeMm);
        support[j] = valid ? Support::Measured : Support::Void;
        u[j] = valid ? 1000.0F / rangeMm[j] : kVoidU;
    }
}

// 1 at measured cells that end a gap of 1 to 4 cells. Cells are `step` apart, `cells` of them come before the first one; the search needs
// five of these where they exist.
EDGESCAN_INLINE void findGapEnds(const Support* support, std::ptrdiff_t step, int cells, int beams, std::uint8_t* __restrict ends) {
    static_assert(kLongestGap == 4);
    // If there are fewer cells before, the last of them is used again.
    const std::ptrdiff_t three = std::min(3, cells) * step, four = std::min(4, cells) * step, five = std::min(5, cells) * step;
    for (int j = 0; j < beams; ++j) {
        const bool before = (support[j - 2 * step] == Support::Measured) | (support[j - three] == Support::Measured) |
                            (support[j - four] == Support::Measured) | (support[j - five] == Support::Measured);
        ends[j] = static_cast<std::uint8_t>((support[j] == Support::Measured) & (support[j - step] != Support::Measured) & before);
    }
}

// The difference between the two ends of a filled gap along the beams, 1/m.
float apartAlongBeams(const InverseRange& inverse, std::size_t hole) {
    std::size_t before = hole;
    std::size_t after = hole;
    while (inverse.support[before] != Support::Measured) --before;
    while (inverse.support[after] != Support::Measured) ++after;
    return std::abs(inverse.u[after] - inverse.u[before]);
}

// Fills the gap before cell `end`; cells are `step` apart. If a cell can be filled in both directions, the filling whose ends are more
// alike is used.
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

// Finds the gaps that end on a line and fills them. Gaps along the beams do not depend on other lines. Each missing cell belongs to one gap
// along the lines. So the order of the lines does not matter.
class GapEnds {
public:
    explicit GapEnds(int beams) : ends_(static_cast<std::size_t>(beams)) {}

    void fillAlongBeams(InverseRange& inverse, int line) {
        const int beams = inverse.u.beams;
        for (int before = 2; before < std::min(kLongestGap + 1, beams); ++before) find(inverse, line, before, 1, 1, before);
        if (beams > kLongestGap + 1) find(inverse, line, kLongestGap + 1, beams - kLongestGap - 1, 1, kLongestGap + 1);
    }
    void fillAlongLines(InverseRange& inverse, int line) {
        if (line >= 2) find(inverse, line, 0, inverse.u.beams, inverse.u.beams, line);
    }

private:
    // Searches `beams` beams from `beam` on, with `before` cells before them.
    void find(InverseRange& inverse, int line, int beam, int beams, int step, int before) {
        vectorised<findGapEnds>(inverse.support.line(line) + beam, step, before, beams, ends_.data());
        forEachMarked(std::span(ends_.data(), static_cast<std::size_t>(beams)),
                      [&](std::size_t place) { fillGap(inverse, inverse.u.index(line, beam) + place, static_cast<std::size_t>(step)); });
    }
    std::vector<std::uint8_t> ends_;
};

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
        steps.fromAxis.push_back(
            static_cast<float>(std::max(std::abs(polar.axis == Axis::Sweep ? portable::sin(a) : portable::cos(a)), 0.02)));
    }
    for (std::size_t i = 0; i < polar.lineDeg.size(); ++i) steps.line.push_back(static_cast<float>(stepOf(polar.lineDeg, i) * kRadPerDeg));
    return steps;
}

// The distance of the inner cells of a line from the straight line through their neighbours, in metres, and the bin of their range. The bin
// is the one behind the last if one of the three cells was not measured or is too far.
EDGESCAN_INLINE void offStraight(const float* u, const Support* support, int beams, float* __restrict off, std::uint8_t* __restrict bin) {
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

// The end of the run of cells of one bin that begins at `from`.
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

// A camera's rays are almost evenly spaced, so one angle per direction is enough.
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

InverseRange inverseRange(const Scan& scan, int threads) {
    const int lines = scan.lines(), beams = scan.beams();
    const int bands = std::clamp(bandsFor(scan.cells(), threads), 1, std::max(1, lines));
    InverseRange inverse{Grid<float>(lines, beams, std::vector<float>()), Grid<Support>(lines, beams)};
    inverse.u.cells.reserve(scan.cells());
    if (bands > 1) inverse.u.cells.resize(scan.cells());
    runInBands(lines, bands, [&](int first, int last) {
        IsolatedLines isolatedLines(scan, first);
        GapEnds ends(beams);
        std::vector<std::uint8_t> isolated(static_cast<std::size_t>(beams));
        for (int i = first; i < last; ++i) {
            isolatedLines.next(isolated.data());
            if (bands == 1) inverse.u.cells.resize(inverse.u.index(i + 1, 0)); // cleared while it is in the cache
            vectorised<invertMeasured>(scan.rangeMm.line(i), scan.state.line(i), isolated.data(), beams, inverse.u.line(i),
                                       inverse.support.line(i));
            ends.fillAlongBeams(inverse, i);
            if (bands == 1) ends.fillAlongLines(inverse, i);
        }
    });
    if (bands == 1) return inverse;
    // The first gap ends of a band read lines of the band before, and may close gaps there.
    constexpr int kLooksBack = kLongestGap + 1;
    const auto start = [&](int band) { return firstLineOfBand(lines, bands, band); };
    runInParallel(bands, [&](int band) {
        GapEnds ends(beams);
        for (int i = start(band) + kLooksBack; i < start(band + 1); ++i) ends.fillAlongLines(inverse, i);
    });
    GapEnds ends(beams);
    for (int band = 0; band < bands; ++band) {
        for (int i = start(band); i < std::min(start(band) + kLooksBack, start(band + 1)); ++i) ends.fillAlongLines(inverse, i);
    }
    return inverse;
}

AngularSteps angularSteps(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar != nullptr) return polarSteps(*polar);
    const auto& angles = std::get<PointGeometry>(scan.geometry).angles;
    return angles ? polarSteps(*angles) : cameraSteps(scan);
}

RangeNoise noiseByRange(const InverseRange& inverse) {
    std::vector<std::vector<float>> bins(kBins);
    // A quarter of a million cells are enough for the estimate.
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCellsForNoise));
    const auto beams = static_cast<std::size_t>(inverse.u.beams);
    std::vector<float> off(beams);
    std::vector<std::uint8_t> binOf(beams);
    for (int i = std::min(every, inverse.u.lines) / 2; i < inverse.u.lines; i += every) {
        vectorised<offStraight>(inverse.u.line(i), inverse.support.line(i), inverse.u.beams, off.data(), binOf.data());
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
