// Small scenes of rocks with their truth, and the stages up to the segments in one call.
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/rocks/selection/rock_map.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace edgescan::test {

struct RockScene {
    std::shared_ptr<const Scan> scan;
    sim::SimulationTruth truth;
};

inline RockScene rockScene(const std::string& name, std::uint64_t seed, int lines, int beams) {
    sim::SimulationSettings settings;
    settings.scene = name;
    settings.seed = seed;
    settings.lines = lines;
    settings.beams = beams;
    settings.truth = true;
    settings.threads = 1;
    auto simulated = sim::simulate(settings);
    if (!simulated) {
        ADD_FAILURE() << simulated.error().sentence();
        return {};
    }
    return {std::make_shared<const Scan>(std::move(simulated->scan)), std::move(*simulated->truth)};
}

inline rocks::Segmentation segmentationOf(const std::shared_ptr<const Scan>& scan) {
    return rocks::segmentRocks(rocks::rockInputs(*edges::detectEdges(scan, edges::Settings{}, edges::KeepFor::Rocks)));
}

/// Panoptic quality of the regions relative to true rocks of at least `fewest` measured cells. Regions on walls and on smaller rocks are
/// left out.
inline double panopticQuality(const rocks::Segmentation& segments, const rocks::RegionMap& map, const sim::SimulationTruth& truth,
                              std::uint32_t fewest) {
    const Grid<std::uint32_t> labels = rocks::regionLabels(segments, map);
    std::map<std::uint32_t, std::uint32_t> ofRock, ofRegion, onCounted;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> both;
    const auto counts = [&](std::size_t k) { return segments.inputs.surface->inverse.support[k] == Support::Measured; };
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (!counts(k)) continue;
        ++ofRock[truth.object[k]];
        ++ofRegion[labels[k]];
        ++both[{labels[k], truth.object[k]}];
    }
    const auto isCounted = [&](std::uint32_t object) { return object >= 2 && ofRock[object] >= fewest; };
    double iouSum = 0;
    double found = 0;
    std::map<std::uint32_t, bool> matched;
    for (const auto& [pair, cells] : both) {
        const auto [region, object] = pair;
        if (isCounted(object)) onCounted[region] += cells;
        if (region == 0 || !isCounted(object)) continue;
        const double iou = static_cast<double>(cells) / (ofRegion[region] + ofRock[object] - cells);
        if (iou <= 0.5) continue;
        iouSum += iou;
        ++found;
        matched[region] = true;
    }
    double rocks = 0;
    for (const auto& [object, cells] : ofRock) rocks += isCounted(object) ? 1 : 0;
    double invented = 0;
    for (const auto& [region, cells] : ofRegion) {
        if (region != 0 && cells >= fewest && !matched[region] && 2 * onCounted[region] > cells) ++invented;
    }
    return iouSum / (found + 0.5 * (rocks - found) + 0.5 * invented);
}

} // namespace edgescan::test
