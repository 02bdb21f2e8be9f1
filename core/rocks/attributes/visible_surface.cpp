// Takes cells behind a rock from its rim, until its rim has no depth jump.
#include "core/rocks/attributes/visible_surface.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/basins.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan::rocks {
namespace {

constexpr double kLeastStepM = 0.1;     // no smaller step between neighbours is a jump by itself
constexpr double kSteepest = 5.67;      // tan 80 degrees: no surface that is seen steeper has cells of its own
constexpr double kOffSurfaceM = 0.04;   // a cell between two surfaces is farther than this from the one that it was moved to
constexpr std::uint32_t kLeastPart = 4; // a part that was cut off has at least one cell for so many of the largest part

struct Step {
    int line, beam;
};
constexpr std::array<Step, 8> kAround{
    {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}}; // the first four share a side

class Peeling {
public:
    Peeling(const Segmentation& segments, Grid<std::uint32_t> labels)
        : inputs_(segments.inputs), tables_(*inputs_.scan), labels_(std::move(labels)), taken_(labels_.lines, labels_.beams) {}

    // Takes cells away until every cell of a rim may stay.
    void run() {
        std::vector<std::uint32_t> open;
        for (std::size_t k = labels_.size(); k-- > 0;) {
            if (labels_[k] != 0) open.push_back(static_cast<std::uint32_t>(k));
        }
        while (!open.empty()) {
            const std::uint32_t k = open.back();
            open.pop_back();
            const std::uint32_t label = labels_[k];
            if (label == 0 || !isRim(k) || !isBehind(k)) continue;
            labels_[k] = 0;
            taken_[k] = label;
            forNeighbours(k, [&](std::size_t n, const Step&) {
                if (labels_[n] == label) open.push_back(static_cast<std::uint32_t>(n));
                return false;
            });
        }
    }

    // Leaves out the small parts that were cut off.
    [[nodiscard]] Grid<std::uint32_t> withoutCrumbs(std::uint32_t rocks) {
        JoinedGroups parts(labels_.size());
        const auto beams = static_cast<std::size_t>(labels_.beams);
        for (std::size_t k = 0; k < labels_.size(); ++k) {
            const auto join = [&](std::size_t n) {
                if (labels_[n] == labels_[k]) parts.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(n));
            };
            if (labels_[k] == 0) continue;
            if (k % beams + 1 < beams) join(k + 1);
            if (k + beams < labels_.size()) join(k + beams);
        }
        std::vector<std::uint32_t> cells(labels_.size(), 0), largest(rocks + std::size_t{1}, 0);
        std::vector<bool> isCutOff(labels_.size(), false);
        for (std::uint32_t k = 0; k < labels_.size(); ++k) {
            if (labels_[k] == 0) continue;
            const std::uint32_t part = parts.of(k);
            largest[labels_[k]] = std::max(largest[labels_[k]], ++cells[part]);
            if (forNeighbours(k, [&](std::size_t n, const Step&) { return taken_[n] == labels_[k]; })) isCutOff[part] = true;
        }
        for (std::uint32_t k = 0; k < labels_.size(); ++k) {
            const std::uint32_t part = labels_[k] == 0 ? 0 : parts.of(k);
            if (labels_[k] != 0 && isCutOff[part] && cells[part] * kLeastPart < largest[labels_[k]]) labels_[k] = 0;
        }
        return std::move(labels_);
    }

private:
    // True if `test` is for one of the neighbours in the grid.
    template <class Test>
    bool forNeighbours(std::size_t k, const Test& test) const {
        const int line = static_cast<int>(k / static_cast<std::size_t>(labels_.beams));
        const int beam = static_cast<int>(k % static_cast<std::size_t>(labels_.beams));
        return std::ranges::any_of(kAround, [&](const Step& step) {
            return labels_.contains(line + step.line, beam + step.beam) && test(labels_.index(line + step.line, beam + step.beam), step);
        });
    }

    // Whether a side of the cell is on the outline.
    [[nodiscard]] bool isRim(std::size_t k) const {
        int same = 0;
        forNeighbours(k, [&](std::size_t n, const Step& step) {
            same += (step.line == 0 || step.beam == 0) && labels_[n] == labels_[k] ? 1 : 0;
            return false;
        });
        return same < 4;
    }

    [[nodiscard]] bool isMeasured(std::size_t k) const { return inputs_.surface->inverse.support[k] == Support::Measured; }

    [[nodiscard]] bool isBehind(std::size_t k) const {
        if (!isMeasured(k)) return true;
        const double rangeM = 0.001 * static_cast<double>(inputs_.scan->rangeMm[k]);
        if (std::abs(rangeM * static_cast<double>(inputs_.cracks->smoothed[k]) - 1) * rangeM > kOffSurfaceM) return true;
        return forNeighbours(k, [&](std::size_t n, const Step& step) {
            return labels_[n] == labels_[k] && isMeasured(n) && inputs_.scan->rangeMm[n] < inputs_.scan->rangeMm[k] &&
                   (isBroken(k, n, step) || isTooSteep(k, n));
        });
    }

    [[nodiscard]] bool isTooSteep(std::size_t farther, std::size_t nearer) const {
        const Eigen::Vector3d far = tables_.point(farther) - tables_.sensor();
        const Eigen::Vector3d near = tables_.point(nearer) - tables_.sensor();
        const double across = far.cross(near).norm() / std::max(far.norm(), 1e-9);
        return far.norm() - near.norm() > std::max(kLeastStepM, kSteepest * across);
    }

    // Whether the surface breaks between two cells with a side in common; of diagonal neighbours: on both ways around the corner.
    [[nodiscard]] bool isBroken(std::size_t k, std::size_t n, const Step& step) const {
        if (step.line == 0 || step.beam == 0) return crackIsBroken(k, n, step.line == 0);
        const auto beam = static_cast<std::ptrdiff_t>(step.beam);
        const auto besideK = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) + beam);
        const auto besideN = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(n) - beam);
        return (crackIsBroken(k, besideK, true) || crackIsBroken(besideK, n, false)) &&
               (crackIsBroken(k, besideN, false) || crackIsBroken(besideN, n, true));
    }
    [[nodiscard]] bool crackIsBroken(std::size_t a, std::size_t b, bool alongBeams) const {
        return (alongBeams ? inputs_.cracks->jumpBeams : inputs_.cracks->jumpLines)[std::min(a, b)] > 1.0F;
    }

    const Inputs& inputs_;
    CartesianTables tables_;
    Grid<std::uint32_t> labels_;
    Grid<std::uint32_t> taken_; // the former label of each cell that was taken away
};

} // namespace

Grid<std::uint32_t> visibleSurfaces(const Segmentation& segments, const RegionMap& map) {
    Peeling peeling(segments, rockLabels(segments, map));
    peeling.run();
    return peeling.withoutCrumbs(map.rocks);
}

} // namespace edgescan::rocks
