// Creases. Lines of plain arithmetic without branches, so that the compiler makes vectors of them.
#include "core/depth/depth_crease.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr float kFewest = 3;
constexpr float kMost = kFoldLooks - 1; // the link of the last cell to the next is looked at
constexpr float kWanted = 2;            // cells beyond the cell itself, on both sides
constexpr float kNoiseFloor = 4.5F;     // standard deviations
constexpr float kDegPerRad = 57.2957795F;

// With room for whole lanes.
std::vector<float> lineOf(int beams) { return std::vector<float>(static_cast<std::size_t>(beams + kMostLanes)); }

using SideSums = FoldWork::SideSums;
using LineFits = FoldWork::LineFits;

// A line of the sweep, and the way along which it is looked at.
struct Cells {
    const float* u;
    const float* links;
    const float* angle;
    std::ptrdiff_t step;
    int beams;
};

// How many cells of a side are within the window; 0 beyond the line.
EDGESCAN_SIMD void reachOfLine(const Cells& at, float windowM, float* __restrict reach) {
    const float* u = at.u;
    const float* angle = at.angle;
    for (int j = 0; j < at.beams; ++j) {
        const float cells = windowM * u[j] / angle[j] + 0.5F;
        reach[j] = std::max(std::min(cells, kMost), kFewest);
    }
}

template <class Lanes>
struct LaneSums {
    Lanes alive = Lanes{} + 1.0F; // 1 until the side ends
    Lanes cells{}, sum{}, weighted{};
};

// A cell before a break is left out unless it is the first of its side: the spot of the beam may lie on what is behind, too.
template <class Lanes>
inline __attribute__((always_inline)) void add(LaneSums<Lanes>& side, const Lanes& here, const float* u, const float* link,
                                               const float* nextLink, float distance, const Lanes& reach) {
    Lanes there, linked, goesOn;
    load(there, u);
    load(linked, link);
    load(goesOn, nextLink);
    both(linked, side.alive);
    side.alive = distance <= reach ? linked : Lanes{};
    Lanes taken = side.alive;
    if (distance > 1) both(taken, goesOn);
    const Lanes difference = taken * (there - here);
    side.cells += taken;
    side.sum += difference;
    side.weighted += distance * difference;
}

template <class Lanes>
inline __attribute__((always_inline)) void put(SideSums& side, int beam, const LaneSums<Lanes>& sums) {
    store(side.cells.data() + beam, sums.cells);
    store(side.sum.data() + beam, sums.sum);
    store(side.weighted.data() + beam, sums.weighted);
}

// Both sides of all cells. A side ends at a break, or where it is long enough.
template <class Lanes>
inline __attribute__((always_inline)) void addUpBy(const Cells& at, const float* reach, SideSums& left, SideSums& right) {
    for (int j = 0; j < at.beams; j += kLanes<Lanes>) {
        const float farthest = largest<kLanes<Lanes>>(reach + j);
        Lanes here, cells;
        load(here, at.u + j);
        load(cells, reach + j);
        LaneSums<Lanes> before, after;
        std::ptrdiff_t there = at.step;
        for (float distance = 1; distance <= farthest; ++distance, there += at.step) {
            add(before, here, at.u + j - there, at.links + j - there, at.links + j - there - at.step, distance, cells);
            add(after, here, at.u + j + there, at.links + j + there - at.step, at.links + j + there, distance, cells);
        }
        put(left, j, before);
        put(right, j, after);
    }
}

EDGESCAN_SIMD void addUpBySixteen(const Cells& at, const float* reach, SideSums& left, SideSums& right) {
    addUpBy<SixteenLanes>(at, reach, left, right);
}

void addUp(const Cells& at, const float* reach, SideSums& left, SideSums& right) {
    if (EDGESCAN_SIMD_WIDE)
        addUpBySixteen(at, reach, left, right);
    else
        addUpBy<FourLanes>(at, reach, left, right);
}

// Sum of the squares of so many places from their mean, n (n^2 - 1) / 12. With these few it is the same by a product, which takes less.
constexpr float spreadOf(float count) { return count * (count * count - 1) * (1.0F / 12.0F); }
constexpr bool isSpreadExact() {
    for (float count = 1; count <= kMost + 1; ++count) {
        if (spreadOf(count) != count * (count * count - 1) / 12.0F) return false;
    }
    return true;
}
static_assert(isSpreadExact());

