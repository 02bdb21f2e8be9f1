// The text that explains why a cell is an edge, or why it is not.
#include "core/base/number_text.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/explain/why.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace edgescan::edges {
namespace {

std::string number(double value) { return fixedText(value, std::abs(value) < 10 ? 2 : 1); }

} // namespace

std::string strengthNumber(double value) {
    constexpr double kNearlyNext = 1e-4; // of the last digit: 0.7 has no exact binary value
    const double tens = std::abs(value) < 10 ? 100.0 : 10.0;
    return number(std::floor(value * tens + kNearlyNext) / tens);
}

namespace {

std::string whole(double value) { return fixedText(value, value < 10 ? 1 : 0); }

/// Lengths are in metres, with the digits of the status line; noise below 10 mm has one digit more.
std::string metres(double mm) { return fixedText(mm / 1000.0, 3); }

std::string noiseMetres(double mm) { return fixedText(mm / 1000.0, mm < 10.0 ? 4 : 3); }

/// The strongest step at the cell that is strong enough for an edge and belongs to its neighbour; null: it has none. The farther side of a
/// jump is never an edge, however large the jump: the outline of the rock is at the nearer cell.
const DepthStepAtCell* stepOfNeighbour(const Why& why) {
    if (!why.depth || why.strength > why.lower) return nullptr;
    const DepthStepAtCell* strongest = nullptr;
    for (const DepthStepAtCell& step : why.depth->steps) {
        if (!step.cellIsNearer && step.strength > why.lower && (strongest == nullptr || step.strength > strongest->strength))
            strongest = &step;
    }
    return strongest;
}

struct EvidenceWords {
    BorderEvidence evidence;
    const char *key, *words;
};
constexpr std::array<EvidenceWords, kBorderEvidences> kEvidences{{
    {BorderEvidence::Steps, "steps", "steps in depth around it"},
    {BorderEvidence::Fold, "fold", "its own fold"},
    {BorderEvidence::Across, "across", "the surface across the edge"},
    {BorderEvidence::Along, "along", "the surface along the edge"},
    {BorderEvidence::Height, "height", "its height over the surroundings"},
    {BorderEvidence::Folds, "folds", "folds around it"},
    {BorderEvidence::Distance, "distance", "distance and noise"},
}};

const EvidenceWords& wordsOf(BorderEvidence evidence) { return *std::ranges::find(kEvidences, evidence, &EvidenceWords::evidence); }

/// The texts of one cell, in the words of the command line or of the window.
class WhyWords {
public:
    WhyWords(const Why& why, const Settings& settings, Naming naming, Translated translated)
        : why_(why), settings_(settings), naming_(naming), translated_(translated) {}

    [[nodiscard]] std::string verdict() const;
    [[nodiscard]] std::string numbers() const;
    [[nodiscard]] std::string border() const;

private:
    /// The pattern in the language of the texts, with the values in place of %1, %2 ... (resources/languages/collect finds the patterns).
    [[nodiscard]] std::string say(const char* pattern, std::initializer_list<ValueText> values = {}) const;
    [[nodiscard]] std::string place(int line, int beam) const {
        return say("line %1, beam %2", {std::to_string(line), std::to_string(beam)});
    }
    [[nodiscard]] std::string place(const CellStrength& cell) const { return place(cell.line, cell.beam); }
    [[nodiscard]] bool isDepth() const { return why_.depth.has_value(); }
    /// A number with the unit of the thresholds; strengths of EdgeScan+ are factors without unit.
    [[nodiscard]] std::string inUnit(double value) const { return strengthNumber(value) + (isDepth() ? "" : " " + translated_(why_.unit)); }
    [[nodiscard]] std::string label(const char* key) const { return translated_(findParameter(key)->label); }
    [[nodiscard]] std::string named(const char* key) const { return naming_ == Naming::Keys ? key : label(key); }
    [[nodiscard]] std::string kindName(DepthEdge kind) const;
    [[nodiscard]] std::string stateName(CellState state) const;
    [[nodiscard]] std::string alongName(Along along) const {
        return along == Along::Beams ? say("along the line") : say("across the lines");
    }
    [[nodiscard]] std::string lowerThreshold() const;
    [[nodiscard]] std::string upperThreshold() const;
    [[nodiscard]] std::string reasonOfNone(const std::string& strength) const;
    [[nodiscard]] std::string reasonOfChain(const std::string& strength) const;
    [[nodiscard]] std::string reason() const;
    [[nodiscard]] std::string stepText(const DepthStepAtCell& step) const;
    [[nodiscard]] std::string foldText(const FoldAtCell& fold) const;
    [[nodiscard]] std::string roughText() const;
    [[nodiscard]] std::string supportText() const;
    [[nodiscard]] std::string depthText() const;
    [[nodiscard]] std::string strengthText() const;
    [[nodiscard]] std::string chainText() const;

