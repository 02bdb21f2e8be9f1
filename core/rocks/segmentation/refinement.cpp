// Assigns cells on the borders of segments to the segment whose plane fits them.
#include "core/rocks/segmentation/refinement.h"

#include "core/base/bands.h"
#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/equal_runs.h"
#include "core/rocks/segmentation/inner_cells.h"
#include "core/rocks/segmentation/planes.h"
#include "core/scan/grid/beam_width.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <ranges>
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
constexpr float kAcrossEdge = 0.5F; // weight of a neighbour behind a full jump or valley
constexpr double kFitsOpen = 20.0;  // an open cell is assigned within this many standard deviations
constexpr std::size_t kMostChoices = 9;
constexpr double kLeastU = 1e-4; // 1/m

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

// A segment that a cell may choose.
struct SegmentChoice {
    std::uint32_t segment;
    double neighbours; // weighted number of neighbours in it; smaller weight behind an edge
};

class Refinement {
public:
    Refinement(const InverseRange& inverse, const edges::DepthCracks& cracks, const RangeNoise& noise, double most,
               Grid<std::uint32_t>& segment)
        : inverse_(inverse), noise_(noise), most_(most), segment_(segment),
          inner_(marginBeams_ * static_cast<std::size_t>(segment.lines + 2 * kPlaneReach) + kPlaneColumns),
          solid_(inner_.size(), kVoidCell), u_(inner_.size()), edgeBeams_(inner_.size()), edgeLines_(inner_.size()),
          looked_(segment.lines, segment.beams), weighed_(segment.lines, segment.beams, kNeighbours) {
        const auto beams = static_cast<std::size_t>(segment.beams);
        runInBands(segment.lines, threads_, [&](int from, int end) {
            for (int i = from; i < end; ++i) {
                const std::size_t first = segment.index(i, 0);
                const std::size_t at = marginIndex(i, 0);
                std::copy_n(&inverse.u[first], beams, &u_[at]);
                vectorised<edgesOf>(&cracks.jumpBeams[first], &cracks.foldBeams[first], 1, beams - 1, &edgeBeams_[at]);
                if (i + 1 < segment.lines)
                    vectorised<edgesOf>(&cracks.jumpLines[first], &cracks.foldLines[first], beams, beams, &edgeLines_[at]);
                for (std::size_t j = 0; j < beams; ++j)
                    solid_[at + j] = inverse.support[first + j] != Support::Void ? segment[first + j] : kVoidCell;
            }
        });
        runInBands(segment.lines, threads_, [&](int from, int end) {
            for (int i = from; i < end; ++i) {
                const std::size_t at = marginIndex(i, 0);
                vectorised<markInner>(&solid_[at], marginBeams_, beams, &inner_[at]);
                for (std::size_t j = 0; j < beams; ++j)
                    looked_.line(i)[j] = (inner_[at + j] == kNoSegment) & (solid_[at + j] != kVoidCell) ? kNeighbours : 0;
            }
        });
    }

