// The structure function of the noise, and its effect on folds.
#include "core/edges/edgescan_plus/noise_memory.h"

#include "core/base/order_statistic.h"
#include "core/edges/edgescan_plus/crease.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan::edges {
namespace {

constexpr std::size_t kCellsLookedAt = 10000; // per direction; half as many at lags that only show how the noise continues
constexpr std::size_t kLagsThatDecide = 2;
constexpr std::size_t kFoldsLookedAt = 6000; // per direction
constexpr std::size_t kFewestValues = 400;   // fewest values for the estimate of a spread
constexpr double kNil = 0.05;                // share of the RMS below which a difference counts as nil
constexpr double kMostNil = 0.20;            // share of nil differences above which the ranges come in steps
constexpr double kGrows = 1.15;              // least S(2) / S(1) of noise with memory
constexpr double kStopsGrowing = 1.05;       // S(next lag) / S(lag) below which the noise has stopped growing ...
constexpr double kReliefGrows = 1.6;         // ... and above which it is not noise: on a curved surface S grows by a factor of four
constexpr double kEighty = 1.2816;           // 80 % of |N(0, 1)| are below it
constexpr double kTrimmedAt = 2.7;           // standard deviations ...
constexpr double kTrimmedRms = 0.971;        // ... and the RMS of the remaining values of N(0, 1)
constexpr double kForty = 0.524;             // 40 % of |N(0, 1)| are below it
constexpr double kNearestBinM = 0.25;
constexpr double kBinFactor = 1.189207115; // four bins per doubling
constexpr std::size_t kRangeBins = 33;

using Bins = std::vector<std::vector<float>>;

// Bins of consecutive ranges: neighbours are similar, so the search begins at the last bin.
class RangeBins {
public:
    RangeBins() {
        for (double far = kNearestBinM * kBinFactor; double& end : ends_) {
            end = far;
            far *= kBinFactor;
        }
    }
    [[nodiscard]] std::size_t of(double rangeM) {
        while (bin_ + 1 < kRangeBins && rangeM >= ends_[bin_]) ++bin_;
        while (bin_ > 0 && rangeM < ends_[bin_ - 1]) --bin_;
        return bin_;
    }

private:
    std::array<double, kRangeBins> ends_{};
    std::size_t bin_ = 0;
};

double middleOf(std::size_t bin) {
    double near = kNearestBinM;
    for (std::size_t b = 0; b < bin; ++b) near *= kBinFactor;
    return near * std::sqrt(kBinFactor);
}

// The value that a share of the values is below; needs at least one value.
double shareBelow(const std::vector<float>& sizes, double share) {
    return static_cast<double>(nthSmallest(sizes, static_cast<std::size_t>(share * static_cast<double>(sizes.size() - 1))));
}

// Standard deviation of values given by their sizes, without outliers such as jumps and folds.
double trimmedRms(const std::vector<float>& sizes) {
    if (sizes.size() < kFewestValues) return 0;
    const double most = kTrimmedAt / kEighty * shareBelow(sizes, 0.8);
    double sum = 0;
    std::size_t count = 0;
    for (const float size : sizes) {
        if (static_cast<double>(size) > most) continue;
        sum += static_cast<double>(size) * static_cast<double>(size);
        ++count;
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, count))) / kTrimmedRms;
}

// A sweep seen in one direction.
struct NoiseWay {
    const InverseRange& inverse;
    Along along;

    [[nodiscard]] std::ptrdiff_t step() const { return along == Along::Beams ? 1 : inverse.u.beams; }
    [[nodiscard]] int placeOf(int line, int beam) const { return along == Along::Beams ? beam : line; }
    [[nodiscard]] int places() const { return along == Along::Beams ? inverse.u.beams : inverse.u.lines; }
};

// Calls `look(line, beam)` for about `wanted` cells, distributed evenly over the sweep.
template <class Look>
void forSome(const InverseRange& inverse, std::size_t wanted, const Look& look) {
    const double share = static_cast<double>(wanted) / static_cast<double>(std::max<std::size_t>(1, inverse.u.size()));
    const int every = std::max(1, static_cast<int>(std::sqrt(1 / share)));
    for (int i = every / 2; i < inverse.u.lines; i += every) {
        // Shifted from line to line, so that all columns are sampled.
        for (int j = (i / every) % every; j < inverse.u.beams; j += every) look(i, j);
    }
}

