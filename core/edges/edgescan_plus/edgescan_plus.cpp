// EdgeScan+: its stages in order, up to the decision.
#include "core/edges/edgescan_plus/edgescan_plus.h"

#include "core/base/bands.h"
#include "core/base/portable_math.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/gap_detour.h"
#include "core/edges/edgescan_plus/silhouettes.h"
#include "core/edges/edgescan_plus/surface_lines.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/grid/marked_cells.h"
#include "core/scan/grid/spikes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace edgescan::edges {
namespace {

constexpr double kNominalNoiseMm = 6.75; // sigma at 5 m of an LMS511
constexpr double kOffsetShare = 0.815;   // share of sigma at 5 m: sigma at 0 m ...
constexpr double kPerMetreShare = 0.037; // ... and its growth per metre
constexpr double kJumpMm = 30.0;
constexpr double kMisfitMm = 6.0;
constexpr double kReliefMm = 5.0;
constexpr double kWindowMm = 50.0;
// of folds if the errors of neighbours are correlated: narrower windows follow the steps of the depth
constexpr double kMemoryWindowMm = 50.0;
constexpr double kNoisy = 1.5;             // x nominal
constexpr double kLeastNoise = 0.2;        // x nominal
constexpr double kRelief = 0.7;            // x nominal: relief and beam width blur as much as this, even with perfect ranges ...
constexpr double kJumpSpacings = 2.0;      // ... but where points are close together, J0 is at most this many point spacings
constexpr float kInterlacedGrazing = 0.5F; // index steps: remaining displacement of interlaced beams after straightening

// q of step 6: the noise divided by that of an LMS511; thresholds in millimetres scale with it.
double noiseShare(const RangeNoise& noise, double spacingMm, double rangeM = 5.0) {
    const double least = std::clamp(kJumpSpacings * spacingMm / kJumpMm, kLeastNoise, kRelief);
    const double nominal = rangeM == 5.0 ? kNominalNoiseMm : kNominalNoiseMm * (kOffsetShare + kPerMetreShare * rangeM);
    return std::clamp(noise.at(rangeM) / nominal, least, 10.0);
}

// Both directions of one line.
struct BothWays {
    const float* beamwise;
    const float* linewise;
    std::ptrdiff_t stride;

    /// In the direction of the stronger response a cell must not be weaker than one neighbour, and must be stronger than the other.
    [[nodiscard]] bool isKept(int j) const {
        const float b = std::abs(beamwise[j]);
        const float l = std::abs(linewise[j]);
        const bool keepB = (b >= l) & (std::abs(beamwise[j - 1]) <= b) & (std::abs(beamwise[j + 1]) < b);
        const bool keepL = (b < l) & (std::abs(linewise[j - stride]) <= l) & (std::abs(linewise[j + stride]) < l);
        return keepB | keepL;
    }
    [[nodiscard]] bool isBeamwise(int j) const { return std::abs(beamwise[j]) >= std::abs(linewise[j]); }
};

// The response of the stronger direction.
EDGESCAN_INLINE void suppressJumps(const BothWays& jumps, const Support* support, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float value = jumps.isBeamwise(j) ? jumps.beamwise[j] : jumps.linewise[j];
        out[j] = (jumps.isKept(j) & (support[j] != Support::Void)) ? value : 0.0F;
    }
}

// The root of the sum of squares where both directions have the same sign: a diagonal fold shows only a part of its angle in each
// direction.
EDGESCAN_INLINE void suppressFolds(const BothWays& folds, const Support* support, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float stronger = folds.isBeamwise(j) ? folds.beamwise[j] : folds.linewise[j];
        const float weaker = folds.isBeamwise(j) ? folds.linewise[j] : folds.beamwise[j];
        const float add = stronger * weaker > 0 ? weaker * weaker : 0.0F;
        const float value = std::copysign(std::sqrt(stronger * stronger + add), stronger);
        out[j] = (folds.isKept(j) & (support[j] != Support::Void)) ? value : 0.0F;
    }
}

BothWays bothWays(const Lines& beamwise, const Lines& linewise, int line) {
    return {beamwise.line(line), linewise.line(line), linewise.stride};
}

