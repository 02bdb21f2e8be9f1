// A spatial index by Boost's R-tree.
#include "core/inspect/registration/point_index.h"

#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <iterator>

namespace edgescan::inspect {
namespace {

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Entry = std::pair<TreePoint, std::uint32_t>;
TreePoint treePoint(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

std::vector<Entry> entriesOf(std::span<const Eigen::Vector3d> points) {
    std::vector<Entry> entries;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (points[n].allFinite()) entries.emplace_back(treePoint(points[n]), static_cast<std::uint32_t>(n));
    }
    return entries;
}

} // namespace

struct PointIndex::Tree {
    boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> tree;
};

PointIndex::PointIndex(std::span<const Eigen::Vector3d> points)
    : tree_(std::make_unique<Tree>(Tree{decltype(Tree::tree)(entriesOf(points))})), points_(points.begin(), points.end()) {}
PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;
PointIndex::~PointIndex() = default;

std::vector<std::uint32_t> PointIndex::nearest(const Eigen::Vector3d& p, unsigned count) const {
    std::vector<std::uint32_t> found;
    tree_->tree.query(boost::geometry::index::nearest(treePoint(p), count),
                      boost::make_function_output_iterator([&](const Entry& entry) { found.push_back(entry.second); }));
    // Boost does not define the order of points at equal distance; they are sorted by index, so that every machine gives the same result.
    std::ranges::sort(found, [&](std::uint32_t a, std::uint32_t b) {
        const double da = (points_[a] - p).squaredNorm(), db = (points_[b] - p).squaredNorm();
        return da < db || (da == db && a < b);
    });
    return found;
}

std::optional<std::uint32_t> PointIndex::nearest(const Eigen::Vector3d& p) const {
    const auto found = nearest(p, 1);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

} // namespace edgescan::inspect
