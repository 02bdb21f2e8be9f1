// Distances along the beams' columns first, then the least of all columns of a line, many cells at once.
#include "core/rocks/segmentation/distance.h"

#include "core/base/bands.h"
#include "core/base/simd.h"
#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace edgescan::rocks {
namespace {

// Squares of larger numbers and their sums are not exact in floats, so that another method gives other bits there.
constexpr int kMostExact = 2048;
constexpr double kMostMean = 400;     // cells: with longer ways on average, the method of OpenCV is faster
constexpr float kNone = 1e8F;         // distance in a column without barrier
constexpr float kNoneSquared = 1e15F; // as OpenCV has it
constexpr std::size_t kCellsOfBlock = 32;

EDGESCAN_INLINE void stepDown(const std::uint8_t* free, const float* above, std::size_t beams, float* __restrict here) {
    for (std::size_t j = 0; j < beams; ++j) here[j] = free[j] != 0 ? above[j] + 1.0F : 0.0F;
}
EDGESCAN_INLINE void stepUp(const float* below, std::size_t beams, float* __restrict here) {
    for (std::size_t j = 0; j < beams; ++j) here[j] = std::min(here[j], below[j] + 1.0F);
}
EDGESCAN_INLINE void squareAll(const float* distance, std::size_t beams, float* __restrict squares) {
    for (std::size_t j = 0; j < beams; ++j) squares[j] = distance[j] < kNone ? distance[j] * distance[j] : kNoneSquared;
}

// Along the columns of some beams.
void measureColumns(const Grid<std::uint8_t>& free, int first, int last, Grid<float>& distance) {
    const auto beams = static_cast<std::size_t>(last - first);
    const std::vector<float> outside(beams, kNone);
    for (int i = 0; i < free.lines; ++i)
        vectorised<stepDown>(free.line(i) + first, i > 0 ? distance.line(i - 1) + first : outside.data(), beams, distance.line(i) + first);
    for (int i = free.lines - 2; i >= 0; --i) vectorised<stepUp>(distance.line(i + 1) + first, beams, distance.line(i) + first);
}

// The least of the squared distances in the columns plus the squared ways to them, for the cells of a block. `squares`: with `most` more
// cells on each side.
EDGESCAN_INLINE void leastOfColumns(const float* squares, std::size_t most, float* __restrict distance) {
    float least[kCellsOfBlock];
    for (std::size_t n = 0; n < kCellsOfBlock; ++n) least[n] = squares[n];
    for (std::size_t way = 1; way <= most; ++way) {
        const auto squared = static_cast<float>(way * way);
        if (squared >= largest<kCellsOfBlock>(least)) break;
        for (std::size_t n = 0; n < kCellsOfBlock; ++n)
            least[n] = std::min(least[n], std::min(*(squares + n - way), squares[n + way]) + squared);
    }
    for (std::size_t n = 0; n < kCellsOfBlock; ++n) distance[n] = std::sqrt(least[n]);
}

void measureLines(int first, int last, Grid<float>& distance) {
    const auto beams = static_cast<std::size_t>(distance.beams);
    std::vector<float> squares(3 * beams + 2 * kCellsOfBlock, kNoneSquared), found(beams + kCellsOfBlock);
    float* const line = squares.data() + beams;
    for (int i = first; i < last; ++i) {
        vectorised<squareAll>(distance.line(i), beams, line);
        for (std::size_t j = 0; j < beams; j += kCellsOfBlock) vectorised<leastOfColumns>(line + j, beams, &found[j]);
        std::copy_n(found.data(), beams, distance.line(i));
    }
}

} // namespace

Grid<float> distanceToZero(const Grid<std::uint8_t>& free, int threads) {
    // Without any barrier, versions of OpenCV give different numbers.
    if (std::ranges::find(free.cells, std::uint8_t{0}) == free.cells.end()) return {free.lines, free.beams, std::sqrt(kNoneSquared)};
    Grid<float> distance(free.lines, free.beams);
    threads = bandsFor(free.size(), threads);
    bool isNear = std::max(free.lines, free.beams) <= kMostExact;
    if (isNear) {
        runInBands(free.beams, threads, [&](int first, int last) { measureColumns(free, first, last, distance); });
        const auto sums = madeOfParts(free.lines, threads, [&](int first, int last) {
            double sum = 0;
            for (int i = first; i < last; ++i) {
                for (int j = 0; j < free.beams; j += 8)
                    sum += std::min(static_cast<double>(distance.at(i, j)), static_cast<double>(kMostExact));
            }
            return sum;
        });
        isNear = 8 * std::accumulate(sums.begin(), sums.end(), 0.0) <= kMostMean * static_cast<double>(free.size());
    }
    if (isNear) {
        (void)madeOfParts(free.lines, threads, [&](int first, int last) {
            measureLines(first, last, distance);
            return 0;
        });
        return distance;
    }
    cv::Mat result = asMat(distance);
    cv::distanceTransform(asMat(free), result, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
    return distance;
}

} // namespace edgescan::rocks
