// The measurements of EdgeScan+ at one cell. This file does not repeat the formulas: it finds each part of a limit by running the stage
// itself with limits that contain only this part.
#include "core/edges/edgescan_plus/cell_probe.h"

#include "core/edges/edgescan_plus/crease.h"
#include "core/edges/edgescan_plus/jump.h"
#include "core/edges/edgescan_plus/surface_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace edgescan::edges {
namespace {

constexpr double kReferenceM = 5.0;
constexpr float kTinyDeg = 1e-6F;

struct CellPlace {
    int line, beam;
};

struct DepthInputs {
    const InverseRange& inverse;
    const SweepSlips& slips;
    const AngularSteps& steps;
    DepthLimits limits;
};

// Limits that consist of one millimetre, or one degree, and nothing else.
DepthLimits bare(DepthLimits limits) {
    limits.jumpMm = 1;
    limits.growth = 0;
    limits.grazing = 0;
    limits.reliefMm = 0;
    limits.creaseDeg = 1;
    limits.foldNoise = {};
    limits.misfitMm = std::numeric_limits<float>::infinity();
    return limits;
}

// The crack behind (line, beam) in one direction; valid while the stages are at this line.
struct Crack {
    double strength = 0, stepMm = 0, growthMm = 0, grazingMm = 0, reliefMm = 0;
};
Crack crackAt(const SurfaceLines& surface, Along along, CellPlace at, const DepthInputs& inputs) {
    if (at.line < 0 || at.line >= inputs.inverse.u.lines) return {};
    std::vector<float> room;
    const float* angle = anglesOf(inputs.steps, along, at.line, room);
    const auto strengthWith = [&](const DepthLimits& limits) {
        Lines jumps(inputs.inverse.u.beams, 1, 0.0F, at.line);
        crackJumps(surface.surface(), along, at.line, angle, inputs.slips, limits, jumps);
        return static_cast<double>(jumps.line(at.line)[at.beam]);
    };
    const DepthLimits one = bare(inputs.limits);
    Crack crack{strengthWith(inputs.limits), strengthWith(one), 0, 0, 0};
    if (crack.stepMm <= 0) return crack;
    // The part of the limit beyond the one millimetre.
    const auto partOf = [&](float DepthLimits::*part) {
        DepthLimits with = one;
        with.*part = inputs.limits.*part;
        return std::max(0.0, crack.stepMm / strengthWith(with) - 1);
    };
    crack.growthMm = partOf(&DepthLimits::growth);
    crack.grazingMm = partOf(&DepthLimits::grazing);
    crack.reliefMm = partOf(&DepthLimits::reliefMm);
    return crack;
}

class Prober {
public:
    Prober(const DepthInputs& inputs, CellPlace cell) : inputs_(inputs), cell_(cell) {}

    // Reads the values of the current lines.
    void look(const SurfaceLines& surface) {
        if (surface.jumpLine() == cell_.line - 1) addStep(surface, Along::Lines, {cell_.line - 1, cell_.beam});
        if (surface.jumpLine() == cell_.line) {
            addStep(surface, Along::Lines, cell_);
            addStep(surface, Along::Beams, cell_);
            addStep(surface, Along::Beams, {cell_.line, cell_.beam - 1});
            lookForSnap(surface);
        }
        if (surface.jumpLine() == cell_.line + 1) probe.jump = thinned(surface.jumps(Along::Beams), surface.jumps(Along::Lines), false);
        if (surface.foldLine() == cell_.line) {
            addFold(surface, Along::Beams);
            addFold(surface, Along::Lines);
        }
        if (surface.foldLine() == cell_.line + 1) probe.crease = thinned(surface.folds(Along::Beams), surface.folds(Along::Lines), true);
    }

    DepthProbe probe;

private:
    // Adds the crack between `first` and the next cell.
    void addStep(const SurfaceLines& surface, Along along, CellPlace first) {
        const Crack crack = crackAt(surface, along, first, inputs_);
        if (crack.strength <= 0) return;
        const CellPlace next{first.line + (along == Along::Lines ? 1 : 0), first.beam + (along == Along::Beams ? 1 : 0)};
        const auto u = [&](CellPlace p) { return surface.surface().u.line(p.line)[p.beam]; };
        const bool firstIsNearer = u(first) >= u(next);
        const bool isFirst = first.line == cell_.line && first.beam == cell_.beam;
        const CellPlace other = isFirst ? next : first;
        probe.steps.push_back({along, other.line, other.beam, crack.stepMm, static_cast<double>(inputs_.limits.jumpMm), crack.growthMm,
                               crack.grazingMm, crack.reliefMm, crack.strength, isFirst == firstIsNearer});
    }

    void lookForSnap(const SurfaceLines& surface) {
        const float before = inputs_.inverse.u.at(cell_.line, cell_.beam);
        const float after = surface.surface().u.line(cell_.line)[cell_.beam];
        if (before != after) probe.snappedMm = 1000.0 / static_cast<double>(after);
    }

