// Why a cell is an edge, or why it is none.
#include "core/edges/why.h"

#include "core/edges/canny.h"
#include "core/edges/depth_settings.h"
#include "core/edges/detectors/detector.h"
#include "core/edges/detectors/log_range.h"
#include "core/edges/frame_thresholds.h"
#include "core/edges/holes.h"
#include "core/edges/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace edgescan {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::abs(value) < 10 ? "%.2f" : "%.1f", value);
    return text.data();
}

std::string cellName(const CellStrength& cell) { return "line " + std::to_string(cell.line) + ", beam " + std::to_string(cell.beam); }

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
Grid<float> judgeGradient(Why& why, const Frame& frame) {
    const Settings& settings = frame.settings;
    const Gradient gradient = gradientOf(frame);
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
        if (why.suppressedBy || !frame.scan->rangeMm.contains(line, beam)) continue;
        const double other = strengthAt(frame.scan->rangeMm.index(line, beam));
        const bool outdone = sign > 0 && along.tieIsKept ? why.strength >= other : why.strength > other;
        if (!outdone && other > why.lower) why.suppressedBy = CellStrength{line, beam, other};
    }
    const Grid<std::int32_t> kept = suppressedMagnitude(gradient, settings.norm);
    Grid<float> strength(kept.lines, kept.beams);
    for (std::size_t n = 0; n < kept.size(); ++n) strength[n] = static_cast<float>(sized(kept[n]));
    return strength;
}

void judgeResponse(Why& why, const Frame& frame) {
    const Settings& settings = frame.settings;
    const Grid<std::uint8_t> masked = maskedCells(*frame.scan, settings);
    const Grid<std::uint8_t>& levels = frame.smoothed ? *frame.smoothed : frame.gray->levels;
    why.strength = detectorResponse(settings.method, levels, masked.size() > 0 ? &masked : nullptr, settings)[why.probe.cell];
    why.lower = why.upper = settings.lower;
    why.standing = standingOf(why.strength, why);
}

// EdgeScan+ and its parts. Returns the suppressed strengths.
Grid<float> judgeDepth(Why& why, const Frame& frame) {
    const DepthEdgeSettings settings = depthEdgeSettings(frame.settings);
    DepthEdges found = frame.responses ? decideDepthEdges(*frame.responses, settings) : depthEdges(*frame.scan, settings);
    why.upper = settings.sensitivity;
    why.lower = settings.sensitivity * settings.hysteresisLow;
    why.strength = found.strength[why.probe.cell];
    if (why.strength > 0) return std::move(found.strength);
    // Nothing of its own: the strongest neighbour may have taken the edge.
    for (int i = why.probe.line - 1; i <= why.probe.line + 1; ++i) {
        for (int j = why.probe.beam - 1; j <= why.probe.beam + 1; ++j) {
            if (!found.strength.contains(i, j) || found.strength.at(i, j) <= why.lower) continue;
            if (!why.suppressedBy || found.strength.at(i, j) > why.suppressedBy->strength)
                why.suppressedBy = CellStrength{i, j, found.strength.at(i, j)};
        }
    }
    return std::move(found.strength);
}

