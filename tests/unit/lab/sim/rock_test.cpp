// Rocks of the simulator: hulls are convex hulls, and rays hit rocks at the same points as triangles.
#include "app/lab/sim/caster.h"
#include "app/lab/sim/convex_rock.h"
#include "app/lab/sim/noise.h"
#include "core/base/geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace edgescan::sim {
namespace {

using Points = std::vector<Eigen::Vector3d>;

const Eigen::Vector3d& at(const Points& points, int i) { return points[static_cast<std::size_t>(i)]; }

Points cloud(int count, std::uint64_t seed) {
    RandomSequence dice(seed, Purpose::Shapes);
    Points points;
    for (int i = 0; i < count; ++i) points.emplace_back(Eigen::Vector3d{dice.normal(), dice.normal(), dice.normal()});
    return points;
}

void expectHull(const Points& points, const std::vector<HullTriangle>& hull) {
    ASSERT_GE(hull.size(), 4U);
    std::map<std::pair<int, int>, int> edges;
    std::set<int> used;
    for (const HullTriangle& t : hull) {
        const Eigen::Vector3d normal = (at(points, t[1]) - at(points, t[0])).cross(at(points, t[2]) - at(points, t[0])).normalized();
        for (const Eigen::Vector3d& p : points) EXPECT_LE(normal.dot(p - at(points, t[0])), 1e-7);
        for (std::size_t e = 0; e < 3; ++e) {
            ++edges[{t[e], t[(e + 1) % 3]}];
            used.insert(t[e]);
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ((edges.count({edge.second, edge.first})), 1U) << "open edge";
    }
    EXPECT_EQ(used.size() + hull.size() - edges.size() / 2, 2U) << "Euler";
}

TEST(SimHull, ContainsItsPointsAndIsClosed) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Points points = cloud(4 + static_cast<int>(seed % 37), seed);
        expectHull(points, convexHull(points));
    }
}

TEST(SimHull, CubeWithPointsOnItsFacesAndEdges) {
    Points points;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) points.emplace_back(x, y, z);
    const auto hull = convexHull(points);
    ASSERT_FALSE(hull.empty());
    double volume = 0.0;
    for (const HullTriangle& t : hull) volume += at(points, t[0]).dot(at(points, t[1]).cross(at(points, t[2]))) / 6.0;
    EXPECT_NEAR(volume, 8.0, 1e-9);
}

TEST(SimHull, FlatPointsHaveNone) {
    EXPECT_TRUE(convexHull({}).empty());
    EXPECT_TRUE(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
    EXPECT_TRUE(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}}).empty());
    EXPECT_TRUE(convexHull({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).empty());
    EXPECT_TRUE(convexHull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).empty());
}

TEST(SimRock, CornersSpansAndAspect) {
    RandomSequence dice(5, Purpose::Shapes);
    for (int i = 0; i < 100; ++i) {
        const Points corners = rockCorners(1.5, dice);
        EXPECT_GE(corners.size(), 12U);
        EXPECT_LE(corners.size(), 40U);
        expectHull(corners, convexHull(corners));
        Scene scene;
        addRock(scene, corners, {0, 0, 5});
        ASSERT_EQ(scene.rocks.size(), 1U);
        const auto& spans = scene.rocks[0].spansM;
        EXPECT_GE(spans[0], 1.49F);
        EXPECT_LE(spans[0], 1.5F * 1.74F);
        EXPECT_GE(spans[0], spans[1]);
        EXPECT_GE(spans[1] * 1.0001F, spans[2] * 0.7F);
        EXPECT_GT(scene.rocks[0].volumeM3, 0.0F);
        EXPECT_LT(scene.rocks[0].volumeM3, spans[0] * spans[1] * spans[2]);
    }
}

TEST(SimRock, SizesAreSortedAndBounded) {
    const auto sizes = rockSizes(420, 3);
    ASSERT_EQ(sizes.size(), 420U);
    EXPECT_TRUE(std::is_sorted(sizes.rbegin(), sizes.rend()));
    EXPECT_LE(sizes.front(), 2.6);
    EXPECT_GE(sizes.front(), 2.2);
    EXPECT_GE(sizes.back(), 0.16);
    EXPECT_TRUE(rockSizes(0, 3).empty());
}

/// The same rock as triangles.
Mesh trianglesOf(const Points& corners, const Eigen::Vector3d& centre) {
    Mesh mesh;
    for (const HullTriangle& t : convexHull(corners)) {
        const Eigen::Vector3f a = (at(corners, t[0]) + centre).cast<float>();
        mesh.push_back({a, (at(corners, t[1]) + centre).cast<float>() - a, (at(corners, t[2]) + centre).cast<float>() - a, 0});
    }
    return mesh;
}