// The lines that a thread processes; it also reads lines around them.
struct Band {
    int first, last; // the line behind the band
    [[nodiscard]] bool contains(int line) const { return line >= first && line < last; }
};

void copyLine(const Lines& window, int line, const Band& band, Grid<float>& grid) {
    if (band.contains(line)) std::copy_n(window.line(line), window.beams, grid.line(line));
}

void copyCracks(const SurfaceLines& surface, const Band& band, DepthCracks& cracks) {
    copyLine(surface.cracks(Along::Beams), surface.jumpLine(), band, cracks.jumpBeams);
    copyLine(surface.cracks(Along::Lines), surface.jumpLine(), band, cracks.jumpLines);
    copyLine(surface.smoothed(), surface.foldLine(), band, cracks.smoothed);
    copyLine(surface.folds(Along::Beams), surface.foldLine(), band, cracks.foldBeams);
    copyLine(surface.folds(Along::Lines), surface.foldLine(), band, cracks.foldLines);
}

void respond(const DepthSurface& surface, const DepthLimits& limits, const Band& band, DepthResponses& result, DepthCracks* cracks,
             FoldingCells* folding) {
    const Grid<Support>& support = surface.inverse.support;
    SurfaceLines lines(surface.inverse, surface.steps, surface.slips, limits, std::max(0, band.first - SurfaceLines::kLinesBefore));
    while (lines.foldLine() < band.last) {
        lines.advance();
        if (cracks != nullptr) copyCracks(lines, band, *cracks);
        if (const int line = lines.foldLine(); folding != nullptr && band.contains(line))
            folding->note(line, lines.folds(Along::Beams).line(line), lines.folds(Along::Lines).line(line), support.line(line));
        // One line behind the newest: suppression reads the lines on both sides.
        if (const int line = lines.jumpLine() - 1; band.contains(line))
            vectorised<suppressJumps>(bothWays(lines.jumps(Along::Beams), lines.jumps(Along::Lines), line), support.line(line),
                                      support.beams, result.jump.line(line));
        if (const int line = lines.foldLine() - 1; band.contains(line))
            vectorised<suppressFolds>(bothWays(lines.folds(Along::Beams), lines.folds(Along::Lines), line), support.line(line),
                                      support.beams, result.crease.line(line));
    }
}

// 1 at measured cells with a void next to them. For the first and the last line, the missing neighbour line is the line itself: this adds
// no void.
EDGESCAN_INLINE void markBorder(const Support* before, const Support* line, const Support* after, int beams,
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
        vectorised<markBorder>(support.line(std::max(0, i - 1)), support.line(i), support.line(std::min(support.lines - 1, i + 1)),
                               support.beams, marked.data());
        forEachMarked(marked,
                      [&](std::size_t beam) { cells.push_back(static_cast<std::uint32_t>(support.index(i, static_cast<int>(beam)))); });
    }
    return cells;
}

} // namespace

DepthSurface depthSurface(const Scan& scan, bool straightened, int threads, NoiseKind noise) {
    DepthSurface surface{inverseRange(scan, threads), {}, angularSteps(scan), {}, 0, {}, {}, withheldCells(scan)};
    surface.slips = straightened ? straighten(surface.inverse, threads) : noSlips(scan.lines());
    runParts(bandsFor(scan.cells(), threads), {[&] { surface.noise = rangeNoise(surface.inverse); },
                                               [&] { surface.scales = noiseScales(surface.inverse, noise == NoiseKind::Camera); }});
    if (noise == NoiseKind::Camera || (noise == NoiseKind::Measured && surface.scales.remembered))
        surface.memory = memoryNoise(surface.inverse, surface.steps, surface.scales, kMemoryWindowMm);
    removeSpikes(surface.inverse, surface.noise);
    surface.spacingMm = pointSpacingMm(surface.inverse, surface.steps);
    return surface;
}

DepthSurface withFilledGaps(DepthSurface surface, const GapFilling* filling) {
    if (filling == nullptr) return surface;
    for (const FilledCell& filled : filling->cells) {
        surface.inverse.u[filled.cell] = 1000.0F / filled.rangeMm;
        surface.inverse.support[filled.cell] = Support::RequestedFill;
    }
    return surface;
}

