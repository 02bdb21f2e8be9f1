// Where the sub-rays of a beam end in a scene.
#pragma once

#include "core/sim/bvh.h"
#include "core/sim/rays.h"
#include "core/sim/scene.h"

namespace edgescan::sim {

/// A scene made ready for casting. Never changes, so any number of threads may cast. The scene must outlive it.
class Caster {
public:
    /// @param footprint the widest beam that will be cast
    /// @param leverM how far from the origin a beam may start
    Caster(const Scene& scene, const Footprint& footprint, double leverM = 0);

    [[nodiscard]] BundleHits cast(const RayBundle& bundle) const;

private:
    const Scene* scene_;
    std::vector<BoxTree> voidTrees_;
    BoxTree solidTree_;
    BoxTree bodyTree_;
};

/// Moves the hits closer where the bundle meets the triangle, or enters the body, before them.
void meet(const Triangle& triangle, const RayBundle& bundle, BundleHits& hits);
void meet(const ConvexBody& body, const RayBundle& bundle, BundleHits& hits);

} // namespace edgescan::sim
