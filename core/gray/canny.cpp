// Canny's edges.
#include "core/gray/canny.h"

#include "core/scan/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstring>

namespace edgescan {

Grid<std::uint8_t> canny(const Grid<std::uint8_t>& smoothed, const Settings& settings) {
    Grid<std::uint8_t> mask(smoothed.lines, smoothed.beams);
    if (mask.size() == 0) return mask;
    cv::Mat output = asMat(mask);
    cv::Canny(asMat(smoothed), output, settings.lower, settings.upper(), settings.aperture, settings.norm == Norm::L2);
    return mask;
}

Grid<std::uint8_t> cannyAroundHoles(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>& missing, const Settings& settings) {
    return cannyOfGradient(sobelGradient(smoothed, &missing, settings.aperture), settings.lower, settings.upper(), settings.norm);
}

Grid<std::uint8_t> cannyOfGradient(const Gradient& gradient, double lower, double upper, Norm norm) {
    Grid<std::uint8_t> mask(gradient.alongBeams.lines, gradient.alongBeams.beams);
    if (mask.size() == 0) return mask;
    cv::Mat output = asMat(mask);
    cv::Canny(asMat(gradient.alongBeams), asMat(gradient.alongLines), output, lower * gradient.scale, upper * gradient.scale,
              norm == Norm::L2);
    return mask;
}

std::vector<std::uint32_t> edgeCells(const Grid<std::uint8_t>& mask) {
    std::vector<std::uint32_t> cells;
    constexpr std::size_t kAtOnce = 32; // most of a mask is empty
    constexpr std::array<std::uint8_t, kAtOnce> kNone{};
    for (std::size_t first = 0; first < mask.size(); first += kAtOnce) {
        const std::size_t end = std::min(first + kAtOnce, mask.size());
        if (std::memcmp(mask.cells.data() + first, kNone.data(), end - first) == 0) continue;
        for (std::size_t k = first; k < end; ++k) {
            if (mask[k] != 0) cells.push_back(static_cast<std::uint32_t>(k));
        }
    }
    return cells;
}

} // namespace edgescan
