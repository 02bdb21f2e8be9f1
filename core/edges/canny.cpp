// Canny's edges.
#include "core/edges/canny.h"

#include "core/edges/holes.h"
#include "core/edges/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace edgescan {
namespace {

// cv::Canny divides gradient and thresholds by 16 for aperture 7, to keep the gradient within 16 bits.
double gradientScale(int aperture) { return aperture == 7 ? 1.0 / 16.0 : 1.0; }

struct SobelWeights {
    std::vector<int> derivative; // across the edge, aperture values
    std::vector<int> smoothing;  // along the edge, aperture values
};

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

struct Gradient {
    Grid<std::int16_t> alongBeams; ///< d gray / d beam
    Grid<std::int16_t> alongLines; ///< d gray / d line
};

Gradient sobel(const Grid<std::uint8_t>& smoothed, int aperture) {
    Gradient gradient{Grid<std::int16_t>(smoothed.lines, smoothed.beams), Grid<std::int16_t>(smoothed.lines, smoothed.beams)};
    const cv::Mat input = asMat(smoothed);
    cv::Mat dx = asMat(gradient.alongBeams);
    cv::Mat dy = asMat(gradient.alongLines);
    cv::Sobel(input, dx, CV_16S, 1, 0, aperture, gradientScale(aperture), 0, cv::BORDER_REPLICATE);
    cv::Sobel(input, dy, CV_16S, 0, 1, aperture, gradientScale(aperture), 0, cv::BORDER_REPLICATE);
    return gradient;
}

// One cell's gradient with missing cells counted as the centre.
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
    const double scale = gradientScale(aperture);
    const std::size_t k = smoothed.index(line, beam);
    gradient.alongBeams[k] = cv::saturate_cast<std::int16_t>(dx * scale);
    gradient.alongLines[k] = cv::saturate_cast<std::int16_t>(dy * scale);
}

} // namespace

Grid<std::uint8_t> canny(const Grid<std::uint8_t>& smoothed, const Settings& settings) {
    Grid<std::uint8_t> mask(smoothed.lines, smoothed.beams);
    if (mask.size() == 0) return mask;
    cv::Mat output = asMat(mask);
    cv::Canny(asMat(smoothed), output, settings.lower, settings.upper(), settings.aperture, settings.norm == Norm::L2);
    return mask;
}

Grid<std::uint8_t> cannyAroundHoles(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>& missing, const Settings& settings) {
    Grid<std::uint8_t> mask(smoothed.lines, smoothed.beams);
    if (mask.size() == 0) return mask;
    Gradient gradient = sobel(smoothed, settings.aperture);
    const SobelWeights weights = sobelWeights(settings.aperture);
    const Grid<std::uint8_t> near = nearMissing(missing, settings.aperture / 2);
    for (int i = 0; i < mask.lines; ++i) {
        for (int j = 0; j < mask.beams; ++j) {
            const std::size_t k = mask.index(i, j);
            if (missing[k] != 0)
                gradient.alongBeams[k] = gradient.alongLines[k] = 0;
            else if (near[k] != 0)
                gradientAt(gradient, smoothed, missing, weights, i, j);
        }
    }
    cv::Mat output = asMat(mask);
    const double scale = gradientScale(settings.aperture);
    cv::Canny(asMat(gradient.alongBeams), asMat(gradient.alongLines), output, settings.lower * scale, settings.upper() * scale,
              settings.norm == Norm::L2);
    return mask;
}

std::vector<std::uint32_t> edgeCells(const Grid<std::uint8_t>& mask) {
    std::vector<std::uint32_t> cells;
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (mask[k] != 0) cells.push_back(static_cast<std::uint32_t>(k));
    }
    return cells;
}

} // namespace edgescan