    void pass() {
        const auto moves = madeOfParts(segment_.lines, threads_, [this](int first, int last) { return movesOf(first, last); });
        std::fill(looked_.cells.begin(), looked_.cells.end(), std::uint8_t{0});
        for (const Move& move : moves | std::views::join) {
            segment_.at(move.line, move.beam) = move.segment;
            solid_[marginIndex(move.line, move.beam)] = move.segment;
        }
        for (const Move& move : moves | std::views::join) {
            look(move.line, move.beam, 1, kNeighbours);
            renewInner(move.line, move.beam);
        }
    }

private:
    struct Move {
        int line, beam;
        std::uint32_t segment;
    };
    // Of these lines. Writes only what it notes for their own cells.
    std::vector<Move> movesOf(int first, int last) {
        std::vector<Move> moves;
        for (int i = first; i < last; ++i) {
            const std::uint8_t* const look = looked_.line(i);
            for (int j = nextLooked(look, 0); j < segment_.beams; j = nextLooked(look, j + 1)) {
                const std::size_t at = marginIndex(i, j);
                if (inner_[at] != kNoSegment || solid_[at] == kVoidCell || (look[j] & weighed_.at(i, j)) == 0) continue;
                const std::uint32_t chosen = choice(i, j);
                if (chosen != solid_[at]) moves.push_back({i, j, chosen});
            }
        }
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
    void look(int line, int beam, int reach, std::uint8_t segments) {
        const int first = std::max(beam - reach, 0);
        const int last = std::min(beam + reach, segment_.beams - 1);
        for (int i = std::max(line - reach, 0); i <= std::min(line + reach, segment_.lines - 1); ++i) {
            for (int j = first; j <= last; ++j) looked_.at(i, j) |= segments;
        }
    }
    // Updates a cell that changed its segment, and its neighbours.
    void renewInner(int line, int beam) {
        for (int i = std::max(line - 1, 0); i <= std::min(line + 1, segment_.lines - 1); ++i) {
            const std::size_t first = marginIndex(i, beam - 1);
            std::array<std::uint32_t, 3> renewed;
            vectorised<markInner>(&solid_[first], marginBeams_, renewed.size(), renewed.data());
            for (std::size_t n = 0; n < renewed.size(); ++n) {
                const int j = beam - 1 + static_cast<int>(n);
                if (j < 0 || j >= segment_.beams || inner_[first + n] == renewed[n]) continue;
                look(i, j, kPlaneReach, markOf(inner_[first + n]) | markOf(renewed[n]));
                inner_[first + n] = renewed[n];
            }
        }
    }
    [[nodiscard]] std::uint32_t choice(int line, int beam) {
        std::array<SegmentChoice, kMostChoices> choices;           // used up to the number of choices
        const std::uint32_t own = solid_[marginIndex(line, beam)]; // as in segment_, and already in the cache
        const std::size_t count = choicesAt(marginIndex(line, beam), choices);
        std::uint8_t& weighed = weighed_.at(line, beam);
        weighed = kNeighbours;
        if (count == 0 || (count == 1 && choices[0].segment == own)) return own;
        // The one with the most neighbours first: after it most others cannot cost less, however well they fit.
        const auto fewer = [](const SegmentChoice& x, const SegmentChoice& y) { return x.neighbours < y.neighbours; };
        std::swap(choices[0], *std::max_element(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(count), fewer));
        const double rangeM = 1.0 / static_cast<double>(inverse_.u.at(line, beam));
        const double noiseMm = std::max(noise_.at(rangeM), 0.1);
        const std::size_t window = marginIndex(line - kPlaneReach, beam - kPlaneReach);
        std::uint32_t best = own;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t n = 0; n < count; ++n) {
            if (-kPerNeighbour * choices[n].neighbours > least) continue;
            weighed |= markOf(choices[n].segment);
            const PlaneSums plane = planeSums(&inner_[window], &u_[window], marginBeams_, choices[n].segment);
            // In standard deviations of the noise.
            const double off = plane.n == 0 ? most_ : 1000.0 * std::abs(1.0 / std::max(plane.height(), kLeastU) - rangeM) / noiseMm;
            if (own == kNoSegment && off >= kFitsOpen) continue;
            const double cost = (off > most_ ? most_ + kBeyond * (off - most_) : off) - kPerNeighbour * choices[n].neighbours;
            if (cost < least || (cost == least && choices[n].segment < best)) {
                least = cost;
                best = choices[n].segment;
            }
        }
        return best;
    }
    // The weight of each of the eight neighbours, by line, then beam; smaller behind a jump or valley. For a diagonal neighbour: the path
    // around the corner with the larger weight.
    [[nodiscard]] std::array<double, 9> neighbourWeights(std::size_t at) const {
        const float* const up = &edgeLines_[at - marginBeams_]; // towards the line before
        const float* const down = &edgeLines_[at];
        const float* const above = &edgeBeams_[at - marginBeams_ - 1];
        const float* const here = &edgeBeams_[at - 1];
        const float* const below = &edgeBeams_[at + marginBeams_ - 1];
        const auto counts = [](float edge) { return static_cast<double>(1.0F - kAcrossEdge * edge); };
        const auto corner = [&](float one, float then, float other, float next) {
            return counts(std::min(std::max(one, then), std::max(other, next)));
        };
        return {corner(here[0], up[-1], up[0], above[0]),
                counts(up[0]),
                corner(here[1], up[1], up[0], above[1]),
                counts(here[0]),
                0.0,
                counts(here[1]),
                corner(here[0], down[-1], down[0], below[0]),
                counts(down[0]),
                corner(here[1], down[1], down[0], below[1])};
    }
    // The segments of the cell and its neighbours, with the weighted number of neighbours in each.
    std::size_t choicesAt(std::size_t at, std::array<SegmentChoice, kMostChoices>& choices) const {
        std::array<std::uint32_t, 9> segments;
        for (std::size_t n = 0; n < 3; ++n) std::copy_n(&solid_[at + n * marginBeams_ - marginBeams_ - 1], 3, &segments[3 * n]);
        const std::array<double, 9> weights = neighbourWeights(at);
        std::size_t count = 0;
        for (std::size_t k = 0; k < segments.size(); ++k) {
            if (segments[k] == kNoSegment || segments[k] == kVoidCell) continue;
            std::size_t n = 0;
            while (n < count && choices[n].segment != segments[k]) ++n;
            if (n == count) choices[count++] = {segments[k], 0.0};
            choices[n].neighbours += weights[k];
        }
        return count;
    }
    // Index of a cell in the grids with a margin.
    [[nodiscard]] std::size_t marginIndex(int line, int beam) const {
        return static_cast<std::size_t>(line + kPlaneReach) * marginBeams_ + static_cast<std::size_t>(beam + kPlaneReach);
    }

    const InverseRange& inverse_;
    const RangeNoise& noise_;
    const double most_;
    Grid<std::uint32_t>& segment_;
    const int threads_ = bandsFor(segment_.size(), 0);
    // With kPlaneReach more cells on each side, and a few more behind them.
    const std::size_t marginBeams_ = static_cast<std::size_t>(segment_.beams + 2 * kPlaneReach);
    std::vector<std::uint32_t> inner_; // the segment of cells that do not touch another one, otherwise kOpen
    std::vector<std::uint32_t> solid_; // the segment, or kVoidCell without a range
    std::vector<float> u_;
    std::vector<float> edgeBeams_, edgeLines_; // between each cell and the next one in the direction
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
