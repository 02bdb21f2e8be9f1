// Creases. Blocks of plain arithmetic without branches, so that the compiler makes vectors of them.
#include "core/edges/depth_crease.h"

#include "core/edges/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr int kBlock = 64; // cells of a line that are worked on together
constexpr float kFewest = 3;
constexpr float kMost = PaddedGrid<float>::kMargin;
constexpr float kWanted = 2;          // cells beyond the cell itself, on both sides
constexpr float kNoiseFloor = 5;      // standard deviations
constexpr float kNoiseShare = 0.55F;  // of the range noise that is left after smoothing (METHOD.md step 5)
constexpr float kSlopesApart = 1.41F; // two slopes with the noise of one each
constexpr float kDegPerRad = 57.2957795F;

using Block = std::array<float, kBlock>;

// Sums over one side of the cells of a block; differences to the cell itself keep the digits.
struct SideSums {
    Block cells, sum, weighted;
};

// Cells `count` from `u` on; `sign` -1: towards lower indices.
inline __attribute__((always_inline)) void addUp(SideSums& side, const float* u, const float* links, std::ptrdiff_t step, int sign,
                                                 const Block& reach, int farthest) {
    Block alive;
    alive.fill(1.0F);
    side.cells.fill(0.0F);
    side.sum.fill(0.0F);
    side.weighted.fill(0.0F);
    for (int q = 1; q <= farthest; ++q) {
        const auto distance = static_cast<float>(q);
        const float* there = u + sign * q * step;
        const float* link = sign > 0 ? links + (q - 1) * step : links - q * step;
        for (int j = 0; j < kBlock; ++j) {
            const auto n = static_cast<std::size_t>(j);
            alive[n] = distance <= reach[n] ? alive[n] * link[j] : 0.0F;
            const float difference = alive[n] * (there[j] - u[j]);
            side.cells[n] += alive[n];
            side.sum[n] += difference;
            side.weighted[n] += distance * difference;
        }
    }
}

// Slope of u per step outwards and height of the line over the cell.
struct SideLine {
    Block slope, height;
};
inline __attribute__((always_inline)) void fitLine(const SideSums& side, SideLine& line) {
    for (std::size_t n = 0; n < kBlock; ++n) {
        const float count = side.cells[n] + 1;
        const float mean = 0.5F * side.cells[n];
        const float spread = std::max(count * (count * count - 1) / 12.0F, 0.5F);
        line.slope[n] = (side.weighted[n] - mean * side.sum[n]) / spread;
        line.height[n] = side.sum[n] / count - mean * line.slope[n];
    }
}

// Angle whose tangent is y / x, y >= 0, degrees. A polynomial (Abramowitz and Stegun 4.4.49): within 0.01 degrees on every machine alike.
inline __attribute__((always_inline)) float angleDeg(float y, float x) {
    const float size = std::abs(x);
    const float t = std::min(y, size) / std::max(std::max(y, size), 1e-30F);
    const float t2 = t * t;
    float angle = t * (0.9998660F + t2 * (-0.3302995F + t2 * (0.1801410F + t2 * (-0.0851330F + t2 * 0.0208351F))));
    angle = y > size ? 1.57079633F - angle : angle;
    angle = x < 0 ? 3.14159265F - angle : angle;
    return angle * kDegPerRad;
}

// One line: what its two sides say about each cell.
struct LineFits {
    explicit LineFits(int beams) {
        for (auto* values : {&before, &after, &noise, &misfit, &fitted}) values->resize(static_cast<std::size_t>(beams));
    }
    std::vector<float> before, after; ///< tangents of the angle at which the surface recedes; equal where only one side was fitted
    std::vector<float> noise;         ///< standard deviation of the difference of the tangents
    std::vector<float> misfit;        ///< distance of the two lines at the cell along the beam, mm
    std::vector<float> fitted;        ///< 1 where both sides have enough cells
};

struct Cells {
    const float* u;
    const float* links;
    const float* angle;
    std::ptrdiff_t step;
};

