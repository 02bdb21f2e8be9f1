// Canny on the logarithm of the range.
#include "core/edges/gray/log_range.h"

#include "core/edges/gray/canny.h"
#include "core/edges/gray/smooth.h"
#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/missing_cells.h"

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr double kPerEFold = 4096.0;       // whole numbers per factor e of range: 0.024 % each
constexpr int kSmoothedBits = 8;           // binary places of the Gaussian's results
constexpr double kGradientPerEFold = 2048; // of the 16-bit gradient: a straight step gives 4 x this value, so 1 % of range counts 81

struct Logarithms {
    Grid<std::int32_t> value;
    Grid<std::uint8_t> missing; // 255
};

Logarithms logarithms(const Scan& scan) {
    const InverseRange inverse = inverseRange(scan);
    Logarithms logs{Grid<std::int32_t>(scan.lines(), scan.beams()), Grid<std::uint8_t>(scan.lines(), scan.beams())};
    for (std::size_t k = 0; k < logs.value.size(); ++k) {
        if (inverse.support[k] == Support::Void) {
            logs.missing[k] = 255;
            continue;
        }
        const double rangeMm = inverse.support[k] == Support::Measured ? scan.rangeMm[k] : 1000.0 / inverse.u[k];
        logs.value[k] = static_cast<std::int32_t>(std::lround(std::log(rangeMm) * kPerEFold));
    }
    return logs;
}

int mirrored(int i, int count) {
    if (count == 1) return 0;
    while (i < 0 || i >= count) i = i < 0 ? -i : 2 * count - 2 - i;
    return i;
}

enum class Border : std::uint8_t { Mirrored, Repeated };

// Correlation with the product of two rows of weights. A missing cell in the window counts as the centre and is unchanged itself.
Grid<std::int64_t> weighted(const Grid<std::int64_t>& from, const Grid<std::uint8_t>& missing, const std::vector<int>& overLines,
                            const std::vector<int>& overBeams, Border border) {
    const int reach = static_cast<int>(overLines.size()) / 2;
    const auto place = [border](int i, int count) { return border == Border::Mirrored ? mirrored(i, count) : std::clamp(i, 0, count - 1); };
    Grid<std::int64_t> rows(from.lines, from.beams); // over beams only
    for (int i = 0; i < from.lines; ++i) {
        for (int j = 0; j < from.beams; ++j) {
            std::int64_t sum = 0;
            for (int d = -reach; d <= reach; ++d)
                sum += overBeams[static_cast<std::size_t>(d + reach)] * from.at(i, place(j + d, from.beams));
            rows.at(i, j) = sum;
        }
    }
    Grid<std::int64_t> result(from.lines, from.beams);
    const Grid<std::uint8_t> near = nearMissing(missing, reach);
    for (int i = 0; i < from.lines; ++i) {
        for (int j = 0; j < from.beams; ++j) {
            const std::size_t k = from.index(i, j);
            if (missing[k] != 0) continue;
            std::int64_t sum = 0;
            for (int d = -reach; d <= reach; ++d) {
                const int line = place(i + d, from.lines);
                std::int64_t row = rows.at(line, j);
                if (near[k] != 0) {
                    row = 0;
                    for (int e = -reach; e <= reach; ++e) {
                        const std::size_t there = from.index(line, place(j + e, from.beams));
                        row += overBeams[static_cast<std::size_t>(e + reach)] * (missing[there] != 0 ? from[k] : from[there]);
                    }
                }
                sum += overLines[static_cast<std::size_t>(d + reach)] * row;
            }
            result[k] = sum;
        }
    }
    return result;
}

// Sum of the positive derivative weights times the sum of the smoothing weights: the gradient of a straight unit step.
int stepWeight(const SobelWeights& sobel) {
    int positive = 0;
    int smoothing = 0;
    for (const int w : sobel.derivative) positive += std::max(w, 0);
    for (const int w : sobel.smoothing) smoothing += w;
    return positive * smoothing;
}

