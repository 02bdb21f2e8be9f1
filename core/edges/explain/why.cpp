// Explains why a cell is an edge, or why it is not.
#include "core/edges/explain/why.h"

#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::edges {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A value with the table's precision at which the cell is still an edge: rounded down.
double roundedDown(double value, const Parameter& parameter) {
    const double tens = std::pow(10.0, parameter.decimals);
    return std::floor(value * tens) / tens;
}

// Breadth first over cells above the lower threshold: finds the path to the nearest strong cell, and the number of connected cells.
void followChain(Why& why) {
    const Grid<float>& strength = why.linked;
    if (why.level == StrengthLevel::Below) return;
    const auto beams = static_cast<std::size_t>(strength.beams);
    std::vector<std::uint32_t> from(strength.size(), kNone);
    std::vector<std::uint32_t> waiting{why.probe.cell};
    from[why.probe.cell] = why.probe.cell;
    const auto described = [&](std::uint32_t k) {
        return CellStrength{static_cast<int>(k / beams), static_cast<int>(k % beams), strength[k]};
    };
    std::uint32_t strong = kNone;
    for (std::size_t at = 0; at < waiting.size(); ++at) {
        const std::uint32_t k = waiting[at];
        if (strong == kNone && strength[k] > why.upper) strong = k;
        const CellStrength here = described(k);
        for (int i = here.line - 1; i <= here.line + 1; ++i) {
            for (int j = here.beam - 1; j <= here.beam + 1; ++j) {
                if (!strength.contains(i, j) || strength.at(i, j) <= why.lower) continue;
                const auto n = static_cast<std::uint32_t>(strength.index(i, j));
                if (from[n] != kNone) continue;
                from[n] = k;
                waiting.push_back(n);
            }
        }
    }
    why.chainCells = waiting.size();
    const auto weaker = [&](std::uint32_t a, std::uint32_t b) { return strength[a] != strength[b] ? strength[a] < strength[b] : a > b; };
    why.chainTop = described(*std::ranges::max_element(waiting, weaker));
    why.chainMembers = waiting;
    std::ranges::sort(why.chainMembers);
    if (strong == kNone) return;
    for (std::uint32_t k = strong;; k = from[k]) {
        why.chain.push_back(described(k));
        if (k == why.probe.cell) break;
    }
    std::ranges::reverse(why.chain);
}

StrengthLevel standingOf(double strength, const Why& why) {
    return strength > why.upper ? StrengthLevel::Above : strength > why.lower ? StrengthLevel::Between : StrengthLevel::Below;
}

// Converts strengths and thresholds to the units of the settings.
void convertToShownUnits(Why& why, const Settings& settings) {
    const auto shown = [&](double& value) { value = why.shown(value, settings); };
    for (double* value : {&why.strength, &why.lower, &why.upper}) shown(*value);
    for (std::optional<double>* value : {&why.alongBeams, &why.alongLines}) {
        if (*value) shown(**value);
    }
    for (std::optional<CellStrength>* cell : {&why.suppressedBy, &why.chainTop}) {
        if (*cell) shown((*cell)->strength);
    }
    for (CellStrength& cell : why.chain) shown(cell.strength);
}

} // namespace

Why whyCell(const Detection& detection, std::size_t k) {
    const Settings& settings = detection.settings;
    const Decision& decision = rowOf(settings.method).decision;
    const Parameter& parameter = sweptParameter(settings.method);
    Why why;
    static_cast<Judgement&>(why) = decision.judge(detection, k);
    why.probe = probeCell(detection, k);
    why.parameter = parameter.key;
    why.unit = parameter.unit;
    if (detection.smoothed) why.smoothed = (*detection.smoothed)[k];
    const bool linked = why.linked.size() > 0;
    why.level = standingOf(linked ? static_cast<double>(why.linked[k]) : why.strength, why);
    if (linked) followChain(why);
    if (why.shown != nullptr) convertToShownUnits(why, settings);
    const double highest = decision.threshold(detection, k);
    if (highest >= 0) {
        const double limited = std::min(roundedDown(highest, parameter), parameter.maximum);
        if (limited >= parameter.minimum) why.appearsAt = limited;
    }
    why.verdict = whyVerdict(why, settings, Naming::Keys);
    return why;
}

} // namespace edgescan::edges
