// Methods that find rocks in one scan.
#include "app/lab/peers/rock_answers.h"

#include "app/lab/peers/watershed_rocks.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/rocks/attributes/attributes.h"
#include "core/rocks/selection/rock_map.h"
#include "core/scan/grid/inverse_range.h"

#include <array>

namespace edgescan::lab {
namespace {

RockDetection byRecipe(const std::shared_ptr<const Scan>& scan, const RockMethodSettings& choices) {
    const auto detection = edges::detectEdges(scan, choices.edges, edges::KeepFor::Rocks);
    const double start = edges::threadCpuMilliseconds();
    const rocks::Segmentation leaves = rocks::segmentRocks(rocks::rockInputs(*detection));
    const rocks::RegionMap map = rocks::rocksAt(leaves, rocks::mergeTree(leaves), choices.rocks);
    RockDetection answer;
    answer.milliseconds = edges::threadCpuMilliseconds() - start;
    answer.region = rocks::regionLabels(leaves, map);
    for (const rocks::Region& region : map.regions) answer.isRock.push_back(region.kind == rocks::RegionKind::Rock ? 1 : 0);
    answer.claims.resize(map.regions.size());
    for (const rocks::Rock& row : rocks::rockRows(leaves, map))
        answer.claims[row.label] = RockClaim{
            .aM = row.longestCaliperM, .bM = row.shortestCaliperM, .uncertaintyM = row.toleranceM / 2, .confidence = row.confidence};
    for (const rocks::RegionBorder& border : map.borders)
        answer.pairs.push_back({border.a, border.b, rocks::nearerSide(border), rocks::touch(border)});
    return answer;
}

RockDetection onOutlines(const std::shared_ptr<const Scan>& scan, const RockMethodSettings& choices) {
    RockDetection answer;
    edges::Settings settings = choices.edges;
    settings.method = edges::Method::Outlines;
    const auto detection = edges::detectEdges(scan, settings);
    const double start = edges::threadCpuMilliseconds();
    const InverseRange inverse = inverseRange(*scan);
    Grid<std::uint8_t> solid(scan->lines(), scan->beams());
    for (std::size_t k = 0; k < solid.size(); ++k) solid[k] = inverse.support[k] != Support::Void ? 1 : 0;
    answer.region = watershedRocks(*detection->mask, solid);
    answer.milliseconds = edges::threadCpuMilliseconds() - start;
    return answer;
}

template <PclMethod kPeer>
RockDetection ofPeer(const std::shared_ptr<const Scan>& scan, const RockMethodSettings& /*choices*/) {
    RockDetection answer;
    Result<PclEdges> segments = runPclMethod(kPeer, pclScan(*scan), {});
    if (!segments) {
        answer.note = segments.error().sentence();
        return answer;
    }
    answer.region = std::move(segments->segments);
    for (const edges::StageTime& step : segments->steps) answer.milliseconds += step.milliseconds;
    return answer;
}

constexpr std::array<RockMethod, 4> kWays{{{"recipe", "EdgeScan+ rocks", false, byRecipe},
                                           {"watershed", "watershed on Rock outlines", false, onOutlines},
                                           {"region_growing", "PCL RegionGrowing", true, ofPeer<PclMethod::RegionGrowing>},
                                           {"lccp", "PCL LCCP on supervoxels", true, ofPeer<PclMethod::ConvexPatches>}}};

} // namespace

std::span<const RockMethod> rockMethods() { return kWays; }

} // namespace edgescan::lab
