// Creases. Loops of plain arithmetic without branches, so that the compiler can vectorise them.
#include "core/edges/edgescan_plus/crease.h"

#include "core/base/simd.h"
#include "core/scan/grid/beam_width.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace edgescan::edges {
namespace {

constexpr float kFewest = 3;
constexpr int kMost = kFoldReach - 1; // the link of the last cell to the next is also read
constexpr float kWanted = 2;          // cells on both sides, in addition to the cell itself
constexpr float kNoiseFloor = 4.5F;   // standard deviations
constexpr float kTangentNoise = kFoldOfWhite * 0.001F;
constexpr float kLeastCube = 6.0F; // of two cells
constexpr float kDegPerRad = 57.2957795F;
constexpr auto kHalfSpotM = static_cast<float>(0.5 * BeamWidth{}.atExitM);
constexpr auto kHalfSpotRad = static_cast<float>(0.5 * BeamWidth{}.growthRad);

// The values for the cells of a block. The block is small enough to stay in the nearest cache.
constexpr int kBlock = 128;
using Values = std::array<float, kBlock>;

// Sums over one side of each cell, of differences to the cell: such sums are more exact than sums of u.
struct SideSums {
    Values cells, sum, weighted;
};

// The lines fitted to both sides of each cell.
struct LineFits {
    Values before, after; // tangents of the slope away from the scanner; equal if only one side was fitted
    Values noise;         // variance of the difference of the tangents
    Values apart, meet;   // distance of the two lines at the cell along the beam divided by the misfit limit, as a fraction
    Values fitted;        // 1 where both sides have enough cells
};

// Cells of a scan line, and the direction in which they are processed.
struct Cells {
    const float* u;
    const std::uint8_t* links;
    const float* angle;
    std::ptrdiff_t step;
};

// Number of cells on one side of each cell without regard to the window, up to the first break: 16 at most. `links`: of the first cell to
// the next one that way.
using Counts = std::array<std::uint8_t, kBlock>;
template <class Count>
EDGESCAN_INLINE void countSide(const std::uint8_t* links, std::ptrdiff_t step, Count count, Counts& side) {
    for (int j = 0; j < count; ++j) {
        std::uint8_t goesOn = 1, cells = 0;
        for (int n = 0; n <= kMost; ++n) {
            goesOn &= links[j + n * step];
            cells = static_cast<std::uint8_t>(cells + goesOn);
        }
        side[j] = cells;
    }
}

// Of `reach` cells on a side, those that are left. `blurred` cells before a break are left out, except the first of the side: the spot of
// the beam may partly be on the surface behind.
EDGESCAN_INLINE float cellsOfSide(int reach, int untilBreak, int blurred) {
    const int clear = untilBreak > kMost ? kMost : std::max(std::min(untilBreak, 1), untilBreak - blurred);
    return static_cast<float>(std::min(reach, clear));
}

// The sums of both sides of some cells, from the farthest to the nearest cell: adding up the partial sums gives the weighted sum.
template <class Lanes>
struct LaneSums {
    Lanes here, cells, sum{}, weighted{};
    LaneSums(const float* u, const float* from) {
        load(here, u);
        load(cells, from);
    }
    EDGESCAN_INLINE void add(const float* u, const Lanes& distance) {
        Lanes there;
        load(there, u);
        sum += distance <= cells ? there - here : Lanes{};
        weighted += sum;
    }
    EDGESCAN_INLINE void storeTo(SideSums& side, int j) const {
        store(side.sum.data() + j, sum);
        store(side.weighted.data() + j, weighted);
    }
};

// In a group of this many cells all use the largest reach of the group: the additional terms are 0, and the loop has one length.
constexpr int kAlike = 64;

template <class Lanes>
EDGESCAN_INLINE int farthestOf(const SideSums& left, const SideSums& right, int first) {
    Lanes most{};
    for (int j = first; j < first + kAlike; j += kLanes<Lanes>) {
        Lanes before, after;
        load(before, left.cells.data() + j);
        load(after, right.cells.data() + j);
        most = most > before ? most : before;
        most = most > after ? most : after;
    }
    std::array<float, kLanes<Lanes>> values;
    store(values.data(), most);
    return static_cast<int>(largest<kLanes<Lanes>>(values.data()));
}

// The sums of one vector of cells: the sixteen registers of AVX2 have no room for two.
template <class Lanes>
EDGESCAN_INLINE void addUpOne(const Cells& at, int j, int farthest, SideSums& left, SideSums& right) {
    LaneSums<Lanes> before(at.u + j, left.cells.data() + j), after(at.u + j, right.cells.data() + j);
    Lanes distance = Lanes{} + static_cast<float>(farthest);
    const float* back = at.u + j - farthest * at.step;
    const float* on = at.u + j + farthest * at.step;
    for (int n = farthest; n > 0; --n, back += at.step, on -= at.step, distance -= 1.0F) {
        before.add(back, distance);
        after.add(on, distance);
    }
    before.storeTo(left, j);
    after.storeTo(right, j);
}

// The sums of two vectors of cells, whose additions do not depend on each other.
template <class Lanes>
EDGESCAN_INLINE void addUpTwo(const Cells& at, int j, int farthest, SideSums& left, SideSums& right) {
    const int k = j + kLanes<Lanes>;
    LaneSums<Lanes> before(at.u + j, left.cells.data() + j), after(at.u + j, right.cells.data() + j);
    LaneSums<Lanes> before2(at.u + k, left.cells.data() + k), after2(at.u + k, right.cells.data() + k);
    Lanes distance = Lanes{} + static_cast<float>(farthest);
    const float* back = at.u + j - farthest * at.step;
    const float* on = at.u + j + farthest * at.step;
    for (int n = farthest; n > 0; --n, back += at.step, on -= at.step, distance -= 1.0F) {
        before.add(back, distance);
        after.add(on, distance);
        before2.add(back + kLanes<Lanes>, distance);
        after2.add(on + kLanes<Lanes>, distance);
    }
    before.storeTo(left, j);
    after.storeTo(right, j);
    before2.storeTo(left, k);
    after2.storeTo(right, k);
}

template <class Lanes>
EDGESCAN_INLINE void addUp(const Cells& at, int count, SideSums& left, SideSums& right) {
    for (int j = 0; j < count; j += kAlike) {
        const int farthest = farthestOf<Lanes>(left, right, j);
        const int end = std::min(j + kAlike, count);
        if constexpr (std::is_same_v<Lanes, EightLanes>) {
            for (int k = j; k < end; k += kLanes<Lanes>) addUpOne<Lanes>(at, k, farthest, left, right);
        } else {
            for (int k = j; k < end; k += 2 * kLanes<Lanes>) addUpTwo<Lanes>(at, k, farthest, left, right);
        }
    }
}

// The angle whose tangent is y / x, y >= 0, in degrees. A polynomial (Abramowitz and Stegun 4.4.49), exact to 0.01 degrees and the same on
// every machine.
EDGESCAN_INLINE float angleDeg(float y, float x) {
    const float size = std::abs(x);
    const float t = std::min(y, size) / std::max(std::max(y, size), 1e-30F);
    const float t2 = t * t;
    float angle = t * (0.9998660F + t2 * (-0.3302995F + t2 * (0.1801410F + t2 * (-0.0851330F + t2 * 0.0208351F))));
    angle = y > size ? 1.57079633F - angle : angle;
    angle = x < 0 ? 3.14159265F - angle : angle;
    return angle * kDegPerRad;
}

// The lines through both sides of each cell in one direction. Divisions take the most time: two are left, each used for several values.
template <class Lanes, class Count>
EDGESCAN_INLINE void fitBlock(const Cells& at, Count count, const DepthLimits& limits, LineFits& fits) {
    Values scales;
    SideSums left, right;
    Counts before, after;
    countSide(at.links - at.step, -at.step, count, before);
    countSide(at.links, at.step, count, after);
    const float* u = at.u;
    const float* angle = at.angle;
    const float windowM = limits.windowMm * 0.001F;
    const float spotM = limits.spotGrows ? kHalfSpotM : 0, spotRad = limits.spotGrows ? kHalfSpotRad : 0;
    for (int j = 0; j < count; ++j) {
        const float scale = 1.0F / (u[j] * angle[j]);
        const float wanted = windowM * (u[j] * u[j]) * scale + 0.5F;
        const int reach = static_cast<int>(std::max(std::min(wanted, static_cast<float>(kMost)), kFewest));
        const float halfSpot = (spotM * u[j] + spotRad) * (u[j] * scale) + 0.5F; // cells
        const int blurred = static_cast<int>(std::max(std::min(halfSpot, static_cast<float>(kMost)), 1.0F));
        scales[j] = scale;
        left.cells[j] = cellsOfSide(reach, before[j], blurred);
        right.cells[j] = cellsOfSide(reach, after[j], blurred);
    }
    for (int j = count; j < kBlock; ++j) left.cells[j] = right.cells[j] = 0; // behind the last cell
    addUp<Lanes>(at, count, left, right);
    const auto offset = static_cast<float>(limits.foldNoise.offsetMm);
    const auto perMetre = static_cast<float>(limits.foldNoise.perMetreMm);
    const auto perSquareMetre = static_cast<float>(limits.foldNoise.perSquareMetreMm);
    const float misfits = 1000.0F / limits.misfitMm;
    for (int j = 0; j < count; ++j) {
        // Slopes of u per step outwards, from n (n^2 - 1) / 12, the sum of squares of n positions about their mean; and heights of the
        // lines over the cell.
        const float nl = left.cells[j] + 1, nr = right.cells[j] + 1;
        const float ml = 0.5F * left.cells[j], mr = 0.5F * right.cells[j];
        const float sl = nl * nl - 1, sr = nr * nr - 1;
        const float cubeLeft = std::max(nl * sl, kLeastCube), cubeRight = std::max(nr * sr, kLeastCube);
        const float inverse = 1.0F / (cubeLeft * cubeRight);
        const float perLeft = inverse * cubeRight, perRight = inverse * cubeLeft;
        const float slopeLeft = (left.weighted[j] - ml * left.sum[j]) * (12.0F * perLeft);
        const float slopeRight = (right.weighted[j] - mr * right.sum[j]) * (12.0F * perRight);
        const float rangeM = scales[j] * angle[j];
        const float heightLeft = (left.sum[j] * (sl * perLeft) - ml * slopeLeft) * rangeM; // as a share of u
        const float heightRight = (right.sum[j] * (sr * perRight) - mr * slopeRight) * rangeM;
        const float tangentLeft = slopeLeft * scales[j];
        const float tangentRight = -slopeRight * scales[j];
        fits.before[j] = left.cells[j] > 0 ? tangentLeft : tangentRight;
        fits.after[j] = right.cells[j] > 0 ? tangentRight : tangentLeft;
        fits.fitted[j] = std::min(left.cells[j], right.cells[j]) >= kWanted ? 1.0F : 0.0F;
        const float sigma = kTangentNoise * (offset + (perMetre + perSquareMetre * rangeM) * rangeM) * (u[j] * u[j]) * scales[j];
        fits.noise[j] = sigma * sigma * (12.0F * std::max(perLeft, perRight));
        fits.apart[j] = misfits * rangeM * (heightLeft - heightRight);
        fits.meet[j] = (1.0F + heightLeft) * (1.0F + heightRight);
    }
}

// Where the parts of S_C of some cells in one direction are written.
struct PartsOut {
    float *size, *all, *flatter, *noise;
    [[nodiscard]] PartsOut from(int first) const { return {size + first, all + first, flatter + first, noise + first}; }
    [[nodiscard]] FoldParts read() const { return {size, all, flatter, noise}; }
};
// The same for a block that is not stored.
struct BlockParts {
    Values size, all, flatter, noise;
    [[nodiscard]] PartsOut out() { return {size.data(), all.data(), flatter.data(), noise.data()}; }
};

// The parts of S_C of the cells in one direction; the slope across it tilts both planes.
template <class Count>
EDGESCAN_INLINE void partsOf(const LineFits& along, const LineFits& across, Count count, const PartsOut& out) {
    float* __restrict sizes = out.size, * __restrict alls = out.all, * __restrict flatters = out.flatter, * __restrict noises = out.noise;
    for (int j = 0; j < count; ++j) {
        const float a = along.before[j];
        const float b = along.after[j];
        const float tilt = 0.5F * (across.before[j] + across.after[j]);
        const float tilted = 1 + tilt * tilt;
        const float fold = angleDeg(std::abs(a - b) * std::sqrt(tilted), a * b + tilted);
        // The limit angle times `flatter`: C0, or the angle that noise causes on a flat surface.
        const float flatter = std::min(a * a, b * b) + tilted;
        // How well the lines meet, by their distance across the surface, not along the beam: the square root of meet / (meet + apart).
        const float mean = 0.5F * (a + b);
        const float meet = along.meet[j] * along.meet[j] * (mean * mean + tilted);
        const float all = std::max(meet + along.apart[j] * along.apart[j], 1e-30F);
        const float size = along.fitted[j] * fold * flatter * std::sqrt(meet * all);
        sizes[j] = a < b ? size : -size;
        alls[j] = all;
        flatters[j] = flatter;
        noises[j] = kNoiseFloor * kDegPerRad * std::sqrt(along.noise[j] * tilted);
    }
}

template <class Count>
EDGESCAN_INLINE void strengthsOf(const FoldParts& parts, Count count, float least, float* __restrict out) {
    for (int j = 0; j < count; ++j) {
        const float floor = std::max(least * parts.flatter[j], parts.noise[j]);
        out[j] = parts.size[j] / (parts.all[j] * floor);
    }
}

EDGESCAN_INLINE void strengthsOfParts(const FoldParts& parts, int cells, float least, float* out) { strengthsOf(parts, cells, least, out); }

// A line of cells in one direction: what is read, and what is written.
struct FoldWay {
    Cells cells;
    float* strengths;
    const PartsOut* parts; // null: not stored

