// Methods that find rocks in one scan.
#include "core/lab/peers/rock_answers.h"

#include "core/edges/pipeline/pipeline.h"
#include "core/lab/peers/watershed_rocks.h"
#include "core/rocks/attributes/attributes.h"
#include "core/rocks/selection/rock_map.h"
#include "core/scan/grid/inverse_range.h"

#include <array>

namespace edgescan {
namespace {

RockAnswer byRecipe(const std::shared_ptr<const Scan>& scan, const RockChoices& choices) {
    const auto detection = detectEdges(scan, choices.edges, KeepFor::Rocks);
    const double start = threadCpuMilliseconds();
    const RockLeaves leaves = rockLeaves(rockInputs(*detection));
    const RockMap map = rocksAt(leaves, mergeTree(leaves.count(), leaves.borders), choices.rocks);
    RockAnswer answer;
    answer.milliseconds = threadCpuMilliseconds() - start;
    answer.region = regionLabels(leaves, map);
    for (const RockRegion& region : map.regions) answer.isRock.push_back(region.kind == RegionKind::Rock ? 1 : 0);
    answer.claims.resize(map.regions.size());
    for (const Rock& row : rockRows(leaves, map))
        answer.claims[row.label] =
            RockClaim{.aM = row.longM, .bM = row.wideM, .uncertaintyM = row.toleranceM / 2, .confidence = row.confidence};
    for (const RegionBorder& border : map.borders) answer.pairs.push_back({border.a, border.b, nearerSide(border), touch(border)});
    return answer;
}

RockAnswer onOutlines(const std::shared_ptr<const Scan>& scan, const RockChoices& choices) {
    RockAnswer answer;
    Settings settings = choices.edges;
    settings.method = Method::Outlines;
    const auto detection = detectEdges(scan, settings);
    const double start = threadCpuMilliseconds();
    const InverseRange inverse = inverseRange(*scan);
    Grid<std::uint8_t> solid(scan->lines(), scan->beams());
    for (std::size_t k = 0; k < solid.size(); ++k) solid[k] = inverse.support[k] != Support::Void ? 1 : 0;
    answer.region = watershedRocks(*detection->mask, solid);
    answer.milliseconds = threadCpuMilliseconds() - start;
    return answer;
}

template <Peer kPeer>
RockAnswer ofPeer(const std::shared_ptr<const Scan>& scan, const RockChoices& /*choices*/) {
    RockAnswer answer;
    Result<PeerEdges> segments = runPeer(kPeer, peerScan(*scan), {});
    if (!segments) {
        answer.note = segments.error().sentence();
        return answer;
    }
    answer.region = std::move(segments->segments);
    for (const StageTime& step : segments->steps) answer.milliseconds += step.milliseconds;
    return answer;
}

constexpr std::array<RockWay, 4> kWays{{{"recipe", "EdgeScan+ rocks", false, byRecipe},
                                        {"watershed", "watershed on Rock outlines", false, onOutlines},
                                        {"region_growing", "PCL RegionGrowing", true, ofPeer<Peer::RegionGrowing>},
                                        {"lccp", "PCL LCCP on supervoxels", true, ofPeer<Peer::ConvexPatches>}}};

} // namespace

std::span<const RockWay> rockWays() { return kWays; }

} // namespace edgescan
