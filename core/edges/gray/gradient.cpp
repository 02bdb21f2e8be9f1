// The Sobel gradient.
#include "core/edges/gray/gradient.h"

#include "core/scan/grid/missing_cells.h"
#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace edgescan::edges {
namespace {

constexpr double kLargestThreshold = 32767.0; // cv::Canny squares no threshold above this

Gradient plainSobel(const Grid<std::uint8_t>& smoothed, int aperture) {
    Gradient gradient{Grid<std::int16_t>(smoothed.lines, smoothed.beams), Grid<std::int16_t>(smoothed.lines, smoothed.beams),
                      gradientScale(aperture)};
    const cv::Mat input = asMat(smoothed);
    cv::Mat dx = asMat(gradient.alongBeams);
    cv::Mat dy = asMat(gradient.alongLines);
    cv::Sobel(input, dx, CV_16S, 1, 0, aperture, gradient.scale, 0, cv::BORDER_REPLICATE);
    cv::Sobel(input, dy, CV_16S, 0, 1, aperture, gradient.scale, 0, cv::BORDER_REPLICATE);
    return gradient;
}

// One cell's gradient; missing cells count as the centre.
void gradientAt(Gradient& gradient, const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>& missing, const SobelWeights& weights,
                int line, int beam) {
    const int aperture = static_cast<int>(weights.derivative.size());
    const int reach = aperture / 2;
    const int centre = smoothed.at(line, beam);
    int dx = 0;
    int dy = 0;
    for (int di = 0; di < aperture; ++di) {
        const int i = std::clamp(line + di - reach, 0, smoothed.lines - 1);
        for (int dj = 0; dj < aperture; ++dj) {
            const std::size_t k = smoothed.index(i, std::clamp(beam + dj - reach, 0, smoothed.beams - 1));
            const int level = missing[k] != 0 ? centre : smoothed[k];
            dx += weights.smoothing[static_cast<std::size_t>(di)] * weights.derivative[static_cast<std::size_t>(dj)] * level;
            dy += weights.derivative[static_cast<std::size_t>(di)] * weights.smoothing[static_cast<std::size_t>(dj)] * level;
        }
    }
    const std::size_t k = smoothed.index(line, beam);
    gradient.alongBeams[k] = cv::saturate_cast<std::int16_t>(dx * gradient.scale);
    gradient.alongLines[k] = cv::saturate_cast<std::int16_t>(dy * gradient.scale);
}

} // namespace

double gradientScale(int aperture) { return aperture == 7 ? 1.0 / 16.0 : 1.0; }

SobelWeights sobelWeights(int aperture) {
    cv::Mat derivative;
    cv::Mat smoothing;
    cv::getDerivKernels(derivative, smoothing, 1, 0, aperture, false, CV_32F);
    SobelWeights weights;
    for (int i = 0; i < aperture; ++i) {
        weights.derivative.push_back(cvRound(derivative.at<float>(i)));
        weights.smoothing.push_back(cvRound(smoothing.at<float>(i)));
    }
    return weights;
}

Gradient sobelGradient(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>* missing, int aperture) {
    if (smoothed.size() == 0)
        return {Grid<std::int16_t>(smoothed.lines, smoothed.beams), Grid<std::int16_t>(smoothed.lines, smoothed.beams),
                gradientScale(aperture)};
    Gradient gradient = plainSobel(smoothed, aperture);
    if (missing == nullptr) return gradient;
    const SobelWeights weights = sobelWeights(aperture);
    const Grid<std::uint8_t> near = nearMissing(*missing, aperture / 2);
    for (int i = 0; i < smoothed.lines; ++i) {
        for (int j = 0; j < smoothed.beams; ++j) {
            const std::size_t k = smoothed.index(i, j);
            if ((*missing)[k] != 0)
                gradient.alongBeams[k] = gradient.alongLines[k] = 0;
            else if (near[k] != 0)
                gradientAt(gradient, smoothed, *missing, weights, i, j);
        }
    }
    return gradient;
}