// One block; `count` of its cells are wanted. Results go to the lines of `fits`.
EDGESCAN_VECTORS void fitBlock(const Cells& at, int count, const DepthLimits& limits, float* before, float* after, float* noise,
                               float* misfit, float* fitted) {
    Block reach;
    reach.fill(0.0F);
    float farthest = 0;
    for (int j = 0; j < count; ++j) {
        const auto n = static_cast<std::size_t>(j);
        const float cells = limits.windowMm * 0.001F * at.u[j] / at.angle[j] + 0.5F;
        reach[n] = std::max(static_cast<float>(static_cast<int>(std::min(cells, kMost))), kFewest);
        farthest = std::max(farthest, reach[n]);
    }
    SideSums sums;
    SideLine left;
    SideLine right;
    addUp(sums, at.u, at.links, at.step, -1, reach, static_cast<int>(farthest));
    const Block leftCells = sums.cells;
    fitLine(sums, left);
    addUp(sums, at.u, at.links, at.step, 1, reach, static_cast<int>(farthest));
    fitLine(sums, right);
    const auto offset = static_cast<float>(limits.noise.offsetMm);
    const auto perMetre = static_cast<float>(limits.noise.perMetreMm);
    for (int j = 0; j < count; ++j) {
        const auto n = static_cast<std::size_t>(j);
        const float scale = 1.0F / (at.u[j] * at.angle[j]);
        const float leftTangent = left.slope[n] * scale;
        const float rightTangent = -right.slope[n] * scale;
        before[j] = leftCells[n] > 0 ? leftTangent : rightTangent;
        after[j] = sums.cells[n] > 0 ? rightTangent : leftTangent;
        const float fewer = std::min(leftCells[n], sums.cells[n]);
        fitted[j] = fewer >= kWanted ? 1.0F : 0.0F;
        const float points = std::max(fewer, 1.0F) + 1;
        const float rangeM = 1.0F / at.u[j];
        const float sigmaMm = offset + perMetre * rangeM;
        noise[j] =
            kSlopesApart * kNoiseShare * 0.001F * sigmaMm * std::sqrt(12.0F / (points * (points * points - 1))) / (rangeM * at.angle[j]);
        const float gap = std::abs(left.height[n] - right.height[n]);
        misfit[j] = 1000.0F * gap / ((at.u[j] + left.height[n]) * (at.u[j] + right.height[n]));
    }
}

void fitLineOf(const PaddedGrid<float>& u, const PaddedGrid<float>& links, const AngularSteps& steps, Along along, int line,
               const DepthLimits& limits, LineFits& fits) {
    const float* angle = anglesOf(steps, along, line);
    const std::ptrdiff_t step = along == Along::Beams ? 1 : u.stride;
    for (int j = 0; j < u.beams; j += kBlock) {
        // The last block starts early rather than to read beyond the margin.
        const int first = std::max(0, std::min(j, u.beams - kBlock));
        const int count = std::min(kBlock, u.beams - first);
        fitBlock({u.line(line) + first, links.line(line) + first, angle + first, step}, count, limits, fits.before.data() + first,
                 fits.after.data() + first, fits.noise.data() + first, fits.misfit.data() + first, fits.fitted.data() + first);
    }
}

EDGESCAN_VECTORS void strengthsOf(const LineFits& along, const LineFits& across, const DepthLimits& limits, int beams, float* out) {
    const float* before = along.before.data();
    const float* after = along.after.data();
    const float* noise = along.noise.data();
    const float* misfit = along.misfit.data();
    const float* fitted = along.fitted.data();
    const float* tiltBefore = across.before.data();
    const float* tiltAfter = across.after.data();
    const float least = limits.creaseDeg;
    const float misfitMm = limits.misfitMm;
    for (int j = 0; j < beams; ++j) {
        const float a = before[j];
        const float b = after[j];
        const float tilt = 0.5F * (tiltBefore[j] + tiltAfter[j]);
        const float tilted = 1 + tilt * tilt;
        const float fold = angleDeg(std::abs(a - b) * std::sqrt(tilted), a * b + tilted);
        const float flatter = std::min(a * a, b * b);
        const float floor = kNoiseFloor * kDegPerRad * noise[j] * std::sqrt(tilted) / (flatter + tilted);
        // Distance across the surface, not along the beam.
        const float mean = 0.5F * (a + b);
        const float apart = misfit[j] / misfitMm;
        const float meets = 1.0F / std::sqrt(1 + apart * apart / (mean * mean + tilted));
        const float size = fitted[j] * fold * meets / std::max(least, floor);
        out[j] = a < b ? size : -size;
    }
}

} // namespace

FoldStrengths foldStrengths(const PaddedGrid<float>& u, const PaddedGrid<float>& linksAlongBeams, const PaddedGrid<float>& linksAlongLines,
                            const AngularSteps& steps, const DepthLimits& limits) {
    FoldStrengths strengths{PaddedGrid<float>(u.lines, u.beams), PaddedGrid<float>(u.lines, u.beams)};
    LineFits beamwise(u.beams);
    LineFits linewise(u.beams);
    for (int i = 0; i < u.lines; ++i) {
        fitLineOf(u, linksAlongBeams, steps, Along::Beams, i, limits, beamwise);
        fitLineOf(u, linksAlongLines, steps, Along::Lines, i, limits, linewise);
        strengthsOf(beamwise, linewise, limits, u.beams, strengths.alongBeams.line(i));
        strengthsOf(linewise, beamwise, limits, u.beams, strengths.alongLines.line(i));
    }
    return strengths;
}

} // namespace edgescan