    [[nodiscard]] EDGESCAN_INLINE FoldWay from(int first) const {
        return {{cells.u + first, cells.links + first, cells.angle + first, cells.step}, strengths + first, parts};
    }
};

template <class Count>
EDGESCAN_INLINE void foldWay(const FoldWay& way, const LineFits& along, const LineFits& across, Count count, int first, float creaseDeg) {
    BlockParts own;
    const PartsOut parts = way.parts != nullptr ? way.parts->from(first) : own.out();
    partsOf(along, across, count, parts);
    strengthsOf(parts.read(), count, creaseDeg, way.strengths);
}

template <class Lanes, class Count>
EDGESCAN_INLINE void foldBlock(const FoldWay& beamwise, const FoldWay& linewise, Count count, int first, const DepthLimits& limits) {
    LineFits beams, lines;
    fitBlock<Lanes>(beamwise.cells, count, limits, beams);
    fitBlock<Lanes>(linewise.cells, count, limits, lines);
    foldWay(beamwise, beams, lines, count, first, limits.creaseDeg);
    foldWay(linewise, lines, beams, count, first, limits.creaseDeg);
}

// Processes a line in blocks. The last block overlaps the one before, so that loops never end with single cells.
template <class Lanes>
EDGESCAN_INLINE void foldLine(const FoldWay& beamwise, const FoldWay& linewise, int beams, const DepthLimits& limits) {
    if (beams < kBlock) return foldBlock<Lanes>(beamwise, linewise, beams, 0, limits);
    for (int next = 0; next < beams; next += kBlock) {
        const int first = std::min(next, beams - kBlock);
        foldBlock<Lanes>(beamwise.from(first), linewise.from(first), std::integral_constant<int, kBlock>(), first, limits);
    }
}

PartsOut nextOf(FoldPartLines::Way& way) { return {way.size.next(), way.all.next(), way.flatter.next(), way.noise.next()}; }

} // namespace

