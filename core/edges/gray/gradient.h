// The Sobel gradient that Canny's edges are made of, and how strong it is.
#pragma once

#include "core/base/grid.h"
#include "core/edges/settings/settings.h"

#include <cstdint>
#include <vector>

namespace edgescan {

struct Gradient {
    Grid<std::int16_t> alongBeams; ///< d level / d beam, lines x beams, times the weights of the aperture
    Grid<std::int16_t> alongLines; ///< d level / d line
    double scale = 1.0;            ///< what the numbers are multiplied by to stay within 16 bits; thresholds are too
};

/// Weights of the Sobel operator: `aperture` values each, whole numbers.
struct SobelWeights {
    std::vector<int> derivative; ///< across the edge
    std::vector<int> smoothing;  ///< along the edge
};
[[nodiscard]] SobelWeights sobelWeights(int aperture);

/// What cv::Canny multiplies gradient and thresholds by: 1/16 for aperture 7, which keeps them within 16 bits, else 1.
[[nodiscard]] double gradientScale(int aperture);

/// As cv::Canny computes it, borders repeated. `missing` (255 = no valid range) may be null; else a missing cell in the window counts as
/// the window's centre and has no gradient itself. Bit-identical to OpenCV where no cell is missing.
[[nodiscard]] Gradient sobelGradient(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>* missing, int aperture);

/// What cv::Canny compares: |gx| + |gy|, or gx^2 + gy^2 for L2.
[[nodiscard]] std::int32_t gradientMagnitude(std::int16_t alongBeams, std::int16_t alongLines, Norm norm);

/// A threshold of the gradient in the numbers of gradientMagnitude(): the magnitude must be larger.
[[nodiscard]] double magnitudeLimit(double threshold, double scale, Norm norm);

/// The two cells that a cell must outdo along its gradient (cv::Canny's three sectors), as steps in lines and beams.
struct AlongGradient {
    int lineStep = 0; ///< to the second neighbour; the first lies the other way
    int beamStep = 0;
    bool tieIsKept = true; ///< equal to the second neighbour is enough (not on diagonals)
};
[[nodiscard]] AlongGradient alongGradient(std::int16_t alongBeams, std::int16_t alongLines);

/// Non-maximum suppression: the magnitude of the cells that outdo their neighbours along the gradient, else 0.
[[nodiscard]] Grid<std::int32_t> suppressedMagnitude(const Gradient& gradient, Norm norm);

} // namespace edgescan
