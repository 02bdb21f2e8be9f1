// Intersects a bundle with triangles and with convex bodies. The inner loops run over lanes without branches, so that the compiler can
// vectorise them.
#include "app/lab/sim/caster.h"

namespace edgescan::sim {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// The tree follows the centre of a beam that starts at its origin, which is the centre of the beams' starts. So the boxes grow by the
/// radius of the beam at their far end, and by the distance of the beam's start from that centre.
struct Around {
    Footprint footprint;
    Eigen::Vector3f centreM;
    double leverM;
};

Eigen::AlignedBox3f widened(const Eigen::AlignedBox3f& inScene, const Around& around) {
    const Eigen::AlignedBox3f box(inScene.min() - around.centreM, inScene.max() - around.centreM);
    const double reach = static_cast<double>(box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm());
    const auto margin = static_cast<float>(around.leverM + 1.05 * around.footprint.radiusM(reach) + 1e-4);
    return {box.min() - Eigen::Vector3f::Constant(margin), box.max() + Eigen::Vector3f::Constant(margin)};
}

BoxTree treeOver(const Mesh& mesh, const Around& around) {
    std::vector<Eigen::AlignedBox3f> boxes;
    boxes.reserve(mesh.size());
    for (const Triangle& t : mesh) {
        Eigen::AlignedBox3f box(t.corner);
        box.extend(t.corner + t.edge1);
        box.extend(t.corner + t.edge2);
        boxes.push_back(widened(box, around));
    }
    return BoxTree(boxes);
}

void castInto(const Mesh& mesh, const BoxTree& tree, const RayBundle& bundle, BundleHits& hits) {
    const Eigen::Vector3f centre(bundle.dx[0], bundle.dy[0], bundle.dz[0]);
    tree.along(
        centre, [&](std::int32_t part) { meet(mesh[static_cast<std::size_t>(part)], bundle, hits); }, [&] { return farthest(hits); });
}

Eigen::Vector3f originOf(const RayBundle& bundle, std::size_t i) { return {bundle.ox[i], bundle.oy[i], bundle.oz[i]}; }
Eigen::Vector3f directionOf(const RayBundle& bundle, std::size_t i) { return {bundle.dx[i], bundle.dy[i], bundle.dz[i]}; }

/// Whether a point on a side of a rounded body is over that side of its core. Elsewhere the ray hits a ridge, or misses.
bool onFlatPart(const ConvexBody& body, std::size_t side, const Eigen::Vector3f& point) {
    constexpr float kOverlapM = 1e-5F; // overlap, so that no ray passes between a side and its ridges
    const Eigen::Vector3f below = point - body.radiusM * body.facets[side].normal;
    return std::all_of(body.facets.begin(), body.facets.end(),
                       [&](const Facet& facet) { return facet.normal.dot(below) <= facet.offset - body.radiusM + kOverlapM; });
}

/// Distance at which a ray comes within the radius of a ridge, infinite if it does not; `start` and `along` in metres.
double entryOfRidge(const Ridge& ridge, double radius, const Eigen::Vector3d& start, const Eigen::Vector3d& along) {
    const auto entry = [](double a, double half, double c) { // the smaller root of a t^2 + 2 half t + c
        const double inside = half * half - a * c;
        return inside > 0.0 ? (-half - std::sqrt(inside)) / a : std::numeric_limits<double>::infinity();
    };
    const Eigen::Vector3d axis = (ridge.to - ridge.from).cast<double>();
    const double length = axis.norm();
    const Eigen::Vector3d unit = axis / length;
    const Eigen::Vector3d offset = start - ridge.from.cast<double>();
    const Eigen::Vector3d across = along - along.dot(unit) * unit;
    const Eigen::Vector3d offsetAcross = offset - offset.dot(unit) * unit;
    const double square = across.squaredNorm();
    double place = along.dot(unit) > 0.0 ? -1.0 : length + 1.0; // a ray along the ridge enters at the end that it reaches first
    if (square > 1e-12) {
        const double t = entry(square, across.dot(offsetAcross), offsetAcross.squaredNorm() - radius * radius);
        if (std::isinf(t)) return t;
        place = (offset + t * along).dot(unit);
        if (place >= 0.0 && place <= length) return t;
    }
    const Eigen::Vector3d fromEnd = place < 0.0 ? offset : offset - axis;
    return entry(along.squaredNorm(), along.dot(fromEnd), fromEnd.squaredNorm() - radius * radius);
}

void meetRidges(const ConvexBody& body, const RayBundle& bundle, std::size_t lane, BundleHits& hits) {
    const Eigen::Vector3d start = originOf(bundle, lane).cast<double>();
    const Eigen::Vector3d along = directionOf(bundle, lane).cast<double>();
    for (const Ridge& ridge : body.ridges) {
        const auto t = static_cast<float>(entryOfRidge(ridge, static_cast<double>(body.radiusM), start, along));
        if (t <= 0.0F || t >= hits.distanceM[lane]) continue;
        hits.distanceM[lane] = t;
        hits.surface[lane] = ridge.surface;
    }
}

/// The box of a copy in the scene.
Eigen::AlignedBox3f boxOf(const MeshCopy& copy) {
    Eigen::AlignedBox3f box;
    const Eigen::Matrix3f turn = copy.scale * copy.rotation;
    for (const Eigen::Vector3f& point : copy.mesh->points()) box.extend(turn * point);
    return {box.min() + copy.placeM, box.max() + copy.placeM};
}

/// From the scene to the frame of a copy's mesh; distances along rays stay the same numbers.
RayBundle carried(const RayBundle& bundle, const Eigen::Matrix3f& turn, const Eigen::Vector3f& placeM) {
    RayBundle there;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = bundle.ox[i] - placeM.x();
        const float y = bundle.oy[i] - placeM.y();
        const float z = bundle.oz[i] - placeM.z();
        there.ox[i] = turn(0, 0) * x + turn(0, 1) * y + turn(0, 2) * z;
        there.oy[i] = turn(1, 0) * x + turn(1, 1) * y + turn(1, 2) * z;
        there.oz[i] = turn(2, 0) * x + turn(2, 1) * y + turn(2, 2) * z;
        there.dx[i] = turn(0, 0) * bundle.dx[i] + turn(0, 1) * bundle.dy[i] + turn(0, 2) * bundle.dz[i];
        there.dy[i] = turn(1, 0) * bundle.dx[i] + turn(1, 1) * bundle.dy[i] + turn(1, 2) * bundle.dz[i];
        there.dz[i] = turn(2, 0) * bundle.dx[i] + turn(2, 1) * bundle.dy[i] + turn(2, 2) * bundle.dz[i];
    }
    return there;
}

} // namespace

