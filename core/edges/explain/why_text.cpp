// The text that explains why a cell is an edge, or why it is not.
#include "core/base/number_text.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/explain/why.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <array>
#include <cmath>

namespace edgescan::edges {
namespace {

std::string number(double value) { return fixedText(value, std::abs(value) < 10 ? 2 : 1); }

std::string whole(double value) { return fixedText(value, value < 10 ? 1 : 0); }

std::string place(int line, int beam) { return "line " + std::to_string(line) + ", beam " + std::to_string(beam); }
std::string place(const CellStrength& cell) { return place(cell.line, cell.beam); }

bool isDepth(const Why& why) { return why.depth.has_value(); }

// A number with the unit of the thresholds; strengths of EdgeScan+ are factors without unit.
std::string inUnit(const Why& why, double value) { return number(value) + (isDepth(why) ? "" : std::string(" ") + why.unit); }

const char* kindName(DepthEdge kind) {
    static constexpr std::array<const char*, kDepthEdges> kNames{
        "edge", "jump", "convex fold", "concave fold", "data border", "outline before a void", "void rim"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* alongName(Along along) { return along == Along::Beams ? "along the line" : "across the lines"; }

std::string named(const char* key, Naming naming) { return naming == Naming::Keys ? key : findParameter(key)->label; }

struct Thresholds {
    std::string lower, upper;
};
Thresholds thresholdNames(const Why& why, const Settings& settings, Naming naming) {
    if (isDepth(why))
        return {named("hysteresis-low", naming) + " (" + number(why.lower) + ")", named("sensitivity", naming) + " " + number(why.upper)};
    if (hasOneThreshold(settings.method)) return {"the threshold " + inUnit(why, why.lower), "the threshold " + inUnit(why, why.upper)};
    return {"the lower threshold " + inUnit(why, why.lower), "the upper threshold " + inUnit(why, why.upper)};
}

// The farther side of a jump is never an edge, however large the jump: the outline of the rock is at the nearer cell.
const DepthStepAtCell* stepOfNeighbour(const Why& why) {
    if (!isDepth(why) || why.strength > why.lower) return nullptr;
    const auto& steps = why.depth->steps;
    const DepthStepAtCell* strongest = nullptr;
    for (const DepthStepAtCell& step : steps) {
        if (!step.cellIsNearer && step.strength > why.lower && (strongest == nullptr || step.strength > strongest->strength))
            strongest = &step;
    }
    return strongest;
}

std::string reasonOfNone(const Why& why, const Settings& settings, const std::string& strength, const Thresholds& thresholds) {
    const bool lost = why.suppressedBy && (why.strength > why.lower || why.strength == 0);
    if (lost)
        return place(*why.suppressedBy) + " next to it is " + (why.suppressedBy->strength > why.strength ? "stronger (" : "as strong (") +
               inUnit(why, why.suppressedBy->strength) + "), and an edge is one cell wide";
    if (const DepthStepAtCell* step = stepOfNeighbour(why))
        return "the step of " + whole(step->stepMm) + " mm belongs to " + place(step->line, step->beam) + ", which is the nearer cell";
    if (why.level == StrengthLevel::Below) {
        const std::string text = strength + (why.strength < why.lower ? " is below " : " does not exceed ") + thresholds.lower;
        return why.suppressedBy ? text + ", and " + place(*why.suppressedBy) + " next to it is stronger" : text;
    }
    if (why.chain.empty())
        return strength + " is above " + thresholds.lower + ", but no chain of such cells leads to one above " + thresholds.upper;
    return "its chain has " + std::to_string(why.chainCells) + (why.chainCells == 1 ? " cell" : " cells") +
           ", fewer than the minimum length " + std::to_string(settings.minimumLength);
}

std::string reason(const Why& why, const Settings& settings, Naming naming) {
    if (!why.takesPart) return why.probe.state == CellState::Valid ? "it is a single cell and takes no part" : "it has no range";
    const std::string strength = isDepth(why) && why.kind != DepthEdge::None
                                     ? "the strength " + number(why.strength) + " of its " + kindName(why.kind)
                                     : "its strength " + inUnit(why, why.strength);
    const Thresholds thresholds = thresholdNames(why, settings, naming);
    if (!why.probe.edge) return reasonOfNone(why, settings, strength, thresholds);
    if (hasOneThreshold(settings.method)) return strength + " is above " + thresholds.upper;
    if (why.probe.kind == DepthEdge::Border) return "it is next to missing data, and such borders are a class that was chosen";
    if (why.probe.kind == DepthEdge::Silhouette)
        return "the surface ends here before missing data, and what is behind them is farther away";
    if (why.probe.kind == DepthEdge::VoidRim) return "the surface ends here at an open void, from which nothing came back";
    if (why.level == StrengthLevel::Above) return strength + " is above " + thresholds.upper;
    if (why.chain.size() > 1)
        return strength + " is above " + thresholds.lower + ", and " + std::to_string(why.chain.size() - 1) +
               (why.chain.size() == 2 ? " cell on, at " : " cells on, at ") + place(why.chain.back()) + ", its chain reaches " +
               inUnit(why, why.chain.back().strength);
    return strength + " is enough where it continues its chain";
}

std::string stepText(const Why& why, const DepthStepAtCell& step) {
    std::string text = "Step in depth: " + whole(step.stepMm) + " mm to " + place(step.line, step.beam) + " (" + alongName(step.along) +
                       (step.cellIsNearer ? "; this cell is the nearer one)" : "; that cell is the nearer one)");
    text += ", limit " + whole(step.limitMm()) + " mm = " + findParameter("jump")->label + " " + whole(step.smallestMm) + " + " +
            findParameter("growth")->label + " " + whole(step.growthMm) + " + " + findParameter("grazing")->label + " " +
            whole(step.grazingMm) + (why.depth->grazingRaised ? " (raised: beams are interlaced)" : "") + " + relief " +
            whole(step.reliefMm);
    return text + ": strength " + number(step.strength) + ".";
}

std::string foldText(const Why& why, const FoldAtCell& fold) {
    const bool noisy = fold.noiseDeg > why.depth->creaseDeg;
    std::string text = "Fold: " + number(fold.dihedralDeg) + " degrees " + (fold.convex ? "convex, outwards" : "concave, inwards") + " (" +
                       alongName(fold.along) + "), limit ";
    text += noisy ? number(fold.noiseDeg) + " degrees, which noise alone may look like (" + findParameter("crease")->label + " " +
                        number(why.depth->creaseDeg) + ")"
                  : number(why.depth->creaseDeg) + " degrees = " + findParameter("crease")->label;
    if (fold.meets < 0.995) text += "; " + whole(100 * fold.meets) + " % of it counts, for the two sides do not meet at the cell";
    return text + ": strength " + number(fold.strength) + ".";
}

std::string roughText(const Judgement::RoughAround& rough) {
    std::string text = "Rough scan: " + whole(100 * rough.share) + " % of what is within 15 degrees folds";
    return text +
           (rough.factor > 1 ? ", so a fold must be " + number(rough.factor) + " times as strong here." : "; a fold counts as elsewhere.");
}

// The measurements of the surface at the cell, one per line.
std::string depthText(const Why& why) {
    const DepthProbe& depth = *why.depth;
    std::string text;
    if (depth.support == Support::Filled)
        text += "\nNo range of its own: the gap is filled from both sides, and edges go round it by the cells next to it.";
    if (depth.support == Support::RequestedFill)
        text += "\nNo range of its own: the gap was filled on request, and its cells take part like measured ones.";
    if (why.movedFromGap) text += "\nThe edge of a cell without a range next to it goes round by this one.";
    if (depth.support == Support::Void) text += "\nNothing is known here: no step and no fold is measured next to missing data.";
    if (depth.snappedMm) text += "\nMixed pixel: taken at " + number(*depth.snappedMm / 1000) + " m, on the closer of two surfaces.";
    const DepthStepAtCell* decisive = stepOfNeighbour(why);
    if (!depth.steps.empty()) text += "\n" + stepText(why, decisive != nullptr ? *decisive : depth.steps.front());
    if (!depth.folds.empty()) text += "\n" + foldText(why, depth.folds.front());
    const double together = static_cast<double>(std::abs(depth.crease.before)) * (why.rough ? why.rough->factor : 1.0);
    if (depth.folds.size() > 1 && together > 1.005 * depth.folds.front().strength)
        text += " Together with the other way " + number(together) + ".";
    if (why.rough && !depth.folds.empty()) text += "\n" + roughText(*why.rough);
    if (depth.support != Support::Void) {
        text += "\nRange noise used: sigma " + number(depth.noiseMm) + " mm here, " + number(depth.noiseAt5mMm) + " mm at 5 m.";
        if (depth.foldNoiseMm != depth.noiseMm)
            text += " Neighbours err alike, so for folds it counts as " + number(depth.foldNoiseMm) + " mm here.";
    }
    return text;
}

std::string strengthText(const Why& why, const Settings& settings) {
    std::string text = choiceLabel(*findParameter("method"), settings) + ": strength " + inUnit(why, why.strength);
    if (isDepth(why) && why.kind != DepthEdge::None) text += std::string(" as ") + kindName(why.kind);
    if (why.directionDeg) {
        text += why.alongBeams ? " (along the line " + inUnit(why, *why.alongBeams) + ", across the lines " + inUnit(why, *why.alongLines) +
                                     ", direction "
                               : " (direction ";
        text += number(*why.directionDeg) + " degrees)";
    }
    if (isDepth(why)) {
        return text + "; " + findParameter("sensitivity")->label + " " + number(why.upper) + ", " + findParameter("hysteresis-low")->label +
               " " + whole(settings.hysteresisPercent) + " % of it: weak from " + number(why.lower) + ", strong from " + number(why.upper);
    }
    return text + (why.lower == why.upper ? ", threshold " + inUnit(why, why.upper)
                                          : ", thresholds " + number(why.lower) + " and " + inUnit(why, why.upper));
}

std::string chainText(const Why& why) {
    if (why.chainCells == 0 || !why.chainTop) return "";
    return "\nChain: " + std::to_string(why.chainCells) + (why.chainCells == 1 ? " cell" : " cells") + ", strongest at " +
           place(*why.chainTop) + " (" + inUnit(why, why.chainTop->strength) + ").";
}

} // namespace

std::string whyVerdict(const Why& why, const Settings& settings, Naming naming) {
    const Parameter& parameter = *findParameter(why.parameter);
    const std::string name = named(why.parameter, naming);
    std::string text = (why.probe.edge ? "Edge: " : "No edge: ") + reason(why, settings, naming) + "; ";
    if (!why.appearsAt) return text + "no value of " + name + " makes it one.";
    return text + (why.probe.edge ? "stays one at " : "would appear at ") + name + " <= " + formatValue(parameter, *why.appearsAt) + ".";
}

std::string whyText(const Why& why, const Settings& settings) {
    return whyNumbers(why, settings) + "\n" + whyVerdict(why, settings, Naming::Labels);
}

std::string whyNumbers(const Why& why, const Settings& settings) {
    std::string text = place(why.probe.line, why.probe.beam) + ": ";
    text += why.probe.state == CellState::Valid ? "range " + number(why.probe.rangeMm / 1000) + " m"
                                                : std::string(cellStateName(why.probe.state));
    if (!isDepth(why)) text += ", gray " + std::to_string(why.probe.gray);
    if (why.smoothed) text += ", smoothed " + std::to_string(static_cast<int>(*why.smoothed));
    if (why.probe.edge && why.probe.kind != DepthEdge::None) text += std::string(", class ") + kindName(why.probe.kind);
    text += "\n" + strengthText(why, settings);
    if (isDepth(why)) text += depthText(why);
    return text + chainText(why);
}

} // namespace edgescan::edges
