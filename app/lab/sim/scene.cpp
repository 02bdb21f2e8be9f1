// Building blocks of scenes: surfaces through lattices of points, rotation.
#include "app/lab/sim/scene.h"

#include <algorithm>

namespace edgescan::sim {
namespace {

void addTriangle(Scene& scene, Mesh& mesh, const std::array<Eigen::Vector3d, 3>& corners, Surface look) {
    Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double area = normal.norm();
    if (area < 1e-12) return; // several nodes of a lattice may coincide
    normal /= area;
    if (normal.dot(corners[0]) > 0.0) normal = -normal;
    look.normal = normal.cast<float>();
    mesh.push_back({corners[0].cast<float>(), (corners[1] - corners[0]).cast<float>(), (corners[2] - corners[0]).cast<float>(),
                    static_cast<std::int32_t>(scene.surfaces.size())});
    scene.surfaces.push_back(look);
}

void transform(Mesh& mesh, const Eigen::Matrix3f& by) {
    for (Triangle& t : mesh) {
        t.corner = by * t.corner;
        t.edge1 = by * t.edge1;
        t.edge2 = by * t.edge2;
    }
}

} // namespace

Surface surfaceOf(const Scene& scene, const RayBundle& bundle, const BundleHits& hits, std::size_t lane) {
    const auto part = static_cast<std::size_t>(hits.surface[lane]);
    if (hits.copy[lane] < 0) return scene.surfaces[part];
    const MeshCopy& copy = scene.copies[static_cast<std::size_t>(hits.copy[lane])];
    Eigen::Vector3f normal = (copy.rotation * copy.mesh->normal(part)).normalized();
    if (normal.x() * bundle.dx[lane] + normal.y() * bundle.dy[lane] + normal.z() * bundle.dz[lane] > 0.0F) normal = -normal;
    return {.normal = normal, .object = copy.object, .face = copy.face, .texture = Texture::Smooth};
}

Eigen::Vector3f normalAt(const Scene& scene, const Surface& surface, const Eigen::Vector3f& point) {
    if (surface.ridge < 0) return surface.normal;
    const Ridge& ridge = scene.bodies[static_cast<std::size_t>(surface.body)].ridges[static_cast<std::size_t>(surface.ridge)];
    const Eigen::Vector3f along = ridge.to - ridge.from;
    const float share = std::clamp(along.dot(point - ridge.from) / along.squaredNorm(), 0.0F, 1.0F);
    return (point - ridge.from - share * along).normalized();
}

void addLattice(Scene& scene, Mesh& mesh, const Lattice& lattice, const Surface& look) {
    std::vector<Eigen::Vector3d> nodes;
    nodes.reserve(static_cast<std::size_t>(lattice.rows) * static_cast<std::size_t>(lattice.columns));
    for (int i = 0; i < lattice.rows; ++i) {
        for (int j = 0; j < lattice.columns; ++j) nodes.push_back(lattice.point(i, j));
    }
    const auto node = [&](int i, int j) -> const Eigen::Vector3d& {
        return nodes[static_cast<std::size_t>(i) * static_cast<std::size_t>(lattice.columns) + static_cast<std::size_t>(j)];
    };
    const int cells = lattice.closed ? lattice.columns : lattice.columns - 1;
    for (int i = 0; i + 1 < lattice.rows; ++i) {
        for (int j = 0; j < cells; ++j) {
            const int next = (j + 1) % lattice.columns;
            addTriangle(scene, mesh, {node(i, j), node(i, next), node(i + 1, next)}, look);
            addTriangle(scene, mesh, {node(i, j), node(i + 1, next), node(i + 1, j)}, look);
        }
    }
}

Scene scaled(Scene scene, float factor) {
    const Eigen::Matrix3f by = factor * Eigen::Matrix3f::Identity();
    for (Mesh& mesh : scene.voids) transform(mesh, by);
    transform(scene.solids, by);
    for (ConvexBody& body : scene.bodies) {
        body.box = {body.box.min() * factor, body.box.max() * factor};
        for (Facet& facet : body.facets) facet.offset *= factor;
        for (Ridge& ridge : body.ridges) ridge = {ridge.from * factor, ridge.to * factor, ridge.surface};
        body.radiusM *= factor;
    }
    for (MeshCopy& copy : scene.copies) {
        copy.scale *= factor;
        copy.placeM *= factor;
    }
    for (RockTruth& rock : scene.rocks) {
        rock.centreM *= factor;
        for (float& span : rock.spansM) span *= factor;
        rock.volumeM3 *= factor * factor * factor;
    }
    return scene;
}

Scene rotated(Scene scene, const Eigen::Matrix3f& rotation) {
    for (Surface& surface : scene.surfaces) surface.normal = rotation * surface.normal;
    for (Mesh& mesh : scene.voids) transform(mesh, rotation);
    transform(scene.solids, rotation);
    for (ConvexBody& body : scene.bodies) {
        Eigen::AlignedBox3f box;
        for (int k = 0; k < 8; ++k) box.extend(rotation * body.box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(k)));
        body.box = box;
        for (Facet& facet : body.facets) facet.normal = rotation * facet.normal;
        for (Ridge& ridge : body.ridges) ridge = {rotation * ridge.from, rotation * ridge.to, ridge.surface};
    }
    for (MeshCopy& copy : scene.copies) {
        copy.rotation = rotation * copy.rotation;
        copy.placeM = rotation * copy.placeM;
    }
    for (RockTruth& rock : scene.rocks) rock.centreM = rotation * rock.centreM;
    return scene;
}

} // namespace edgescan::sim
