// Scans of heaps of stones: files of stones and of heaps, the physics, one seed and one scan.
#include "app/lab/stones/carved_stone.h"
#include "app/lab/stones/npz.h"
#include "app/lab/stones/stone_scene.h"
#include "tests/support/cube_stones.h"
#include "tests/support/run_program.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace edgescan::lab {
namespace {

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

Stones cubes(const std::string& set = "all") {
    const test::TemporaryFolder folder;
    test::writeCubeStones(folder.path());
    auto stones = readStones(folder.path(), set, 1);
    EXPECT_TRUE(stones) << (stones ? "" : stones.error().sentence());
    return stones ? *stones : Stones{};
}

TEST(StoneFiles, ArraysAreReadFromPackedAndUnpackedArchives) {
    for (const bool packed : {false, true}) {
        const std::string file = test::zipBytes(
            {{"V.npy", test::arrayOfThree({1, 2.5, -3, 4, 5, 6}, "<f4")}, {"F.npy", test::arrayOfThree({0, 1, 2}, "<i4")}}, packed);
        const auto points = npzPoints(bytesOf(file), "V", "here");
        ASSERT_TRUE(points);
        ASSERT_EQ(points->size(), 2U);
        EXPECT_EQ((*points)[0], Eigen::Vector3f(1, 2.5F, -3));
        const auto triples = npzTriples(bytesOf(file), "F", 3, "here");
        ASSERT_TRUE(triples);
        EXPECT_EQ((*triples)[0], (std::array<std::int32_t, 3>{0, 1, 2}));
        EXPECT_EQ(npzTriples(bytesOf(file), "F", 2, "here").error().what, "the array F names a point that is not there");
        EXPECT_EQ(npzPoints(bytesOf(file), "F", "here").error().what,
                  "the array F does not have the numbers and the two sides that it should have");
        EXPECT_EQ(npzPoints(bytesOf(file), "hull", "here").error().what, "the array hull is missing");
    }
    EXPECT_FALSE(npzPoints(bytesOf("no archive"), "V", "here"));
}

TEST(StoneFiles, SetsHaveTheirStones) {
    EXPECT_EQ(cubes().stones.size(), 2U);
    ASSERT_EQ(cubes("free").stones.size(), 1U);
    EXPECT_EQ(cubes("free").stones[0].name, "cube");
    EXPECT_EQ(cubes("free").stones[0].mesh->triangles().size(), 12U);
    EXPECT_EQ(cubes("lab").stones[0].name, "epflcube");
    EXPECT_FALSE(readStones("/nowhere", "free", 1));
    EXPECT_FALSE(readStones("/nowhere", "other", 1));
}

// A ball of 2,000 points, without triangles between most of them.
Stone ball() {
    Stone stone{"ball", 0.02, nullptr, {}};
    std::vector<Eigen::Vector3f> points;
    for (int n = 0; n < 2000; ++n) {
        const double height = 1.0 - (2.0 * n + 1.0) / 2000, around = 2.4 * n, across = std::sqrt(1.0 - height * height);
        points.emplace_back((0.5 * Eigen::Vector3d(across * std::cos(around), across * std::sin(around), height)).cast<float>());
    }
    stone.hull = points;
    stone.mesh = std::make_shared<const sim::StoredMesh>(std::move(points), std::vector<sim::StoredMesh::Corners>{{0, 1, 2}});
    return stone;
}

TEST(CarvedStones, LoseSomeOfTheirSurfaceAndKeepTheRest) {
    const Stone whole = ball();
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Stone carved = carvedStone(whole, seed), again = carvedStone(whole, seed);
        ASSERT_EQ(carved.mesh->points().size(), whole.mesh->points().size());
        EXPECT_EQ(carved.mesh->points(), again.mesh->points());
        EXPECT_EQ(carved.mesh->triangles(), whole.mesh->triangles());
        EXPECT_NE(carved.mesh->points(), carvedStone(whole, seed + 100).mesh->points());
        int deep = 0;
        for (const Eigen::Vector3f& point : carved.mesh->points()) {
            EXPECT_GT(point.norm(), 0.02F); // a ray still meets a body
            EXPECT_LT(point.norm(), 0.5F * 1.031F);
            deep += point.norm() < 0.47F ? 1 : 0;
        }
        EXPECT_GT(deep, 100) << seed;
        EXPECT_LT(deep, 1995) << seed;
    }
}

TEST(StoneFiles, ASettledHeapIsReadBackWithTheSameBits) {
    const test::TemporaryFolder folder;
    const Heap heap{{"cube", 0.1 + 0.2, {1.0 / 3, -2, 3e-7}, Eigen::Quaterniond(0.1, 0.7, -0.3, 0.6).normalized(), 0.01}};
    ASSERT_TRUE(writeHeap(heap, folder.path() / "new", "heap.json"));
    const auto back = readHeap(folder.path() / "new" / "heap.json");
    ASSERT_TRUE(back);
    ASSERT_EQ(back->size(), 1U);
    EXPECT_EQ(back->front().stone, "cube");
    EXPECT_EQ(back->front().sizeM, heap[0].sizeM);
    EXPECT_EQ(back->front().placeM, heap[0].placeM);
    EXPECT_EQ(back->front().turn.coeffs(), heap[0].turn.coeffs());
    EXPECT_EQ(back->front().speedMps, heap[0].speedMps);
    std::ofstream(folder / "broken.json") << R"({"format": "edgescan-settled-stones/1", "stones": [{"stone": "cube"}]})";
    EXPECT_FALSE(readHeap(folder / "broken.json"));
    ASSERT_TRUE(writeHeap({{"cube", 1, {0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 0), 0}}, folder.path(), "turned.json"));
    EXPECT_FALSE(readHeap(folder / "turned.json"));
}