TEST(SimRock, RaysMeetItWhereItsTrianglesAre) {
    RandomSequence dice(9, Purpose::Shapes);
    int hitsSeen = 0;
    int outlines = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const Points corners = rockCorners(dice.uniform(0.3, 2.5), dice);
        const Eigen::Vector3d centre{dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(3, 9)};
        Scene scene;
        addRock(scene, corners, centre);
        const Mesh mesh = trianglesOf(corners, centre);
        for (int ray = 0; ray < 60; ++ray) {
            const Eigen::Vector3d aim = centre + Eigen::Vector3d{dice.normal(), dice.normal(), dice.normal()} * 0.5;
            const RayBundle bundle = bundleAlong(aim.normalized(), {});
            BundleHits body;
            BundleHits brute;
            meet(scene.bodies[0], bundle, body);
            for (const Triangle& triangle : mesh) meet(triangle, bundle, brute);
            for (std::size_t i = 0; i < kLanes; ++i) {
                const bool inside = body.surface[i] >= 0;
                hitsSeen += inside ? 1 : 0;
                if (inside != (brute.surface[i] >= 0))
                    ++outlines;
                else if (inside) {
                    EXPECT_NEAR(body.distanceM[i], brute.distanceM[i], 2e-4);
                }
            }
        }
    }
    EXPECT_LT(outlines, 10); // rays along an outline, where rounding decides
    EXPECT_GT(hitsSeen, 5000);
}

TEST(SimCaster, TreeFindsWhatBruteForceFinds) {
    RandomSequence dice(21, Purpose::Shapes);
    Scene scene;
    for (int i = 0; i < 80; ++i) {
        const Eigen::Vector3d centre{dice.uniform(-4, 4), dice.uniform(-4, 4), dice.uniform(2, 9)};
        addRock(scene, rockCorners(dice.uniform(0.2, 1.5), dice), centre);
    }
    const Lattice ground{12, 12, false, [](int i, int j) { return Eigen::Vector3d(i - 5.5, j - 5.5, 9.0 + 0.3 * ((i * 7 + j * 3) % 5)); }};
    addLattice(scene, scene.solids, ground, {});
    const RayCaster caster(scene, {});
    for (int ray = 0; ray < 800; ++ray) {
        const RayBundle bundle = bundleAlong(Eigen::Vector3d{dice.normal(), dice.normal(), 3.0 * dice.uniform()}.normalized(), {});
        const BundleHits hits = caster.cast(bundle);
        BundleHits brute;
        for (const Triangle& triangle : scene.solids) meet(triangle, bundle, brute);
        for (const ConvexBody& body : scene.bodies) meet(body, bundle, brute);
        EXPECT_EQ(hits.distanceM, brute.distanceM);
    }
}

TEST(SimCaster, BeamPassesFromVoidToVoid) {
    Scene scene;
    const auto plate = [](double z) {
        return Lattice{2, 2, false, [z](int i, int j) { return Eigen::Vector3d(8.0 * i - 4.0, 8.0 * j - 4.0, z); }};
    };
    scene.voids.resize(2);
    addLattice(scene, scene.voids[0], plate(3.0), {.face = 1});
    addLattice(scene, scene.voids[1], plate(5.0), {.face = 2});
    const RayCaster caster(scene, {});
    const BundleHits hits = caster.cast(bundleAlong(Eigen::Vector3d::UnitZ(), {}));
    EXPECT_FLOAT_EQ(hits.distanceM[0], 5.0F);
    EXPECT_EQ(scene.surfaces[static_cast<std::size_t>(hits.surface[0])].face, 2);
}

TEST(SimRandom, NormalAndUniformHaveTheirMoments) {
    double sum = 0.0;
    double squares = 0.0;
    double uniform = 0.0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        const double n = normalOf(hashOf(4, Purpose::Noise, static_cast<std::uint64_t>(i)));
        sum += n;
        squares += n * n;
        uniform += uniformOf(hashOf(4, Purpose::Dropout, static_cast<std::uint64_t>(i)));
    }
    EXPECT_NEAR(sum / kCount, 0.0, 0.01);
    EXPECT_NEAR(squares / kCount, 1.0, 0.015);
    EXPECT_NEAR(uniform / kCount, 0.5, 0.003);
}

TEST(SimNoise, ReliefHasItsNominalSizeAndNoSteps) {
    RandomSequence dice(2, Purpose::Shapes);
    double squares = 0.0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const Eigen::Vector3d p{dice.uniform(-50, 50), dice.uniform(-50, 50), dice.uniform(-50, 50)};
        const double here = fractalNoise(p, 0.5, 4, 1);
        squares += here * here;
        EXPECT_LE(std::abs(here), 5.0);
        EXPECT_NEAR(fractalNoise(p + Eigen::Vector3d(1e-7, 0, 0), 0.5, 4, 1), here, 1e-4);
    }
    EXPECT_NEAR(std::sqrt(squares / kCount), 1.0, 0.1);
}

} // namespace
} // namespace edgescan::sim
