// Finds missing and isolated cells.
#include "core/scan/grid/missing_cells.h"

#include "core/base/simd.h"
#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan {
namespace {

constexpr int kNeighboursWanted = 2;
constexpr float kAgreeShare = 0.08F;
constexpr float kAgreeMm = 60.0F;

// Copies the ranges of a line with one cell on either side. A missing range becomes a value that agrees with nothing.
EDGESCAN_INLINE void copyValid(const float* ranges, const CellState* states, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) out[j] = states[j] == CellState::Valid ? ranges[j] : std::numeric_limits<float>::quiet_NaN();
}

void copyRanges(std::vector<float>& out, const Scan& scan, int line) {
    out.assign(static_cast<std::size_t>(scan.beams()) + 2, std::numeric_limits<float>::quiet_NaN());
    if (line >= 0 && line < scan.lines())
        vectorised<copyValid>(scan.rangeMm.line(line), scan.state.line(line), scan.beams(), out.data() + 1);
}

// 255 where too few neighbours agree. The lines have one cell on either side.
EDGESCAN_INLINE void isolatedOfLine(const float* before, const float* line, const float* after, int beams, std::uint8_t* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float here = line[j];
        const float allowed = kAgreeShare * here + kAgreeMm;
        const auto agrees = [&](float there) { return std::abs(there - here) <= allowed ? 1 : 0; };
        // The cell agrees with itself, unless it has no range.
        const int agreeing = agrees(before[j - 1]) + agrees(before[j]) + agrees(before[j + 1]) + agrees(line[j - 1]) + agrees(here) +
                             agrees(line[j + 1]) + agrees(after[j - 1]) + agrees(after[j]) + agrees(after[j + 1]);
        out[j] = static_cast<std::uint8_t>((agreeing > 0) & (agreeing <= kNeighboursWanted) ? 255 : 0);
    }
}

} // namespace

Grid<std::uint8_t> missingCells(const Scan& scan) {
    Grid<std::uint8_t> missing(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < scan.cells(); ++k) missing[k] = scan.state[k] == CellState::Valid ? 0 : 255;
    return missing;
}

Grid<std::uint8_t> isolatedCells(const Scan& scan) {
    Grid<std::uint8_t> isolated(scan.lines(), scan.beams());
    IsolatedLines lines(scan);
    for (int i = 0; i < isolated.lines; ++i) lines.next(isolated.line(i));
    return isolated;
}

bool isIsolated(const Scan& scan, std::uint32_t cell) {
    if (scan.state[cell] != CellState::Valid) return false;
    const int line = static_cast<int>(cell) / scan.beams(), beam = static_cast<int>(cell) % scan.beams();
    const float here = scan.rangeMm[cell], allowed = kAgreeShare * here + kAgreeMm;
    int agreeing = -1; // the cell agrees with itself
    for (int i = std::max(0, line - 1); i <= std::min(scan.lines() - 1, line + 1); ++i) {
        for (int j = std::max(0, beam - 1); j <= std::min(scan.beams() - 1, beam + 1); ++j)
            agreeing += scan.state.at(i, j) == CellState::Valid && std::abs(scan.rangeMm.at(i, j) - here) <= allowed ? 1 : 0;
    }
    return agreeing < kNeighboursWanted;
}

IsolatedLines::IsolatedLines(const Scan& scan, int firstLine) : scan_(&scan), line_(firstLine) {
    copyRanges(ranges_[1], scan, firstLine - 1);
    copyRanges(ranges_[2], scan, firstLine);
}

void IsolatedLines::next(std::uint8_t* isolated) {
    std::rotate(ranges_.begin(), ranges_.begin() + 1, ranges_.end());
    copyRanges(ranges_[2], *scan_, ++line_);
    vectorised<isolatedOfLine>(ranges_[0].data() + 1, ranges_[1].data() + 1, ranges_[2].data() + 1, scan_->beams(), isolated);
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