// |u[-lag] - 2 u + u[+lag]| r^2 in mm divided by sqrt(6); below 0 if a cell between them was not measured.
float differenceAt(const NoiseWay& way, int line, int beam, int lag) {
    const int place = way.placeOf(line, beam);
    if (place < lag || place + lag >= way.places()) return -1;
    const std::size_t at = way.inverse.u.index(line, beam);
    const auto cell = [&](int off) { return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + off * way.step()); };
    for (int off = -lag; off <= lag; ++off) {
        if (way.inverse.support[cell(off)] != Support::Measured) return -1;
    }
    const auto u = [&](int off) { return static_cast<double>(way.inverse.u[cell(off)]); };
    return static_cast<float>(1000.0 * std::abs(u(-lag) - 2 * u(0) + u(lag)) / (u(0) * u(0)) / std::sqrt(6.0));
}

// The same differences, in range bins.
Bins differencesByRange(const InverseRange& inverse, int lag, std::size_t cells) {
    Bins bins(kRangeBins);
    RangeBins bin;
    for (const Along along : {Along::Beams, Along::Lines}) {
        forSome(inverse, cells, [&](int i, int j) {
            const float size = differenceAt({inverse, along}, i, j, lag);
            if (size >= 0) bins[bin.of(1.0 / static_cast<double>(inverse.u.at(i, j)))].push_back(size);
        });
    }
    return bins;
}

// sigma = offset + growth r or sigma = offset + growth r^2, with both coefficients 0 or more; the one closer to the bins.
class NoiseLaw {
public:
    void add(double rangeM, double sigmaMm, std::size_t count) { bins_.push_back({rangeM, sigmaMm, static_cast<double>(count)}); }

    [[nodiscard]] RangeNoise fitted() const {
        if (bins_.empty()) return {};
        const Line linear = lineOver(1), square = lineOver(2);
        if (square.misfit < linear.misfit) return {square.offset, 0, square.slope};
        return {linear.offset, linear.slope, 0};
    }

private:
    struct Bin {
        double rangeM, sigmaMm, weight;
    };
    struct Line {
        double offset, slope, misfit;
    };

    [[nodiscard]] Line lineOver(int power) const {
        const auto xOf = [power](const Bin& bin) { return power == 1 ? bin.rangeM : bin.rangeM * bin.rangeM; };
        double w = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (const Bin& bin : bins_) {
            w += bin.weight;
            x += bin.weight * xOf(bin);
            y += bin.weight * bin.sigmaMm;
            xx += bin.weight * xOf(bin) * xOf(bin);
            xy += bin.weight * xOf(bin) * bin.sigmaMm;
        }
        const double spread = w * xx - x * x;
        Line line{y / w, 0, 0};
        if (spread > 1e-9 * w * xx) {
            line.slope = std::max(0.0, (w * xy - x * y) / spread);
            line.offset = (y - line.slope * x) / w;
            if (line.offset < 0) line = {0, xy / xx, 0}; // a line through 0 at 0 m
        }
        for (const Bin& bin : bins_) {
            const double off = line.offset + line.slope * xOf(bin) - bin.sigmaMm;
            line.misfit += bin.weight * off * off;
        }
        return line;
    }

    std::vector<Bin> bins_;
};

RangeNoise lawOf(const Bins& bins, double (*spread)(const std::vector<float>&)) {
    NoiseLaw law;
    for (std::size_t b = 0; b < bins.size(); ++b) {
        const std::size_t count = bins[b].size();
        if (count >= kFewestValues) law.add(middleOf(b), spread(bins[b]), count);
    }
    return law.fitted();
}

double spreadByForty(const std::vector<float>& sizes) { return shareBelow(sizes, 0.4) / kForty; }

// The white noise, in mm, that would cause a fold as large as the one at this cell; below 0 if it cannot be computed. Both sides contain
// the cell and `reach` more on smoothed ranges, as foldStrengths() fits them.
float foldAt(const NoiseWay& way, int line, int beam, int reach) {
    const InverseRange& inverse = way.inverse;
    const int place = way.placeOf(line, beam);
    if (place <= reach || place + reach + 1 >= way.places()) return -1;
    const int other = way.along == Along::Beams ? line : beam;
    if (other < 1 || other + 1 >= (way.along == Along::Beams ? inverse.u.lines : inverse.u.beams)) return -1;
    const std::ptrdiff_t step = way.step();
    const std::ptrdiff_t across = way.along == Along::Beams ? inverse.u.beams : 1;
    const auto at = static_cast<std::ptrdiff_t>(inverse.u.index(line, beam));
    // Sums of three cells each across the direction; below they are smoothed again along it.
    std::array<double, 2 * kFoldReach + 3> sums{};
    for (int off = -reach - 1; off <= reach + 1; ++off) {
        double sum = 0;
        for (int side = -1; side <= 1; ++side) {
            const auto cell = static_cast<std::size_t>(at + off * step + side * across);
            if (inverse.support[cell] != Support::Measured) return -1;
            sum += (side == 0 ? 0.5 : 0.25) * static_cast<double>(inverse.u[cell]);
        }
        sums[static_cast<std::size_t>(off + reach + 1)] = sum;
    }
    const auto smoothed = [&](int off) {
        const auto n = static_cast<std::size_t>(off + reach + 1);
        return 0.25 * sums[n - 1] + 0.5 * sums[n] + 0.25 * sums[n + 1];
    };
    const double middle = 0.5 * reach;
    double before = 0, after = 0;
    for (int off = 0; off <= reach; ++off) {
        before += (off - middle) * smoothed(-off);
        after += (off - middle) * smoothed(off);
    }
    const double count = reach + 1;
    const double spread = count * (count * count - 1) / 12;
    const double u = static_cast<double>(inverse.u[static_cast<std::size_t>(at)]);
    // Both slopes point outwards: on a plane they cancel. White noise of 1 mm gives their sum a standard deviation of kFoldOfWhite /
    // sqrt(spread), in mm.
    return static_cast<float>(1000.0 * std::abs(before + after) / (u * u) / std::sqrt(spread) / static_cast<double>(kFoldOfWhite));
}