std::int32_t gradientMagnitude(std::int16_t alongBeams, std::int16_t alongLines, Norm norm) {
    const std::int32_t x = alongBeams;
    const std::int32_t y = alongLines;
    return norm == Norm::L2 ? x * x + y * y : std::abs(x) + std::abs(y);
}

double magnitudeLimit(double threshold, double scale, Norm norm) {
    const double scaled = threshold * scale;
    if (norm == Norm::L1) return scaled;
    const double limited = std::min(scaled, kLargestThreshold);
    return limited > 0 ? limited * limited : limited;
}

AlongGradient alongGradient(std::int16_t alongBeams, std::int16_t alongLines) {
    constexpr int kShift = 15;
    constexpr int kTan22 = 13573; // tan(22.5 degrees) x 2^15, as cv::Canny rounds it
    const std::int64_t x = std::abs(static_cast<int>(alongBeams));
    const std::int64_t y = static_cast<std::int64_t>(std::abs(static_cast<int>(alongLines))) << kShift;
    const std::int64_t below = x * kTan22;
    if (y < below) return {0, 1, true};
    if (y > below + (x << (kShift + 1))) return {1, 0, true};
    return {1, (alongBeams < 0) != (alongLines < 0) ? -1 : 1, false};
}

Grid<std::int32_t> suppressedMagnitude(const Gradient& gradient, Norm norm) {
    const int lines = gradient.alongBeams.lines;
    const int beams = gradient.alongBeams.beams;
    // A frame of zeros around the magnitudes: cells outside are weaker than all others.
    const std::size_t wide = static_cast<std::size_t>(beams) + 2;
    std::vector<std::int32_t> magnitude(wide * (static_cast<std::size_t>(lines) + 2));
    for (int i = 0; i < lines; ++i) {
        std::int32_t* row = magnitude.data() + (static_cast<std::size_t>(i) + 1) * wide + 1;
        const std::int16_t* dx = gradient.alongBeams.line(i);
        const std::int16_t* dy = gradient.alongLines.line(i);
        for (int j = 0; j < beams; ++j) row[j] = gradientMagnitude(dx[j], dy[j], norm);
    }
    Grid<std::int32_t> kept(lines, beams);
    for (int i = 0; i < lines; ++i) {
        const std::int32_t* row = magnitude.data() + (static_cast<std::size_t>(i) + 1) * wide + 1;
        for (int j = 0; j < beams; ++j) {
            const std::int32_t here = row[j];
            if (here == 0) continue;
            const std::size_t k = kept.index(i, j);
            const AlongGradient along = alongGradient(gradient.alongBeams[k], gradient.alongLines[k]);
            const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(wide) * along.lineStep + along.beamStep;
            const std::int32_t second = row[j + step];
            if (here > row[j - step] && (here > second || (along.tieSurvives && here == second))) kept[k] = here;
        }
    }
    return kept;
}

std::int32_t suppressedMagnitudeAt(const Gradient& gradient, Norm norm, std::size_t k) {
    const Grid<std::int16_t>&dx = gradient.alongBeams, &dy = gradient.alongLines;
    const int line = static_cast<int>(k / static_cast<std::size_t>(dx.beams));
    const int beam = static_cast<int>(k % static_cast<std::size_t>(dx.beams));
    const auto magnitude = [&](int i, int j) { return dx.contains(i, j) ? gradientMagnitude(dx.at(i, j), dy.at(i, j), norm) : 0; };
    const std::int32_t here = magnitude(line, beam);
    const AlongGradient along = alongGradient(dx[k], dy[k]);
    const std::int32_t second = magnitude(line + along.lineStep, beam + along.beamStep);
    const bool kept =
        here > magnitude(line - along.lineStep, beam - along.beamStep) && (here > second || (along.tieSurvives && here == second));
    return kept ? here : 0;
}

} // namespace edgescan::edges
