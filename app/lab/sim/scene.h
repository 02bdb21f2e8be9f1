// The surfaces that beams can hit: walls of voids, solid surfaces in them, and convex bodies.
#pragma once

#include "app/lab/sim/rays.h"
#include "app/lab/sim/stored_mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace edgescan::sim {

inline constexpr std::uint16_t kWallObject = 1;
inline constexpr std::uint16_t kFirstRock = 2;

enum class Texture : std::uint8_t { Smooth, Rock, Wall };

/// One flat piece, or a rounded ridge. Pieces with the same object and face form one smooth face of that object.
struct Surface {
    Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< unit vector towards the scanner's side; unused for a rounded ridge
    std::uint16_t object = kWallObject;
    std::uint16_t face = 1;
    Texture texture = Texture::Wall;
    std::int32_t body = -1;  ///< rounded ridge: index into Scene::bodies
    std::int32_t ridge = -1; ///< rounded ridge: index into that body's ridges
};

struct Triangle {
    Eigen::Vector3f corner, edge1, edge2; ///< metres, scanner frame
    std::int32_t surface = -1;
};
using Mesh = std::vector<Triangle>;

/// Half-space normal . x <= offset.
struct Facet {
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float offset = 0.0F;
    std::int32_t surface = -1;
};

/// A ridge of a rounded body's core, metres.
struct Ridge {
    Eigen::Vector3f from, to;
    std::int32_t surface = -1;
};

/// The intersection of half-spaces. If the radius is not 0 the body is rounded: the half-spaces, moved inwards by the radius, enclose the
/// core, and the body contains all points within the radius of the core: planes over its flat sides, cylinders along ridges, spheres at
/// corners.
struct ConvexBody {
    std::vector<Facet> facets;
    Eigen::AlignedBox3f box;
    std::vector<Ridge> ridges; ///< of the core; empty for a sharp body
    float radiusM = 0.0F;
};

/// A copy of a mesh: its point p is at rotation * (scale * p) + placeM, metres, scanner frame.
struct MeshCopy {
    std::shared_ptr<const StoredMesh> mesh;
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
    float scale = 1.0F;
    Eigen::Vector3f placeM = Eigen::Vector3f::Zero();
    std::uint16_t object = kWallObject;
    std::uint16_t face = 1;
};

/// The true dimensions of a rock, including hidden parts.
struct RockTruth {
    std::uint16_t object = 0;
    Eigen::Vector3f centreM = Eigen::Vector3f::Zero();
    std::array<float, 3> spansM{}; ///< longest axis first
    float volumeM3 = 0.0F;
};

/// Metres, scanner frame, scanner at the origin.
struct Scene {
    std::vector<Surface> surfaces;
    /// Each mesh is the wall of one void that contains the scanner; a beam passes from void to void and ends at the farthest wall.
    std::vector<Mesh> voids;
    Mesh solids; ///< surfaces that stop a beam in any void
    std::vector<ConvexBody> bodies;
    std::vector<MeshCopy> copies; ///< closed or open meshes, seen from both sides
    std::vector<RockTruth> rocks;
};

/// The surface that a sub-ray hit. Of a copy of a mesh: smooth, with the normal of the triangle on the scanner's side.
[[nodiscard]] Surface surfaceOf(const Scene& scene, const RayBundle& bundle, const BundleHits& hits, std::size_t lane);

/// Unit normal of a surface at one of its points.
[[nodiscard]] Eigen::Vector3f normalAt(const Scene& scene, const Surface& surface, const Eigen::Vector3f& point);

/// Adds the surface through a rows x columns lattice of points, facing the scanner, two triangles per lattice cell. @param closed joins the
/// last column to the first @param point position of lattice node (row, column), metres
struct Lattice {
    int rows = 2;
    int columns = 2;
    bool closed = false;
    std::function<Eigen::Vector3d(int row, int column)> point;
};
void addLattice(Scene& scene, Mesh& mesh, const Lattice& lattice, const Surface& look);

/// The scene scaled by a factor about the scanner.
[[nodiscard]] Scene scaled(Scene scene, float factor);

/// The scene rotated about the scanner.
[[nodiscard]] Scene rotated(Scene scene, const Eigen::Matrix3f& rotation);

} // namespace edgescan::sim
