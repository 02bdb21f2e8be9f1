// EdgeScan+: its stages one after the other.
#include "core/depth/depth_edges.h"

#include "core/base/huge_pages.h"
#include "core/base/simd.h"
#include "core/depth/gap_detour.h"
#include "core/depth/surface_lines.h"
#include "core/scan/marked_cells.h"
#include "core/scan/spikes.h"
#include "core/straighten/interlace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace edgescan {
namespace {

constexpr double kNominalNoiseMm = 6.75; // sigma at 5 m of an LMS511
constexpr double kOffsetShare = 0.815;   // of sigma at 5 m: sigma at 0 m ...
constexpr double kPerMetreShare = 0.037; // ... and its growth per metre
constexpr double kJumpMm = 30.0;
constexpr double kMisfitMm = 6.0;
constexpr double kReliefMm = 5.0;
constexpr double kWindowMm = 50.0;
constexpr double kNoisy = 1.5;             // x nominal
constexpr double kLeastNoise = 0.2;        // x nominal
constexpr double kRelief = 0.7;            // x nominal: relief and the width of the beam blur as much, however good the ranges are ...
constexpr double kJumpSpacings = 2.0;      // ... but where points lie close together, J0 need not exceed so many point spacings
constexpr float kInterlacedGrazing = 0.5F; // index steps by which interlaced beams are still out of place after straightening

// q of step 6: the noise over that of an LMS511, by which the thresholds in millimetres grow and shrink.
double noiseShare(const RangeNoise& noise, double spacingMm) {
    const double least = std::clamp(kJumpSpacings * spacingMm / kJumpMm, kLeastNoise, kRelief);
    return std::clamp(noise.at(5.0) / kNominalNoiseMm, least, 10.0);
}

// The responses of both ways as one: the stronger alone, or with `both` the root of the sum of squares where they have the same sign: a
// fold that runs askew shows only part of itself in each way.
float together(float stronger, float weaker, bool both) {
    const float add = both && stronger * weaker > 0 ? weaker * weaker : 0.0F;
    return std::copysign(std::sqrt(stronger * stronger + add), stronger);
}

// One line: along the way of the stronger response a cell must be no weaker than one neighbour and stronger than the other.
EDGESCAN_SIMD void suppressLine(const float* beamwise, const float* linewise, std::ptrdiff_t stride, const Support* support, int beams,
                                bool both, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float b = std::abs(beamwise[j]);
        const float l = std::abs(linewise[j]);
        const bool keepB = (b >= l) & (std::abs(beamwise[j - 1]) <= b) & (std::abs(beamwise[j + 1]) < b);
        const bool keepL = (b < l) & (std::abs(linewise[j - stride]) <= l) & (std::abs(linewise[j + stride]) < l);
        const float stronger = b >= l ? beamwise[j] : linewise[j];
        const float weaker = b >= l ? linewise[j] : beamwise[j];
        const float value = together(stronger, weaker, both);
        out[j] = ((keepB | keepL) & (support[j] != Support::Void)) ? value : 0.0F;
    }
}

// The next line of `kept`.
void suppress(const Lines& alongBeams, const Lines& alongLines, int line, const Grid<Support>& support, bool both,
              std::vector<float>& kept) {
    if (line < 0 || line >= support.lines) return;
    std::vector<float> values(static_cast<std::size_t>(support.beams));
    suppressLine(alongBeams.line(line), alongLines.line(line), alongLines.stride, support.line(line), support.beams, both, values.data());
    kept.insert(kept.end(), values.begin(), values.end());
}

// Appends a line of `window` to `cells` where the line is one of the sweep.
void append(std::vector<float>& cells, const Lines& window, int line, int lines) {
    if (line < 0 || line >= lines) return;
    const float* values = window.line(line);
    cells.insert(cells.end(), values, values + window.beams);
}

