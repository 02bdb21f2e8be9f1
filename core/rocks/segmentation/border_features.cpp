// Measures the surroundings of a cell: planes, neighbours, a profile across the border.
#include "core/rocks/segmentation/border_features.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/scan/grid/beam_width.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace edgescan::rocks {
namespace {

constexpr int kAround = 2;         // cells on each side that are counted
constexpr float kMostOff = 60;     // standard deviations
constexpr float kMostBetween = 10; // the same, of one cell that votes for a plane
constexpr float kNoRange = 99;
constexpr float kAtCorner = 0.75F;     // weight of a diagonal neighbour
constexpr double kLeastInverse = 1e-4; // 1/m
constexpr double kLeastNoiseMm = 0.1;

float offWithin(float value) { return std::clamp(value, -kMostOff, kMostOff); }

float rangeOf(const FittedPlane& plane) { return static_cast<float>(1.0 / std::max(plane.u, kLeastInverse)); }

// The cells within two: towards which side the other segment is, and for which plane their ranges speak.
struct Votes {
    int down = 0, right = 0;
    float own = 0, other = 0, near = 0; // sums of the distance from the plane of `own` minus that from the other one
    int ownCells = 0, otherCells = 0, nearCells = 0;
};

float meanOf(float sum, int cells) { return cells > 0 ? sum / static_cast<float>(cells) : 0.0F; }

Votes votesAt(const InnerCells& cells, std::size_t at, const BorderSide& own, const BorderSide& other, float perM) {
    Votes votes;
    const auto u1 = static_cast<float>(own.plane.u), x1 = static_cast<float>(own.plane.x), y1 = static_cast<float>(own.plane.y);
    const auto u2 = static_cast<float>(other.plane.u), x2 = static_cast<float>(other.plane.x), y2 = static_cast<float>(other.plane.y);
    for (int dy = -kAround; dy <= kAround; ++dy) {
        const std::size_t row =
            dy < 0 ? at - static_cast<std::size_t>(-dy) * cells.beams() : at + static_cast<std::size_t>(dy) * cells.beams();
        for (int dx = -kAround; dx <= kAround; ++dx) {
            const std::size_t q = dx < 0 ? row - static_cast<std::size_t>(-dx) : row + static_cast<std::size_t>(dx);
            const bool isOwn = cells.solid[q] == own.segment;
            if (!isOwn && cells.solid[q] != other.segment) continue;
            votes.down += isOwn ? -dy : dy;
            votes.right += isOwn ? -dx : dx;
            const float u = cells.u[q], x = static_cast<float>(dx), y = static_cast<float>(dy);
            const float deviations = perM / (u * u); // per 1/m
            const float fromOwn = std::min(std::abs(u1 + x1 * x + y1 * y - u) * deviations, kMostBetween);
            const float fromOther = std::min(std::abs(u2 + x2 * x + y2 * y - u) * deviations, kMostBetween);
            const float vote = fromOwn - fromOther;
            (isOwn ? votes.own : votes.other) += vote;
            (isOwn ? votes.ownCells : votes.otherCells) += 1;
            if (std::max(std::abs(dx), std::abs(dy)) > 1) continue;
            votes.near += vote;
            ++votes.nearCells;
        }
    }
    return votes;
}

} // namespace

BorderFeatures::Noise BorderFeatures::noiseAt(std::size_t at) const {
    const float rangeM = 1.0F / cells_.u[at];
    const double noiseMm = std::max(kLeastNoiseMm, inputs_.responses->noise.at(static_cast<double>(rangeM)));
    return {rangeM, static_cast<float>(1000.0 / noiseMm)};
}

BorderSide BorderFeatures::side(int line, int beam, std::uint32_t segment) const {
    const std::size_t at = cells_.index(line, beam);
    const std::size_t k = inputs_.scan->rangeMm.index(line, beam);
    const Noise noise = noiseAt(at);
    const edges::DepthCracks& cracks = *inputs_.cracks;
    const auto gridBeams = static_cast<std::size_t>(inputs_.scan->beams());
    BorderSide side;
    side.segment = segment;
    const std::size_t window = cells_.index(line - kPlaneReach, beam - kPlaneReach);
    side.plane = fittedPlane(&cells_.inner[window], &cells_.u[window], cells_.beams(), segment);
    if (side.plane.n > 0) {
        side.rangeM = rangeOf(side.plane);
        side.off = offWithin((noise.rangeM - side.rangeM) * noise.perM);
        side.smoothOff = offWithin((1.0F / cracks.smoothed[k] - side.rangeM) * noise.perM);
    }
    for (int dy = -kAround; dy <= kAround; ++dy) {
        const std::uint32_t* const row = &cells_.solid[cells_.index(line + dy, beam - kAround)];
        for (int n = 0; n <= 2 * kAround; ++n) side.around += row[n] == segment ? 1.0F : 0.0F;
    }
    side.around -= cells_.solid[at] == segment ? 1.0F : 0.0F;
    float sum = 0;
    int cells = 0;
    const auto take = [&](std::size_t q) {
        const float off = (noise.rangeM - 1.0F / cells_.u[q]) * noise.perM;
        side.closest = std::min(side.closest, std::abs(off));
        sum += offWithin(off);
        ++cells;
    };
    const std::size_t beams = cells_.beams();
    for (const std::size_t q : {at - beams - 1, at - beams + 1, at + beams - 1, at + beams + 1}) {
        if (cells_.solid[q] != segment) continue;
        side.neighbours += kAtCorner;
        take(q);
    }
    const auto adjacent = [&](std::size_t q, std::size_t crack, std::size_t next, const Grid<float>& jumps, const Grid<float>& folds) {
        if (cells_.solid[q] != segment) return;
        const float jump = jumps[crack], valley = std::max(-folds[crack], -folds[next]);
        side.neighbours += 1.0F - 0.5F * std::clamp(std::max(jump, valley), 0.0F, 1.0F);
        side.jump = std::max(side.jump, std::clamp(jump, -1.0F, 5.0F));
        side.valley = std::max(side.valley, std::clamp(valley, -1.0F, 3.0F));
        side.adjacent += 1;
        take(q);
    };
    adjacent(at - beams, k - gridBeams, k, cracks.jumpLines, cracks.foldLines);
    adjacent(at - 1, k - 1, k, cracks.jumpBeams, cracks.foldBeams);
    adjacent(at + 1, k, k + 1, cracks.jumpBeams, cracks.foldBeams);
    adjacent(at + beams, k, k + gridBeams, cracks.jumpLines, cracks.foldLines);
    side.mean = meanOf(sum, cells);
    return side;
}

