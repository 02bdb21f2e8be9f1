// Finds the cells inside a polygon of cells.
#include "core/rocks/selection/region_of_interest.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace edgescan::rocks {
namespace {

struct Side {
    RegionCorner a, b; // a above b, or on the same line
};

std::vector<Side> sidesOf(const std::vector<RegionCorner>& corners) {
    std::vector<Side> sides;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        Side side{corners[n], corners[(n + 1) % corners.size()]};
        if (side.a.line > side.b.line) std::swap(side.a, side.b);
        sides.push_back(side);
    }
    return sides;
}

// Even-odd rule; a cell on the outline is inside.
bool isInPolygon(const std::vector<Side>& sides, std::int64_t line, std::int64_t beam) {
    bool inside = false;
    for (const auto& [a, b] : sides) {
        const std::int64_t side = (b.beam - a.beam) * (line - a.line) - (beam - a.beam) * static_cast<std::int64_t>(b.line - a.line);
        const auto [least, most] = std::minmax(a.beam, b.beam);
        if (side == 0 && line >= a.line && line <= b.line && beam >= least && beam <= most) return true;
        if (line >= a.line && line < b.line && side > 0) inside = !inside;
    }
    return inside;
}

bool isInRectangle(const RegionCorner& a, const RegionCorner& b, int line, int beam) {
    return line >= std::min(a.line, b.line) && line <= std::max(a.line, b.line) && beam >= std::min(a.beam, b.beam) &&
           beam <= std::max(a.beam, b.beam);
}

} // namespace

bool isInside(const std::vector<RegionCorner>& region, int line, int beam) {
    if (region.empty()) return true;
    return region.size() > 2 ? isInPolygon(sidesOf(region), line, beam) : isInRectangle(region.front(), region.back(), line, beam);
}

Grid<std::uint8_t> insideMask(const std::vector<RegionCorner>& region, int lines, int beams) {
    Grid<std::uint8_t> mask(lines, beams, region.empty() ? std::uint8_t{1} : std::uint8_t{0});
    if (region.empty()) return mask;
    const std::vector<Side> sides = sidesOf(region);
    for (int i = 0; i < lines; ++i) {
        std::vector<Side> here; // the sides that cross this line
        for (const Side& side : sides) {
            if (i >= side.a.line && i <= side.b.line) here.push_back(side);
        }
        for (int j = 0; j < beams && !here.empty(); ++j) {
            const bool inside = region.size() > 2 ? isInPolygon(here, i, j) : isInRectangle(region.front(), region.back(), i, j);
            mask.at(i, j) = inside ? 1 : 0;
        }
    }
    return mask;
}

std::vector<RegionCorner> regionOfDrawing(const std::vector<RegionCorner>& drawn) {
    constexpr std::size_t kMostCorners = 500;
    std::vector<cv::Point> points, corners;
    for (const RegionCorner& corner : drawn) points.emplace_back(corner.beam, corner.line);
    if (points.size() < 3) return {};
    double tolerance = 1.0; // cells
    do {
        cv::approxPolyDP(points, corners, tolerance, true);
        tolerance *= 2.0;
    } while (corners.size() > kMostCorners);
    std::vector<RegionCorner> region;
    for (const cv::Point& corner : corners) region.push_back({corner.y, corner.x});
    return region.size() < 3 ? std::vector<RegionCorner>{} : region;
}

void markOutsideRegion(const Segmentation& segments, RegionMap& map) {
    if (map.settings.region.empty()) return;
    const Grid<Support>& support = segments.inputs.surface->inverse.support;
    std::vector<std::uint32_t> inside(map.regions.size());
    const Grid<std::uint8_t> mask = insideMask(map.settings.region, segments.segment.lines, segments.segment.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (mask[k] == 0 || segments.segment[k] == kNoSegment || support[k] != Support::Measured) continue;
        ++inside[map.regionOfSegment[segments.segment[k]]];
    }
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        if (2 * static_cast<std::uint64_t>(inside[n]) < map.regions[n].sums.cells) map.regions[n].kind = RegionKind::Outside;
    }
}

} // namespace edgescan::rocks
