// Weighs neighbours and compares ranges with planes, several cells at once.
#include "core/rocks/segmentation/segment_choice.h"

#include "core/rocks/segmentation/inner_cells.h"

#include <algorithm>
#include <cmath>

namespace edgescan::rocks {
namespace {

constexpr float kAcrossEdge = 0.5F; // weight of a neighbour behind a full jump or valley
constexpr double kLeastU = 1e-4;    // 1/m
constexpr double kLeastNoiseMm = 0.1;

template <class Vector>
EDGESCAN_INLINE Vector weightBehind(const Vector& edge) {
    return (1.0F - kAcrossEdge * edge) * static_cast<float>(1.0 / kWeightUnit);
}

template <class Vector>
using NeighbourWeights = std::array<typename At<Vector>::Numbers, kThreeByThree>;

template <class Vector>
EDGESCAN_INLINE void weighNeighbours(const ChoosingCells& cells, const At<Vector>& at, NeighbourWeights<Vector>& weights) {
    using In = ChoosingCells;
    std::array<Vector, In::kCracks> edge;
    for (std::size_t n = 0; n < edge.size(); ++n) edge[n] = at(cells.edge[n]);
    const std::array<Vector, kThreeByThree> behind{
        smaller(larger(edge[In::kLeft], edge[In::kUpLeft]), larger(edge[In::kUp], edge[In::kAboveLeft])),
        edge[In::kUp],
        smaller(larger(edge[In::kRight], edge[In::kUpRight]), larger(edge[In::kUp], edge[In::kAboveRight])),
        edge[In::kLeft],
        Vector{},
        edge[In::kRight],
        smaller(larger(edge[In::kLeft], edge[In::kDownLeft]), larger(edge[In::kDown], edge[In::kBelowLeft])),
        edge[In::kDown],
        smaller(larger(edge[In::kRight], edge[In::kDownRight]), larger(edge[In::kDown], edge[In::kBelowRight]))};
    for (std::size_t k = 0; k < kThreeByThree; ++k)
        weights[k] = __builtin_convertvector(weightBehind(behind[k]), typename At<Vector>::Numbers);
    weights[kThreeByThree / 2] = typename At<Vector>::Numbers{}; // the cell itself
}

// True if a lane has a bit.
template <class Numbers>
EDGESCAN_INLINE bool any(const Numbers& numbers) {
    std::array<std::uint64_t, sizeof(Numbers) / sizeof(std::uint64_t)> words;
    std::memcpy(words.data(), &numbers, sizeof numbers);
    std::uint64_t all = 0;
    for (const std::uint64_t word : words) all |= word;
    return all != 0;
}

template <class Vector>
EDGESCAN_INLINE void listAll(const ChoosingCells& cells, SegmentChoices& choices) {
    using Numbers = typename At<Vector>::Numbers;
    choices.most = 0;
    for (auto& segment : choices.segment) segment.fill(kNoSegment);
    for (std::size_t lane = 0; lane < kCellsAtOnce; lane += kLanes<Vector>) {
        const At<Vector> at{lane};
        NeighbourWeights<Vector> weights;
        weighNeighbours(cells, at, weights);
        std::array<Numbers, kThreeByThree> left; // segments that are not listed yet, otherwise kNoSegment
        Numbers some{};
        for (std::size_t k = 0; k < left.size(); ++k) {
            const Numbers solid = at(cells.solid[k]);
            left[k] = solid & (solid != static_cast<std::int32_t>(kVoidCell));
            some |= left[k];
        }
        Numbers first{}, mostWeight{};
        for (std::size_t n = 0; any(some); ++n) {
            Numbers segment{}, weight{};
            for (std::size_t k = left.size(); k-- > 0;) segment = left[k] != 0 ? left[k] : segment;
            some = Numbers{};
            for (std::size_t k = 0; k < left.size(); ++k) {
                const Numbers isIn = left[k] == segment;
                weight += weights[k] & isIn;
                left[k] &= ~isIn;
                some |= left[k];
            }
            weight &= segment != 0;
            // The segment with the most neighbours changes places with the first one.
            const Numbers isMore = n == 0 ? Numbers{} - 1 : Numbers(weight > mostWeight);
            const Numbers here = (first & isMore) | (segment & ~isMore), hereWeight = (mostWeight & isMore) | (weight & ~isMore);
            first = (segment & isMore) | (first & ~isMore);
            mostWeight = (weight & isMore) | (mostWeight & ~isMore);
            at.put(choices.segment[n], here);
            at.put(choices.weight[n], hereWeight);
            choices.most = std::max(choices.most, n + 1);
        }
        at.put(choices.segment[0], first);
        at.put(choices.weight[0], mostWeight);
    }
}

EDGESCAN_INLINE void measureAll(const WindowSums& windows, const Lanes<float>& u, const RangeNoise& noise, double without,
                                Lanes<double>& __restrict off) {
    for (std::size_t n = 0; n < kCellsAtOnce; ++n) {
        const double rangeM = 1.0 / static_cast<double>(u[n]);
        const double noiseMm = std::max(noise.at(rangeM), kLeastNoiseMm);
        const PlaneSums sums(windows, n);
        const double deviations = 1000.0 * std::abs(1.0 / std::max(sums.height(), kLeastU) - rangeM) / noiseMm;
        off[n] = sums.n > 0 ? deviations : without;
    }
}

} // namespace

void listChoices(const ChoosingCells& cells, SegmentChoices& choices) {
    vectorised<listAll<FourLanes>, listAll<EightLanes>, listAll<SixteenLanes>>(cells, choices);
}

void measureDeviations(const WindowSums& windows, const Lanes<float>& u, const RangeNoise& noise, double without, Lanes<double>& off) {
    vectorised<measureAll>(windows, u, noise, without, off);
}

} // namespace edgescan::rocks