// Slope of u per step outwards and height of the line over the cell.
struct SideLine {
    float slope, height;
};
inline __attribute__((always_inline)) SideLine fitted(float cells, float sum, float weighted) {
    const float count = cells + 1;
    const float mean = 0.5F * cells;
    const float spread = std::max(spreadOf(count), 0.5F);
    const float slope = (weighted - mean * sum) / spread;
    return {slope, sum / count - mean * slope};
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

// The lines through both sides of each cell. Results go to `fits`.
EDGESCAN_SIMD void fitSides(const Cells& at, const SideSums& left, const SideSums& right, const DepthLimits& limits,
                            float* __restrict before, float* __restrict after, float* __restrict noise, float* __restrict misfit,
                            float* __restrict bothSides) {
    const float* u = at.u;
    const float* angle = at.angle;
    const float* leftCells = left.cells.data();
    const float* leftSum = left.sum.data();
    const float* leftWeighted = left.weighted.data();
    const float* rightCells = right.cells.data();
    const float* rightSum = right.sum.data();
    const float* rightWeighted = right.weighted.data();
    const auto offset = static_cast<float>(limits.foldNoise.offsetMm);
    const auto perMetre = static_cast<float>(limits.foldNoise.perMetreMm);
    const auto perSquareMetre = static_cast<float>(limits.foldNoise.perSquareMetreMm);
    for (int j = 0; j < at.beams; ++j) {
        const SideLine l = fitted(leftCells[j], leftSum[j], leftWeighted[j]);
        const SideLine r = fitted(rightCells[j], rightSum[j], rightWeighted[j]);
        const float scale = 1.0F / (u[j] * angle[j]);
        const float leftTangent = l.slope * scale;
        const float rightTangent = -r.slope * scale;
        before[j] = leftCells[j] > 0 ? leftTangent : rightTangent;
        after[j] = rightCells[j] > 0 ? rightTangent : leftTangent;
        const float fewer = std::min(leftCells[j], rightCells[j]);
        bothSides[j] = fewer >= kWanted ? 1.0F : 0.0F;
        const float points = std::max(fewer, 1.0F) + 1;
        const float rangeM = 1.0F / u[j];
        const float sigmaMm = offset + perMetre * rangeM + perSquareMetre * rangeM * rangeM;
        noise[j] = kFoldOfWhite * 0.001F * sigmaMm * std::sqrt(12.0F / (points * (points * points - 1))) / (rangeM * angle[j]);
        const float gap = std::abs(l.height - r.height);
        misfit[j] = 1000.0F * gap / ((u[j] + l.height) * (u[j] + r.height));
    }
}

EDGESCAN_SIMD void strengthsOf(const LineFits& along, const LineFits& across, const DepthLimits& limits, int beams, float* out) {
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

void fitLineOf(const Lines& u, const Lines& links, const AngularSteps& steps, Along along, int line, const DepthLimits& limits,
               FoldWork& work, LineFits& fits) {
    const Cells at{u.line(line), links.line(line), anglesOf(steps, along, line, work.angles), stepOf(u, along), u.beams};
    reachOfLine(at, limits.windowMm * 0.001F, work.reach.data());
    addUp(at, work.reach.data(), work.left, work.right);
    fitSides(at, work.left, work.right, limits, fits.before.data(), fits.after.data(), fits.noise.data(), fits.misfit.data(),
             fits.fitted.data());
}

} // namespace

FoldWork::SideSums::SideSums(int beams) : cells(lineOf(beams)), sum(lineOf(beams)), weighted(lineOf(beams)) {}

FoldWork::LineFits::LineFits(int beams)
    : before(lineOf(beams)), after(lineOf(beams)), noise(lineOf(beams)), misfit(lineOf(beams)), fitted(lineOf(beams)) {}

FoldWork::FoldWork(int beams) : reach(lineOf(beams)), left(beams), right(beams), beamwise(beams), linewise(beams) {}

void foldStrengths(const Lines& u, const Lines& linksAlongBeams, const Lines& linksAlongLines, const AngularSteps& steps, int line,
                   const DepthLimits& limits, FoldWork& work, FoldStrengths& strengths) {
    fitLineOf(u, linksAlongBeams, steps, Along::Beams, line, limits, work, work.beamwise);
    fitLineOf(u, linksAlongLines, steps, Along::Lines, line, limits, work, work.linewise);
    strengthsOf(work.beamwise, work.linewise, limits, u.beams, strengths.alongBeams.next());
    strengthsOf(work.linewise, work.beamwise, limits, u.beams, strengths.alongLines.next());
}

} // namespace edgescan
