// Casts rays into a stored mesh.
#include "core/sim/stored_mesh.h"

#include "core/sim/caster.h"

namespace edgescan::sim {
namespace {

constexpr std::int32_t kTrianglesTogether = 4; // small trees matter more than the few triangles that are tested in vain

BoxTree treeOver(const std::vector<Eigen::Vector3f>& points, const std::vector<StoredMesh::Corners>& triangles) {
    std::vector<Eigen::AlignedBox3f> boxes;
    boxes.reserve(triangles.size());
    for (const StoredMesh::Corners& corners : triangles) {
        Eigen::AlignedBox3f box;
        for (const std::int32_t corner : corners) box.extend(points[static_cast<std::size_t>(corner)]);
        boxes.push_back(box);
    }
    return BoxTree(boxes, kTrianglesTogether);
}

} // namespace

StoredMesh::StoredMesh(std::vector<Eigen::Vector3f> points, std::vector<Corners> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)), tree_(treeOver(points_, triangles_)) {}

void StoredMesh::meet(const RayBundle& bundle, float spread, BundleHits& hits) const {
    const Eigen::Vector3f start(bundle.ox[0], bundle.oy[0], bundle.oz[0]);
    const Eigen::Vector3f along(bundle.dx[0], bundle.dy[0], bundle.dz[0]);
    float limit = farthest(hits);
    const auto visit = [&](std::int32_t part) {
        const Corners& corners = triangles_[static_cast<std::size_t>(part)];
        const Eigen::Vector3f& corner = points_[static_cast<std::size_t>(corners[0])];
        const Triangle triangle{corner, points_[static_cast<std::size_t>(corners[1])] - corner,
                                points_[static_cast<std::size_t>(corners[2])] - corner, part};
        sim::meet(triangle, bundle, hits);
        limit = farthest(hits);
    };
    tree_.along(start, along, spread, visit, [&] { return limit; });
}

Eigen::Vector3f StoredMesh::normal(std::size_t triangle) const {
    const Corners& corners = triangles_[triangle];
    const Eigen::Vector3f& corner = points_[static_cast<std::size_t>(corners[0])];
    return (points_[static_cast<std::size_t>(corners[1])] - corner).cross(points_[static_cast<std::size_t>(corners[2])] - corner);
}

} // namespace edgescan::sim
