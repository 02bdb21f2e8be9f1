// A mesh that is stored once: every copy of it in a scene, and every scene, share its triangles and its tree.
#pragma once

#include "app/lab/sim/bvh.h"
#include "app/lab/sim/rays.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan::sim {

/// Immutable, so that several threads may cast rays at once.
class StoredMesh {
public:
    using Corners = std::array<std::int32_t, 3>;

    /// @param triangles indices into the points
    StoredMesh(std::vector<Eigen::Vector3f> points, std::vector<Corners> triangles);

    /// Shortens the hits of a bundle in the mesh's own frame, where directions need not have unit length. BundleHits::surface becomes the
    /// number of the triangle.
    void meet(const RayBundle& bundle, BundleHits& hits) const;

    /// Normal of a triangle, of any length; which side it is on depends on the order of the corners.
    [[nodiscard]] Eigen::Vector3f normal(std::size_t triangle) const;

    [[nodiscard]] const std::vector<Eigen::Vector3f>& points() const { return points_; }
    [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }

private:
    std::vector<Eigen::Vector3f> points_;
    std::vector<Corners> triangles_;
    BoxTree tree_;
    float reach_ = 0; ///< largest coordinate
};

} // namespace edgescan::sim
