// Assigns cells on the borders of segments to the segment whose plane fits them.
#include "core/rocks/segmentation/refinement.h"

#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/cell_moves.h"
#include "core/rocks/segmentation/equal_runs.h"
#include "core/rocks/segmentation/inner_cells.h"
#include "core/rocks/segmentation/lanes.h"
#include "core/rocks/segmentation/planes.h"
#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/beam_width.h"
#include "core/scan/grid/inverse_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace edgescan::rocks {
namespace {

/// A cell and its neighbours by line, then beam.
inline constexpr std::size_t kThreeByThree = 9;

/// Cells that choose among the segments of their neighbours, a cell per lane.
struct ChoosingCells {
    /// Cracks between the cells of the 3 x 3, by line, then beam: six towards the next beam, six towards the next line.
    enum Crack : std::size_t {
        kAboveLeft,
        kAboveRight,
        kLeft,
        kRight,
        kBelowLeft,
        kBelowRight,
        kUpLeft,
        kUp,
        kUpRight,
        kDownLeft,
        kDown,
        kDownRight,
        kCracks
    };
    std::array<Lanes<std::uint32_t>, kThreeByThree> solid; ///< segments as in InnerCells
    std::array<Lanes<float>, kCracks> edge;                ///< 0..1: strength of the jump or valley there
    Lanes<float> u;                                        ///< 1/m
};

/// The segments that each cell may choose: those of the cell and its neighbours. A cell with fewer than others has kNoSegment there.
struct SegmentChoices {
    std::size_t most = 0; ///< number of choices of the cell that has most
    std::array<Lanes<std::uint32_t>, kThreeByThree> segment;
    /// Weights of the neighbours in it, in units of kWeightUnit; of the first segment the largest.
    std::array<Lanes<std::int32_t>, kThreeByThree> weight;
};

/// Weights are whole multiples of this, so that their sums are exact.
inline constexpr double kWeightUnit = 1.0 / (1U << 24U);

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

/// A neighbour behind an edge weighs less. For a diagonal neighbour: the path around the corner with the larger weight.
void listChoices(const ChoosingCells& cells, SegmentChoices& choices) {
    vectorised<listAll<FourLanes>, listAll<EightLanes>, listAll<SixteenLanes>>(cells, choices);
}

/// How far the ranges of the cells are from the planes, in standard deviations of the noise; `without` where a plane has no cells.
void measureDeviations(const WindowSums& windows, const Lanes<float>& u, const RangeNoise& noise, double without, Lanes<double>& off) {
    vectorised<measureAll>(windows, u, noise, without, off);
}

constexpr int kPasses = 4;
// mostDeviations(): ratio of the beam's growth to the step from beam to beam.
constexpr double kApart = 1.1;
constexpr double kOverlapping = 1.5;
constexpr double kMostApart = 5.0;
constexpr double kMostOverlapping = 30.0;
constexpr double kBeyond = 0.01;
constexpr double kPerNeighbour = 2.0;
constexpr double kFitsOpen = 20.0; // an open cell is assigned within this many standard deviations

// 0..1 on the crack between each cell and the next one in the direction: strength of the jump or valley there.
EDGESCAN_INLINE void edgesOf(const float* jump, const float* fold, std::size_t step, std::size_t cells, float* __restrict edge) {
    for (std::size_t k = 0; k < cells; ++k) {
        const float valley = std::max(-fold[k], -fold[k + step]);
        edge[k] = std::min(std::max(std::max(jump[k], valley), 0.0F), 1.0F);
    }
}

// Bits for the inputs of a choice: one for the segments of the neighbours, and one of seven for each segment that was considered.
constexpr std::uint8_t kNeighbours = 128;
std::uint8_t markOf(std::uint32_t segment) {
    return segment == kNoSegment || segment == kVoidCell ? std::uint8_t{0} : static_cast<std::uint8_t>(1U << (segment % 7U));
}

class Refinement {
public:
    Refinement(const InverseRange& inverse, const edges::DepthCracks& cracks, const RangeNoise& noise, double most,
               Grid<std::uint32_t>& segment)
        : noise_(noise), most_(most), segment_(segment), cells_(inverse, segment), edgeBeams_(cells_.solid.size()),
          edgeLines_(cells_.solid.size()), looked_(segment.lines, segment.beams), weighed_(segment.lines, segment.beams, kNeighbours) {
        const auto beams = static_cast<std::size_t>(segment.beams);
        runInBands(segment.lines, threads_, [&](int from, int end) {
            for (int i = from; i < end; ++i) {
                const std::size_t first = segment.index(i, 0);
                const std::size_t at = cells_.index(i, 0);
                vectorised<edgesOf>(&cracks.jumpBeams[first], &cracks.foldBeams[first], 1, beams - 1, &edgeBeams_[at]);
                if (i + 1 < segment.lines)
                    vectorised<edgesOf>(&cracks.jumpLines[first], &cracks.foldLines[first], beams, beams, &edgeLines_[at]);
                for (std::size_t j = 0; j < beams; ++j) looked_.line(i)[j] = cells_.touches(at + j) ? kNeighbours : 0;
            }
        });
    }

