// Computes the features of all lanes at once. Each lane adds in the order of its cells, so that it has the same bits wherever it is.
#include "core/rocks/segmentation/border_lanes.h"

#include "core/rocks/segmentation/planes.h"

#include <algorithm>
#include <cmath>

namespace edgescan::rocks {
namespace {

constexpr float kMostOff = 60;     // standard deviations
constexpr float kMostBetween = 10; // the same, of one cell that votes for a plane
constexpr float kNoRange = 99;
constexpr float kAtCorner = 0.75F;     // weight of a diagonal neighbour
constexpr double kLeastInverse = 1e-4; // 1/m
constexpr double kLeastSlope = 1e-7;
constexpr std::size_t kMiddle = kCellsAround / 2;
constexpr std::array kCorners{kMiddle - kAcross - 1, kMiddle - kAcross + 1, kMiddle + kAcross - 1, kMiddle + kAcross + 1};
constexpr std::array<std::size_t, kCellSides> kSideCells{kMiddle - kAcross, kMiddle - 1, kMiddle + 1, kMiddle + kAcross}; // by CellSide

template <class T>
EDGESCAN_INLINE T within(T value, T least, T most) {
    return value < least ? least : most < value ? most : value;
}
EDGESCAN_INLINE float offWithin(float value) { return within(value, -kMostOff, kMostOff); }

EDGESCAN_INLINE void fitPlanes(const WindowSums& windows, BorderSide& side) {
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        const PlaneSums s(windows, n);
        const double u = s.height();
        const double a = s.xx + kPlaneRidge;
        const double d = s.yy + kPlaneRidge;
        // The normal equations without the height: each row minus the height times its count.
        const double xu = s.xu - s.x * u;
        const double yu = s.yu - s.y * u;
        const double minor = a * d - s.xy * s.xy;
        const double x = (xu * d - yu * s.xy) / minor;
        const double y = (yu * a - xu * s.xy) / minor;
        const double off = windows.uu[n] - u * s.u - x * s.xu - y * s.yu;
        const double scatter = std::sqrt(std::max(0.0, off / s.n));
        const bool isPlane = s.n >= kFewestForPlane;
        side.u[n] = s.n > 0 ? u : 0.0;
        side.x[n] = isPlane ? x : 0.0;
        side.y[n] = isPlane ? y : 0.0;
        side.scatter[n] = isPlane ? scatter : 0.0;
        side.n[n] = static_cast<float>(s.n);
    }
}

EDGESCAN_INLINE void compareWithPlanes(const BorderLanes& lanes, BorderSide& side) {
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        const auto planeM = static_cast<float>(1.0 / std::max(side.u[n], kLeastInverse));
        const float off = offWithin((lanes.rangeM[n] - planeM) * lanes.perM[n]);
        const float smoothOff = offWithin((lanes.smoothedRangeM[n] - planeM) * lanes.perM[n]);
        const bool any = side.n[n] > 0;
        side.rangeM[n] = any ? planeM : 0.0F;
        side.off[n] = any ? off : kMostOff + 1;
        side.smoothOff[n] = any ? smoothOff : kMostOff + 1;
    }
}

// The ranges of the neighbours in a segment from that of the cell.
template <class Vector>
struct NeighbourRanges {
    Vector closest = Vector{} + kMostOff, sum{}, cells{};

    EDGESCAN_INLINE void add(const Vector& off, const typename At<Vector>::Numbers& isIn) {
        closest = smaller(closest, chosen(isIn, absolute(off), Vector{} + kMostOff));
        sum += where(isIn, clipped(off, -kMostOff, kMostOff));
        cells += where(isIn, Vector{} + 1.0F);
    }
};

