// Why a cell is an edge, or why it is none.
#include "core/explain/why.h"

#include "core/depth/depth_settings.h"
#include "core/gray/canny.h"
#include "core/gray/detector.h"
#include "core/gray/gradient_masks.h"
#include "core/gray/log_range.h"
#include "core/gray/masked_cells.h"
#include "core/method/detection_thresholds.h"
#include "core/scan/missing_cells.h"
#include "core/settings/method_traits.h"
#include "core/settings/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace edgescan {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A value of the table's precision at which the cell still is an edge: rounded down.
double roundedDown(double value, const Parameter& parameter) {
    const double tens = std::pow(10.0, parameter.decimals);
    return std::floor(value * tens) / tens;
}

// Breadth first over cells above the lower threshold: the way to the nearest strong cell, and how many cells hang together.
void followChain(Why& why, const Grid<float>& strength) {
    if (why.standing == Standing::Below) return;
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

Standing standingOf(double strength, const Why& why) {
    return strength > why.upper ? Standing::Above : strength > why.lower ? Standing::Between : Standing::Below;
}

// Canny on levels or log range. Returns the suppressed strengths.
Grid<float> judgeGradient(Why& why, const Detection& detection) {
    const Settings& settings = detection.settings;
    const Gradient gradient = gradientOf(detection);
    const bool logRange = settings.method == Method::LogRange;
    why.lower = logRange ? logRangeGradientOfStep(settings.stepPercent, settings) : settings.lower;
    why.upper = settings.ratio * why.lower;
    const auto sized = [&](std::int32_t magnitude) {
        return (settings.norm == Norm::L2 ? std::sqrt(static_cast<double>(magnitude)) : magnitude) / gradient.scale;
    };
    const auto strengthAt = [&](std::size_t k) {
        return sized(gradientMagnitude(gradient.alongBeams[k], gradient.alongLines[k], settings.norm));
    };
    const std::size_t k = why.probe.cell;
    const std::int16_t dx = gradient.alongBeams[k];
    const std::int16_t dy = gradient.alongLines[k];
    why.alongBeams = dx / gradient.scale;
    why.alongLines = dy / gradient.scale;
    why.strength = strengthAt(k);
    if (dx != 0 || dy != 0) why.directionDeg = std::atan2(dy, dx) * 180.0 / std::numbers::pi;
    const AlongGradient along = alongGradient(dx, dy);
    for (const int sign : {-1, 1}) {
        const int line = why.probe.line + sign * along.lineStep;
        const int beam = why.probe.beam + sign * along.beamStep;
        if (why.suppressedBy || !detection.scan->rangeMm.contains(line, beam)) continue;
        const double other = strengthAt(detection.scan->rangeMm.index(line, beam));
        const bool outdone = sign > 0 && along.tieIsKept ? why.strength >= other : why.strength > other;
        if (!outdone && other > why.lower) why.suppressedBy = CellStrength{line, beam, other};
    }
    const Grid<std::int32_t> kept = suppressedMagnitude(gradient, settings.norm);
    Grid<float> strength(kept.lines, kept.beams);
    for (std::size_t n = 0; n < kept.size(); ++n) strength[n] = static_cast<float>(sized(kept[n]));
    return strength;
}

void judgeResponse(Why& why, const Detection& detection) {
    const Settings& settings = detection.settings;
    const Grid<std::uint8_t> masked = maskedCells(*detection.scan, settings);
    const Grid<std::uint8_t>& levels = detection.smoothed ? *detection.smoothed : detection.gray->levels;
    const Grid<std::uint8_t>* missing = masked.size() > 0 ? &masked : nullptr;
    why.strength = detectorResponse(settings.method, levels, missing, settings)[why.probe.cell];
    const MaskDirection direction = maskDirection(settings.method, levels, missing, why.probe.line, why.probe.beam);
    why.alongBeams = direction.alongBeams;
    why.alongLines = direction.alongLines;
    why.directionDeg = direction.deg;
    why.lower = why.upper = settings.lower;
    why.standing = standingOf(why.strength, why);
}

// EdgeScan+ and its parts. Returns the suppressed strengths.
Grid<float> judgeDepth(Why& why, const Detection& detection) {
    const DepthEdgeSettings settings = depthEdgeSettings(detection.settings);
    const DepthResponses own = detection.responses ? DepthResponses{} : depthResponses(*detection.scan, settings);
    const DepthResponses& responses = detection.responses ? *detection.responses : own;
    DepthEdges found = decideDepthEdges(responses, settings);
    const std::size_t k = why.probe.cell;
    why.upper = settings.sensitivity;
    why.lower = settings.sensitivity * settings.hysteresisLow;
    why.depth = probeDepth(*detection.scan, settings, why.probe.line, why.probe.beam);
    const ThinnedStrength& jump = why.depth->jump;
    const ThinnedStrength& crease = why.depth->crease;
    // What is left of either decides where it is enough; else the larger of what was there before a neighbour took it.
    const auto jumpCounts = [&](float response) { return settings.jumps ? response : 0.0F; };
    const auto foldCounts = [&](float response) { return (response > 0 ? settings.convex : settings.concave) ? std::abs(response) : 0.0F; };
    const float strength = found.strength[k];
    const float kept = static_cast<double>(strength) > why.lower || strength >= std::max(jumpCounts(jump.before), foldCounts(crease.before))
                           ? strength
                           : 0.0F;
    const float fold = kept > 0 ? responses.crease[k] : crease.before;
    const float jumpSize = jumpCounts(kept > 0 ? responses.jump[k] : jump.before);
    const float foldSize = foldCounts(fold);
    const bool isJump = jumpSize >= foldSize;
    const float size = std::max(jumpSize, foldSize);
    why.strength = static_cast<double>(size);
    if (size > 0) why.kind = isJump ? DepthEdge::Jump : fold > 0 ? DepthEdge::Convex : DepthEdge::Concave;
    if (kept > 0)
        why.roundGap = isJump ? jump.kept != responses.jump[k] : crease.kept != responses.crease[k];
    else if (size > 0)
        why.suppressedBy = isJump ? jump.stronger : crease.stronger;
    return std::move(found.strength);
}

// From gradients of the logarithm to steps in percent of the range, which is what the threshold is in.
void tellInPercent(Why& why, const Settings& settings) {
    const auto percent = [&](double gradient) { return std::copysign(logRangeStepOfGradient(std::abs(gradient), settings), gradient); };
    for (double* value : {&why.strength, &why.lower, &why.upper}) *value = percent(*value);
    for (std::optional<double>* value : {&why.alongBeams, &why.alongLines}) {
        if (*value) *value = percent(**value);
    }
    for (std::optional<CellStrength>* cell : {&why.suppressedBy, &why.chainTop}) {
        if (*cell) (*cell)->strength = percent((*cell)->strength);
    }
    for (CellStrength& cell : why.chain) cell.strength = percent(cell.strength);
}

} // namespace

