// Finds where the sub-rays of a beam end in a scene.
#pragma once

#include "app/lab/sim/bvh.h"
#include "app/lab/sim/rays.h"
#include "app/lab/sim/scene.h"

namespace edgescan::sim {

/// A scene prepared for ray casting. Immutable, so that several threads may cast rays at once. The scene must outlive this object.
class RayCaster {
public:
    /// @param footprint the widest beam that will be cast @param centreM the centre of the beams' starts @param leverM the largest distance
    /// of a beam's start from it, metres
    RayCaster(const Scene& scene, const Footprint& footprint, const Eigen::Vector3d& centreM = Eigen::Vector3d::Zero(), double leverM = 0);

    [[nodiscard]] BundleHits cast(const RayBundle& bundle) const;

private:
    void castCopy(std::size_t copy, const RayBundle& bundle, BundleHits& hits) const;

    const Scene* scene_;
    std::vector<BoxTree> voidTrees_;
    BoxTree solidTree_;
    BoxTree bodyTree_;
    BoxTree copyTree_;
    std::vector<Eigen::Matrix3f> toMesh_; ///< from the scene to the frame of each copy's mesh, without the place
};

/// Shortens the hits to the point where the bundle meets the triangle, or enters the body.
void meet(const Triangle& triangle, const RayBundle& bundle, BundleHits& hits);
void meet(const ConvexBody& body, const RayBundle& bundle, BundleHits& hits);

} // namespace edgescan::sim
