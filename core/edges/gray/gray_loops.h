// The loops of the gray path over a whole image, by each instruction set. All give the same bits as OpenCV.
#pragma once

#include "core/base/grid.h"
#include "core/base/instruction_set.h"
#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// The thresholds that cv::Canny compares magnitudes with, as whole numbers: a cell above `low` may be an edge, a cell above `high` starts
/// one.
struct CannyLimits {
    std::int32_t low = 0;
    std::int32_t high = 0;
};

/// Gray levels proportional to the range.
struct LinearLevels {
    double factor = 1.0; ///< levels per mm
    double nearMm = 0.0;
    double farMm = 0.0;
};

/// Marks for the cells of an image, in a frame of one cell on each side, so that every cell has eight neighbours.
struct CannyMarks {
    static constexpr std::uint8_t kNone = 0, kWeak = 1, kStrong = 2;

    int lines, beams;
    std::vector<std::uint8_t> framed; ///< (lines + 2) x (beams + 2)

    CannyMarks(int lineCount, int beamCount) : lines(lineCount), beams(beamCount), framed((height()) * width()) {}
    [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(beams) + 2; }
    [[nodiscard]] std::size_t height() const { return static_cast<std::size_t>(lines) + 2; }
    [[nodiscard]] std::size_t index(int line, int beam) const {
        return (static_cast<std::size_t>(line) + 1) * width() + static_cast<std::size_t>(beam) + 1;
    }
};

/// rint(range x factor) within 0..255, the product as double; 0 where the cell is not valid. Returns how many valid ranges are outside
/// near..far.
std::size_t levelsBy(InstructionSet set, const Grid<float>& rangeMm, const Grid<CellState>& states, LinearLevels to,
                     Grid<std::uint8_t>& levels);

/// cv::GaussianBlur of 8-bit levels with gaussianWeights() of 3 to 11 cells; `blurred` has the size of `levels`, at least 1 x 1.
void blurBy(InstructionSet set, const Grid<std::uint8_t>& levels, const std::vector<int>& weights, Grid<std::uint8_t>& blurred);

/// Sobel gradient of aperture 3, 5 or 7 and non-maximum suppression, as cv::Canny does them: marks the cells that exceed their neighbours
/// and the limits. `squared`: magnitudes are gx^2 + gy^2 (norm L2), otherwise |gx| + |gy|.
void suppressBy(InstructionSet set, const Grid<std::uint8_t>& smoothed, int aperture, bool squared, CannyLimits limits, CannyMarks& marks);

} // namespace edgescan::edges
