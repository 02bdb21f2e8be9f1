// Casts rays into a stored mesh.
#include "app/lab/sim/stored_mesh.h"

#include "app/lab/sim/caster.h"

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
    : points_(std::move(points)), triangles_(std::move(triangles)), tree_(treeOver(points_, triangles_)) {
    for (const Eigen::Vector3f& point : points_) reach_ = std::max(reach_, point.cwiseAbs().maxCoeff());
}

void StoredMesh::meet(const RayBundle& bundle, BundleHits& hits) const {
    constexpr float kRounding = 1e-5F; // of a coordinate: boxes are larger by this, so that no ray misses them
    const float margin = kRounding * std::max({reach_, std::abs(bundle.ox[0]), std::abs(bundle.oy[0]), std::abs(bundle.oz[0])});
    tree_.along(bundle, margin, hits, [&](std::int32_t part) {
        const Corners& corners = triangles_[static_cast<std::size_t>(part)];
        const Eigen::Vector3f& corner = points_[static_cast<std::size_t>(corners[0])];
        const Triangle triangle{corner, points_[static_cast<std::size_t>(corners[1])] - corner,
                                points_[static_cast<std::size_t>(corners[2])] - corner, part};
        sim::meet(triangle, bundle, hits);
    });
}

Eigen::Vector3f StoredMesh::normal(std::size_t triangle) const {
    const Corners& corners = triangles_[triangle];
    const Eigen::Vector3f& corner = points_[static_cast<std::size_t>(corners[0])];
    return (points_[static_cast<std::size_t>(corners[1])] - corner).cross(points_[static_cast<std::size_t>(corners[2])] - corner);
}

} // namespace edgescan::sim