    const Why& why_;
    const Settings& settings_;
    Naming naming_;
    Translated translated_;
};

std::string WhyWords::say(const char* pattern, std::initializer_list<ValueText> values) const {
    return withValues(translated_(pattern), values);
}

std::string WhyWords::kindName(DepthEdge kind) const {
    switch (kind) {
    case DepthEdge::Jump:
        return say("jump");
    case DepthEdge::Convex:
        return say("convex fold");
    case DepthEdge::Concave:
        return say("concave fold");
    case DepthEdge::Border:
        return say("data border");
    case DepthEdge::Silhouette:
        return say("outline before a void");
    case DepthEdge::VoidRim:
        return say("void rim");
    case DepthEdge::None:
        break;
    }
    return say("edge");
}

std::string WhyWords::stateName(CellState state) const {
    switch (state) {
    case CellState::DeviceStatus:
        return say("device status");
    case CellState::OutOfWindow:
        return say("out of window");
    case CellState::Masked:
        return say("masked");
    case CellState::Lost:
        return say("lost");
    default:
        return say("no return");
    }
}

std::string WhyWords::lowerThreshold() const {
    if (isDepth()) return named("hysteresis-low") + " (" + strengthNumber(why_.lower) + ")";
    return hasOneThreshold(settings_.method) ? say("the threshold %1", {inUnit(why_.lower)})
                                             : say("the lower threshold %1", {inUnit(why_.lower)});
}

std::string WhyWords::upperThreshold() const {
    if (isDepth()) return named("sensitivity") + " " + strengthNumber(why_.upper);
    return hasOneThreshold(settings_.method) ? say("the threshold %1", {inUnit(why_.upper)})
                                             : say("the upper threshold %1", {inUnit(why_.upper)});
}

std::string WhyWords::reasonOfNone(const std::string& strength) const {
    switch (noEdgeReason(why_)) {
    case NoEdge::NotBorder: {
        const std::string from = formatValue(*findParameter("border-from"), settings_.borderPercent);
        return say("it is an edge, but only %1 % likely the border of a rock, and only those from %2 % on are shown (%3)",
                   {std::to_string(*why_.border), from, named("border-from")});
    }
    case NoEdge::StrongerNeighbour: {
        const CellStrength& other = *why_.suppressedBy;
        const bool isStronger = other.strength > why_.compared;
        if (why_.compared < why_.strength) { // a fold in two directions
            const std::string along = alongName(other.line == why_.probe.line ? Along::Beams : Along::Lines);
            const std::initializer_list<ValueText> values{along, place(other), inUnit(other.strength), inUnit(why_.compared)};
            return isStronger ? say("%1 the fold at %2 next to it is stronger (%3 against %4), and an edge is one cell wide", values)
                              : say("%1 the fold at %2 next to it is as strong (%3 against %4), and an edge is one cell wide", values);
        }
        return isStronger ? say("%1 next to it is stronger (%2), and an edge is one cell wide", {place(other), inUnit(other.strength)})
                          : say("%1 next to it is as strong (%2), and an edge is one cell wide", {place(other), inUnit(other.strength)});
    }
    case NoEdge::StepOfNeighbour: {
        const DepthStepAtCell& step = *stepOfNeighbour(why_);
        return say("the step of %1 m belongs to %2, which is the nearer cell", {metres(step.stepMm), place(step.line, step.beam)});
    }
    case NoEdge::TooWeak: {
        const std::string text = why_.strength < why_.lower ? say("%1 is below %2", {strength, lowerThreshold()})
                                                            : say("%1 does not exceed %2", {strength, lowerThreshold()});
        return why_.suppressedBy && why_.suppressedBy->strength > why_.strength
                   ? say("%1, and %2 next to it is stronger", {text, place(*why_.suppressedBy)})
                   : text;
    }
    case NoEdge::NoStrongPlace:
        return say("%1 is above %2, but no chain of such cells leads to one above %3", {strength, lowerThreshold(), upperThreshold()});
    case NoEdge::TooShort:
        break;
    }
    const std::string least = std::to_string(settings_.minimumLength);
    return why_.chainCells == 1 ? say("its chain has 1 cell, fewer than the minimum length %1", {least})
                                : say("its chain has %1 cells, fewer than the minimum length %2", {std::to_string(why_.chainCells), least});
}

std::string WhyWords::reasonOfChain(const std::string& strength) const {
    if (why_.chain.size() < 2) return say("%1 is enough where it continues its chain", {strength});
    const CellStrength& last = why_.chain.back();
    return why_.chain.size() == 2
               ? say("%1 is above %2, and 1 cell on, at %3, its chain reaches %4",
                     {strength, lowerThreshold(), place(last), inUnit(last.strength)})
               : say("%1 is above %2, and %3 cells on, at %4, its chain reaches %5",
                     {strength, lowerThreshold(), std::to_string(why_.chain.size() - 1), place(last), inUnit(last.strength)});
}

std::string WhyWords::reason() const {
    if (!why_.takesPart)
        return why_.probe.state == CellState::Valid ? say("it is a single cell and takes no part") : say("it has no range");
    const std::string strength = isDepth() && why_.kind != DepthEdge::None
                                     ? say("the strength %1 of its %2", {strengthNumber(why_.strength), kindName(why_.kind)})
                                     : say("its strength %1", {inUnit(why_.strength)});
    if (!why_.probe.edge) return reasonOfNone(strength);
    const auto above = [&] { return say("%1 is above %2", {strength, upperThreshold()}); };
    if (hasOneThreshold(settings_.method)) return above();
    if (why_.probe.kind == DepthEdge::Border) return say("it is next to missing data, and such borders are a class that was chosen");
    if (why_.probe.kind == DepthEdge::Silhouette)
        return say("the surface ends here before missing data, and what is behind them is farther away");
    if (why_.probe.kind == DepthEdge::VoidRim) return say("the surface ends here at an open void, from which nothing came back");
    return why_.level == StrengthLevel::Above ? above() : reasonOfChain(strength);
}

std::string WhyWords::stepText(const DepthStepAtCell& step) const {
    double sumMm = 0; // of the parts as they are printed
    const auto part = [&sumMm](double mm) {
        sumMm += std::round(mm);
        return metres(std::round(mm));
    };
    const std::string parts = label("jump") + " " + part(step.smallestMm) + " + " + label("growth") + " " + part(step.growthMm) + " + " +
                              label("grazing") + " " + part(step.grazingMm) +
                              (why_.depth->grazingRaised ? say(" (raised: beams are interlaced)") : "") + " + " +
                              say("relief %1", {part(step.reliefMm)});
    const std::string limit = metres(sumMm) + " m = " + parts;
    const std::initializer_list<ValueText> values{metres(step.stepMm), place(step.line, step.beam), alongName(step.along), limit,
                                                  strengthNumber(step.strength)};
    return step.cellIsNearer ? say("Step in depth: %1 m to %2 (%3; this cell is the nearer one), limit %4: strength %5.", values)
                             : say("Step in depth: %1 m to %2 (%3; that cell is the nearer one), limit %4: strength %5.", values);
}

std::string WhyWords::foldText(const FoldAtCell& fold) const {
    const std::string crease = number(why_.depth->creaseDeg);
    std::string limit = fold.noiseDeg > why_.depth->creaseDeg
                            ? say("%1 degrees, which noise alone may look like (%2 %3)", {number(fold.noiseDeg), label("crease"), crease})
                            : say("%1 degrees = %2", {crease, label("crease")});
    if (fold.meets < 0.995) limit += say("; %1 % of it counts, for the two sides do not meet at the cell", {whole(100 * fold.meets)});
    const std::initializer_list<ValueText> values{number(fold.dihedralDeg), alongName(fold.along), limit, strengthNumber(fold.strength)};
    return fold.convex ? say("Fold: %1 degrees convex, outwards (%2), limit %3: strength %4.", values)
                       : say("Fold: %1 degrees concave, inwards (%2), limit %3: strength %4.", values);
}

std::string WhyWords::roughText() const {
    const std::string share = whole(100 * why_.rough->share);
    return why_.rough->factor > 1 ? say("Rough scan: %1 % of what is within 15 degrees folds, so a fold must be %2 times as strong here.",
                                        {share, number(why_.rough->factor)})
                                  : say("Rough scan: %1 % of what is within 15 degrees folds; a fold counts as elsewhere.", {share});
}

std::string WhyWords::supportText() const {
    const DepthProbe& depth = *why_.depth;
    std::string text;
    if (depth.support == Support::Filled)
        text += "\n" + say("No range of its own: the gap is filled from both sides, and edges go round it by the cells next to it.");
    if (depth.support == Support::RequestedFill)
        text += "\n" + say("No range of its own: the gap was filled on request, and its cells take part like measured ones.");
    if (why_.movedFromGap) text += "\n" + say("The edge of a cell without a range next to it goes round by this one.");
    if (depth.support == Support::Void) text += "\n" + say("Nothing is known here: no step and no fold is measured next to missing data.");
    if (depth.snappedMm)
        text += "\n" + say("Mixed pixel: its range is between two surfaces. For edges it counts as %1 m, the one nearer to its range.",
                           {metres(*depth.snappedMm)});
    return text;
}

// The measurements of the surface at the cell, one per line.
std::string WhyWords::depthText() const {
    const DepthProbe& depth = *why_.depth;
    std::string text = supportText();
    const DepthStepAtCell* decisive = stepOfNeighbour(why_);
    if (!depth.steps.empty()) text += "\n" + stepText(decisive != nullptr ? *decisive : depth.steps.front());
    if (!depth.folds.empty()) text += "\n" + foldText(depth.folds.front());
    const double together = static_cast<double>(std::abs(depth.crease.before)) * (why_.rough ? why_.rough->factor : 1.0);
    if (depth.folds.size() > 1 && together > 1.005 * depth.folds.front().strength)
        text += " " + say("Together with the other way %1.", {strengthNumber(together)});
    if (why_.rough && !depth.folds.empty()) text += "\n" + roughText();
    if (depth.support == Support::Void) return text;
    text += "\n" + say("Range noise used: sigma %1 m here, %2 m at 5 m.", {noiseMetres(depth.noiseMm), noiseMetres(depth.noiseAt5mMm)});
    if (depth.foldNoiseMm > depth.noiseMm)
        text += " " + say("Neighbours err alike, so for folds it counts as %1 m here.", {noiseMetres(depth.foldNoiseMm)});
    if (depth.foldNoiseMm < depth.noiseMm)
        text += " " + say("Noisy ranges are smoothed, so for folds it counts as %1 m here.", {noiseMetres(depth.foldNoiseMm)});
    return text;
}

std::string WhyWords::strengthText() const {
    const std::string method = translated_(choiceLabel(*findParameter("method"), settings_).c_str());
    std::string text = isDepth() && why_.kind != DepthEdge::None
                           ? say("%1: strength %2 as %3", {method, inUnit(why_.strength), kindName(why_.kind)})
                           : say("%1: strength %2", {method, inUnit(why_.strength)});
    if (why_.directionDeg) {
        text += why_.alongBeams ? say(" (along the line %1, across the lines %2, direction %3 degrees)",
                                      {inUnit(*why_.alongBeams), inUnit(*why_.alongLines), number(*why_.directionDeg)})
                                : say(" (direction %1 degrees)", {number(*why_.directionDeg)});
    }
    if (isDepth())
        return text + say("; %1 %2, %3 %4 % of it: weak from %5, strong from %6",
                          {label("sensitivity"), strengthNumber(why_.upper), label("hysteresis-low"), whole(settings_.hysteresisPercent),
                           strengthNumber(why_.lower), strengthNumber(why_.upper)});
    return text + (why_.lower == why_.upper ? say(", threshold %1", {inUnit(why_.upper)})
                                            : say(", thresholds %1 and %2", {strengthNumber(why_.lower), inUnit(why_.upper)}));
}

std::string WhyWords::chainText() const {
    if (why_.chainCells == 0 || !why_.chainTop) return "";
    const std::string top = place(*why_.chainTop), strength = inUnit(why_.chainTop->strength);
    return "\n" + (why_.chainCells == 1 ? say("Chain: 1 cell, strongest at %1 (%2).", {top, strength})
                                        : say("Chain: %1 cells, strongest at %2 (%3).", {std::to_string(why_.chainCells), top, strength}));
}

std::string WhyWords::border() const {
    if (!why_.border) return "";
    if (*why_.border == kUnknownBorder)
        return say("It is unknown if it is the border of a rock: the grid ends nearby, ranges are missing, or neighbours err alike.");
    const std::string text = say("It is %1 % likely the border of a rock, and not a fold within one.", {std::to_string(*why_.border)});
    std::string evidence;
    for (const BorderReason& reason : why_.borderReasons) {
        const std::string what = translated_(wordsOf(reason.evidence).words);
        evidence += (evidence.empty() ? "" : ", ") + (reason.added > 0 ? say("%1 (for it)", {what}) : say("%1 (against it)", {what}));
    }
    return evidence.empty() ? text : text + " " + say("What decided that: %1.", {evidence});
}

std::string WhyWords::verdict() const {
    const std::string name = named(why_.parameter);
    const bool edge = why_.probe.edge;
    if (why_.leftOut) return say("Left out: %1.", {reasonOfNone({})});
    if (!why_.appearsAt)
        return edge ? say("Edge: %1; no value of %2 makes it one.", {reason(), name})
                    : say("No edge: %1; no value of %2 makes it one.", {reason(), name});
    const Parameter& parameter = *findParameter(why_.parameter);
    const std::string limit = formatValue(parameter, *why_.appearsAt);
    const bool byChain = why_.chainCells > 1 && *why_.appearsAt > why_.strength;
    if (edge && byChain && *why_.appearsAt >= parameter.maximum)
        return say("Edge: %1; as part of its chain it remains an edge at each %2, up to the largest: %3.", {reason(), name, limit});
    if (edge && *why_.appearsAt >= parameter.maximum)
        return say("Edge: %1; this remains an edge at each %2, up to the largest: %3.", {reason(), name, limit});
    if (edge && byChain) return say("Edge: %1; as part of its chain it disappears only if you set %2 above %3.", {reason(), name, limit});
    if (edge && isDepth() && *why_.appearsAt + std::pow(10.0, -parameter.decimals) < why_.strength) // it alone would remain
        return say("Edge: %1; it disappears if you set %2 above %3, because its chain is then shorter than the minimum length %4.",
                   {reason(), name, limit, std::to_string(settings_.minimumLength)});
    return edge ? say("Edge: %1; it disappears if you set %2 above %3.", {reason(), name, limit})
                : say("No edge: %1; this becomes an edge when %2 is %3 or less.", {reason(), name, limit});
}

std::string WhyWords::numbers() const {
    const Probe& probe = why_.probe;
    const std::string at = place(probe.line, probe.beam);
    std::string text =
        probe.state == CellState::Valid ? say("%1: range %2 m", {at, metres(probe.rangeMm)}) : at + ": " + stateName(probe.state);
    if (!isDepth()) text += say(", gray %1", {std::to_string(probe.gray)});
    if (why_.smoothed) text += say(", smoothed %1", {std::to_string(static_cast<int>(*why_.smoothed))});
    if (probe.edge && probe.kind != DepthEdge::None) text += say(", class %1", {kindName(probe.kind)});
    text += "\n" + strengthText();
    if (isDepth()) text += depthText();
    if (why_.border) text += "\n" + border();
    return text + chainText();
}

} // namespace

NoEdge noEdgeReason(const Why& why) {
    if (why.leftOut) return NoEdge::NotBorder;
    if (why.suppressedBy && (why.strength > why.lower || why.strength == 0)) return NoEdge::StrongerNeighbour;
    if (stepOfNeighbour(why) != nullptr) return NoEdge::StepOfNeighbour;
    if (why.level == StrengthLevel::Below) return NoEdge::TooWeak;
    return why.chain.empty() ? NoEdge::NoStrongPlace : NoEdge::TooShort;
}

std::string whyVerdict(const Why& why, const Settings& settings, Naming naming, Translated translated) {
    return WhyWords(why, settings, naming, translated).verdict();
}

const char* evidenceKey(BorderEvidence evidence) { return wordsOf(evidence).key; }

std::string whyBorder(const Why& why, Translated translated) { return WhyWords(why, {}, Naming::Labels, translated).border(); }

std::string whyText(const Why& why, const Settings& settings) {
    return whyNumbers(why, settings) + "\n" + whyVerdict(why, settings, Naming::Labels);
}

std::string whyNumbers(const Why& why, const Settings& settings, Translated translated) {
    return WhyWords(why, settings, Naming::Labels, translated).numbers();
}

} // namespace edgescan::edges
