// Sorts cells by rock, by counting.
#include "core/rocks/attributes/cells.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"

namespace edgescan::rocks {

CellsByRock cellsByRock(const Segmentation& segments, const RegionMap& map, const std::function<bool(std::uint32_t label)>& skipped) {
    CellsByRock sorted;
    std::vector<std::uint8_t> wanted(map.regions.size(), 0);
    sorted.first.assign(static_cast<std::size_t>(map.rocks) + 2, 0);
    for (std::uint32_t label = 1; label <= map.rocks; ++label) {
        wanted[label] = skipped && skipped(label) ? 0 : 1;
        sorted.first[label + 1] = sorted.first[label] + (wanted[label] != 0 ? map.regions[label].sums.cells : 0);
    }
    if (sorted.first.back() == 0) return sorted;
    sorted.cells.resize(sorted.first.back());
    std::vector<std::size_t> at = sorted.first;
    const Grid<Support>& support = segments.inputs.surface->inverse.support;
    for (const SegmentRun& run : segments.beamRuns) {
        const std::uint32_t region = map.regionOfSegment[run.segment];
        if (wanted[region] == 0) continue;
        const std::size_t line = static_cast<std::size_t>(run.row) * static_cast<std::size_t>(segments.segment.beams);
        for (std::size_t k = line + run.begin; k < line + run.end; ++k) {
            if (support[k] == Support::Measured) sorted.cells[at[region]++] = static_cast<std::uint32_t>(k);
        }
    }
    return sorted;
}

} // namespace edgescan::rocks
