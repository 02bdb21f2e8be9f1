// Leaves with their borders and sums, from the inputs on.
#include "core/leaves/rock_leaves.h"

#include "core/leaves/leaf_basins.h"
#include "core/leaves/leaf_borders.h"
#include "core/leaves/leaf_cuts.h"
#include "core/leaves/leaf_refinement.h"
#include "core/scan/cartesian.h"

#include <algorithm>
#include <numeric>

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

std::vector<LeafRun> runsAlongBeams(const Grid<std::uint32_t>& leaf) {
    std::vector<LeafRun> runs;
    const auto beams = static_cast<std::uint32_t>(leaf.beams);
    for (int i = 0; i < leaf.lines; ++i) {
        const std::uint32_t* const cells = leaf.line(i);
        for (std::uint32_t begin = 0; begin < beams;) {
            std::uint32_t end = begin + 1;
            while (end < beams && cells[end] == cells[begin]) ++end;
            if (cells[begin] != kOpen) runs.push_back({cells[begin], static_cast<std::uint32_t>(i), begin, end});
            begin = end;
        }
    }
    return runs;
}

// By beam, then line; gone through line by line, as the cells lie in memory.
std::vector<LeafRun> runsAlongLines(const Grid<std::uint32_t>& leaf) {
    const auto beams = static_cast<std::size_t>(leaf.beams);
    const std::vector<std::uint32_t> outside(beams, kOpen);
    const auto eachChange = [&](const auto& say) {
        for (int i = 0; i <= leaf.lines; ++i) {
            const std::uint32_t* const before = i > 0 ? leaf.line(i - 1) : outside.data();
            const std::uint32_t* const here = i < leaf.lines ? leaf.line(i) : outside.data();
            for (std::size_t j = 0; j < beams; ++j) {
                if (before[j] != here[j]) say(static_cast<std::uint32_t>(i), j, before[j], here[j]);
            }
        }
    };
    std::vector<std::size_t> next(beams + 1, 0); // place of the next run of each beam
    eachChange([&](std::uint32_t, std::size_t j, std::uint32_t, std::uint32_t here) { next[j + 1] += here != kOpen ? 1 : 0; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<LeafRun> runs(next.back());
    eachChange([&](std::uint32_t i, std::size_t j, std::uint32_t before, std::uint32_t here) {
        if (before != kOpen) runs[next[j] - 1].end = i;
        if (here != kOpen) runs[next[j]++] = {here, static_cast<std::uint32_t>(j), i, i};
    });
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
    refineLeaves(inverse, *inputs.cracks, inputs.responses->noise, mostDeviations(inputs.surface->steps), leaves.leaf, count);
    leaves.beamRuns = runsAlongBeams(leaves.leaf);
    leaves.sums = leafSums(inputs, leaves.beamRuns, count);
    leaves.lineRuns = runsAlongLines(leaves.leaf);
    return leaves;
}

} // namespace edgescan