int reachOfFold(double rangeM, double angleRad, double windowMm) {
    return static_cast<int>(std::clamp(0.001 * windowMm / (rangeM * angleRad) + 0.5, 3.0, static_cast<double>(kFoldReach - 1)));
}

} // namespace

NoiseScales noiseScales(const InverseRange& inverse, bool all) {
    NoiseScales scales;
    std::vector<float> ranges;
    forSome(inverse, kCellsLookedAt, [&](int i, int j) {
        if (inverse.isMeasured(i, j)) ranges.push_back(1.0F / inverse.u.at(i, j));
    });
    if (!ranges.empty()) scales.rangeM = static_cast<double>(nthSmallest(ranges, ranges.size() / 2));
    const auto measure = [&](std::size_t n) {
        std::vector<float> sizes;
        for (std::vector<float>& bin :
             differencesByRange(inverse, kNoiseLags[n], n < kLagsThatDecide ? kCellsLookedAt : kCellsLookedAt / 2))
            sizes.insert(sizes.end(), bin.begin(), bin.end());
        scales.sigmaMm[n] = trimmedRms(sizes);
        if (n > 0 || sizes.empty()) return;
        const auto nil =
            std::count_if(sizes.begin(), sizes.end(), [&](float size) { return static_cast<double>(size) < kNil * scales.sigmaMm[0]; });
        scales.nilShare = static_cast<double>(nil) / static_cast<double>(sizes.size());
    };
    for (std::size_t n = 0; n < kLagsThatDecide; ++n) measure(n);
    scales.inSteps = scales.nilShare > kMostNil;
    scales.remembered = scales.inSteps && scales.sigmaMm[1] > kGrows * scales.sigmaMm[0];
    // The large lags read far along the columns, which takes longer than all the rest: they are not needed for the noise of a laser.
    if (all || scales.remembered)
        for (std::size_t n = kLagsThatDecide; n < kNoiseLags.size(); ++n) measure(n);
    return scales;
}

MemoryNoise memoryNoise(const InverseRange& inverse, const AngularSteps& steps, const NoiseScales& scales, double windowMm) {
    std::size_t plateau = 0;
    const auto goesOn = [&](std::size_t n) {
        return scales.sigmaMm[n + 1] > kStopsGrowing * scales.sigmaMm[n] && scales.sigmaMm[n + 1] < kReliefGrows * scales.sigmaMm[n];
    };
    while (plateau + 1 < kNoiseLags.size() && goesOn(plateau)) ++plateau;
    MemoryNoise noise;
    noise.windowMm = windowMm;
    noise.range = lawOf(differencesByRange(inverse, kNoiseLags[plateau], 2 * kCellsLookedAt), trimmedRms);
    Bins bins(kRangeBins);
    RangeBins bin;
    for (const Along along : {Along::Beams, Along::Lines}) {
        forSome(inverse, kFoldsLookedAt, [&](int i, int j) {
            if (!inverse.isMeasured(i, j)) return;
            const double rangeM = 1.0 / static_cast<double>(inverse.u.at(i, j));
            const auto angle = static_cast<double>(along == Along::Beams ? steps.beam[static_cast<std::size_t>(j)] : steps.lineAt(i, j));
            const float size = foldAt({inverse, along}, i, j, reachOfFold(rangeM, angle, windowMm));
            if (size >= 0) bins[bin.of(rangeM)].push_back(size);
        });
    }
    noise.fold = lawOf(bins, spreadByForty);
    if (scales.sigmaMm[0] > 0) {
        const double times = noise.fold.at(scales.rangeM) / scales.sigmaMm[0];
        noise.cells = std::max(1.0, times * times);
    }
    return noise;
}

} // namespace edgescan::edges