std::int64_t roundedQuotient(std::int64_t a, std::int64_t b) { return (a >= 0 ? a + b / 2 : a - b / 2) / b; }

} // namespace

Gradient logRangeGradient(const Scan& scan, const Settings& settings) {
    Logarithms logs = logarithms(scan);
    Grid<std::int64_t> values(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::int64_t{logs.value[k]} << kSmoothedBits;
    if (settings.kernel > 1) {
        const std::vector<int> gaussian = gaussianWeights(settings.kernel, settings.sigma);
        for (std::int64_t& v : values.cells) v >>= kSmoothedBits;
        values = weighted(values, logs.missing, gaussian, gaussian, Border::Mirrored); // two weights in 1/256 each
        for (std::int64_t& v : values.cells) v = (v + 128) >> 8;
    }
    const SobelWeights sobel = sobelWeights(settings.aperture);
    // Scaled as if every aperture responded to a straight step with 4 times its size.
    const auto unit = static_cast<std::int64_t>((kPerEFold / kGradientPerEFold) * (1 << kSmoothedBits)) * stepWeight(sobel) / 4;
    Gradient gradient{Grid<std::int16_t>(scan.lines(), scan.beams()), Grid<std::int16_t>(scan.lines(), scan.beams()), 1.0};
    const auto fill = [&](Grid<std::int16_t>& to, const std::vector<int>& overLines, const std::vector<int>& overBeams) {
        const Grid<std::int64_t> sums = weighted(values, logs.missing, overLines, overBeams, Border::Repeated);
        for (std::size_t k = 0; k < sums.size(); ++k)
            to[k] = static_cast<std::int16_t>(std::clamp<std::int64_t>(roundedQuotient(sums[k], unit), -32767, 32767));
    };
    fill(gradient.alongBeams, sobel.smoothing, sobel.derivative);
    fill(gradient.alongLines, sobel.derivative, sobel.smoothing);
    return gradient;
}

double logRangeGradientOfStep(double percent, const Settings& settings) {
    // The largest response to a step at any position of derivative and Gaussian together.
    const SobelWeights sobel = sobelWeights(settings.aperture);
    const std::vector<int> gaussian = settings.kernel > 1 ? gaussianWeights(settings.kernel, settings.sigma) : std::vector<int>{256};
    std::vector<double> answer(sobel.derivative.size() + gaussian.size() - 1);
    for (std::size_t d = 0; d < sobel.derivative.size(); ++d) {
        for (std::size_t g = 0; g < gaussian.size(); ++g) answer[d + g] += sobel.derivative[d] * gaussian[g] / 256.0;
    }
    double sum = 0;
    double largest = 0;
    for (const double a : answer) {
        sum += a;
        largest = std::max(largest, std::abs(sum));
    }
    int positive = 0;
    for (const int w : sobel.derivative) positive += std::max(w, 0);
    return 4.0 * kGradientPerEFold * largest / positive * std::log1p(percent / 100.0);
}

double logRangeStepOfGradient(double gradient, const Settings& settings) {
    const double perEFold = logRangeGradientOfStep(100.0 * std::expm1(1.0), settings);
    return 100.0 * std::expm1(gradient / perEFold);
}

Grid<std::uint8_t> logRangeEdges(const Scan& scan, const Settings& settings) {
    const double lower = logRangeGradientOfStep(settings.stepPercent, settings);
    Grid<std::uint8_t> mask = cannyOfGradient(logRangeGradient(scan, settings), lower, settings.ratio * lower, settings.norm);
    const Grid<std::uint8_t> without = withoutOwnRange(scan);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = static_cast<std::uint8_t>(mask[k] & ~without[k]);
    return mask;
}

Grid<std::uint8_t> withoutOwnRange(const Scan& scan) {
    Grid<std::uint8_t> without = missingCells(scan);
    const Grid<std::uint8_t> isolated = isolatedCells(scan);
    for (std::size_t k = 0; k < without.size(); ++k) without[k] |= isolated[k];
    return without;
}

} // namespace edgescan::edges
