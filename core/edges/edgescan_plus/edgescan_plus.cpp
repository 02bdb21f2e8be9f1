// EdgeScan+: its stages in order, up to the decision.
#include "core/edges/edgescan_plus/edgescan_plus.h"

#include "core/base/bands.h"
#include "core/base/portable_math.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/gap_detour.h"
#include "core/edges/edgescan_plus/mixed_pixels.h"
#include "core/edges/edgescan_plus/noise_smoothing.h"
#include "core/edges/edgescan_plus/silhouettes.h"
#include "core/edges/edgescan_plus/stored_folds.h"
#include "core/edges/edgescan_plus/suppression.h"
#include "core/edges/edgescan_plus/surface_lines.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/grid/marked_cells.h"
#include "core/scan/grid/spikes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
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
// x nominal: between them the share of what noisy ranges need grows; in the middle is where the rules of default set 4 change at once
constexpr double kQuiet = 1.25, kNoisy = 1.75;
constexpr double kLeftOfJumps = 0.67, kLeftOfFolds = 0.6; // of the noise, after noisy ranges were smoothed
// tangents: ranges are often lost on steeper surfaces, and there nothing ends
constexpr float kRimSlant = 5.67F, kRimSlantOf4 = 2.75F; // of 80 and of 70 degrees
constexpr double kLeastNoise = 0.2;                      // x nominal
constexpr double kRelief = 0.7;            // x nominal: relief and beam width blur as much as this, even with perfect ranges ...
constexpr double kJumpSpacings = 2.0;      // ... but where points are close together, J0 is at most this many point spacings
constexpr float kInterlacedGrazing = 0.5F; // index steps: remaining displacement of interlaced beams after straightening

// q of step 6: the noise divided by that of an LMS511; thresholds in millimetres scale with it.
double noiseShare(const RangeNoise& noise, double spacingMm, double rangeM = 5.0) {
    const double least = std::clamp(kJumpSpacings * spacingMm / kJumpMm, kLeastNoise, kRelief);
    const double nominal = rangeM == 5.0 ? kNominalNoiseMm : kNominalNoiseMm * (kOffsetShare + kPerMetreShare * rangeM);
    return std::clamp(noise.at(rangeM) / nominal, least, 10.0);
}

// The share of what noisy ranges need. Under the rules of default set 4 all of it or nothing.
double noisyShare(double q, const Settings& settings) {
    if (settings.rules < 5) return q > 0.5 * (kQuiet + kNoisy) ? 1 : 0;
    return std::clamp((q - kQuiet) / (kNoisy - kQuiet), 0.0, 1.0);
}

// Typed or measured.
RangeNoise noiseForLimits(const DepthSurface& surface, const Settings& settings) {
    const double typed = settings.noiseMm; // NaN: measured
    if (typed >= 0) return {typed * kOffsetShare, typed * kPerMetreShare};
    return settings.rules < 5 ? surface.ofRange : surface.steady;
}

RangeNoise times(const RangeNoise& noise, double factor) {
    return {factor * noise.offsetMm, factor * noise.perMetreMm, factor * noise.perSquareMetreMm};
}

// The responses of one line in both directions, and around it.
struct BothWays {
    const float* beamwise;
    const float* linewise;
    std::ptrdiff_t stride;
    [[nodiscard]] EDGESCAN_INLINE bool isKept(int j) const {
        return isStrongest(beamwise[j], beamwise[j - 1], beamwise[j + 1], linewise[j], linewise[j - stride], linewise[j + stride]);
    }
};

EDGESCAN_INLINE void suppressJumps(const BothWays& jumps, const Support* support, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float value = strongerOf(jumps.beamwise[j], jumps.linewise[j]);
        out[j] = (jumps.isKept(j) & (support[j] != Support::Void)) ? value : 0.0F;
    }
}

