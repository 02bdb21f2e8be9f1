// Watershed of the distance to edges.
#include "app/lab/peers/watershed_rocks.h"

#include "core/rocks/segmentation/basins.h"
#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace edgescan::lab {
namespace {

constexpr float kShallowBasin = 1.0F; // cells: depth of a saddle below a peak
constexpr float kOnEdge = 1.5F;       // cells from an edge: the border runs along the edge
constexpr double kLeastCovered = 0.5; // share of a border along edges

cv::Mat distanceToEdges(const Grid<std::uint8_t>& edges, const Grid<std::uint8_t>& solid) {
    Grid<std::uint8_t> open(edges.lines, edges.beams);
    for (std::size_t k = 0; k < open.size(); ++k) open[k] = edges[k] == 0 && solid[k] != 0 ? 255 : 0;
    cv::Mat distance;
    cv::distanceTransform(asMat(open), distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return distance;
}

/// Calls `visit` for the 4 neighbours of a cell.
template <class Visit>
void forNeighbours(const Grid<std::uint32_t>& grid, std::size_t k, Visit visit) {
    const auto beams = static_cast<std::size_t>(grid.beams);
    if (k >= beams) visit(k - beams);
    if (k + beams < grid.size()) visit(k + beams);
    if (k % beams > 0) visit(k - 1);
    if (k % beams + 1 < beams) visit(k + 1);
}

/// Floods from the highest cell down. Every solid cell gets the number of a basin, from 1.
Grid<std::uint32_t> basins(const std::vector<float>& height, const Grid<std::uint8_t>& solid, rocks::JoinedGroups& joined) {
    Grid<std::uint32_t> basin(solid.lines, solid.beams);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < solid.size(); ++k) {
        if (solid[k] != 0) order.push_back(k);
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return height[a] > height[b]; });
    std::vector<float> peak{0.0F}; // by basin
    for (const std::size_t k : order) {
        std::uint32_t own = 0;
        forNeighbours(basin, k, [&](std::size_t next) {
            if (basin[next] == 0) return;
            std::uint32_t low = joined.of(basin[next]);
            if (own == 0) {
                own = low;
                return;
            }
            if (low == own) return;
            std::uint32_t high = own;
            if (peak[low] > peak[high]) std::swap(low, high);
            if (peak[low] - height[k] < kShallowBasin) joined.join(high, low);
            own = high; // the cell joins the higher one
        });
        if (own == 0) {
            own = static_cast<std::uint32_t>(peak.size());
            peak.push_back(height[k]);
        }
        basin[k] = own;
    }
    return basin;
}

/// Joins basins whose border is not along edges.
void joinUncovered(const Grid<std::uint32_t>& basin, const std::vector<float>& height, rocks::JoinedGroups& joined) {
    struct Border {
        std::size_t cracks = 0, covered = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Border> borders;
    for (std::size_t k = 0; k < basin.size(); ++k) {
        forNeighbours(basin, k, [&](std::size_t next) {
            if (next < k || basin[k] == 0 || basin[next] == 0) return;
            const std::uint32_t a = joined.of(basin[k]);
            const std::uint32_t b = joined.of(basin[next]);
            if (a == b) return;
            Border& border = borders[{std::min(a, b), std::max(a, b)}];
            ++border.cracks;
            border.covered += std::min(height[k], height[next]) < kOnEdge ? 1 : 0;
        });
    }
    for (const auto& [pair, border] : borders) {
        if (static_cast<double>(border.covered) < kLeastCovered * static_cast<double>(border.cracks)) joined.join(pair.first, pair.second);
    }
}

} // namespace

Grid<std::uint32_t> watershedRocks(const Grid<std::uint8_t>& edges, const Grid<std::uint8_t>& solid) {
    const cv::Mat distance = distanceToEdges(edges, solid);
    const std::vector<float> height(distance.begin<float>(), distance.end<float>());
    rocks::JoinedGroups joined(height.size() + 1); // there are at most as many basins as cells
    Grid<std::uint32_t> piece = basins(height, solid, joined);
    joinUncovered(piece, height, joined);
    for (std::uint32_t& cell : piece.cells) cell = joined.of(cell);
    rocks::numberByFirstCell(piece);
    return piece;
}

} // namespace edgescan::lab
