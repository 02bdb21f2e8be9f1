// Assigns cells on the borders of segments to the segment whose plane fits them.
#include "core/rocks/segmentation/refinement.h"

#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/cell_moves.h"
#include "core/rocks/segmentation/equal_runs.h"
#include "core/rocks/segmentation/inner_cells.h"
#include "core/rocks/segmentation/planes.h"
#include "core/rocks/segmentation/segment_choice.h"
#include "core/scan/grid/beam_width.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace edgescan::rocks {
namespace {

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