// The grids of DepthCracks while they grow.
class CrackCopies {
public:
    CrackCopies(DepthCracks& cracks, int lines, int beams) : cracks_(&cracks), lines_(lines) {
        for (Grid<float>* grid : grids()) {
            *grid = Grid<float>(lines, beams, hugePageVector<float>(static_cast<std::size_t>(lines) * static_cast<std::size_t>(beams)));
        }
    }
    void take(const SurfaceLines& surface) {
        append(cracks_->jumpBeams.cells, surface.cracks(Along::Beams), surface.jumpLine(), lines_);
        append(cracks_->jumpLines.cells, surface.cracks(Along::Lines), surface.jumpLine(), lines_);
        append(cracks_->smoothed.cells, surface.smoothed(), surface.foldLine(), lines_);
        append(cracks_->foldBeams.cells, surface.folds(Along::Beams), surface.foldLine(), lines_);
        append(cracks_->foldLines.cells, surface.folds(Along::Lines), surface.foldLine(), lines_);
    }

private:
    [[nodiscard]] std::array<Grid<float>*, 5> grids() const {
        return {&cracks_->smoothed, &cracks_->jumpBeams, &cracks_->jumpLines, &cracks_->foldBeams, &cracks_->foldLines};
    }
    DepthCracks* cracks_;
    int lines_;
};

// 1 at measured cells with a void beside them. Before the first and after the last line the line itself is given: that adds no void.
EDGESCAN_SIMD void markBorder(const Support* before, const Support* line, const Support* after, int beams,
                              std::uint8_t* __restrict marked) {
    const auto mark = [&](int j, int left, int right) {
        const bool empty =
            (before[j] == Support::Void) | (after[j] == Support::Void) | (line[left] == Support::Void) | (line[right] == Support::Void);
        marked[j] = static_cast<std::uint8_t>((line[j] == Support::Measured) & empty);
    };
    for (int j = 1; j < beams - 1; ++j) mark(j, j - 1, j + 1);
    if (beams == 0) return;
    mark(0, 0, std::min(1, beams - 1));
    mark(beams - 1, std::max(0, beams - 2), beams - 1);
}

std::vector<std::uint32_t> borderCells(const Grid<Support>& support) {
    std::vector<std::uint32_t> cells;
    std::vector<std::uint8_t> marked(static_cast<std::size_t>(support.beams));
    for (int i = 0; i < support.lines; ++i) {
        markBorder(support.line(std::max(0, i - 1)), support.line(i), support.line(std::min(support.lines - 1, i + 1)), support.beams,
                   marked.data());
        forEachMarked(marked,
                      [&](std::size_t beam) { cells.push_back(static_cast<std::uint32_t>(support.index(i, static_cast<int>(beam)))); });
    }
    return cells;
}

} // namespace

DepthSurface depthSurface(const Scan& scan, bool straightened) {
    DepthSurface surface{inverseRange(scan), {}, angularSteps(scan), {}, 0};
    surface.slips = straightened ? straighten(surface.inverse) : noSlips(scan.lines());
    surface.noise = rangeNoise(surface.inverse);
    flattenSpikes(surface.inverse, surface.noise);
    surface.spacingMm = pointSpacingMm(surface.inverse, surface.steps);
    return surface;
}

DepthLimits depthLimits(const DepthSurface& surface, const DepthEdgeSettings& settings) {
    DepthLimits limits;
    const double typed = settings.noiseAt5mMm;
    limits.noise = typed >= 0 ? RangeNoise{typed * kOffsetShare, typed * kPerMetreShare} : surface.noise;
    const double q = noiseShare(limits.noise, surface.spacingMm);
    limits.jumpMm = static_cast<float>(settings.jumpMm >= 0 ? settings.jumpMm : kJumpMm * q);
    limits.growth = static_cast<float>(settings.jumpGrowth);
    limits.grazing = static_cast<float>(settings.grazing);
    limits.misfitMm = static_cast<float>(kMisfitMm * q);
    limits.reliefMm = static_cast<float>(kReliefMm * q);
    limits.windowMm = static_cast<float>(kWindowMm * std::pow(q, 0.7));
    limits.creaseDeg = static_cast<float>(settings.creaseDeg);
    limits.noisy = q > kNoisy;
    limits.passes = limits.noisy ? 2 : 1;
    if (surface.slips.interlaced) limits.grazing = std::max(limits.grazing, kInterlacedGrazing);
    return limits;
}

