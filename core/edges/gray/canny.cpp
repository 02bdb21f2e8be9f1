// Canny's edges.
#include "core/edges/gray/canny.h"

#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace edgescan::edges {
namespace {

constexpr std::uint8_t kEdge = 128; // and no other bit: marks that are weak or strong are not decided yet

constexpr std::size_t kEight = sizeof(std::uint64_t);
constexpr std::uint64_t kEachByte = 0x0101010101010101U;

std::uint64_t eightBytes(const std::uint8_t* from) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, from, sizeof eight);
    return eight;
}

// Calls visit(place) for the bytes that have one of these bits, ascending.
template <class Visit>
void forBytesWith(std::uint8_t bits, const std::uint8_t* bytes, std::size_t count, Visit visit) {
    const std::uint64_t wanted = kEachByte * bits;
    std::size_t k = 0;
    const auto look = [&](std::size_t from) {
        for (std::size_t n = from; n < from + kEight; ++n) {
            if ((bytes[n] & bits) != 0) visit(n);
        }
    };
    for (; k + 4 * kEight <= count; k += 4 * kEight) { // most bytes are 0
        const std::uint64_t first = eightBytes(bytes + k) | eightBytes(bytes + k + kEight);
        const std::uint64_t second = eightBytes(bytes + k + 2 * kEight) | eightBytes(bytes + k + 3 * kEight);
        if (((first | second) & wanted) == 0) continue;
        for (std::size_t n = k; n < k + 4 * kEight; n += kEight) {
            if ((eightBytes(bytes + n) & wanted) != 0) look(n);
        }
    }
    for (; k < count; ++k) {
        if ((bytes[k] & bits) != 0) visit(k);
    }
}

// Marks connected with a strong cell (8 neighbours) become edges.
void followFromStrongCells(CannyMarks& marks) {
    constexpr std::uint8_t kWaits = CannyMarks::kWeak | CannyMarks::kStrong;
    const auto width = static_cast<std::ptrdiff_t>(marks.width());
    std::uint8_t* const cells = marks.framed.data();
    std::vector<std::uint8_t*> waiting;
    const auto addEdge = [&waiting](std::uint8_t* cell) {
        if ((*cell & kWaits) == 0) return;
        *cell = kEdge;
        waiting.push_back(cell);
    };
    const auto anyOf = [](const std::uint8_t* middle) { return (middle[-1] | middle[0] | middle[1]) & kWaits; };
    forBytesWith(CannyMarks::kStrong, cells, marks.framed.size(), [&](std::size_t k) {
        addEdge(cells + k);
        while (!waiting.empty()) {
            std::uint8_t* const cell = waiting.back();
            waiting.pop_back();
            for (std::uint8_t* middle : {cell - width, cell, cell + width}) {
                if (anyOf(middle) == 0) continue; // the strong cells of a line that was already followed are edges now
                for (const std::ptrdiff_t step : {-1, 0, 1}) addEdge(middle + step);
            }
        }
    });
}

// The remaining weak cells are not edges.
Grid<std::uint8_t> edgesOf(const CannyMarks& marks) {
    Grid<std::uint8_t> mask(marks.lines, marks.beams);
    for (int i = 0; i < marks.lines; ++i) {
        const std::uint8_t* from = marks.framed.data() + marks.index(i, 0);
        std::uint8_t* __restrict to = mask.line(i);
        const int beams = marks.beams;
        for (int j = 0; j < beams; ++j) to[j] = from[j] >= kEdge ? 255 : 0;
    }
    return mask;
}

// cv::Canny rounds its thresholds down to whole numbers; magnitudes are whole numbers.
std::int32_t wholeLimit(double threshold, int aperture, Norm norm) {
    const double limit = std::floor(magnitudeLimit(threshold, gradientScale(aperture), norm));
    return static_cast<std::int32_t>(std::clamp(limit, 0.0, static_cast<double>(std::numeric_limits<std::int32_t>::max())));
}

} // namespace

Grid<std::uint8_t> cannyBy(InstructionSet set, const Grid<std::uint8_t>& smoothed, const Settings& settings) {
    if (smoothed.size() == 0) return Grid<std::uint8_t>(smoothed.lines, smoothed.beams);
    const CannyLimits limits{wholeLimit(settings.lower, settings.aperture, settings.norm),
                             wholeLimit(settings.upper(), settings.aperture, settings.norm)};
    CannyMarks marks(smoothed.lines, smoothed.beams);
    suppressBy(set, smoothed, settings.aperture, settings.norm == Norm::L2, limits, marks);
    followFromStrongCells(marks);
    return edgesOf(marks);
}

Grid<std::uint8_t> canny(const Grid<std::uint8_t>& smoothed, const Settings& settings) {
    return cannyBy(instructionSet(), smoothed, settings);
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
    std::vector<std::uint32_t> cells(kEight);
    std::size_t found = 0;
    const std::uint8_t* const bytes = mask.cells.data();
    std::size_t k = 0;
    for (; k + kEight <= mask.size(); k += kEight) { // most of a mask is empty
        if (eightBytes(bytes + k) == 0) continue;
        if (found + kEight > cells.size()) cells.resize(2 * cells.size());
        // Written without a branch, because the processor cannot predict which cells are edges.
        for (std::size_t n = k; n < k + kEight; ++n) {
            cells[found] = static_cast<std::uint32_t>(n);
            found += bytes[n] != 0 ? 1U : 0U;
        }
    }
    cells.resize(found);
    for (; k < mask.size(); ++k) {
        if (bytes[k] != 0) cells.push_back(static_cast<std::uint32_t>(k));
    }
    cells.shrink_to_fit();
    return cells;
}

} // namespace edgescan::edges