RayCaster::RayCaster(const Scene& scene, const Footprint& footprint, const Eigen::Vector3d& centreM, double leverM) : scene_(&scene) {
    const Around around{footprint, centreM.cast<float>(), leverM};
    for (const Mesh& mesh : scene.voids) voidTrees_.push_back(treeOver(mesh, around));
    solidTree_ = treeOver(scene.solids, around);
    std::vector<Eigen::AlignedBox3f> boxes;
    boxes.reserve(scene.bodies.size());
    for (const ConvexBody& body : scene.bodies) boxes.push_back(widened(body.box, around));
    bodyTree_ = BoxTree(boxes);
    boxes.clear();
    for (const MeshCopy& copy : scene.copies) {
        boxes.push_back(boxOf(copy));
        toMesh_.emplace_back(copy.rotation.transpose() / copy.scale);
    }
    copyTree_ = BoxTree(boxes);
}

void RayCaster::castCopy(std::size_t copy, const RayBundle& bundle, BundleHits& hits) const {
    const MeshCopy& of = scene_->copies[copy];
    BundleHits inside;
    inside.distanceM = hits.distanceM;
    of.mesh->meet(carried(bundle, toMesh_[copy], of.placeM), inside);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool closer = inside.surface[i] >= 0;
        hits.distanceM[i] = inside.distanceM[i];
        hits.surface[i] = closer ? inside.surface[i] : hits.surface[i];
        hits.copy[i] = closer ? static_cast<std::int32_t>(copy) : hits.copy[i];
    }
}