template <class Vector>
EDGESCAN_INLINE void lookAtNeighbours(const BorderLanes& lanes, const At<Vector>& at, std::size_t which, BorderSide& side) {
    const auto segment = at(lanes.segment[which]);
    const Vector r = at(lanes.rangeM), perM = at(lanes.perM), one = Vector{} + 1.0F;
    NeighbourRanges<Vector> ranges;
    Vector neighbours{}, around{}, adjacent{}, mostJump = -one, mostValley = -one;
    for (const std::size_t q : kCorners) {
        const auto isIn = at(lanes.solid[q]) == segment;
        neighbours += where(isIn, Vector{} + kAtCorner);
        ranges.add((r - 1.0F / at(lanes.u[q])) * perM, isIn);
    }
    for (std::size_t s = 0; s < kCellSides; ++s) {
        const auto isIn = at(lanes.solid[kSideCells[s]]) == segment;
        const Vector jump = at(lanes.jump[s]), valley = at(lanes.valley[s]);
        neighbours += where(isIn, one - 0.5F * clipped(larger(jump, valley), 0.0F, 1.0F));
        mostJump = larger(mostJump, chosen(isIn, clipped(jump, -1.0F, 5.0F), -one));
        mostValley = larger(mostValley, chosen(isIn, clipped(valley, -1.0F, 3.0F), -one));
        adjacent += where(isIn, one);
        ranges.add((r - 1.0F / at(lanes.u[kSideCells[s]])) * perM, isIn);
    }
    for (std::size_t q = 0; q < kCellsAround; ++q) {
        if (q != kMiddle) around += where(at(lanes.solid[q]) == segment, one);
    }
    at.put(side.neighbours, neighbours);
    at.put(side.around, around);
    at.put(side.adjacent, adjacent);
    at.put(side.jump, mostJump);
    at.put(side.valley, mostValley);
    at.put(side.closest, ranges.closest);
    at.put(side.mean, where(ranges.cells > 0.0F, ranges.sum / ranges.cells));
}

// The heights of a plane at the cells around.
template <class Vector>
struct FlatPlane {
    Vector u, x, y;

    EDGESCAN_INLINE FlatPlane(const BorderSide& side, const At<Vector>& at) {
        Lanes<float> height, slopeX, slopeY;
        for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
            height[n] = static_cast<float>(side.u[n]);
            slopeX[n] = static_cast<float>(side.x[n]);
            slopeY[n] = static_cast<float>(side.y[n]);
        }
        u = at(height);
        x = at(slopeX);
        y = at(slopeY);
    }
    // Of a cell, in standard deviations; `deviations`: per 1/m.
    EDGESCAN_INLINE Vector off(float right, float down, const Vector& cellU, const Vector& deviations) const {
        return smaller(absolute(u + x * right + y * down - cellU) * deviations, Vector{} + kMostBetween);
    }
};

template <class Vector>
EDGESCAN_INLINE void countVotes(const BorderLanes& lanes, const At<Vector>& at, const BorderSides& sides, BorderVotes& votes) {
    using Numbers = typename At<Vector>::Numbers;
    const FlatPlane<Vector> ownPlane(sides[0], at), otherPlane(sides[1], at);
    const auto own = at(lanes.segment[0]), other = at(lanes.segment[1]);
    const Vector perM = where((at(sides[0].n) > 0.0F) & (at(sides[1].n) > 0.0F), at(lanes.perM)), one = Vector{} + 1.0F;
    Vector ownSum{}, otherSum{}, nearSum{}, ownCells{}, otherCells{}, nearCells{};
    Numbers down{}, right{};
    for (std::size_t q = 0; q < kCellsAround; ++q) {
        const int dy = static_cast<int>(q / kAcross) - kAround, dx = static_cast<int>(q % kAcross) - kAround;
        const auto y = static_cast<float>(dy), x = static_cast<float>(dx);
        const Numbers there = at(lanes.solid[q]);
        const Numbers isOwn = there == own, isOther = there == other;
        const Numbers way = isOwn - isOther; // -1 and 1: a mask is -1
        down += way * dy;
        right += way * dx;
        const Vector u = at(lanes.u[q]);
        const Vector deviations = perM / (u * u); // per 1/m
        const Vector vote = ownPlane.off(x, y, u, deviations) - otherPlane.off(x, y, u, deviations);
        ownSum += where(isOwn, vote);
        otherSum += where(isOther, vote);
        ownCells += where(isOwn, one);
        otherCells += where(isOther, one);
        if (dx * dx > 1 || dy * dy > 1) continue;
        nearSum += where(isOwn | isOther, vote);
        nearCells += where(isOwn | isOther, one);
    }
    at.put(votes.down, down);
    at.put(votes.right, right);
    at.put(votes.own, where(ownCells > 0.0F, ownSum / ownCells));
    at.put(votes.other, where(otherCells > 0.0F, otherSum / otherCells));
    at.put(votes.near, where(nearCells > 0.0F, nearSum / nearCells));
}

template <class Vector>
EDGESCAN_INLINE void measureAll(const BorderLanes& lanes, BorderSides& sides, BorderVotes& votes) {
    for (std::size_t s = 0; s < sides.size(); ++s) {
        fitPlanes(lanes.windows[s], sides[s]);
        compareWithPlanes(lanes, sides[s]);
    }
    for (std::size_t lane = 0; lane < kCellsAtOnce; lane += kLanes<Vector>) {
        const At<Vector> at{lane};
        for (std::size_t s = 0; s < sides.size(); ++s) lookAtNeighbours(lanes, at, s, sides[s]);
        countVotes(lanes, at, sides, votes);
    }
}

