// The Sobel gradient on which Canny's edges are based, and its magnitude.
#pragma once

#include "core/base/grid.h"
#include "core/edges/settings/settings.h"

#include <cstdint>
#include <vector>

namespace edgescan::edges {

struct Gradient {
    Grid<std::int16_t> alongBeams; ///< d level / d beam, lines x beams, multiplied by the weights of the aperture
    Grid<std::int16_t> alongLines; ///< d level / d line
    double scale = 1.0;            ///< factor that keeps the numbers within 16 bits; the thresholds are multiplied by it, too
};

/// Weights of the Sobel operator: `aperture` whole numbers each.
struct SobelWeights {
    std::vector<int> derivative; ///< across the edge
    std::vector<int> smoothing;  ///< along the edge
};
[[nodiscard]] SobelWeights sobelWeights(int aperture);

/// The factor by which cv::Canny multiplies gradient and thresholds: 1/16 for aperture 7, to stay within 16 bits, otherwise 1.
[[nodiscard]] double gradientScale(int aperture);

/// The gradient as cv::Canny computes it, borders repeated. `missing` (255 = no valid range) may be null; otherwise a missing cell in the
/// window counts as the window's centre and has no gradient itself. Bit-identical to OpenCV if no cell is missing.
[[nodiscard]] Gradient sobelGradient(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>* missing, int aperture);

/// The magnitude that cv::Canny compares: |gx| + |gy|, or gx^2 + gy^2 for L2.
[[nodiscard]] std::int32_t gradientMagnitude(std::int16_t alongBeams, std::int16_t alongLines, Norm norm);

/// Converts a threshold of the gradient to the units of gradientMagnitude(): the magnitude must be larger.
[[nodiscard]] double magnitudeLimit(double threshold, double scale, Norm norm);

/// The two neighbours along the gradient that a cell must exceed (cv::Canny's three sectors), as steps in lines and beams.
struct AlongGradient {
    int lineStep = 0; ///< to the second neighbour; the first is in the opposite direction
    int beamStep = 0;
    bool tieSurvives = true; ///< being equal to the second neighbour is enough (not on diagonals)
};
[[nodiscard]] AlongGradient alongGradient(std::int16_t alongBeams, std::int16_t alongLines);

/// Non-maximum suppression: the magnitude of the cells that exceed their neighbours along the gradient, otherwise 0.
[[nodiscard]] Grid<std::int32_t> suppressedMagnitude(const Gradient& gradient, Norm norm);
/// The same for cell `k` alone, without a grid.
[[nodiscard]] std::int32_t suppressedMagnitudeAt(const Gradient& gradient, Norm norm, std::size_t k);

} // namespace edgescan::edges
