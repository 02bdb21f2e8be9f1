// Jumps and folds between rays: on planes, and on meshes with facets smaller than the distance between two rays.
#include "app/lab/sim/seam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace edgescan::sim {
namespace {

using Eigen::Vector3d;

Vector3d rayAt(double angleDeg) {
    const double a = angleDeg * std::numbers::pi / 180.0;
    return {std::sin(a), 0.0, std::cos(a)};
}

// The point where a ray in the x-z plane meets the plane through `place`.
TangentPlane on(const Vector3d& place, const Vector3d& normal, const Vector3d& ray) {
    return {ray, normal.dot(place) / normal.dot(ray), normal};
}

TEST(SimSeam, OnePlaneHasNoneHoweverGrazing) {
    const Vector3d normal = Vector3d(-1.0, 0.0, 0.1).normalized();
    const Seam seam = seamBetween(on({2000, 0, 0}, normal, rayAt(10)), on({2000, 0, 0}, normal, rayAt(10.4)));
    EXPECT_NEAR(seam.tearMm, 0.0, 1e-6);
    EXPECT_EQ(seam.foldDeg, 0.0F);
}

TEST(SimSeam, AStepTearsAndARoofFolds) {
    const Vector3d facing(0, 0, -1);
    const Seam step = seamBetween(on({0, 0, 3000}, facing, rayAt(-0.1)), on({0, 0, 3200}, facing, rayAt(0.1)));
    EXPECT_NEAR(step.tearMm, 200.0, 0.1);
    EXPECT_EQ(step.foldDeg, 0.0F);
    // A ridge of two slopes of 30 degrees; they meet between the rays.
    const Vector3d left = Vector3d(-0.5, 0, -std::sqrt(0.75)).normalized();
    const Vector3d right = Vector3d(0.5, 0, -std::sqrt(0.75)).normalized();
    const Seam ridge = seamBetween(on({0, 0, 3000}, left, rayAt(-0.1)), on({0, 0, 3000}, right, rayAt(0.1)));
    EXPECT_EQ(ridge.tearMm, 0.0F);
    EXPECT_NEAR(ridge.foldDeg, 60.0, 1e-4);
}

// A surface z(x) as facets of `facetMm`; a ray's hit is found in small steps.
template <class Height>
TangentCast castOn(Height height, double facetMm) {
    return [=](const Vector3d& ray) -> std::optional<TangentPlane> {
        for (double x = -3000.0; x < 3000.0; x += facetMm) {
            const Vector3d a(x, 0, height(x));
            const Vector3d along = Vector3d(x + facetMm, 0, height(x + facetMm)) - a;
            const Vector3d normal = Vector3d(along.z(), 0, -along.x()).normalized();
            if (normal.dot(ray) > -1e-9) continue; // faces away
            const double range = normal.dot(a) / normal.dot(ray);
            const double share = (ray * range - a).dot(along) / along.squaredNorm();
            if (range > 0 && share >= 0 && share < 1) return TangentPlane{ray, range, normal};
        }
        return std::nullopt;
    };
}

TEST(SimSeam, ABumpyFloorSeenGrazingIsOneSurface) {
    // Waves between the rays; the tangent planes of their ends do not always meet there.
    const TangentCast floor = castOn([](double x) { return 2000.0 - 3.0 * x + 40.0 * std::sin(x / 60.0); }, 10.0);
    double widest = 0;
    for (double deg = -12.0; deg < -9.0; deg += 0.1) {
        const auto a = floor(rayAt(deg));
        const auto b = floor(rayAt(deg + 0.36));
        ASSERT_TRUE(a && b);
        widest = std::max(widest, static_cast<double>(seamBetween(*a, *b).tearMm));
        EXPECT_LE(seamOnMesh(*a, *b, floor).tearMm, kLeastTearMm);
        EXPECT_LE(seamOnMesh(*a, *b, floor).foldDeg, kLeastFoldDeg);
    }
    EXPECT_GT(widest, kLeastTearMm); // otherwise the test shows nothing
}

TEST(SimSeam, AStepOnAMeshStays) {
    const auto height = [](double x) { return x < 0 ? 3000.0 + 0.2 * x : 3400.0; };
    const TangentCast wall = castOn(height, 10.0);
    const auto a = wall(rayAt(-0.7));
    const auto b = wall(rayAt(0.9));
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(seamOnMesh(*a, *b, wall).tearMm, seamBetween(*a, *b).tearMm, 20.0);
    EXPECT_GT(seamOnMesh(*a, *b, wall).tearMm, 300.0F);
}

} // namespace
} // namespace edgescan::sim
