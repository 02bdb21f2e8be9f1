// EdgeScan+ and its parts: their decisions, and their values at one cell.
#include "core/edges/gray/canny.h"
#include "core/edges/gray/log_range.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/method_traits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace edgescan::edges {
namespace {

// The cells, of these, that are left out where only rock borders are edges.
std::vector<std::uint32_t> leftOut(const Detection& detection, const std::vector<std::uint32_t>& cells) {
    std::vector<std::uint32_t> out;
    const std::vector<BorderPercent> borders = borderPercents(*detection.surface, *detection.responses, detection.settings, cells, 0);
    for (std::size_t n = 0; n < cells.size(); ++n) {
        if (borders[n] < detection.settings.borderPercent) out.push_back(cells[n]);
    }
    return out;
}

// The same of all cells that satisfy isCandidate(k), if the settings ask for it.
template <class IsCandidate>
std::vector<std::uint32_t> candidatesLeftOut(const Detection& detection, IsCandidate isCandidate) {
    if (!detection.settings.rockBorders) return {};
    std::vector<std::uint32_t> cells;
    for (std::uint32_t k = 0; k < detection.responses->jump->size(); ++k) {
        if (isCandidate(k)) cells.push_back(k);
    }
    return leftOut(detection, cells);
}

FoundEdges surfaceEdges(const Detection& detection) {
    DepthEdges found = decideDepthEdges(*detection.responses, detection.settings, 0);
    if (detection.settings.rockBorders) {
        for (const std::uint32_t k : leftOut(detection, edgeCells(found.mask))) {
            found.mask[k] = 0;
            found.kind[k] = DepthEdge::None;
        }
    }
    return {std::move(found.mask), std::move(found.kind)};
}

ThresholdMap surfaceThresholds(const Detection& detection) {
    const Settings& settings = detection.settings;
    const DepthResponses& responses = *detection.responses;
    ThresholdMap map =
        linkedThresholdMap(requestedStrength(responses, settings), settings.hysteresisPercent / 100.0, settings.minimumLength);
    for (const std::uint32_t k : candidatesLeftOut(detection, [&map](std::size_t k) { return map.highest[k] >= 0; })) map.highest[k] = -1;
    for (const ClassCells& edges : edgesAtVoids(responses, settings)) {
        for (const std::uint32_t k : edges.cells) map.highest[k] = std::numeric_limits<double>::infinity();
    }
    return map;
}

// As decideDepthEdges() compares them.
EdgeLevels surfaceLevels(const Detection& detection, const std::vector<double>& thresholds) {
    const Settings& settings = detection.settings;
    const auto share = static_cast<float>(settings.hysteresisPercent / 100.0);
    std::vector<double> weak, strong;
    for (const double threshold : thresholds) {
        const auto high = static_cast<float>(threshold);
        weak.push_back(static_cast<double>(high * share));
        strong.push_back(static_cast<double>(high));
    }
    const DepthResponses& responses = *detection.responses;
    std::vector<float> strengths(static_cast<std::size_t>(responses.jump->beams));
    const auto strengthsOf = [&](int line) {
        requestedStrengthsOfLine(responses, settings, line, strengths.data());
        return strengths.data();
    };
    EdgeLevels levels =
        edgeLevels(responses.jump->lines, responses.jump->beams, strengthsOf, std::move(weak), std::move(strong), settings.minimumLength);
    for (const ClassCells& edges : edgesAtVoids(responses, settings))
        levels.apart.insert(levels.apart.end(), edges.cells.begin(), edges.cells.end());
    std::ranges::sort(levels.apart);
    levels.apart.erase(std::unique(levels.apart.begin(), levels.apart.end()), levels.apart.end());
    levels.atEach = levels.apart.size();
    const std::vector<std::uint32_t> out = candidatesLeftOut(detection, [&levels](std::size_t k) { return levels.weak[k] > 0; });
    std::vector<std::uint32_t> notCounted;
    std::ranges::set_union(levels.apart, out, std::back_inserter(notCounted));
    levels.apart = std::move(notCounted);
    return levels;
}

double surfaceThreshold(const Detection& detection, std::size_t k) {
    const Settings& settings = detection.settings;
    const DepthResponses& responses = *detection.responses;
    const auto has = [k](const ClassCells& edges) { return std::ranges::binary_search(edges.cells, k); };
    if (std::ranges::any_of(edgesAtVoids(responses, settings), has)) return std::numeric_limits<double>::infinity();
    if (settings.rockBorders && !leftOut(detection, {static_cast<std::uint32_t>(k)}).empty()) return -1;
    return linkedThresholdAt(
        responses.jump->lines, responses.jump->beams, [&](std::size_t n) { return requestedStrengthAt(responses, settings, n); },
        settings.hysteresisPercent / 100.0, settings.minimumLength, k);
}

Judgement judgeSurface(const Detection& detection, std::size_t k) {
    const Settings& settings = detection.settings;
    const DepthResponses& responses = *detection.responses;
    const auto beams = static_cast<std::size_t>(detection.scan->beams());
    Judgement found;
    const GapFilling* filling = detection.settings.fillEdges ? detection.filled.get() : nullptr;
    found.takesPart = withoutOwnRange(*detection.scan)[k] == 0 || (filling != nullptr && filling->at(k) != nullptr);
    found.linked = [&responses, &settings](std::size_t n) { return requestedStrengthAt(responses, settings, n); };
    found.upper = settings.sensitivity;
    found.lower = settings.sensitivity * (settings.hysteresisPercent / 100.0);
    found.depth = probeDepth(*detection.scan, settings, static_cast<int>(k / beams), static_cast<int>(k % beams), filling);
    if (const Roughness& roughness = responses.roughness; roughness.rough && found.takesPart) {
        const int line = static_cast<int>(k / beams), beam = static_cast<int>(k % beams);
        const float factor = roughness.factorAt(line, beam);
        found.rough = {static_cast<double>(roughness.aroundAt(line, beam)), static_cast<double>(factor)};
        found.depth->crease.before /= factor;
        found.depth->crease.after /= factor;
        found.depth->crease.compared /= factor;
        if (auto& stronger = found.depth->crease.stronger) stronger->strength /= static_cast<double>(factor); // compared without it
    }
    const ThinnedStrength& jump = found.depth->jump;
    const ThinnedStrength& crease = found.depth->crease;
    // The response after suppression decides if it is strong enough; otherwise the larger of the responses before suppression.
    const auto jumpCounts = [&](float response) { return wants(settings, kClassJump) ? response : 0.0F; };
    const auto foldCounts = [&](float response) {
        return wants(settings, response > 0 ? kClassConvex : kClassConcave) ? std::abs(response) : 0.0F;
    };
    const float strength = found.linked(k);
    const bool decides =
        static_cast<double>(strength) > found.lower || strength >= std::max(jumpCounts(jump.before), foldCounts(crease.before));
    const float kept = decides ? strength : 0.0F;
    const float fold = kept > 0 ? responses.crease[k] : crease.before;
    const float jumpSize = jumpCounts(kept > 0 ? (*responses.jump)[k] : jump.before);
    const float foldSize = foldCounts(fold);
    const bool isJump = jumpSize >= foldSize;
    const float size = std::max(jumpSize, foldSize);
    found.strength = static_cast<double>(size);
    if (size > 0) found.kind = isJump ? DepthEdge::Jump : fold > 0 ? DepthEdge::Convex : DepthEdge::Concave;
    const ThinnedStrength& thinned = isJump ? jump : crease;
    if (kept > 0) {
        found.movedFromGap = thinned.after != (isJump ? *responses.jump : responses.crease)[k];
    } else if (size > 0) {
        found.suppressedBy = thinned.stronger;
        found.compared = static_cast<double>(thinned.compared);
    }
    return found;
}

} // namespace

const Decision kSurfaceDecision{"decision", surfaceEdges, surfaceThresholds, surfaceLevels, surfaceThreshold, judgeSurface};

} // namespace edgescan::edges
