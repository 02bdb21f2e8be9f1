// Leaves with their borders and sums, from the inputs on.
#include "core/rocks/rock_leaves.h"

#include "core/rocks/leaf_basins.h"
#include "core/rocks/leaf_borders.h"
#include "core/rocks/leaf_cuts.h"
#include "core/rocks/leaf_refinement.h"
#include "core/scan/cartesian.h"

#include <algorithm>

namespace edgescan {
namespace {

// `runs`: along the beams.
std::vector<LeafSums> leafSums(const RockInputs& inputs, const std::vector<LeafRun>& runs, std::uint32_t count) {
    std::vector<LeafSums> sums(static_cast<std::size_t>(count) + 1);
    const CartesianTables tables(*inputs.scan);
    const InverseRange& inverse = inputs.surface->inverse;
    const AngularSteps& steps = inputs.surface->steps;
    for (const LeafRun& run : runs) {
        LeafSums sum = sums[run.leaf];
        const auto line = static_cast<int>(run.row);
        for (std::uint32_t j = run.begin; j < run.end; ++j) {
            const std::size_t k = inverse.support.index(line, static_cast<int>(j));
            if (inverse.support[k] != Support::Measured) continue;
            const double rangeM = 0.001 * static_cast<double>(inputs.scan->rangeMm[k]);
            const Eigen::Vector3d point = tables.direction(line, static_cast<int>(j)) * rangeM;
            ++sum.cells;
            sum.areaM2 +=
                rangeM * rangeM * static_cast<double>(steps.beam[j]) * static_cast<double>(steps.lineAt(line, static_cast<int>(j)));
            sum.sumM += point;
            for (int n = 0; n < 3; ++n) sum.sumM2.col(n) += point * point[n];
        }
        sums[run.leaf] = sum;
    }
    return sums;
}

// Along the beams of each line, or along the lines of each beam.
std::vector<LeafRun> runsOf(const Grid<std::uint32_t>& leaf, Along along) {
    const bool isBeams = along == Along::Beams;
    const int rows = isBeams ? leaf.lines : leaf.beams;
    const int length = isBeams ? leaf.beams : leaf.lines;
    std::vector<LeafRun> runs;
    for (int row = 0; row < rows; ++row) {
        const auto at = [&](int n) { return isBeams ? leaf.at(row, n) : leaf.at(n, row); };
        for (int begin = 0; begin < length;) {
            const std::uint32_t here = at(begin);
            int end = begin + 1;
            while (end < length && at(end) == here) ++end;
            if (here != kOpen)
                runs.push_back({here, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
            begin = end;
        }
    }
    return runs;
}

} // namespace

RockLeaves rockLeaves(const RockInputs& inputs, std::span<const std::vector<std::uint32_t>> cuts) {
    RockLeaves leaves;
    leaves.inputs = inputs;
    const InverseRange& inverse = inputs.surface->inverse;
    const CellLinks links{inverse.support, *inputs.cracks};
    leaves.leaf = leafBasins(barrierDistance(inputs), links);
    cutLeaves(links, cuts, leaves.leaf);
    leaves.borders = leafBorders(inputs, leaves.leaf);
    const std::uint32_t count = leaves.leaf.size() == 0 ? 0 : *std::max_element(leaves.leaf.cells.begin(), leaves.leaf.cells.end());
    refineLeaves(inverse, *inputs.cracks, inputs.responses->noise, leaves.leaf, count);
    leaves.beamRuns = runsOf(leaves.leaf, Along::Beams);
    leaves.sums = leafSums(inputs, leaves.beamRuns, count);
    leaves.lineRuns = runsOf(leaves.leaf, Along::Lines);
    return leaves;
}

} // namespace edgescan
