// Copies of meshes in a scene: each beam hits them as it would hit the same triangles stored one by one.
#include "app/lab/sim/caster.h"
#include "app/lab/sim/random.h"
#include "tests/support/cube_stones.h"

#include <gtest/gtest.h>

namespace edgescan::sim {
namespace {

std::shared_ptr<const StoredMesh> cubeMesh() {
    const std::vector<double> corners = test::cubeCorners(), numbers = test::cubeTriangles();
    std::vector<Eigen::Vector3f> points;
    for (std::size_t n = 0; n < corners.size(); n += 3)
        points.push_back(Eigen::Vector3d(corners[n], corners[n + 1], corners[n + 2]).cast<float>());
    std::vector<StoredMesh::Corners> triangles;
    for (std::size_t n = 0; n < numbers.size(); n += 3)
        triangles.push_back({static_cast<int>(numbers[n]), static_cast<int>(numbers[n + 1]), static_cast<int>(numbers[n + 2])});
    return std::make_shared<const StoredMesh>(std::move(points), std::move(triangles));
}

Eigen::Vector3d randomDirection(RandomSequence& dice) { return Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized(); }

/// Forty cubes around the scanner.
Scene cubesAround() {
    Scene scene;
    const auto mesh = cubeMesh();
    RandomSequence dice(5, Purpose::Places);
    for (int n = 0; n < 40; ++n) {
        MeshCopy copy;
        copy.mesh = mesh;
        copy.rotation = Eigen::AngleAxisd(dice.uniform(0, 6), randomDirection(dice)).toRotationMatrix().cast<float>();
        copy.scale = static_cast<float>(dice.uniform(0.1, 1.5));
        copy.placeM = (dice.uniform(2, 9) * randomDirection(dice)).cast<float>();
        copy.object = static_cast<std::uint16_t>(kFirstRock + n);
        scene.copies.push_back(copy);
    }
    return scene;
}

/// The same triangles, each stored with its surface.
Scene flattened(const Scene& from) {
    Scene scene;
    for (const MeshCopy& copy : from.copies) {
        const auto placed = [&](std::int32_t corner) -> Eigen::Vector3f {
            return copy.rotation * (copy.scale * copy.mesh->points()[static_cast<std::size_t>(corner)]) + copy.placeM;
        };
        for (const auto& [a, b, c] : copy.mesh->triangles()) {
            Eigen::Vector3f normal = (placed(b) - placed(a)).cross(placed(c) - placed(a)).normalized();
            if (normal.dot(placed(a)) > 0) normal = -normal;
            scene.solids.push_back(
                {placed(a), placed(b) - placed(a), placed(c) - placed(a), static_cast<std::int32_t>(scene.surfaces.size())});
            scene.surfaces.push_back({.normal = normal, .object = copy.object, .texture = Texture::Smooth});
        }
    }
    return scene;
}

// A cell at the very rim of a cube may differ, because the two scenes round differently.
void expectSameHits(const Scene& copies, const Scene& flat, const Footprint& footprint) {
    const RayCaster ofCopies(copies, footprint), ofFlat(flat, footprint);
    RandomSequence dice(6, Purpose::Noise);
    int hits = 0, different = 0;
    for (int n = 0; n < 4000; ++n) {
        const RayBundle bundle = bundleAlong(randomDirection(dice), footprint);
        const BundleHits a = ofCopies.cast(bundle), b = ofFlat.cast(bundle);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if ((a.surface[lane] < 0) != (b.surface[lane] < 0)) {
                ++different;
                continue;
            }
            if (a.surface[lane] < 0) continue;
            ++hits;
            const Surface one = surfaceOf(copies, bundle, a, lane), other = surfaceOf(flat, bundle, b, lane);
            const bool same = std::abs(a.distanceM[lane] - b.distanceM[lane]) < 1e-4F && one.object == other.object &&
                              (one.normal - other.normal).norm() < 1e-4F;
            different += same ? 0 : 1;
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_LE(different, hits / 2000);
}

TEST(MeshCopies, BeamsHitThemLikeTheSameTrianglesStoredOneByOne) {
    const Scene copies = cubesAround();
    expectSameHits(copies, flattened(copies), {});
    expectSameHits(copies, flattened(copies), {0.0, 0.0});
}

TEST(MeshCopies, TurnAndGrowWithTheScene) {
    const Eigen::Matrix3f turn = Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
    const Scene copies = cubesAround();
    expectSameHits(rotated(copies, turn), rotated(flattened(copies), turn), {});
    expectSameHits(scaled(copies, 1.5F), scaled(flattened(copies), 1.5F), {});
}

TEST(MeshCopies, NearerSurfacesOfOtherKindsHideThem) {
    Scene scene;
    scene.surfaces.push_back({.object = 7});
    scene.solids.push_back({{-9, -9, 2}, {40, 0, 0}, {0, 40, 0}, 0});
    scene.copies.push_back({.mesh = cubeMesh(), .placeM = {0, 0, 5}, .object = 3});
    const RayBundle up = bundleAlong(Eigen::Vector3d::UnitZ(), {});
    EXPECT_EQ(surfaceOf(scene, up, RayCaster(scene, {}).cast(up), 0).object, 7);
    scene.copies[0].placeM.z() = 1.5F;
    const BundleHits hits = RayCaster(scene, {}).cast(up);
    const Surface surface = surfaceOf(scene, up, hits, 0);
    EXPECT_EQ(surface.object, 3);
    EXPECT_EQ(surface.normal, Eigen::Vector3f(0, 0, -1));
    EXPECT_FLOAT_EQ(hits.distanceM[0], 1.0F);
}

} // namespace
} // namespace edgescan::sim