    void pass() {
        const CellMoves moves = madeOfParts(segment_.lines, threads_, [this](int first, int last) { return movesOf(first, last); });
        std::fill(looked_.cells.begin(), looked_.cells.end(), std::uint8_t{0});
        eachMove(moves, segment_.lines, 0, threads_, [this](const CellMove& move) {
            segment_.at(move.line, move.beam) = move.segment;
            cells_.assign(move.line, move.beam, move.segment);
        });
        const auto look = [this](int line, int beam, std::uint32_t before, std::uint32_t after) {
            lookAgain(line, beam, kPlaneReach, markOf(before) | markOf(after));
        };
        eachMove(moves, segment_.lines, kPlaneReach + 1, threads_, [&](const CellMove& move) {
            lookAgain(move.line, move.beam, 1, kNeighbours);
            cells_.renew(move.line, move.beam, look);
        });
    }

private:
    // Cells that choose together.
    struct Choosing {
        ChoosingCells cells;
        WindowSums windows;
        std::array<CellMove, kCellsAtOnce> at; // with the segment that each cell has
        std::size_t count = 0;
    };
    // Of these lines. Writes only what it notes for their own cells.
    std::vector<CellMove> movesOf(int first, int last) {
        std::vector<CellMove> moves;
        Choosing choosing{};
        for (int i = first; i < last; ++i) {
            const std::uint8_t* const look = looked_.line(i);
            for (int j = nextLooked(look, 0); j < segment_.beams; j = nextLooked(look, j + 1)) {
                if (!cells_.touches(cells_.index(i, j)) || (look[j] & weighed_.at(i, j)) == 0) continue;
                lookUp(i, j, choosing);
                if (choosing.count == kCellsAtOnce) choose(choosing, moves);
            }
        }
        if (choosing.count > 0) choose(choosing, moves);
        return moves;
    }
    // The next marked cell of a line, searched eight at a time.
    [[nodiscard]] int nextLooked(const std::uint8_t* look, int from) const {
        for (std::uint64_t eight = 0; from + 8 <= segment_.beams; from += 8) {
            std::memcpy(&eight, look + from, sizeof eight);
            if (eight != 0) break;
        }
        while (from < segment_.beams && look[from] == 0) ++from;
        return from;
    }
    // A cell's choice depends on the segments of its neighbours, and on which cells of its window are inner cells of the segments that it
    // considered. If neither changed, its choice is the same as before.
    void lookAgain(int line, int beam, int reach, std::uint8_t segments) {
        const int first = std::max(beam - reach, 0);
        const int last = std::min(beam + reach, segment_.beams - 1);
        constexpr std::uint64_t kEachByte = 0x0101010101010101U;
        for (int i = std::max(line - reach, 0); i <= std::min(line + reach, segment_.lines - 1); ++i) {
            std::uint8_t* at = &looked_.at(i, first);
            std::uint8_t* const end = at + (last - first) + 1;
            for (; at + 8 <= end; at += 8) {
                std::uint64_t eight;
                std::memcpy(&eight, at, sizeof eight);
                eight |= segments * kEachByte;
                std::memcpy(at, &eight, sizeof eight);
            }
            for (; at < end; ++at) *at |= segments;
        }
    }
    // Adds a cell to those that choose.
    void lookUp(int line, int beam, Choosing& choosing) const {
        const std::size_t at = cells_.index(line, beam), lane = choosing.count;
        ChoosingCells& cells = choosing.cells;
        for (std::size_t row = 0; row < 3; ++row) {
            const std::size_t first = at + row * cells_.beams() - cells_.beams() - 1;
            for (std::size_t n = 0; n < 3; ++n) cells.solid[3 * row + n][lane] = cells_.solid[first + n];
            for (std::size_t n = 0; n < 2; ++n) cells.edge[ChoosingCells::kAboveLeft + 2 * row + n][lane] = edgeBeams_[first + n];
            if (row == 2) break;
            for (std::size_t n = 0; n < 3; ++n) cells.edge[ChoosingCells::kUpLeft + 3 * row + n][lane] = edgeLines_[first + n];
        }
        cells_.readBelowEarly(at);
        __builtin_prefetch(&edgeBeams_[at + 2 * cells_.beams()]);
        __builtin_prefetch(&edgeLines_[at + cells_.beams()]);
        cells.u[lane] = cells_.u[at];
        choosing.at[lane] = {line, beam, cells_.solid[at]};
        ++choosing.count;
    }
    // Lets the cells choose, and adds those that move.
    void choose(Choosing& choosing, std::vector<CellMove>& moves) {
        SegmentChoices choices;
        listChoices(choosing.cells, choices);
        Lanes<double> least;
        least.fill(std::numeric_limits<double>::infinity());
        Lanes<std::uint32_t> best;
        for (std::size_t lane = 0; lane < choosing.count; ++lane) {
            best[lane] = choosing.at[lane].segment;
            weighed_.at(choosing.at[lane].line, choosing.at[lane].beam) = kNeighbours;
        }
        // The one with the most neighbours first: after it most others cannot cost less, however well they fit.
        for (std::size_t n = 0; n < choices.most; ++n) consider(choosing, choices, n, least, best);
        for (std::size_t lane = 0; lane < choosing.count; ++lane) {
            const CellMove& at = choosing.at[lane];
            if (best[lane] != at.segment) moves.push_back({at.line, at.beam, best[lane]});
        }
        choosing.count = 0;
    }
    // The n-th segment of each cell that may cost less than the best one so far.
    void consider(Choosing& choosing, const SegmentChoices& choices, std::size_t n, Lanes<double>& least, Lanes<std::uint32_t>& best) {
        const auto bonus = [&](std::size_t lane) { return kPerNeighbour * kWeightUnit * choices.weight[n][lane]; };
        Lanes<std::size_t> active;
        std::size_t count = 0;
        for (std::size_t lane = 0; lane < choosing.count; ++lane) {
            const std::uint32_t segment = choices.segment[n][lane];
            if (segment == kNoSegment || -bonus(lane) > least[lane]) continue;
            const CellMove& at = choosing.at[lane];
            weighed_.at(at.line, at.beam) |= markOf(segment);
            const std::size_t window = cells_.index(at.line - kPlaneReach, at.beam - kPlaneReach);
            addWindow(&cells_.inner[window], &cells_.u[window], cells_.beams(), segment, choosing.windows, lane);
            active[count++] = lane;
        }
        if (count == 0) return;
        Lanes<double> offs;
        measureDeviations(choosing.windows, choosing.cells.u, noise_, most_, offs);
        for (const std::size_t lane : std::span(active).first(count)) {
            const double off = offs[lane];
            if (choosing.at[lane].segment == kNoSegment && off >= kFitsOpen) continue;
            const double cost = (off > most_ ? most_ + kBeyond * (off - most_) : off) - bonus(lane);
            const std::uint32_t segment = choices.segment[n][lane];
            if (!(cost < least[lane] || (cost == least[lane] && segment < best[lane]))) continue;
            least[lane] = cost;
            best[lane] = segment;
        }
    }