    void addFold(const SurfaceLines& surface, Along along) {
        FoldWork work;
        const auto strengthWith = [&](const DepthLimits& limits) {
            FoldStrengths folds{Lines(inputs_.inverse.u.beams, 1, 0.0F, cell_.line), Lines(inputs_.inverse.u.beams, 1, 0.0F, cell_.line)};
            foldStrengths(surface.smoothed(), surface.links(Along::Beams), surface.links(Along::Lines), inputs_.steps, cell_.line, limits,
                          work, folds);
            const Lines& way = along == Along::Beams ? folds.alongBeams : folds.alongLines;
            return static_cast<double>(way.line(cell_.line)[cell_.beam]);
        };
        const DepthLimits one = bare(inputs_.limits);
        const double fold = strengthWith(one);
        if (fold == 0) return;
        DepthLimits noise = one;
        noise.creaseDeg = kTinyDeg;
        noise.foldNoise = inputs_.limits.foldNoise;
        DepthLimits misfit = one;
        misfit.misfitMm = inputs_.limits.misfitMm;
        probe.folds.push_back({along, std::abs(fold), fold > 0, fold / strengthWith(noise), strengthWith(misfit) / fold,
                               std::abs(strengthWith(inputs_.limits))});
    }

    // As the suppression of depthResponses(): in the direction of the stronger response a cell must not be weaker than the neighbour before
    // it, and it must be stronger than the neighbour after it.
    [[nodiscard]] ThinnedStrength thinned(const Lines& alongBeams, const Lines& alongLines, bool both) const {
        const float b = alongBeams.line(cell_.line)[cell_.beam];
        const float l = alongLines.line(cell_.line)[cell_.beam];
        const bool beams = std::abs(b) >= std::abs(l);
        const Lines& way = beams ? alongBeams : alongLines;
        const auto neighbour = [&](int sign) {
            const CellPlace at{cell_.line + (beams ? 0 : sign), cell_.beam + (beams ? sign : 0)};
            return CellStrength{at.line, at.beam, static_cast<double>(std::abs(way.line(at.line)[at.beam]))};
        };
        const float size = std::abs(beams ? b : l);
        const CellStrength before = neighbour(-1);
        const CellStrength after = neighbour(1);
        const bool outdoneBefore = before.strength > static_cast<double>(size);
        const bool outdoneAfter = after.strength >= static_cast<double>(size);
        const float add = both && b * l > 0 ? std::min(b * b, l * l) : 0.0F;
        ThinnedStrength result;
        result.before = std::copysign(std::sqrt(size * size + add), beams ? b : l);
        result.compared = size;
        if (size == 0) return result;
        if (outdoneBefore && (!outdoneAfter || before.strength >= after.strength))
            result.stronger = before;
        else if (outdoneAfter)
            result.stronger = after;
        const bool solid = inputs_.inverse.support.at(cell_.line, cell_.beam) != Support::Void;
        result.after = result.stronger || !solid ? 0.0F : result.before;
        return result;
    }

    const DepthInputs& inputs_;
    CellPlace cell_;
};

} // namespace

DepthProbe probeDepth(const Scan& scan, const Settings& settings, int line, int beam, const GapFilling* filling) {
    const DepthSurface sweep = withFilledGaps(depthSurface(scan, settings), filling);
    const DepthInputs inputs{sweep.inverse, sweep.slips, sweep.steps, depthLimits(sweep, settings)};
    Prober prober(inputs, {line, beam});
    SurfaceLines surface(inputs.inverse, inputs.steps, inputs.slips, inputs.limits, std::max(0, line - SurfaceLines::kLinesBefore - 2));
    while (surface.foldLine() <= line) {
        surface.advance();
        prober.look(surface);
    }
    DepthProbe& probe = prober.probe;
    probe.support = inputs.inverse.support.at(line, beam);
    probe.noiseMm = inputs.limits.noise.at(1.0 / static_cast<double>(inputs.inverse.u.at(line, beam)));
    probe.foldNoiseMm = inputs.limits.foldNoise.at(1.0 / static_cast<double>(inputs.inverse.u.at(line, beam)));
    probe.noiseAt5mMm = inputs.limits.noise.at(kReferenceM);
    probe.creaseDeg = static_cast<double>(inputs.limits.creaseDeg);
    probe.interlaced = inputs.slips.interlaced;
    probe.grazingRaised = inputs.limits.grazing > static_cast<float>(settings.grazing);
    std::ranges::stable_sort(probe.steps, [](const DepthStepAtCell& a, const DepthStepAtCell& b) {
        return a.cellIsNearer != b.cellIsNearer ? a.cellIsNearer : a.strength > b.strength;
    });
    std::ranges::stable_sort(probe.folds, std::greater{}, &FoldAtCell::strength);
    return std::move(prober.probe);
}

} // namespace edgescan::edges
