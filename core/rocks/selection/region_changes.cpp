// Compares two maps by the cells that their regions share.
#include "core/rocks/selection/region_changes.h"

#include <algorithm>
#include <map>
#include <utility>

namespace edgescan::rocks {
namespace {

/// How many regions of the other map share cells with each region.
std::vector<int> countedPartners(const SharedCells& shared, std::size_t regions, bool ofAfter) {
    std::vector<int> partners(regions, 0);
    for (const auto& [pair, cells] : shared) ++partners[ofAfter ? pair.second : pair.first];
    return partners;
}

bool isSame(const Region& before, const Region& after) { return before.kind == after.kind && before.byHand == after.byHand; }

} // namespace

SharedCells sharedCells(const Segmentation& segmentsBefore, const RegionMap& before, const Segmentation& segmentsAfter,
                        const RegionMap& after) {
    SharedCells shared;
    if (&segmentsBefore == &segmentsAfter) {
        for (std::size_t n = 1; n < segmentsAfter.sums.size(); ++n)
            shared[{before.regionOfSegment[n], after.regionOfSegment[n]}] += segmentsAfter.sums[n].cells;
    } else {
        SharedCells::key_type run{};
        std::uint64_t cells = 0; // of the run: neighbours nearly always share a pair
        for (std::size_t k = 0; k < segmentsAfter.segment.size(); ++k, ++cells) {
            const SharedCells::key_type here{before.regionOfSegment[segmentsBefore.segment[k]],
                                             after.regionOfSegment[segmentsAfter.segment[k]]};
            if (here != run) shared[std::exchange(run, here)] += std::exchange(cells, 0);
        }
        shared[run] += cells;
    }
    shared.erase({0, 0});
    return shared;
}

RegionChanges regionChanges(const Segmentation& segmentsBefore, const RegionMap& before, const Segmentation& segmentsAfter,
                            const RegionMap& after) {
    const SharedCells shared = sharedCells(segmentsBefore, before, segmentsAfter, after);
    const std::vector<int> parts = countedPartners(shared, before.regions.size(), false);
    const std::vector<int> sources = countedPartners(shared, after.regions.size(), true);
    struct Parts {
        int rocks = 0;
        std::uint32_t region = 0; // the largest that is not a rock
        std::uint64_t cells = 0;
    };
    std::map<std::uint32_t, Parts> broken; // by rock before
    RegionChanges changes;
    for (const auto& [pair, cells] : shared) {
        const auto [a, b] = pair;
        if (a == 0 || b == 0 || parts[a] != 1 || sources[b] != 1 || !isSame(before.regions[a], after.regions[b])) changes.any = true;
        if (a == 0 || b == 0) continue;
        const bool wasRock = a <= before.rocks, isRock = b <= after.rocks;
        if (!wasRock || parts[a] < 2) continue;
        Parts& of = broken[a];
        if (isRock)
            ++of.rocks;
        else if (cells > of.cells)
            of = {of.rocks, b, cells};
    }
    for (const auto& [rock, of] : broken) {
        if (of.rocks < 2 && of.region != 0) changes.lost.push_back({rock, of.region});
    }
    return changes;
}

} // namespace edgescan::rocks
