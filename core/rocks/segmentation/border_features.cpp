// Measures the surroundings of cells: planes, neighbours, a profile across the border. First each cell is looked up, then all are computed
// at once.
#include "core/rocks/segmentation/border_features.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/border_lanes.h"
#include "core/scan/grid/beam_width.h"

#include <algorithm>
#include <cstdlib>

namespace edgescan::rocks {
namespace {

constexpr double kLeastNoiseMm = 0.1;

// Writes the surroundings of one cell to its lane.
class Surroundings {
public:
    Surroundings(const Inputs& inputs, const InnerCells& cells, const BorderPlace& place, std::size_t lane, BorderLanes& lanes)
        : inputs_(inputs), cells_(cells), place_(place), lane_(lane), to_(lanes), k_(inputs.scan->rangeMm.index(place.line, place.beam)) {}

    void lookUp() {
        to_.segment[0][lane_] = place_.own;
        to_.segment[1][lane_] = place_.other;
        cellsAround();
        planes();
        cracks();
        const auto rangeM = static_cast<double>(to_.rangeM[lane_] = 1.0F / cells_.u[cells_.index(place_.line, place_.beam)]);
        to_.smoothedRangeM[lane_] = 1.0F / inputs_.cracks->smoothed[k_];
        to_.perM[lane_] = static_cast<float>(1000.0 / std::max(kLeastNoiseMm, inputs_.responses->noise.at(rangeM)));
        const AngularSteps& steps = inputs_.surface->steps;
        to_.beamStep[lane_] = steps.beam[static_cast<std::size_t>(place_.beam)];
        to_.lineStep[lane_] = steps.lineAt(place_.line, place_.beam);
        constexpr BeamWidth kBeam{};
        to_.footprintMm[lane_] = static_cast<float>(1000.0 * kBeam.at(rangeM));
        to_.jumpHere[lane_] = jumpAt(place_.line, place_.beam);
        to_.foldHere[lane_] = foldAt(place_.line, place_.beam);
    }
    // The cells along one step across the border: `down` lines and `right` beams, towards the other segment.
    void lookAcross(int down, int right) {
        const int middle = static_cast<int>(kCellsAround / 2), step = down * static_cast<int>(kAcross) + right;
        for (std::size_t n = 0; n < kProfile.size(); ++n) {
            const auto q = static_cast<std::size_t>(middle + kProfile[n] * step);
            to_.profileU[n][lane_] = to_.solid[q][lane_] == kVoidCell ? 0.0F : to_.u[q][lane_];
        }
        for (const int way : {-1, 1}) {
            const std::size_t n = way < 0 ? 0 : 1;
            to_.jumps[n][lane_] = jumpAt(place_.line + way * down, place_.beam + way * right);
            to_.folds[n][lane_] = foldAt(place_.line + way * down, place_.beam + way * right);
        }
    }

private:
    void cellsAround() {
        for (std::size_t row = 0; row < kAcross; ++row) {
            const std::size_t first = cells_.index(place_.line + static_cast<int>(row) - kAround, place_.beam - kAround);
            for (std::size_t n = 0; n < kAcross; ++n) {
                to_.solid[row * kAcross + n][lane_] = cells_.solid[first + n];
                to_.u[row * kAcross + n][lane_] = cells_.u[first + n];
            }
        }
    }
    void planes() {
        const std::size_t window = cells_.index(place_.line - kPlaneReach, place_.beam - kPlaneReach);
        for (std::size_t which = 0; which < 2; ++which)
            addSquaredWindow(&cells_.inner[window], &cells_.u[window], cells_.beams(), to_.segment[which][lane_], to_.windows[which],
                             lane_);
    }
    void cracks() {
        const edges::DepthCracks& cracks = *inputs_.cracks;
        const Grid<float>& fold = cracks.foldLines;
        const auto beams = static_cast<std::size_t>(fold.beams);
        // Beyond the ends of the grid no cell has a segment, so the crack there has no effect.
        const std::size_t above = place_.line > 0 ? k_ - beams : k_, left = place_.beam > 0 ? k_ - 1 : k_;
        const std::size_t below = place_.line + 1 < fold.lines ? k_ + beams : k_, right = place_.beam + 1 < fold.beams ? k_ + 1 : k_;
        const auto set = [&](CellSide side, const Grid<float>& jumps, std::size_t crack, const Grid<float>& folds, std::size_t next) {
            to_.jump[side][lane_] = jumps[crack];
            to_.valley[side][lane_] = std::max(-folds[crack], -folds[next]);
        };
        set(kLineBefore, cracks.jumpLines, above, cracks.foldLines, k_);
        set(kBeamBefore, cracks.jumpBeams, left, cracks.foldBeams, k_);
        set(kNextBeam, cracks.jumpBeams, k_, cracks.foldBeams, right);
        set(kNextLine, cracks.jumpLines, k_, cracks.foldLines, below);
    }
    [[nodiscard]] float jumpAt(int line, int beam) const {
        const Grid<float>& jump = *inputs_.responses->jump;
        return jump.contains(line, beam) ? std::clamp(jump.at(line, beam), 0.0F, 5.0F) : -1.0F;
    }
    [[nodiscard]] float foldAt(int line, int beam) const {
        const Grid<float>& fold = inputs_.responses->crease;
        return fold.contains(line, beam) ? std::clamp(fold.at(line, beam), -5.0F, 5.0F) : 0.0F;
    }

