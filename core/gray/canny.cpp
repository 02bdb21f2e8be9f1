// Canny's edges.
#include "core/gray/canny.h"

#include "core/scan/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace edgescan {
namespace {

constexpr std::uint8_t kEdge = 255;

// Marks of what hangs together with a strong cell become edges, by 8 neighbours.
void followFromStrongCells(CannyMarks& marks) {
    const auto width = static_cast<std::ptrdiff_t>(marks.width());
    const std::array<std::ptrdiff_t, 8> around{-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1};
    std::uint8_t* const cells = marks.framed.data();
    const std::size_t count = marks.framed.size();
    constexpr std::uint64_t kStrongInEight = 0x0101010101010101U * CannyMarks::kStrong;
    std::vector<std::uint8_t*> waiting;
    const auto follow = [&](std::uint8_t* strong) {
        *strong = kEdge;
        waiting.push_back(strong);
        while (!waiting.empty()) {
            std::uint8_t* const cell = waiting.back();
            waiting.pop_back();
            for (const std::ptrdiff_t step : around) {
                std::uint8_t& beside = cell[step];
                if (beside == CannyMarks::kNone || beside == kEdge) continue;
                beside = kEdge;
                waiting.push_back(&beside);
            }
        }
    };
    std::size_t k = 0;
    for (; k + sizeof(std::uint64_t) <= count; k += sizeof(std::uint64_t)) { // most cells are no edge
        std::uint64_t eight = 0;
        std::memcpy(&eight, cells + k, sizeof eight);
        if ((eight & kStrongInEight) == 0) continue;
        for (std::size_t n = k; n < k + sizeof eight; ++n) {
            if (cells[n] == CannyMarks::kStrong) follow(cells + n);
        }
    }
    for (; k < count; ++k) {
        if (cells[k] == CannyMarks::kStrong) follow(cells + k);
    }
}

// Bit 7 tells edges from the weak cells that are left over.
Grid<std::uint8_t> edgesOf(const CannyMarks& marks) {
    Grid<std::uint8_t> mask(marks.lines, marks.beams);
    for (int i = 0; i < marks.lines; ++i) {
        const std::uint8_t* from = marks.framed.data() + marks.index(i, 0);
        std::uint8_t* to = mask.line(i);
        for (int j = 0; j < marks.beams; ++j) to[j] = from[j] >= 128 ? kEdge : 0;
    }
    return mask;
}

// cv::Canny takes whole numbers below its thresholds; magnitudes are whole.
std::int32_t wholeLimit(double threshold, int aperture, Norm norm) {
    const double limit = std::floor(magnitudeLimit(threshold, gradientScale(aperture), norm));
    return static_cast<std::int32_t>(std::clamp(limit, 0.0, static_cast<double>(std::numeric_limits<std::int32_t>::max())));
}

} // namespace

Grid<std::uint8_t> cannyBy(const GrayLoops& loops, const Grid<std::uint8_t>& smoothed, const Settings& settings) {
    if (smoothed.size() == 0) return Grid<std::uint8_t>(smoothed.lines, smoothed.beams);
    const CannyLimits limits{wholeLimit(settings.lower, settings.aperture, settings.norm),
                             wholeLimit(settings.upper(), settings.aperture, settings.norm)};
    CannyMarks marks(smoothed.lines, smoothed.beams);
    loops.suppress(smoothed, settings.aperture, settings.norm == Norm::L2, limits, marks);
    followFromStrongCells(marks);
    return edgesOf(marks);
}

Grid<std::uint8_t> canny(const Grid<std::uint8_t>& smoothed, const Settings& settings) { return cannyBy(grayLoops(), smoothed, settings); }

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
