// Explains why a cell is an edge, or why it is not.
#include "core/edges/explain/why.h"

#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace edgescan::edges {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A value with the table's precision at which the cell is still an edge: rounded down.
double roundedDown(double value, const Parameter& parameter) {
    const double tens = std::pow(10.0, parameter.decimals);
    return std::floor(value * tens) / tens;
}

// Breadth first over cells above the lower threshold: finds the path to the nearest strong cell, and the number of connected cells.
void followChain(Why& why, const Grid<float>& scan) {
    if (why.level == StrengthLevel::Below) return;
    struct Found {
        CellStrength cell;
        std::uint32_t from; ///< index in `chain` of the cell from which it was reached; the first one: itself
    };
    const auto beams = static_cast<std::size_t>(scan.beams);
    const auto described = [&](std::size_t k) {
        return CellStrength{static_cast<int>(k / beams), static_cast<int>(k % beams), why.linked(k)};
    };
    std::vector<Found> chain{{described(why.probe.cell), 0}};
    std::vector<bool> seen(scan.size(), false);
    seen[why.probe.cell] = true;
    std::uint32_t strong = kNone;
    for (std::uint32_t at = 0; at < chain.size(); ++at) {
        const CellStrength here = chain[at].cell;
        if (strong == kNone && here.strength > why.upper) strong = at;
        for (int i = std::max(here.line - 1, 0); i <= std::min(here.line + 1, scan.lines - 1); ++i) {
            for (int j = std::max(here.beam - 1, 0); j <= std::min(here.beam + 1, scan.beams - 1); ++j) {
                const std::size_t n = scan.index(i, j);
                if (seen[n]) continue;
                seen[n] = true;
                if (const CellStrength next = described(n); next.strength > why.lower) chain.push_back({next, at});
            }
        }
    }
    why.chainCells = chain.size();
    for (const Found& found : chain) why.chainMembers.push_back(static_cast<std::uint32_t>(scan.index(found.cell.line, found.cell.beam)));
    std::ranges::sort(why.chainMembers);
    const auto stronger = [](const CellStrength& a, const CellStrength& b) {
        return std::tuple(-a.strength, a.line, a.beam) < std::tuple(-b.strength, b.line, b.beam);
    };
    why.chainTop = std::ranges::min(chain, stronger, &Found::cell).cell;
    if (strong == kNone) return;
    for (std::uint32_t at = strong;; at = chain[at].from) {
        why.chain.push_back(chain[at].cell);
        if (at == 0) break;
    }
    std::ranges::reverse(why.chain);
}

StrengthLevel standingOf(double strength, const Why& why) {
    return strength > why.upper ? StrengthLevel::Above : strength > why.lower ? StrengthLevel::Between : StrengthLevel::Below;
}

// Whether the cell is an edge that is left out, and how likely it is the border of a rock. `k`: the cell.
void followBorder(Why& why, const Detection& detection, std::size_t k) {
    if (!detection.responses || (!why.probe.edge && !detection.settings.rockBorders)) return;
    const Settings& settings = detection.settings;
    DepthEdges all;
    if (!why.probe.edge) all = decideDepthEdges(*detection.responses, settings, 0);
    why.leftOut = !why.probe.edge && all.mask[k] != 0;
    if (!why.probe.edge && !why.leftOut) return;
    const Grid<DepthEdge>& classes = why.leftOut ? all.kind : *detection.classes;
    const std::array cells{static_cast<std::uint32_t>(k)};
    why.border = borderPercents(*detection.surface, *detection.responses, settings, cells).front();
    if (*why.border == kUnknownBorder || classes[k] >= DepthEdge::Border) return; // of these no evidence is weighed
    constexpr std::size_t kMostReasons = 3;
    why.borderReasons = borderReasons(*detection.surface, *detection.responses, settings, k);
    std::erase_if(why.borderReasons, [](const BorderReason& reason) { return reason.added == 0; });
    if (why.borderReasons.size() > kMostReasons) why.borderReasons.resize(kMostReasons);
}

// Converts strengths and thresholds to the units of the settings.
void convertToShownUnits(Why& why, const Settings& settings) {
    const auto shown = [&](double& value) { value = why.shown(value, settings); };
    for (double* value : {&why.strength, &why.lower, &why.upper, &why.compared}) shown(*value);
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
    followBorder(why, detection, k);
    why.parameter = parameter.key;
    why.unit = parameter.unit;
    if (detection.smoothed) why.smoothed = (*detection.smoothed)[k];
    why.level = standingOf(why.linked ? static_cast<double>(why.linked(k)) : why.strength, why);
    if (why.linked) followChain(why, detection.scan->rangeMm);
    why.linked = nullptr; // may hold a gradient; the threshold below needs its own
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
