// A Grid seen as an OpenCV matrix, without a copy. Only for .cpp files, so that headers do not depend on OpenCV.
#pragma once

#include "core/base/grid.h"

#include <opencv2/core.hpp>

#include <cstdint>

namespace edgescan {

inline cv::Mat asMat(Grid<std::uint8_t>& grid) { return {grid.lines, grid.beams, CV_8U, grid.cells.data()}; }

inline cv::Mat asMat(Grid<float>& grid) { return {grid.lines, grid.beams, CV_32F, grid.cells.data()}; }

inline cv::Mat asMat(Grid<std::int16_t>& grid) { return {grid.lines, grid.beams, CV_16S, grid.cells.data()}; }

/// OpenCV has no read-only matrix: the caller must not write through it.
inline cv::Mat asMat(const Grid<std::uint8_t>& grid) {
    return {grid.lines, grid.beams, CV_8U, const_cast<std::uint8_t*>(grid.cells.data())};
}

inline cv::Mat asMat(const Grid<std::int16_t>& grid) {
    return {grid.lines, grid.beams, CV_16S, const_cast<std::int16_t*>(grid.cells.data())};
}

} // namespace edgescan
