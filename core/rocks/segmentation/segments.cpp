// Computes segments with their borders and sums from the inputs.
#include "core/rocks/segmentation/segments.h"

#include "core/base/bands.h"
#include "core/rocks/segmentation/basins.h"
#include "core/rocks/segmentation/border_choice.h"
#include "core/rocks/segmentation/borders.h"
#include "core/rocks/segmentation/cuts.h"
#include "core/rocks/segmentation/equal_runs.h"
#include "core/rocks/segmentation/refinement.h"
#include "core/scan/grid/cartesian.h"

#include <numeric>
#include <utility>
#include <variant>

namespace edgescan::rocks {
namespace {

// Points of a line relative to the sensor, metres, in separate arrays per coordinate.
struct LinePoints {
    std::vector<double> x, y, z;

    explicit LinePoints(int beams) : x(static_cast<std::size_t>(beams)), y(x), z(x) {}
    void fill(const Scan& scan, const CartesianTables& tables, int line) {
        if (std::holds_alternative<PolarGeometry>(scan.geometry)) return tables.pointsOfLine(line, x.data(), y.data(), z.data());
        for (std::size_t j = 0; j < x.size(); ++j) {
            const auto beam = static_cast<int>(j);
            const Eigen::Vector3d point = tables.direction(line, beam) * (0.001 * static_cast<double>(scan.rangeMm.at(line, beam)));
            x[j] = point.x();
            y[j] = point.y();
            z[j] = point.z();
        }
    }
};

// Adds the measured cells of a run; `steps` are those of the line's cells.
void addRun(const Inputs& inputs, const LinePoints& points, const SegmentRun& run, SegmentSums& sums) {
    const AngularSteps& steps = inputs.surface->steps;
    const auto line = static_cast<int>(run.row);
    const Support* const support = inputs.surface->inverse.support.line(line);
    const float* const rangeMm = inputs.scan->rangeMm.line(line);
    SegmentSums sum = sums;
    for (std::uint32_t j = run.begin; j < run.end; ++j) {
        if (support[j] != Support::Measured) continue;
        const double rangeM = 0.001 * static_cast<double>(rangeMm[j]);
        const double x = points.x[j];
        const double y = points.y[j];
        const double z = points.z[j];
        ++sum.cells;
        sum.areaM2 += rangeM * rangeM * static_cast<double>(steps.beam[j]) * static_cast<double>(steps.lineAt(line, static_cast<int>(j)));
        sum.sumM += Eigen::Vector3d(x, y, z);
        // The upper half of the symmetric matrix.
        sum.sumM2(0, 0) += x * x;
        sum.sumM2(0, 1) += x * y;
        sum.sumM2(0, 2) += x * z;
        sum.sumM2(1, 1) += y * y;
        sum.sumM2(1, 2) += y * z;
        sum.sumM2(2, 2) += z * z;
    }
    sums = sum;
}

// `runs`: along the beams.
std::vector<SegmentSums> segmentSums(const Inputs& inputs, const std::vector<SegmentRun>& runs, std::uint32_t count) {
    std::vector<SegmentSums> sums(static_cast<std::size_t>(count) + 1);
    const CartesianTables tables(*inputs.scan);
    LinePoints points(inputs.scan->beams());
    std::uint32_t line = UINT32_MAX;
    for (const SegmentRun& run : runs) {
        if (run.row != line) {
            line = run.row;
            points.fill(*inputs.scan, tables, static_cast<int>(line));
        }
        addRun(inputs, points, run, sums[run.segment]);
    }
    for (SegmentSums& sum : sums) {
        for (const auto& [row, column] : {std::pair{1, 0}, {2, 0}, {2, 1}}) sum.sumM2(row, column) = sum.sumM2(column, row);
    }
    return sums;
}

std::vector<SegmentRun> runsAlongBeams(const Grid<std::uint32_t>& segment) {
    std::vector<SegmentRun> runs;
    const auto beams = static_cast<std::size_t>(segment.beams);
    for (int i = 0; i < segment.lines; ++i) {
        eachEqualRun({segment.line(i), beams}, [&](std::uint32_t of, std::size_t begin, std::size_t end) {
            if (of != kNoSegment)
                runs.push_back({of, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
        });
    }
    return runs;
}

// By beam, then line; computed line by line, in the order of memory.
std::vector<SegmentRun> runsAlongLines(const Grid<std::uint32_t>& segment) {
    const auto beams = static_cast<std::size_t>(segment.beams);
    const std::vector<std::uint32_t> outside(beams, kNoSegment);
    const auto eachChange = [&](const auto& say) {
        for (int i = 0; i <= segment.lines; ++i) {
            const std::uint32_t* const before = i > 0 ? segment.line(i - 1) : outside.data();
            const std::uint32_t* const here = i < segment.lines ? segment.line(i) : outside.data();
            for (std::size_t j = 0; j < beams; ++j) {
                if (before[j] != here[j]) say(static_cast<std::uint32_t>(i), j, before[j], here[j]);
            }
        }
    };
    std::vector<std::size_t> next(beams + 1, 0); // index of the next run of each beam
    eachChange([&](std::uint32_t, std::size_t j, std::uint32_t, std::uint32_t here) { next[j + 1] += here != kNoSegment ? 1 : 0; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<SegmentRun> runs(next.back());
    eachChange([&](std::uint32_t i, std::size_t j, std::uint32_t before, std::uint32_t here) {
        if (before != kNoSegment) runs[next[j] - 1].end = i;
        if (here != kNoSegment) runs[next[j]++] = {here, static_cast<std::uint32_t>(j), i, i};
    });
    return runs;
}

} // namespace

FittedSegments fittedSegments(const Inputs& inputs) {
    FittedSegments fitted;
    const InverseRange& inverse = inputs.surface->inverse;
    const CellLinks links{inverse.support, *inputs.cracks};
    fitted.basins = segmentBasins(barrierDistance(inputs), links);
    fitted.segment = fitted.basins;
    fitted.borders = segmentBorders(inputs, fitted.segment);
    fitted.count = lastSegment(fitted.segment);
    refineSegments(inverse, *inputs.cracks, inputs.responses->noise, mostDeviations(inputs.surface->steps), fitted.segment, fitted.count);
    return fitted;
}

Segmentation segmentRocks(const Inputs& inputs, std::span<const std::vector<std::uint32_t>> cuts) {
    FittedSegments fitted = fittedSegments(inputs);
    chooseBorders(inputs, settledGroups(fitted.borders, fitted.count), learnedBorders(), kBorderPasses, fitted.segment);
    const CellLinks links{inputs.surface->inverse.support, *inputs.cracks};
    std::vector<std::uint32_t> cutFrom(static_cast<std::size_t>(fitted.count) + 1);
    std::iota(cutFrom.begin(), cutFrom.end(), 0U);
    for (const CutLine& cut : cuts) fitted.count = cutSegments(links, cut, fitted.count, fitted.segment, &fitted.basins, &cutFrom);
    if (!cuts.empty()) fitted.borders = segmentBorders(inputs, fitted.basins);
    Segmentation segments;
    segments.inputs = inputs;
    segments.cutFrom = std::move(cutFrom);
    segments.segment = std::move(fitted.segment);
    segments.borders = std::move(fitted.borders);
    const auto sumUp = [&] {
        segments.beamRuns = runsAlongBeams(segments.segment);
        segments.sums = segmentSums(inputs, segments.beamRuns, fitted.count);
    };
    runParts(bandsFor(segments.segment.size(), 0), {sumUp, [&] { segments.lineRuns = runsAlongLines(segments.segment); }});
    SegmentOutlines outlines = segmentOutlines(inputs, segments.segment, segments.borders, fitted.count);
    segments.outlines = std::move(outlines.borders);
    segments.outer = std::move(outlines.outer);
    return segments;
}

} // namespace edgescan::rocks
