// The second-derivative detectors.
#include "core/edges/gray/zero_crossings.h"

#include "core/base/portable_math.h"

#include "core/edges/gray/neighbours.h"
#include "core/edges/settings/method_traits.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace edgescan::edges {
namespace {

constexpr double kReachInSigmas = 4.0;

// Laplacian of a Gaussian sampled on 5 x 5 cells, as in text books.
constexpr std::array<std::array<int, 5>, 5> kFiveByFive{
    {{0, 0, -1, 0, 0}, {0, -1, -2, -1, 0}, {-1, -2, 16, -2, -1}, {0, -1, -2, -1, 0}, {0, 0, -1, 0, 0}}};

Grid<float> fiveByFive(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing) {
    Grid<float> response(levels.lines, levels.beams);
    for (int i = 0; i < levels.lines; ++i) {
        for (int j = 0; j < levels.beams; ++j) {
            const std::size_t centre = levels.index(i, j);
            if (missing != nullptr && (*missing)[centre] != 0) continue;
            int sum = 0;
            for (int di = -2; di <= 2; ++di) {
                const int line = std::clamp(i + di, 0, levels.lines - 1);
                for (int dj = -2; dj <= 2; ++dj) {
                    const int weight = kFiveByFive[static_cast<std::size_t>(di + 2)][static_cast<std::size_t>(dj + 2)];
                    if (weight == 0) continue;
                    const std::size_t k = levels.index(line, std::clamp(j + dj, 0, levels.beams - 1));
                    sum += weight * (missing != nullptr && (*missing)[k] != 0 ? levels[centre] : levels[k]);
                }
            }
            response[centre] = static_cast<float>(sum);
        }
    }
    return response;
}

std::vector<double> gaussian(double sigma) {
    const int reach = std::max(1, static_cast<int>(std::ceil(kReachInSigmas * sigma)));
    std::vector<double> weights;
    for (int d = -reach; d <= reach; ++d) weights.push_back(portable::exp(-0.5 * d * d / (sigma * sigma)));
    return weights;
}

// One pass of the Gaussian along beams (stride 1) or lines (stride = beams); the border is repeated outside.
std::vector<double> blurredAlong(const std::vector<double>& from, int runs, std::size_t runStep, int length, std::size_t stride,
                                 const std::vector<double>& weights) {
    std::vector<double> to(from.size());
    const int reach = static_cast<int>(weights.size()) / 2;
    for (int run = 0; run < runs; ++run) {
        const std::size_t start = static_cast<std::size_t>(run) * runStep;
        for (int n = 0; n < length; ++n) {
            double sum = 0;
            for (int d = -reach; d <= reach; ++d)
                sum += weights[static_cast<std::size_t>(d + reach)] *
                       from[start + static_cast<std::size_t>(std::clamp(n + d, 0, length - 1)) * stride];
            to[start + static_cast<std::size_t>(n) * stride] = sum;
        }
    }
    return to;
}

// Gaussian of the levels in which missing cells have weight 0.
std::vector<double> blurred(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, double sigma) {
    const std::vector<double> weights = gaussian(sigma);
    const auto beams = static_cast<std::size_t>(levels.beams);
    const auto both = [&](std::vector<double> values) {
        values = blurredAlong(values, levels.lines, beams, levels.beams, 1, weights);
        return blurredAlong(values, levels.beams, 1, levels.lines, beams, weights);
    };
    std::vector<double> values(levels.size());
    std::vector<double> present(levels.size(), 1.0);
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (missing != nullptr && (*missing)[k] != 0)
            present[k] = 0.0;
        else
            values[k] = levels[k];
    }
    values = both(std::move(values));
    present = both(std::move(present));
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = present[k] > 0 ? values[k] / present[k] : 0.0;
    return values;
}

} // namespace

Grid<float> laplacian(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, LogMask mask) {
    if (mask == LogMask::FiveByFive) return fiveByFive(levels, missing);
    const bool four = mask == LogMask::FourNeighbours;
    return responseOfNeighbours(levels, missing, [=](const Neighbours& at) {
        const auto& n = at.around;
        const int neighbours = n[1] + n[3] + n[5] + n[7];
        if (four) return static_cast<float>(4 * at.centre - neighbours);
        return static_cast<float>(8 * at.centre - neighbours - n[0] - n[2] - n[4] - n[6]);
    });
}

Grid<float> laplacianOfGaussian(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, double sigma) {
    Grid<float> response(levels.lines, levels.beams);
    const std::vector<double> smooth = blurred(levels, missing, sigma);
    const double scale = sigma * sigma * sigma * std::sqrt(2.0 * std::numbers::pi);
    for (int i = 0; i < levels.lines; ++i) {
        for (int j = 0; j < levels.beams; ++j) {
            const std::size_t k = levels.index(i, j);
            if (missing != nullptr && (*missing)[k] != 0) continue;
            double sum = 0;
            for (const std::size_t neighbours : {levels.index(std::max(i - 1, 0), j), levels.index(std::min(i + 1, levels.lines - 1), j),
                                                 levels.index(i, std::max(j - 1, 0)), levels.index(i, std::min(j + 1, levels.beams - 1))}) {
                if (missing == nullptr || (*missing)[neighbours] == 0) sum += smooth[neighbours] - smooth[k];
            }
            response[k] = static_cast<float>(scale * sum);
        }
    }
    return response;
}

Grid<float> zeroCrossingSlope(const Grid<float>& laplacian, const Grid<std::uint8_t>* missing) {
    // Rounding errors of sums of doubles do not count as a sign.
    constexpr float kNothing = 1e-6F;
    Grid<float> slope(laplacian.lines, laplacian.beams);
    const auto sign = [&](std::size_t k) { return laplacian[k] > kNothing ? 1 : laplacian[k] < -kNothing ? -1 : 0; };
    const auto isMissing = [&](std::size_t k) { return missing != nullptr && (*missing)[k] != 0; };
    const auto give = [&](std::size_t k, float value) { slope[k] = std::max(slope[k], value); };
    const auto along = [&](std::size_t k, std::size_t next, bool hasSecond, std::size_t second) {
        if (isMissing(k) || isMissing(next)) return;
        if (sign(k) * sign(next) < 0) {
            const bool first = std::abs(laplacian[k]) <= std::abs(laplacian[next]);
            give(first ? k : next, std::abs(laplacian[k] - laplacian[next]));
        } else if (hasSecond && sign(next) == 0 && !isMissing(second) && sign(k) * sign(second) < 0) {
            give(next, std::abs(laplacian[k] - laplacian[second]));
        }
    };
    for (int i = 0; i < slope.lines; ++i) {
        for (int j = 0; j < slope.beams; ++j) {
            const std::size_t k = slope.index(i, j);
            if (j + 1 < slope.beams) along(k, k + 1, j + 2 < slope.beams, k + 2);
            if (i + 1 < slope.lines) along(k, slope.index(i + 1, j), i + 2 < slope.lines, k + 2 * static_cast<std::size_t>(slope.beams));
        }
    }
    return slope;
}

Grid<float> marrHildrethResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings) {
    const double sigma = std::isnan(settings.sigma) ? automaticSigma(settings) : settings.sigma;
    return zeroCrossingSlope(laplacianOfGaussian(levels, missing, sigma), missing);
}

Grid<float> logResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings) {
    return zeroCrossingSlope(laplacian(levels, missing, settings.logMask), missing);
}

} // namespace edgescan::edges
