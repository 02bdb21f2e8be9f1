// Missing cells.
#include "core/edges/holes.h"

#include "core/edges/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace edgescan {
namespace {

constexpr int kNeighboursWanted = 2;
constexpr float kAgreeShare = 0.08F;
constexpr float kAgreeMm = 60.0F;

// The ranges of a line with a cell on either side; what is no range agrees with nothing.
void takeRanges(std::vector<float>& out, const Scan& scan, int line) {
    out.assign(static_cast<std::size_t>(scan.beams()) + 2, std::numeric_limits<float>::quiet_NaN());
    if (line < 0 || line >= scan.lines()) return;
    const float* ranges = scan.rangeMm.line(line);
    const CellState* states = scan.state.line(line);
    for (int beam = 0; beam < scan.beams(); ++beam) {
        if (states[beam] == CellState::Valid) out[static_cast<std::size_t>(beam) + 1] = ranges[beam];
    }
}

} // namespace

Grid<std::uint8_t> missingCells(const Scan& scan) {
    Grid<std::uint8_t> missing(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < scan.cells(); ++k) missing[k] = scan.state[k] == CellState::Valid ? 0 : 255;
    return missing;
}

Grid<std::uint8_t> isolatedCells(const Scan& scan) { return isolatedCells(scan, 0, scan.lines()); }

Grid<std::uint8_t> isolatedCells(const Scan& scan, int firstLine, int endLine) {
    Grid<std::uint8_t> isolated(endLine - firstLine, scan.beams());
    std::array<std::vector<float>, 3> ranges; // of the lines before, at and after
    takeRanges(ranges[1], scan, firstLine - 1);
    takeRanges(ranges[2], scan, firstLine);
    const auto beams = static_cast<std::size_t>(scan.beams());
    std::vector<int> agreeing(beams);
    for (int line = firstLine; line < endLine; ++line) {
        std::rotate(ranges.begin(), ranges.begin() + 1, ranges.end());
        takeRanges(ranges[2], scan, line + 1);
        const float* here = ranges[1].data() + 1;
        std::fill(agreeing.begin(), agreeing.end(), 0);
        for (const std::vector<float>& row : ranges) {
            for (std::size_t shift = 0; shift < 3; ++shift) { // the cell itself agrees too
                const float* there = row.data() + shift;
                for (std::size_t j = 0; j < beams; ++j)
                    agreeing[j] += std::abs(there[j] - here[j]) <= kAgreeShare * here[j] + kAgreeMm ? 1 : 0;
            }
        }
        std::uint8_t* out = isolated.line(line - firstLine);
        // A cell without a range does not even agree with itself.
        for (std::size_t j = 0; j < beams; ++j) out[j] = agreeing[j] > 0 && agreeing[j] <= kNeighboursWanted ? 255 : 0;
    }
    return isolated;
}

Grid<std::uint8_t> maskedCells(const Scan& scan, const Settings& settings) {
    if (!settings.maskMissing) return {};
    Grid<std::uint8_t> masked = missingCells(scan);
    if (!settings.maskIsolated) return masked;
    const Grid<std::uint8_t> isolated = isolatedCells(scan);
    for (std::size_t k = 0; k < masked.size(); ++k) masked[k] |= isolated[k];
    return masked;
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
