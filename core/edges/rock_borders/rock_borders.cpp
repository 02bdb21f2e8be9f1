// Asks the trees about edge cells.
#include "core/edges/rock_borders/rock_borders.h"

#include "core/base/bands.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace edgescan::edges {
namespace {

constexpr BorderPercent kSure = 100;

#include "core/edges/rock_borders/border_trees.inc" // kStart and kTrees

// Of the cells that are edges because of a void: their value does not depend on the features. All others: unknown.
std::vector<BorderPercent> percentsAtVoids(const DepthResponses& responses, const Settings& settings,
                                           std::span<const std::uint32_t> cells) {
    std::vector<BorderPercent> percents(cells.size(), kUnknownBorder);
    for (const ClassCells& edges : edgesAtVoids(responses, settings)) {
        if (edges.kind == DepthEdge::Border) continue;
        for (std::size_t n = 0; n < cells.size(); ++n) {
            if (std::ranges::binary_search(edges.cells, cells[n])) percents[n] = kSure;
        }
    }
    return percents;
}

} // namespace

BorderModel borderModel() { return {kStart, kTrees}; }

std::vector<BorderPercent> borderPercents(const DepthSurface& surface, const DepthResponses& responses, const Settings& settings,
                                          std::span<const std::uint32_t> cells, int threads) {
    std::vector<BorderPercent> percents = percentsAtVoids(responses, settings, cells);
    if (responses.neighboursAlike || cells.empty()) return percents;
    const BorderMeasure measure(surface, responses, settings);
    const BorderModel model = borderModel();
    runInBands(static_cast<int>(cells.size()), bandsFor(surface.inverse.u.size(), threads), [&](int first, int last) {
        BorderFeatures features{};
        for (auto n = static_cast<std::size_t>(first); n < static_cast<std::size_t>(last); ++n) {
            if (percents[n] == kUnknownBorder && measure.measure(cells[n], features))
                percents[n] = static_cast<BorderPercent>(percentOf(logOdds(model.trees, model.start, features.data())));
        }
    });
    return percents;
}

std::vector<BorderReason> borderReasons(const DepthSurface& surface, const DepthResponses& responses, const Settings& settings,
                                        std::size_t cell) {
    BorderFeatures features{};
    if (responses.neighboursAlike || !BorderMeasure(surface, responses, settings).measure(cell, features)) return {};
    std::vector<BorderReason> reasons(kBorderEvidences);
    for (int n = 0; n < kBorderEvidences; ++n) reasons[static_cast<std::size_t>(n)].evidence = static_cast<BorderEvidence>(n);
    const std::vector<std::int32_t> added = addedByFeature(borderModel().trees, features);
    for (std::size_t n = 0; n < added.size(); ++n) reasons[static_cast<std::size_t>(evidenceOf(static_cast<int>(n)))].added += added[n];
    std::ranges::stable_sort(reasons, [](const BorderReason& a, const BorderReason& b) { return std::abs(a.added) > std::abs(b.added); });
    return reasons;
}

} // namespace edgescan::edges