TEST(Heaps, StonesComeToRestOnTheFloorAndASeedGivesTheSameHeap) {
    if (!canSettle()) GTEST_SKIP() << "this build has no physics: libbullet-dev is missing";
    auto site = siteOf("bench", 3);
    ASSERT_TRUE(site);
    site->sizes.count = 8;
    const Stones stones = cubes();
    const auto heap = settledHeap(*site, stones, "all", 3), again = settledHeap(*site, stones, "all", 3);
    ASSERT_TRUE(heap && again);
    ASSERT_EQ(heap->size(), 8U);
    for (std::size_t n = 0; n < heap->size(); ++n) {
        const RestingStone& stone = (*heap)[n];
        EXPECT_EQ(stone.placeM, (*again)[n].placeM);
        EXPECT_EQ(stone.turn.coeffs(), (*again)[n].turn.coeffs());
        EXPECT_LT(stone.speedMps, 0.3);
        EXPECT_GT(stone.placeM.z(), -2.5);
        EXPECT_LT(stone.placeM.z(), -2.4 + 2 * stone.sizeM);
    }
    const auto cancelled = settledHeap(*site, stones, "all", 3, [](double) { return false; });
    EXPECT_EQ(cancelled.error().what, "cancelled");
}

TEST(StoneScans, TheSameForAnyNumberOfThreadsAndOfTheSameHeapFromEachView) {
    const test::TemporaryFolder folder;
    test::writeCubeHeap(folder.path());
    const Stones stones = cubes();
    StoneScene scene;
    scene.settled = folder.path();
    const auto one = stoneScan(scene, stones, 1), three = stoneScan(scene, stones, 3);
    ASSERT_TRUE(one && three);
    EXPECT_EQ(one->simulation.scan.name, "bench-free-seed1-view0");
    EXPECT_EQ(one->simulation.scan.lines(), 400);
    EXPECT_EQ(one->simulation.scan.beams(), 500);
    EXPECT_EQ(one->simulation.scan.rangeMm, three->simulation.scan.rangeMm);
    EXPECT_EQ(one->truth.edges.edgeClass, three->truth.edges.edgeClass);
    EXPECT_EQ(one->truth.edges.ignore, three->truth.edges.ignore);
    scene.view = 1;
    const auto moved = stoneScan(scene, stones);
    ASSERT_TRUE(moved);
    EXPECT_NE(one->simulation.scan.rangeMm, moved->simulation.scan.rangeMm);
    for (const auto& scan : {*one, *moved}) {
        for (const int cube : {2, 3}) EXPECT_GT(std::ranges::count(scan.truth.object.cells, cube), 500);
        EXPECT_GT(std::ranges::count(scan.truth.edges.edgeClass.cells, 1), 200); // outlines of the cubes
        EXPECT_GT(std::ranges::count(scan.truth.edges.edgeClass.cells, 3), 50);  // their creases
        ASSERT_EQ(scan.simulation.truth->rocks.size(), 2U);
        const auto& cube = scan.simulation.truth->rocks[0];
        EXPECT_EQ(cube.object, 2);
        EXPECT_NEAR(cube.spansM[0], 0.6 * std::sqrt(3.0), 1e-6);             // the diagonal
        EXPECT_NEAR(cube.spansM[1], 0.6 * 2.0 * std::sqrt(2.0 / 3.0), 1e-6); // across it, the hexagon of the corners
        EXPECT_NEAR(cube.volumeM3, 0.216, 1e-6);
        EXPECT_NEAR(cube.centreM.norm(), Eigen::Vector3d(0, -1.2, -2.1).norm(), scan.simulation.scan.name.ends_with("0") ? 1e-5 : 1.0);
    }
}

TEST(StoneScans, WhatIsNotThereIsNamed) {
    const Stones stones = cubes("lab");
    const test::TemporaryFolder folder;
    test::writeCubeHeap(folder.path());
    StoneScene scene;
    scene.settled = folder.path();
    EXPECT_EQ(stoneScan(scene, stones).error().what, "the heap has the stone cube, which is not there");
    scene.kind = "cave";
    EXPECT_EQ(stoneScan(scene, stones).error().what, "there is no kind of scene \"cave\"");
}

TEST(StoneScans, RealStonesOfTheFolderAreRead) {
    EDGESCAN_NEEDS_SHARED("data/real_stones/stones");
    const auto stones = readStones(test::sharedFolder() / "data/real_stones/stones", "lab");
    ASSERT_TRUE(stones);
    EXPECT_GE(stones->stones.size(), 10U);
    for (const Stone& stone : stones->stones) EXPECT_GT(stone.mesh->triangles().size(), 2000U);
}

} // namespace
} // namespace edgescan::lab
