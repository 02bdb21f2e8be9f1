// Finds barriers and computes the distance to them.
#include "core/rocks/segmentation/barrier.h"

#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

namespace edgescan::rocks {
namespace {

constexpr float kChainLow = 0.5F;
constexpr float kChainHigh = 0.8F;
constexpr int kChainCells = 3;
constexpr std::uint8_t kFree = 255;

// 0 at barriers, the input format of OpenCV's distance transform.
Grid<std::uint8_t> barriers(const Inputs& inputs) {
    const Grid<Support>& support = inputs.surface->inverse.support;
    const auto beams = static_cast<std::size_t>(support.beams);
    Grid<float> strength(support.lines, support.beams);
    for (std::size_t k = 0; k < strength.size(); ++k) strength[k] = separationStrength(*inputs.responses, k);
    Grid<std::uint8_t> free = edges::linkedChains(strength, kChainHigh, kChainLow, kChainCells);
    for (std::size_t k = 0; k < free.size(); ++k) free[k] = free[k] != 0 || support[k] == Support::Void ? 0 : kFree;
    const edges::DepthCracks& cracks = *inputs.cracks;
    // The cracks at the border of the sweep have no jump.
    for (std::size_t k = 0; k < free.size(); ++k) {
        if (cracks.jumpBeams[k] > 1.0F) free[k] = free[k + 1] = 0;
        if (cracks.jumpLines[k] > 1.0F) free[k] = free[k + beams] = 0;
    }
    return free;
}

} // namespace

Grid<float> barrierDistance(const Inputs& inputs) {
    Grid<std::uint8_t> free = barriers(inputs);
    Grid<float> distance(free.lines, free.beams);
    if (free.size() == 0) return distance;
    cv::Mat result = asMat(distance);
    cv::distanceTransform(asMat(free), result, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
    return distance;
}

} // namespace edgescan::rocks