BundleHits RayCaster::cast(const RayBundle& bundle) const {
    BundleHits hits;
    for (std::size_t v = 0; v < scene_->voids.size(); ++v) {
        BundleHits wall;
        castInto(scene_->voids[v], voidTrees_[v], bundle, wall);
        for (std::size_t i = 0; i < kLanes; ++i) {
            if (v > 0 && wall.distanceM[i] <= hits.distanceM[i]) continue;
            hits.distanceM[i] = wall.distanceM[i];
            hits.surface[i] = wall.surface[i];
        }
    }
    castInto(scene_->solids, solidTree_, bundle, hits);
    const Eigen::Vector3f centre(bundle.dx[0], bundle.dy[0], bundle.dz[0]);
    bodyTree_.along(
        centre, [&](std::int32_t part) { meet(scene_->bodies[static_cast<std::size_t>(part)], bundle, hits); },
        [&] { return farthest(hits); });
    constexpr float kMarginM = 1e-4F; // the box of a copy is not exact
    copyTree_.along(bundle, kMarginM, hits, [&](std::int32_t copy) { castCopy(static_cast<std::size_t>(copy), bundle, hits); });
    return hits;
}

void meet(const Triangle& triangle, const RayBundle& bundle, BundleHits& hits) {
    constexpr float kRim = 1e-5F; // neighbouring triangles overlap by this share, so that no ray passes between them
    const Eigen::Vector3f e1 = triangle.edge1;
    const Eigen::Vector3f e2 = triangle.edge2;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float px = bundle.dy[i] * e2.z() - bundle.dz[i] * e2.y();
        const float py = bundle.dz[i] * e2.x() - bundle.dx[i] * e2.z();
        const float pz = bundle.dx[i] * e2.y() - bundle.dy[i] * e2.x();
        const float determinant = e1.x() * px + e1.y() * py + e1.z() * pz;
        const float inverse = 1.0F / determinant; // infinite for a ray in the plane: then every test below fails
        const float sx = bundle.ox[i] - triangle.corner.x();
        const float sy = bundle.oy[i] - triangle.corner.y();
        const float sz = bundle.oz[i] - triangle.corner.z();
        const float u = (sx * px + sy * py + sz * pz) * inverse;
        const float qx = sy * e1.z() - sz * e1.y();
        const float qy = sz * e1.x() - sx * e1.z();
        const float qz = sx * e1.y() - sy * e1.x();
        const float v = (bundle.dx[i] * qx + bundle.dy[i] * qy + bundle.dz[i] * qz) * inverse;
        const float t = (e2.x() * qx + e2.y() * qy + e2.z() * qz) * inverse;
        const bool closer = (u >= -kRim) & (v >= -kRim) & (u + v <= 1.0F + kRim) & (t > 0.0F) & (t < hits.distanceM[i]);
        hits.distanceM[i] = closer ? t : hits.distanceM[i];
        hits.surface[i] = closer ? triangle.surface : hits.surface[i];
    }
}

void meet(const ConvexBody& body, const RayBundle& bundle, BundleHits& hits) {
    alignas(16) Lanes<float> enter;
    alignas(16) Lanes<float> leave;
    alignas(16) Lanes<std::int32_t> side; // index into the facets
    enter.fill(0.0F);
    leave.fill(kNowhere);
    side.fill(-1);
    for (std::size_t f = 0; f < body.facets.size(); ++f) {
        const Facet& facet = body.facets[f];
        const float nx = facet.normal.x();
        const float ny = facet.normal.y();
        const float nz = facet.normal.z();
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float slope = nx * bundle.dx[i] + ny * bundle.dy[i] + nz * bundle.dz[i];
            const float height = nx * bundle.ox[i] + ny * bundle.oy[i] + nz * bundle.oz[i] - facet.offset;
            const bool parallel = std::abs(slope) < 1e-9F;
            const float t = -height / (parallel ? 1e-9F : slope);
            const bool inward = (slope < 0.0F) & !parallel;
            const bool later = inward & (t > enter[i]);
            const bool sooner = !inward & (t < leave[i]);
            enter[i] = later ? t : enter[i];
            side[i] = later ? static_cast<std::int32_t>(f) : side[i];
            leave[i] = sooner ? t : leave[i];
        }
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool closer = (side[i] >= 0) & (enter[i] <= leave[i]) & (enter[i] < hits.distanceM[i]);
        if (!closer) continue;
        const auto hit = static_cast<std::size_t>(side[i]);
        if (body.radiusM > 0.0F && !onFlatPart(body, hit, originOf(bundle, i) + enter[i] * directionOf(bundle, i))) {
            meetRidges(body, bundle, i, hits);
            continue;
        }
        hits.distanceM[i] = enter[i];
        hits.surface[i] = body.facets[hit].surface;
    }
}

} // namespace edgescan::sim
