// Counts the cells that fold around each cell.
#include "core/edges/edgescan_plus/roughness.h"

#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/crease.h"
#include "core/scan/grid/marked_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <utility>

namespace edgescan::edges {
namespace {

constexpr float kNearlyEdge = 0.7F;              // of the threshold: a fold that may become an edge
constexpr double kRoughScan = 0.46;              // median of the shares around such folds
constexpr float kRoughFrom = 0.42F;              // share from which a fold must be stronger
constexpr float kReachRad = 0.265F;              // 15 degrees to each side
constexpr int kLeastReach = 10, kMostReach = 90; // cells
constexpr int kEvery = 4;                        // lines of which one is looked at for the median
constexpr double kNoiseExplains = 1.2;           // fold of noise in units of C0, from which on folds may be noise
constexpr double kNoiseFloor = 4.5;              // standard deviations that a fold must exceed, as in Step 5
constexpr float kWidestSpacingMm = 80; // of points: three of them, the shortest side of a fold, are as long as a small rock from here on

EDGESCAN_INLINE void markFolding(const float* alongBeams, const float* alongLines, const Support* support, int beams,
                                 std::uint8_t* __restrict folding, std::uint8_t* __restrict solid) {
    for (int j = 0; j < beams; ++j) {
        const float fold = std::max(std::abs(alongBeams[j]), std::abs(alongLines[j]));
        const bool isSolid = support[j] != Support::Void;
        folding[j] = static_cast<std::uint8_t>((fold > kFoldingFrom) & isSolid);
        solid[j] = static_cast<std::uint8_t>(isSolid);
    }
}

float middleOf(const std::vector<float>& steps) { return median(steps, 0.0F); }

int reachOf(float stepRad) {
    return std::clamp(static_cast<int>(std::lround(kReachRad / std::max(stepRad, 1e-4F))), kLeastReach, kMostReach);
}

// The sum over the lines and groups within reach of each one.
Grid<std::uint32_t> sumsAround(const Grid<std::uint8_t>& counts, int up, int aside) {
    Grid<std::uint32_t> sums(counts.lines, counts.beams);
    std::vector<std::uint32_t> column(static_cast<std::size_t>(counts.beams)), upTo(column.size() + 1);
    const auto addLine = [&](int line, std::uint32_t sign) {
        const std::uint8_t* from = counts.line(line);
        for (std::size_t g = 0; g < column.size(); ++g) column[g] += sign * from[g];
    };
    for (int i = 0; i < std::min(up, counts.lines); ++i) addLine(i, 1);
    for (int i = 0; i < counts.lines; ++i) {
        if (i + up < counts.lines) addLine(i + up, 1);
        if (i - up - 1 >= 0) addLine(i - up - 1, ~0U);
        for (std::size_t g = 0; g < column.size(); ++g) upTo[g + 1] = upTo[g] + column[g];
        std::uint32_t* out = sums.line(i);
        for (int g = 0; g < counts.beams; ++g)
            out[g] = upTo[static_cast<std::size_t>(std::min(counts.beams, g + aside + 1))] -
                     upTo[static_cast<std::size_t>(std::max(0, g - aside))];
    }
    return sums;
}

EDGESCAN_INLINE void markNearlyEdges(const float* fold, int beams, std::uint8_t* __restrict marked) {
    for (int j = 0; j < beams; ++j) marked[j] = static_cast<std::uint8_t>(std::abs(fold[j]) > kNearlyEdge);
}

// Calls of(line, beam) for the folds that are, or are nearly, edges, on every fourth line.
template <class Of>
void forFolds(const Grid<float>& crease, Of of) {
    std::vector<std::uint8_t> marked(static_cast<std::size_t>(crease.beams));
    for (int i = 0; i < crease.lines; i += kEvery) {
        vectorised<markNearlyEdges>(crease.line(i), crease.beams, marked.data());
        forEachMarked(marked, [&](std::size_t beam) { of(i, static_cast<int>(beam)); });
    }
}

// The median distance of points at the folds: the side of the square that a cell covers across the beam.
float spacingOfFoldsMm(const Grid<float>& u, const AngularSteps& steps, const Grid<float>& crease) {
    std::vector<float> spacings;
    forFolds(crease, [&](int i, int j) {
        spacings.push_back(1000.0F * std::sqrt(steps.beam[static_cast<std::size_t>(j)] * steps.lineAt(i, j)) / u.at(i, j));
    });
    return median(std::move(spacings), 0.0F);
}

double total(const Grid<std::uint8_t>& counts) {
    return static_cast<double>(std::accumulate(counts.cells.begin(), counts.cells.end(), std::size_t{0}));
}

} // namespace

void countGroups(const std::vector<std::uint8_t>& marks, std::uint8_t* counts) {
    constexpr auto kGroup = static_cast<std::size_t>(Roughness::kGroup);
    constexpr std::uint64_t kOnes = 0x0101010101010101U;
    for (std::size_t at = 0; at < marks.size(); at += kGroup) {
        std::array<std::uint64_t, kGroup / sizeof(std::uint64_t)> eight;
        std::memcpy(eight.data(), marks.data() + at, kGroup);
        counts[at / kGroup] = static_cast<std::uint8_t>(((eight[0] + eight[1]) * kOnes) >> 56U);
    }
}

FoldingCells::FoldingCells(int lines, int beamCount)
    : folding(lines, (beamCount + Roughness::kGroup - 1) / Roughness::kGroup), solid(lines, folding.beams), beams(beamCount) {}

void FoldingCells::note(int line, const float* alongBeams, const float* alongLines, const Support* support) {
    thread_local std::vector<std::uint8_t> folds, solids;
    folds.assign(static_cast<std::size_t>(folding.beams) * Roughness::kGroup, 0);
    solids.assign(folds.size(), 0);
    vectorised<markFolding>(alongBeams, alongLines, support, beams, folds.data(), solids.data());
    countGroups(folds, folding.line(line));
    countGroups(solids, solid.line(line));
}

float Roughness::factorAt(int line, int beam) const {
    const float times = aroundAt(line, beam) / kRoughFrom;
    const float square = times * times;
    return times <= 1 ? 1.0F : square * square * square;
}

double foldOfNoise(const DepthLimits& limits, double rangeM, double spacingMm) {
    if (!(rangeM > 0) || !(spacingMm > 0)) return 0;
    constexpr double kDegPerRad = 57.29578;
    const int cells = std::clamp(static_cast<int>(static_cast<double>(limits.windowMm) / spacingMm + 0.5), 3, 15) + 1;
    const double slope = std::sqrt(12.0 / (cells * (static_cast<double>(cells) * cells - 1)));
    const double deg = kNoiseFloor * static_cast<double>(kFoldOfWhite) * limits.foldNoise.at(rangeM) * slope / spacingMm * kDegPerRad;
    return deg / static_cast<double>(limits.creaseDeg);
}

Roughness roughnessOf(const FoldingCells& cells, const Grid<float>& u, const AngularSteps& steps, const Grid<float>& crease,
                      double ofNoise) {
    Roughness result;
    if (cells.folding.size() == 0) return result;
    result.share = total(cells.folding) / std::max(1.0, total(cells.solid));
    const int up = reachOf(middleOf(steps.line)), aside = (reachOf(middleOf(steps.beam)) + Roughness::kGroup / 2) / Roughness::kGroup;
    const Grid<std::uint32_t> folding = sumsAround(cells.folding, up, aside);
    const Grid<std::uint32_t> solid = sumsAround(cells.solid, up, aside);
    result.around = Grid<float>(folding.lines, folding.beams);
    for (std::size_t k = 0; k < folding.size(); ++k)
        result.around[k] = solid[k] > 0 ? static_cast<float>(folding[k]) / static_cast<float>(solid[k]) : 0.0F;
    std::vector<float> aroundFolds;
    forFolds(crease, [&](int i, int j) { aroundFolds.push_back(result.aroundAt(i, j)); });
    result.aroundFolds = static_cast<double>(median(std::move(aroundFolds), 0.0F));
    result.rough = ofNoise < kNoiseExplains && result.aroundFolds > kRoughScan && spacingOfFoldsMm(u, steps, crease) < kWidestSpacingMm;
    if (!result.rough) result.around = {};
    return result;
}

void weighFolds(const Roughness& roughness, Grid<float>& crease) {
    if (!roughness.rough) return;
    for (int i = 0; i < crease.lines; ++i) {
        float* fold = crease.line(i);
        for (int j = 0; j < crease.beams; ++j) {
            if (fold[j] != 0) fold[j] /= roughness.factorAt(i, j);
        }
    }
}

} // namespace edgescan::edges