    const RangeNoise& noise_;
    const double most_;
    Grid<std::uint32_t>& segment_;
    const int threads_ = bandsFor(segment_.size(), 0);
    InnerCells cells_;
    std::vector<float> edgeBeams_, edgeLines_; // as in cells_: between each cell and the next one in the direction
    Grid<std::uint8_t> looked_;                // bits of the inputs that changed since the cell's last choice
    Grid<std::uint8_t> weighed_;               // bits of the inputs of that choice
};

void dissolveSmallSegments(Grid<std::uint32_t>& segment, std::uint32_t count) {
    std::vector<std::size_t> cells(static_cast<std::size_t>(count) + 1);
    eachEqualRun(segment.cells, [&](std::uint32_t of, std::size_t begin, std::size_t end) { cells[of] += end - begin; });
    eachEqualRun(segment.cells, [&](std::uint32_t of, std::size_t begin, std::size_t end) {
        if (cells[of] < kSmallestSegment) std::fill(&segment.cells[begin], &segment.cells[begin] + (end - begin), kNoSegment);
    });
}

} // namespace

double mostDeviations(const AngularSteps& steps) {
    const double beamToBeam = std::sqrt(static_cast<double>(median(steps.beam)) * static_cast<double>(median(steps.line)) *
                                        static_cast<double>(median(steps.fromAxis)));
    if (!(beamToBeam > 0)) return kMostOverlapping;
    const double overlap = (BeamWidth{}.growthRad / beamToBeam - kApart) / (kOverlapping - kApart);
    return kMostApart + (kMostOverlapping - kMostApart) * std::clamp(overlap, 0.0, 1.0);
}

void refineSegments(const InverseRange& inverse, const edges::DepthCracks& cracks, const RangeNoise& noise, double most,
                    Grid<std::uint32_t>& segment, std::uint32_t count) {
    dissolveSmallSegments(segment, count);
    Refinement refinement(inverse, cracks, noise, most, segment);
    for (int pass = 0; pass < kPasses; ++pass) refinement.pass();
}

} // namespace edgescan::rocks