DepthLimits depthLimits(const DepthSurface& surface, const Settings& settings) {
    DepthLimits limits;
    const double typed = settings.noiseMm; // NaN: measured
    limits.noise = typed >= 0 ? RangeNoise{typed * kOffsetShare, typed * kPerMetreShare} : surface.noise;
    limits.foldNoise = limits.noise;
    double q = noiseShare(limits.noise, surface.spacingMm);
    // A jump is computed from neighbouring cells, so its noise is that of neighbours. It is taken at the scan's own range: noise that grows
    // with the square of the range cannot be extrapolated to 5 m from ranges below one metre.
    const bool remembered = std::isnan(typed) && surface.memory.windowMm > 0;
    if (remembered) {
        limits.noise = surface.memory.range;
        limits.foldNoise = surface.memory.fold;
        q = noiseShare({surface.scales.sigmaMm.front(), 0, 0}, surface.spacingMm, surface.scales.rangeM);
    }
    limits.jumpMm = static_cast<float>(settings.jumpMm >= 0 ? settings.jumpMm : kJumpMm * q);
    limits.growth = static_cast<float>(settings.growthPercent / 100.0);
    limits.grazing = static_cast<float>(settings.grazing);
    limits.misfitMm = static_cast<float>(kMisfitMm * q);
    limits.reliefMm = static_cast<float>(kReliefMm * q);
    limits.windowMm = static_cast<float>(kWindowMm * portable::pow(q, 0.7));
    if (remembered) limits.windowMm = std::max(limits.windowMm, static_cast<float>(surface.memory.windowMm));
    limits.creaseDeg = static_cast<float>(settings.creaseDeg);
    limits.noisy = q > kNoisy;
    limits.passes = limits.noisy ? 2 : 1;
    limits.turns = settings.turns;
    if (surface.slips.interlaced) limits.grazing = std::max(limits.grazing, kInterlacedGrazing);
    return limits;
}

DepthResponses depthResponses(const DepthSurface& surface, const Settings& settings, DepthCracks* cracks, int threads) {
    const DepthLimits limits = depthLimits(surface, settings);
    const Grid<Support>& support = surface.inverse.support;
    const int bands = std::clamp(bandsFor(support.size(), threads), 1, std::max(1, support.lines));
    const auto clear = [&support](Grid<float>& grid) { grid = Grid<float>(support.lines, support.beams); };
    DepthResponses result;
    result.noise = limits.noise;
    result.jumpMm = static_cast<double>(limits.jumpMm);
    result.scales = surface.scales;
    result.foldNoise = limits.foldNoise;
    result.neighboursAlike = surface.memory.windowMm > 0;
    runParts(bands, {[&] { clear(result.jump); }, [&] { clear(result.crease); }});
    if (cracks != nullptr) {
        for (Grid<float>* grid : {&cracks->jumpBeams, &cracks->jumpLines, &cracks->smoothed, &cracks->foldBeams, &cracks->foldLines})
            clear(*grid);
    }
    // Bands of lines, and work that runs in parallel with them.
    FoldingCells folding(support.lines, support.beams);
    std::vector<std::function<void()>> parts;
    for (int band = 0; band < bands; ++band)
        parts.emplace_back([&, band] {
            const Band lines{firstLineOfBand(support.lines, bands, band), firstLineOfBand(support.lines, bands, band + 1)};
            respond(surface, limits, lines, result, cracks, settings.roughScans ? &folding : nullptr);
        });
    parts.emplace_back([&] { result.silhouettes = silhouetteCells(surface.inverse, surface.steps, limits); });
    parts.emplace_back([&] { result.border = borderCells(support); });
    parts.emplace_back(
        [&] { result.rim = voidRimCells(surface.inverse, surface.steps, limits, surface.withheld, result.neighboursAlike); });
    runParts(bands, parts);
    moveResponsesOffGaps(surface.inverse, result.jump, result.crease);
    if (settings.roughScans)
        result.roughness = roughnessOf(folding, surface.inverse.u, surface.steps, result.crease,
                                       foldOfNoise(limits, surface.scales.rangeM, surface.spacingMm));
    if (result.roughness.rough) {
        result.unweighed = result.crease;
        weighFolds(result.roughness, result.crease);
    }
    return result;
}

} // namespace edgescan::edges