DepthResponses depthResponses(const DepthSurface& surface, const DepthEdgeSettings& settings, DepthCracks* cracks) {
    const DepthLimits limits = depthLimits(surface, settings);
    const Grid<Support>& support = surface.inverse.support;
    auto jumps = hugePageVector<float>(support.size());
    auto folds = hugePageVector<float>(support.size());
    SurfaceLines lines(surface.inverse, surface.steps, surface.slips, limits);
    std::optional<CrackCopies> copies;
    if (cracks != nullptr) copies.emplace(*cracks, support.lines, support.beams);
    while (folds.size() < support.size()) {
        lines.advance();
        if (copies) copies->take(lines);
        // One line behind the newest: suppression looks at the lines on both sides.
        suppress(lines.jumps(Along::Beams), lines.jumps(Along::Lines), lines.jumpLine() - 1, support, false, jumps);
        suppress(lines.folds(Along::Beams), lines.folds(Along::Lines), lines.foldLine() - 1, support, true, folds);
    }
    DepthResponses result;
    result.jump = Grid<float>(support.lines, support.beams, std::move(jumps));
    result.crease = Grid<float>(support.lines, support.beams, std::move(folds));
    goRoundGaps(surface.inverse, result.jump, result.crease);
    result.noise = limits.noise;
    result.jumpMm = static_cast<double>(limits.jumpMm);
    result.border = borderCells(support);
    return result;
}

Grid<std::uint8_t> linkedChains(const Grid<float>& strength, float high, float low, int minimum) {
    Grid<std::uint8_t> state(strength.lines, strength.beams); // 1 = waiting, 255 = edge
    for (std::size_t k = 0; k < strength.size(); ++k) state[k] = strength[k] > low ? 1 : 0;
    const auto beams = static_cast<std::size_t>(strength.beams);
    std::vector<std::size_t> chain;
    for (std::size_t seed = 0; seed < state.size(); ++seed) {
        if (state[seed] != 1) continue;
        chain.assign(1, seed);
        state[seed] = 2;
        bool strong = false;
        for (std::size_t at = 0; at < chain.size(); ++at) {
            const std::size_t k = chain[at];
            strong = strong || strength[k] > high;
            const int line = static_cast<int>(k / beams);
            const int beam = static_cast<int>(k % beams);
            for (int i = line - 1; i <= line + 1; ++i) {
                for (int j = beam - 1; j <= beam + 1; ++j) {
                    if (!state.contains(i, j) || state.at(i, j) != 1) continue;
                    state.at(i, j) = 2;
                    chain.push_back(state.index(i, j));
                }
            }
        }
        const bool kept = strong && static_cast<int>(chain.size()) >= minimum;
        for (const std::size_t k : chain) state[k] = kept ? 255 : 0;
    }
    return state;
}

DepthEdges decideDepthEdges(const DepthResponses& responses, const DepthEdgeSettings& settings) {
    const int lines = responses.jump.lines;
    const int beams = responses.jump.beams;
    DepthEdges result{Grid<std::uint8_t>(lines, beams), Grid<DepthEdge>(lines, beams, DepthEdge::None), Grid<float>(lines, beams),
                      responses.noise};
    const float convex = settings.convex ? 1.0F : 0.0F;
    const float concave = settings.concave ? 1.0F : 0.0F;
    const float jumps = settings.jumps ? 1.0F : 0.0F;
    for (std::size_t k = 0; k < result.strength.size(); ++k) {
        const float crease = responses.crease[k];
        result.strength[k] = std::max({jumps * responses.jump[k], convex * crease, -concave * crease});
    }
    const auto high = static_cast<float>(settings.sensitivity);
    const Grid<std::uint8_t> kept =
        linkedChains(result.strength, high, high * static_cast<float>(settings.hysteresisLow), settings.minimumLength);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (kept[k] == 0) continue;
        result.mask[k] = 255;
        const bool jump = settings.jumps && responses.jump[k] >= result.strength[k];
        result.kind[k] = jump ? DepthEdge::Jump : responses.crease[k] > 0 ? DepthEdge::Convex : DepthEdge::Concave;
    }
    if (!settings.border) return result;
    for (const std::uint32_t k : responses.border) {
        if (result.mask[k] != 0) continue;
        result.mask[k] = 255;
        result.kind[k] = DepthEdge::Border;
    }
    return result;
}

} // namespace edgescan