std::array<float, kBorderFeatures> BorderFeatures::of(int line, int beam, const BorderSide& own, const BorderSide& other) const {
    const std::size_t at = cells_.index(line, beam);
    const auto [r, perM] = noiseAt(at);
    const bool both = own.plane.n > 0 && other.plane.n > 0;
    const Votes votes = votesAt(cells_, at, own, other, both ? perM : 0.0F);
    // One step across the border, towards the other segment.
    const bool aside = std::abs(votes.right) >= std::abs(votes.down);
    const int di = aside ? 0 : votes.down >= 0 ? 1 : -1, dj = !aside ? 0 : votes.right >= 0 ? 1 : -1;
    const auto profile = [&](int steps) {
        const std::size_t q = cells_.index(line + steps * di, beam + steps * dj);
        return cells_.solid[q] == kVoidCell ? kNoRange : offWithin((1.0F / cells_.u[q] - r) * perM);
    };
    const edges::DepthResponses& responses = *inputs_.responses;
    const auto jumpAt = [&](int i, int j) {
        return responses.jump->contains(i, j) ? std::clamp(responses.jump->at(i, j), 0.0F, 5.0F) : -1.0F;
    };
    const auto foldAt = [&](int i, int j) {
        return responses.crease.contains(i, j) ? std::clamp(responses.crease.at(i, j), -5.0F, 5.0F) : 0.0F;
    };
    const AngularSteps& steps = inputs_.surface->steps;
    const float step = steps.beam[static_cast<std::size_t>(beam)];
    const auto scatter = [&](const FittedPlane& plane) {
        return std::clamp(static_cast<float>(plane.scatter) * perM * r * r, 0.0F, 30.0F);
    };
    float apart = 0, toCrossing = 0, between = 0.5F;
    if (both) {
        const double slopeX = own.plane.x - other.plane.x, slopeY = own.plane.y - other.plane.y;
        const double slope = std::max(std::sqrt(slopeX * slopeX + slopeY * slopeY), 1e-7);
        apart = std::clamp((own.rangeM - other.rangeM) * perM, -200.0F, 200.0F);
        toCrossing = static_cast<float>(std::clamp((own.plane.u - other.plane.u) / slope, -8.0, 8.0));
        const float from = other.rangeM - own.rangeM;
        between = std::clamp((r - own.rangeM) / (from == 0 ? 1e-9F : from), -1.0F, 2.0F);
    }
    constexpr BeamWidth kBeam{};
    const auto footprint = static_cast<float>(1000.0 * kBeam.at(static_cast<double>(r)));
    return {own.off,
            other.off,
            own.neighbours,
            other.neighbours,
            own.around,
            other.around,
            static_cast<float>(own.plane.n),
            static_cast<float>(other.plane.n),
            scatter(own.plane),
            scatter(other.plane),
            apart,
            toCrossing,
            between,
            own.jump,
            other.jump,
            own.valley,
            other.valley,
            jumpAt(line, beam),
            foldAt(line, beam),
            own.closest,
            other.closest,
            own.mean,
            other.mean,
            footprint / std::max(1e-3F, 1000.0F * r * step),
            r,
            own.smoothOff,
            other.smoothOff,
            own.adjacent,
            other.adjacent,
            steps.lineAt(line, beam) / step,
            std::abs(own.off) - std::abs(other.off),
            own.neighbours - other.neighbours,
            profile(-2),
            profile(-1),
            profile(1),
            profile(2),
            meanOf(votes.own, votes.ownCells),
            meanOf(votes.other, votes.otherCells),
            meanOf(votes.near, votes.nearCells),
            jumpAt(line - di, beam - dj),
            jumpAt(line + di, beam + dj),
            foldAt(line + di, beam + dj) - foldAt(line - di, beam - dj)};
}

} // namespace edgescan::rocks
