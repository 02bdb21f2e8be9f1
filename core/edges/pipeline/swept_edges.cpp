// Sorts the cells of a threshold map.
#include "core/edges/pipeline/swept_edges.h"

#include <algorithm>
#include <utility>

namespace edgescan::edges {
namespace {

constexpr std::size_t kSortedPart = 4; // share of all cells, a fourth: more are not sorted

} // namespace

SweptEdges::SweptEdges(ThresholdMap map) : map_(std::move(map)), lines_(map_.highest.lines), beams_(map_.highest.beams) {
    const Grid<double>& highest = map_.highest;
    std::vector<std::uint32_t> cells;
    for (std::size_t k = 0; k < highest.size(); ++k) {
        if (highest[k] >= 0) cells.push_back(static_cast<std::uint32_t>(k));
        if (cells.size() > highest.size() / kSortedPart) return; // sorting would cost more than it saves
    }
    values_.reserve(cells.size());
    for (const std::uint32_t k : cells) values_.push_back(highest[k]);
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    const auto placeOf = [&](std::uint32_t k) {
        return static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), highest[k]) - values_.begin());
    };
    std::vector<std::uint32_t> places;
    places.reserve(cells.size());
    counts_.assign(values_.size() + 1, 0); // the last one: cells that are never an edge
    for (const std::uint32_t k : cells) {
        places.push_back(static_cast<std::uint32_t>(placeOf(k)));
        ++counts_[places.back()];
    }
    for (std::size_t n = values_.size(); n > 0; --n) counts_[n - 1] += counts_[n];
    std::vector<std::size_t> next(counts_.begin() + 1, counts_.end()); // position of the next cell of each value
    cells_.resize(cells.size());
    for (std::size_t n = 0; n < cells.size(); ++n) cells_[next[places[n]]++] = cells[n];
    map_.highest = {};
}

Grid<std::uint8_t> SweptEdges::at(double threshold) const {
    if (map_.highest.size() != 0) return edgesAt(map_, threshold);
    Grid<std::uint8_t> mask(lines_, beams_);
    if (counts_.empty()) return mask;
    const auto first = static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), threshold) - values_.begin());
    for (std::size_t n = 0; n < counts_[first]; ++n) mask[cells_[n]] = 255;
    return mask;
}

} // namespace edgescan::edges
