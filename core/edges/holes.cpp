// Missing cells.
#include "core/edges/holes.h"

#include "core/edges/opencv_view.h"

#include <opencv2/imgproc.hpp>

namespace edgescan {

Grid<std::uint8_t> missingCells(const Scan& scan) {
    Grid<std::uint8_t> missing(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < scan.cells(); ++k) missing[k] = scan.state[k] == CellState::Valid ? 0 : 255;
    return missing;
}

Grid<std::uint8_t> nearMissing(const Grid<std::uint8_t>& missing, int reach) {
    Grid<std::uint8_t> near(missing.lines, missing.beams);
    if (near.size() == 0) return near;
    const cv::Mat box = cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
    cv::Mat result = asMat(near);
    cv::dilate(asMat(missing), result, box, {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    return near;
}

} // namespace edgescan