void strengthsAt(const FoldParts& parts, int cells, float creaseDeg, float* strengths) {
    vectorised<strengthsOfParts>(parts, cells, creaseDeg, strengths);
}

void foldStrengths(const Lines& u, const Links& linksAlongBeams, const Links& linksAlongLines, const AngularSteps& steps, int line,
                   const DepthLimits& limits, FoldWork& work, FoldStrengths& strengths, FoldPartLines* parts) {
    std::array<PartsOut, 2> stored{};
    if (parts != nullptr) stored = {nextOf(parts->alongBeams), nextOf(parts->alongLines)};
    const auto storedOf = [&](int way) { return parts != nullptr ? &stored[static_cast<std::size_t>(way)] : nullptr; };
    const FoldWay beamwise{
        {u.line(line), linksAlongBeams.line(line), anglesOf(steps, Along::Beams, line, work.angles), stepOf(u, Along::Beams)},
        strengths.alongBeams.next(),
        storedOf(0)};
    const FoldWay linewise{
        {u.line(line), linksAlongLines.line(line), anglesOf(steps, Along::Lines, line, work.angles), stepOf(u, Along::Lines)},
        strengths.alongLines.next(),
        storedOf(1)};
    vectorised<foldLine<FourLanes>, foldLine<EightLanes>, foldLine<SixteenLanes>>(beamwise, linewise, u.beams, limits);
}

} // namespace edgescan::edges