    const Inputs& inputs_;
    const InnerCells& cells_;
    const BorderPlace& place_;
    const std::size_t lane_;
    BorderLanes& to_;
    const std::size_t k_;
};

} // namespace

void BorderFeatures::readEarly(const BorderPlace& place) const {
    const edges::DepthCracks& cracks = *inputs_.cracks;
    const edges::DepthResponses& responses = *inputs_.responses;
    const std::size_t k = inputs_.scan->rangeMm.index(place.line, place.beam);
    for (const Grid<float>* grid : {&cracks.smoothed, &cracks.jumpBeams, &cracks.jumpLines, &cracks.foldBeams, &cracks.foldLines,
                                    responses.jump.get(), &responses.crease})
        __builtin_prefetch(&grid->cells[k]);
    const int above = std::max(place.line - 1, 0), below = std::min(place.line + 1, cracks.foldLines.lines - 1);
    for (const Grid<float>* grid : {&cracks.foldLines, responses.jump.get(), &responses.crease}) {
        __builtin_prefetch(&grid->at(above, place.beam));
        __builtin_prefetch(&grid->at(below, place.beam));
    }
    __builtin_prefetch(&cracks.jumpLines.at(above, place.beam));
}

BorderFeatureLanes BorderFeatures::of(std::span<const BorderPlace> places) const {
    BorderLanes lanes;
    const auto placeOf = [&](std::size_t lane) -> const BorderPlace& { return places[lane < places.size() ? lane : 0]; };
    for (std::size_t lane = 0; lane < kCellsAtOnce; ++lane) Surroundings(inputs_, cells_, placeOf(lane), lane, lanes).lookUp();
    BorderSides sides;
    BorderVotes votes;
    measureSides(lanes, sides, votes);
    for (std::size_t lane = 0; lane < kCellsAtOnce; ++lane) {
        // One step across the border, towards the other segment.
        const bool aside = std::abs(votes.right[lane]) >= std::abs(votes.down[lane]);
        const int down = votes.down[lane] >= 0 ? 1 : -1, right = votes.right[lane] >= 0 ? 1 : -1;
        Surroundings(inputs_, cells_, placeOf(lane), lane, lanes).lookAcross(aside ? 0 : down, aside ? right : 0);
    }
    BorderFeatureLanes features;
    writeFeatures(lanes, sides, votes, features);
    return features;
}

} // namespace edgescan::rocks