Why whyCell(const Detection& detection, std::size_t k) {
    const Settings& settings = detection.settings;
    Why why;
    why.probe = probeCell(detection, k);
    why.parameter = sweptParameter(settings.method);
    why.unit = findParameter(why.parameter)->unit;
    const bool gray = settings.method == Method::Canny || hasOneThreshold(settings.method);
    if (gray) {
        const Grid<std::uint8_t> masked = maskedCells(*detection.scan, settings);
        why.takesPart = masked.size() == 0 || masked[k] == 0;
    } else {
        why.takesPart = withoutOwnRange(*detection.scan)[k] == 0;
    }
    if (detection.smoothed) why.smoothed = (*detection.smoothed)[k];
    if (hasOneThreshold(settings.method)) {
        judgeResponse(why, detection);
    } else {
        const bool gradient = gray || settings.method == Method::LogRange;
        const Grid<float> strength = gradient ? judgeGradient(why, detection) : judgeDepth(why, detection);
        why.standing = standingOf(strength[k], why);
        followChain(why, strength);
        if (settings.method == Method::LogRange) tellInPercent(why, settings);
    }
    const double highest = thresholdMapOf(detection).highest[k];
    const Parameter& parameter = *findParameter(why.parameter);
    if (highest >= 0) {
        const double limited = std::min(roundedDown(highest, parameter), parameter.maximum);
        if (limited >= parameter.minimum) why.appearsAt = limited;
    }
    why.verdict = whyVerdict(why, settings, Naming::Keys);
    return why;
}

} // namespace edgescan
