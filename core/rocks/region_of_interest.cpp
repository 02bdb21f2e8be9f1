// Cells in a polygon of cells.
#include "core/rocks/region_of_interest.h"

#include <algorithm>

namespace edgescan {
namespace {

// Even-odd rule; a cell on the outline is inside.
bool isInPolygon(const std::vector<RegionCorner>& corners, std::int64_t line, std::int64_t beam) {
    bool inside = false;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        RegionCorner a = corners[n];
        RegionCorner b = corners[(n + 1) % corners.size()];
        if (a.line > b.line) std::swap(a, b);
        const std::int64_t side = (b.beam - a.beam) * (line - a.line) - (beam - a.beam) * static_cast<std::int64_t>(b.line - a.line);
        const auto [least, most] = std::minmax(a.beam, b.beam);
        if (side == 0 && line >= a.line && line <= b.line && beam >= least && beam <= most) return true;
        if (line >= a.line && line < b.line && side > 0) inside = !inside;
    }
    return inside;
}

} // namespace

bool isInside(const std::vector<RegionCorner>& region, int line, int beam) {
    if (region.empty()) return true;
    if (region.size() > 2) return isInPolygon(region, line, beam);
    const RegionCorner& a = region.front();
    const RegionCorner& b = region.back();
    return line >= std::min(a.line, b.line) && line <= std::max(a.line, b.line) && beam >= std::min(a.beam, b.beam) &&
           beam <= std::max(a.beam, b.beam);
}

void markOutside(const RockLeaves& leaves, RockMap& map) {
    if (map.settings.region.empty()) return;
    const Grid<Support>& support = leaves.inputs.surface->inverse.support;
    std::vector<std::uint32_t> inside(map.regions.size());
    for (int i = 0; i < leaves.leaf.lines; ++i) {
        for (int j = 0; j < leaves.leaf.beams; ++j) {
            const std::uint32_t leaf = leaves.leaf.at(i, j);
            if (leaf == kOpen || support.at(i, j) != Support::Measured || !isInside(map.settings.region, i, j)) continue;
            ++inside[map.regionOfLeaf[leaf]];
        }
    }
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        if (2 * static_cast<std::uint64_t>(inside[n]) < map.regions[n].sums.cells) map.regions[n].kind = RegionKind::Outside;
    }
}

} // namespace edgescan