// How both planes are to each other; nothing without one of them.
struct PlanePair {
    Lanes<float> apart, toCrossing, between;
};
EDGESCAN_INLINE PlanePair compare(const BorderLanes& lanes, const BorderSide& own, const BorderSide& other) {
    PlanePair pair;
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        const bool both = (own.n[n] > 0) & (other.n[n] > 0);
        const double slopeX = own.x[n] - other.x[n], slopeY = own.y[n] - other.y[n];
        const double slope = std::max(std::sqrt(slopeX * slopeX + slopeY * slopeY), kLeastSlope);
        const float apart = within((own.rangeM[n] - other.rangeM[n]) * lanes.perM[n], -200.0F, 200.0F);
        const auto toCrossing = static_cast<float>(within((own.u[n] - other.u[n]) / slope, -8.0, 8.0));
        const float from = other.rangeM[n] - own.rangeM[n];
        const float between = within((lanes.rangeM[n] - own.rangeM[n]) / (from == 0 ? 1e-9F : from), -1.0F, 2.0F);
        pair.apart[n] = both ? apart : 0.0F;
        pair.toCrossing[n] = both ? toCrossing : 0.0F;
        pair.between[n] = both ? between : 0.5F;
    }
    return pair;
}

EDGESCAN_INLINE Lanes<float> scatterOf(const BorderLanes& lanes, const BorderSide& side) {
    Lanes<float> scatter;
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        const float r = lanes.rangeM[n];
        scatter[n] = within(static_cast<float>(side.scatter[n]) * lanes.perM[n] * r * r, 0.0F, 30.0F);
    }
    return scatter;
}

EDGESCAN_INLINE Lanes<float> profileAt(const BorderLanes& lanes, std::size_t step) {
    Lanes<float> profile;
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        const float u = lanes.profileU[step][n];
        const float off = offWithin((1.0F / u - lanes.rangeM[n]) * lanes.perM[n]);
        profile[n] = u == 0 ? kNoRange : off;
    }
    return profile;
}

EDGESCAN_INLINE void writeAll(const BorderLanes& lanes, const BorderSides& sides, const BorderVotes& votes, BorderFeatureLanes& features) {
    const auto& [own, other] = sides;
    const PlanePair pair = compare(lanes, own, other);
    Lanes<float> footprint, steps, closer, surrounded, folds;
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        footprint[n] = lanes.footprintMm[n] / std::max(1e-3F, 1000.0F * lanes.rangeM[n] * lanes.beamStep[n]);
        steps[n] = lanes.lineStep[n] / lanes.beamStep[n];
        closer[n] = std::abs(own.off[n]) - std::abs(other.off[n]);
        surrounded[n] = own.neighbours[n] - other.neighbours[n];
        folds[n] = lanes.folds[1][n] - lanes.folds[0][n];
    }
    features = {own.off,
                other.off,
                own.neighbours,
                other.neighbours,
                own.around,
                other.around,
                own.n,
                other.n,
                scatterOf(lanes, own),
                scatterOf(lanes, other),
                pair.apart,
                pair.toCrossing,
                pair.between,
                own.jump,
                other.jump,
                own.valley,
                other.valley,
                lanes.jumpHere,
                lanes.foldHere,
                own.closest,
                other.closest,
                own.mean,
                other.mean,
                footprint,
                lanes.rangeM,
                own.smoothOff,
                other.smoothOff,
                own.adjacent,
                other.adjacent,
                steps,
                closer,
                surrounded,
                profileAt(lanes, 0),
                profileAt(lanes, 1),
                profileAt(lanes, 2),
                profileAt(lanes, 3),
                votes.own,
                votes.other,
                votes.near,
                lanes.jumps[0],
                lanes.jumps[1],
                folds};
}

} // namespace

void measureSides(const BorderLanes& lanes, BorderSides& sides, BorderVotes& votes) {
    vectorised<measureAll<FourLanes>, measureAll<EightLanes>, measureAll<SixteenLanes>>(lanes, sides, votes);
}

void writeFeatures(const BorderLanes& lanes, const BorderSides& sides, const BorderVotes& votes, BorderFeatureLanes& features) {
    vectorised<writeAll>(lanes, sides, votes, features);
}

} // namespace edgescan::rocks