EDGESCAN_INLINE void suppressFolds(const BothWays& folds, const Support* support, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float value = wholeFold(folds.beamwise[j], folds.linewise[j]);
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

// What the lines of a sweep are measured into; null: not wanted.
struct Measured {
    Grid<float>* jump;
    Grid<float>* crease;
    FoldingCells* folding;
    DepthCracks* cracks;
    StoredFolds* folds;
};

void measure(const DepthSurface& surface, const DepthLimits& limits, const Band& band, const Measured& to) {
    const Grid<Support>& support = surface.inverse.support;
    const int from = std::max(0, band.first - SurfaceLines::kLinesBefore);
    SurfaceLines lines(surface.inverse, surface.steps, surface.slips, limits, from, to.folds != nullptr);
    std::optional<FoldRecorder> recorder;
    if (to.folds != nullptr) recorder.emplace(*to.folds, support, from, band.first, band.last);
    const int last = band.last + (recorder ? 1 : 0);
    while (lines.foldLine() < last) {
        lines.advance();
        if (to.cracks != nullptr) copyCracks(lines, band, *to.cracks);
        if (const int line = lines.foldLine(); to.folding != nullptr && band.contains(line))
            to.folding->note(line, lines.folds(Along::Beams).line(line), lines.folds(Along::Lines).line(line), support.line(line));
        if (recorder && lines.foldLine() >= from) recorder->addLine(lines.foldLine(), *lines.parts());
        // One line behind the newest: suppression reads the lines on both sides.
        if (const int line = lines.jumpLine() - 1; band.contains(line))
            vectorised<suppressJumps>(bothWays(lines.jumps(Along::Beams), lines.jumps(Along::Lines), line), support.line(line),
                                      support.beams, to.jump->line(line));
        if (const int line = lines.foldLine() - 1; band.contains(line))
            vectorised<suppressFolds>(bothWays(lines.folds(Along::Beams), lines.folds(Along::Lines), line), support.line(line),
                                      support.beams, to.crease->line(line));
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

DepthSurface depthSurface(const Scan& scan, const Settings& settings, int threads) {
    const NoiseKind noise = settings.noiseKind;
    DepthSurface surface{inverseRange(scan, threads), {}, angularSteps(scan), {}, {}, {}, 0, {}, {}, withheldCells(scan)};
    surface.slips = settings.straighten ? straighten(surface.inverse, threads) : noSlips(scan.lines());
    runParts(bandsFor(scan.cells(), threads), {[&] { surface.ofRange = noiseByRange(surface.inverse); },
                                               [&] { surface.scales = noiseScales(surface.inverse, noise == NoiseKind::Camera); }});
    if (noise == NoiseKind::Camera || (noise == NoiseKind::Measured && surface.scales.remembered))
        surface.memory = memoryNoise(surface.inverse, surface.steps, surface.scales, kMemoryWindowMm);
    const bool remembered = surface.memory.windowMm > 0;
    const TileNoise ofTiles = remembered ? TileNoise{surface.ofRange, surface.ofRange} : tileNoise(surface.inverse, surface.ofRange);
    surface.noise = ofTiles.measured;
    surface.steady = ofTiles.steady;
    removeSpikes(surface.inverse, surface.ofRange);
    surface.spacingMm = pointSpacingMm(surface.inverse, surface.steps);
    const RangeNoise ofLimits = noiseForLimits(surface, settings);
    if (!remembered && settings.rules >= 5) surface.smoothed = noisyShare(noiseShare(ofLimits, surface.spacingMm), settings);
    if (surface.smoothed > 0) smoothNoise(surface.inverse, ofLimits, surface.smoothed, threads);
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
    const bool before5 = settings.rules < 5;
    limits.noise = noiseForLimits(surface, settings);
    const auto left = [&surface](double share) { return 1 - surface.smoothed * (1 - share); };
    limits.foldNoise = times(limits.noise, left(kLeftOfFolds));
    double q = noiseShare(limits.noise, surface.spacingMm);
    // A jump is computed from neighbouring cells, so its noise is that of neighbours. It is taken at the scan's own range: noise that grows
    // with the square of the range cannot be extrapolated to 5 m from ranges below one metre.
    const bool remembered = std::isnan(settings.noiseMm) && surface.memory.windowMm > 0;
    if (remembered) {
        limits.noise = surface.memory.range;
        limits.foldNoise = surface.memory.fold;
        q = noiseShare({surface.scales.sigmaMm.front(), 0, 0}, surface.spacingMm, surface.scales.rangeM);
    }
    limits.noisy = static_cast<float>(noisyShare(q, settings));
    limits.passes = limits.noisy > 0 ? 2 : 1;
    q *= left(kLeftOfJumps);
    limits.jumpMm = static_cast<float>(settings.jumpMm >= 0 ? settings.jumpMm : kJumpMm * q);
    limits.growth = static_cast<float>(settings.growthPercent / 100.0);
    limits.grazing = static_cast<float>(settings.grazing);
    limits.misfitMm = static_cast<float>(kMisfitMm * q);
    limits.reliefMm = static_cast<float>(kReliefMm * q);
    limits.windowMm = static_cast<float>(kWindowMm * portable::pow(q, 0.7));
    if (remembered) limits.windowMm = std::max(limits.windowMm, static_cast<float>(surface.memory.windowMm));
    limits.creaseDeg = static_cast<float>(settings.creaseDeg);
    limits.spotGrows = !before5 && surface.memory.windowMm <= 0; // a camera has no such spot
    limits.rimSlant = before5 ? kRimSlantOf4 : kRimSlant;
    limits.turns = settings.turns;
    if (surface.slips.interlaced) limits.grazing = std::max(limits.grazing, kInterlacedGrazing);
    return limits;
}

namespace {

std::vector<Band> bandsOf(const Grid<Support>& support, int threads) {
    const int count = std::clamp(bandsFor(support.size(), threads), 1, std::max(1, support.lines));
    std::vector<Band> bands;
    for (int band = 0; band < count; ++band)
        bands.push_back({firstLineOfBand(support.lines, count, band), firstLineOfBand(support.lines, count, band + 1)});
    return bands;
}

// Only in the rules of default set 4 a whole scan is rough or not.
bool weighsFolds(const Settings& settings) { return settings.rules < 5 && settings.roughScans; }

// The last steps of folds, after suppression.
void finishFolds(const DepthSurface& surface, const DepthLimits& limits, const FoldingCells* folding, DepthResponses& result) {
    moveFoldsOffGaps(surface.inverse, result.crease);
    if (folding != nullptr)
        result.roughness = roughnessOf(*folding, surface.inverse.u, surface.steps, result.crease,
                                       foldOfNoise(limits, surface.scales.rangeM, surface.spacingMm));
    if (result.roughness.rough) {
        result.unweighed = result.crease;
        weighFolds(result.roughness, result.crease);
    }
}

} // namespace

DepthResponses depthResponses(const DepthSurface& surface, const Settings& settings, DepthCracks* cracks, int threads, StoredFolds* folds) {
    const DepthLimits limits = depthLimits(surface, settings);
    const Grid<Support>& support = surface.inverse.support;
    const std::vector<Band> bands = bandsOf(support, threads);
    const int together = static_cast<int>(bands.size());
    const auto clear = [&support](Grid<float>& grid) { grid = Grid<float>(support.lines, support.beams); };
    DepthResponses result;
    result.noise = limits.noise;
    result.jumpMm = static_cast<double>(limits.jumpMm);
    result.scales = surface.scales;
    result.foldNoise = limits.foldNoise;
    result.neighboursAlike = surface.memory.windowMm > 0;
    const auto jump = std::make_shared<Grid<float>>();
    runParts(together, {[&] { clear(*jump); }, [&] { clear(result.crease); }});
    if (cracks != nullptr) {
        for (Grid<float>* grid : {&cracks->jumpBeams, &cracks->jumpLines, &cracks->smoothed, &cracks->foldBeams, &cracks->foldLines})
            clear(*grid);
    }
    if (folds != nullptr) *folds = StoredFolds(support);
    // Bands of lines, and work that runs in parallel with them.
    FoldingCells folding(support.lines, support.beams);
    std::vector<std::function<void()>> parts;
    for (const Band& band : bands)
        parts.emplace_back([&, band] {
            measure(surface, limits, band, {jump.get(), &result.crease, weighsFolds(settings) ? &folding : nullptr, cracks, folds});
        });
    parts.emplace_back([&] { result.silhouettes = silhouetteCells(surface.inverse, surface.steps, limits); });
    parts.emplace_back([&] { result.border = borderCells(support); });
    parts.emplace_back(
        [&] { result.rim = voidRimCells(surface.inverse, surface.steps, limits, surface.withheld, result.neighboursAlike); });
    runParts(together, parts);
    moveJumpsOffGaps(surface.inverse, *jump);
    result.jump = jump;
    finishFolds(surface, limits, weighsFolds(settings) ? &folding : nullptr, result);
    return result;
}

DepthResponses withCreaseAngle(const DepthResponses& before, const StoredFolds& folds, const DepthSurface& surface,
                               const Settings& settings, int threads) {
    const DepthLimits limits = depthLimits(surface, settings);
    const Grid<Support>& support = surface.inverse.support;
    const std::vector<Band> bands = bandsOf(support, threads);
    DepthResponses result{before.jump,
                          Grid<float>(support.lines, support.beams),
                          before.noise,
                          before.jumpMm,
                          before.scales,
                          before.foldNoise,
                          before.neighboursAlike,
                          before.border,
                          before.silhouettes,
                          {},
                          {},
                          before.rim};
    FoldingCells folding;
    std::vector<std::function<void()>> parts;
    for (const Band& band : bands) parts.emplace_back([&, band] { folds.foldsAt(limits.creaseDeg, band.first, band.last, result.crease); });
    if (weighsFolds(settings)) parts.emplace_back([&] { folding = folds.folding(limits.creaseDeg); });
    runParts(static_cast<int>(bands.size()), parts);
    finishFolds(surface, limits, weighsFolds(settings) ? &folding : nullptr, result);
    return result;
}

} // namespace edgescan::edges