std::string reason(const Why& why, const Settings& settings) {
    const std::string strength = "its strength " + number(why.strength);
    if (!why.takesPart) return why.probe.state == CellState::Valid ? "it stands alone and takes no part" : "it has no range";
    const bool oneThreshold = hasOneThreshold(settings.method);
    if (why.probe.edge && oneThreshold) return strength + " is above the threshold " + number(why.upper);
    if (why.probe.kind == DepthEdge::Border) return "it lies beside missing data, and such borders are wanted as a class of their own";
    if (why.probe.edge && why.standing == Standing::Above) return strength + " is above the upper threshold " + number(why.upper);
    if (why.probe.edge && why.chain.size() > 1)
        return strength + " is above the lower threshold, and " + std::to_string(why.chain.size() - 1) + " cells on, at " +
               cellName(why.chain.back()) + ", its chain reaches " + number(why.chain.back().strength);
    if (why.probe.edge) return strength + " is enough where it continues its chain";
    const bool lost = why.suppressedBy && (why.strength > why.lower || why.strength == 0);
    if (lost)
        return cellName(*why.suppressedBy) + " beside it is " + (why.suppressedBy->strength > why.strength ? "stronger (" : "as strong (") +
               number(why.suppressedBy->strength) + "), and an edge is one cell wide";
    if (why.standing == Standing::Below) {
        const std::string text = strength + (why.strength < why.lower ? " is below the " : " is no more than the ") +
                                 (oneThreshold ? "" : "lower ") + "threshold " + number(why.lower);
        return why.suppressedBy ? text + ", and " + cellName(*why.suppressedBy) + " beside it is stronger" : text;
    }
    if (why.chain.empty())
        return strength + " is between the thresholds, and no chain of such cells leads to one above " + number(why.upper);
    return "its chain has " + std::to_string(why.chainCells) + (why.chainCells == 1 ? " cell" : " cells") +
           ", fewer than the minimum length " + std::to_string(settings.minimumLength);
}

std::string verdictOf(const Why& why, const Settings& settings) {
    const Parameter& parameter = *findParameter(why.parameter);
    std::string text = (why.probe.edge ? "Edge: " : "No edge: ") + reason(why, settings) + "; ";
    if (!why.appearsAt) return text + "no value of " + parameter.key + " makes it one.";
    const std::string limit = std::string(parameter.key) + " <= " + formatValue(parameter, *why.appearsAt);
    return text + (why.probe.edge ? "stays one at " : "would appear at ") + limit + ".";
}

} // namespace

Why whyCell(const Frame& frame, std::size_t k) {
    const Settings& settings = frame.settings;
    Why why;
    why.probe = probeCell(frame, k);
    why.parameter = sweptParameter(settings.method);
    const bool gray = settings.method == Method::Canny || hasOneThreshold(settings.method);
    if (gray) {
        const Grid<std::uint8_t> masked = maskedCells(*frame.scan, settings);
        why.takesPart = masked.size() == 0 || masked[k] == 0;
    } else {
        why.takesPart = withoutOwnRange(*frame.scan)[k] == 0;
    }
    if (frame.smoothed) why.smoothed = (*frame.smoothed)[k];
    if (hasOneThreshold(settings.method)) {
        judgeResponse(why, frame);
    } else {
        const bool gradient = gray || settings.method == Method::LogRange;
        const Grid<float> strength = gradient ? judgeGradient(why, frame) : judgeDepth(why, frame);
        why.standing = standingOf(strength[k], why);
        followChain(why, strength);
    }
    const double highest = thresholdMapOf(frame).highest[k];
    const Parameter& parameter = *findParameter(why.parameter);
    if (highest >= 0) {
        const double limited = std::min(roundedDown(highest, parameter), parameter.maximum);
        if (limited >= parameter.minimum) why.appearsAt = limited;
    }
    why.verdict = verdictOf(why, settings);
    return why;
}

std::string whyText(const Why& why, const Settings& settings) {
    std::string text = "line " + std::to_string(why.probe.line) + ", beam " + std::to_string(why.probe.beam) + ": ";
    text += why.probe.state == CellState::Valid ? "range " + number(why.probe.rangeMm / 1000) + " m"
                                                : std::string(cellStateName(why.probe.state));
    text += ", gray " + std::to_string(why.probe.gray);
    if (why.smoothed) text += ", smoothed " + std::to_string(static_cast<int>(*why.smoothed));
    text += "\n" + choiceLabel(*findParameter("method"), settings) + ": strength " + number(why.strength);
    if (why.directionDeg) {
        text += " (along beams " + number(*why.alongBeams) + ", along lines " + number(*why.alongLines) + ", direction " +
                number(*why.directionDeg) + " degrees)";
    }
    text += why.lower == why.upper ? ", threshold " + number(why.upper) : ", thresholds " + number(why.lower) + " and " + number(why.upper);
    return text + "\n" + why.verdict;
}

} // namespace edgescan
