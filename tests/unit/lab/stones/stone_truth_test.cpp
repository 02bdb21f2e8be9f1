// The true edges of scanned meshes: where two surfaces meet or are apart is known here.
#include "app/lab/sim/sweep.h"
#include "app/lab/stones/stone_truth.h"

#include <gtest/gtest.h>

namespace edgescan::lab {
namespace {

using sim::EdgeClass;

/// A flat piece with a corner and two sides.
sim::MeshCopy piece(const Eigen::Vector3f& corner, const Eigen::Vector3f& along, const Eigen::Vector3f& up, std::uint16_t object) {
    std::vector<Eigen::Vector3f> points{corner, corner + along, corner + up, corner + along + up};
    std::vector<sim::StoredMesh::Corners> triangles{{0, 1, 2}, {1, 3, 2}};
    return {.mesh = std::make_shared<const sim::StoredMesh>(std::move(points), std::move(triangles)), .object = object};
}

constexpr int kLines = 60, kBeams = 80;
constexpr double kStepDeg = 0.2;

/// Beam 40 and line 30 look along z.
sim::TruthSet truthOf(const sim::Scene& scene, int threads = 1) {
    PolarGeometry polar;
    polar.axis = Axis::Sweep;
    for (int j = 0; j < kBeams; ++j) polar.beamDeg.push_back(90 + kStepDeg * (j - kBeams / 2 + 0.5));
    for (int i = 0; i < kLines; ++i) polar.lineDeg.push_back(kStepDeg * (i - kLines / 2 + 0.5));
    sim::SimulationSettings settings;
    settings.lines = kLines;
    settings.beams = kBeams;
    settings.absorbingPatches = 0;
    settings.truth = true;
    settings.threads = threads;
    const auto simulation = sim::sweepScene(scene, polar, settings);
    EXPECT_TRUE(simulation);
    return stoneTruth(scene, *simulation, settings);
}

sim::Scene wallWith(const std::vector<sim::MeshCopy>& pieces) {
    sim::Scene scene;
    scene.copies = pieces;
    scene.copies.push_back(piece({-3, -3, 4}, {6, 0, 0}, {0, 6, 0}, sim::kWallObject));
    return scene;
}

/// Share of the lines, without the outermost five, on which the cells next to the middle beam have the class.
double shareInTheMiddle(const sim::TruthSet& truth, EdgeClass wanted) {
    int lines = 0;
    for (int i = 5; i < kLines - 5; ++i) {
        bool found = false;
        for (int j = kBeams / 2 - 2; j <= kBeams / 2 + 1; ++j)
            found = found || truth.edges.edgeClass.at(i, j) == static_cast<std::uint8_t>(wanted);
        lines += found ? 1 : 0;
    }
    return lines / (kLines - 10.0);
}

int countOf(const sim::TruthSet& truth, EdgeClass wanted) {
    return static_cast<int>(std::ranges::count(truth.edges.edgeClass.cells, static_cast<std::uint8_t>(wanted)));
}

TEST(StoneTruth, AFlatWallHasNoEdge) {
    const sim::TruthSet truth = truthOf(wallWith({}));
    EXPECT_EQ(std::ranges::count(truth.edges.edgeClass.cells, 0), kLines * kBeams);
    EXPECT_EQ(std::ranges::count(truth.edges.ignore.cells, 0), kLines * kBeams);
    EXPECT_EQ(truth.object.at(3, 3), sim::kWallObject);
    EXPECT_NEAR(truth.cleanMm.at(kLines / 2, kBeams / 2), 4000, 2);
}

TEST(StoneTruth, AJumpIsAnEdgeOfTheNearerBody) {
    const sim::TruthSet truth = truthOf(wallWith({piece({0, -3, 3}, {3, 0, 0}, {0, 6, 0}, 2)}));
    EXPECT_DOUBLE_EQ(shareInTheMiddle(truth, EdgeClass::Occluding), 1.0);
    EXPECT_EQ(countOf(truth, EdgeClass::Occluding), kLines);
    for (std::size_t k = 0; k < truth.object.size(); ++k) {
        if (truth.edges.edgeClass[k] != 0) {
            EXPECT_EQ(truth.object[k], 2);
        }
    }
}

// A jump of 30 mm is not an edge for sure.
TEST(StoneTruth, ASmallJumpIsAContactOfTwoBodiesAndNotScoredOnOne) {
    const auto step = [](std::uint16_t object) {
        sim::Scene scene;
        scene.copies = {piece({-3, -3, 3}, {3, 0, 0}, {0, 6, 0}, 2), piece({0, -3, 2.97F}, {3, 0, 0}, {0, 6, 0}, object)};
        return scene;
    };
    EXPECT_DOUBLE_EQ(shareInTheMiddle(truthOf(step(3)), EdgeClass::Contact), 1.0);
    const sim::TruthSet one = truthOf(step(2));
    EXPECT_EQ(std::ranges::count(one.edges.edgeClass.cells, 0), kLines * kBeams);
    EXPECT_EQ(one.edges.ignore.at(kLines / 2, kBeams / 2), 255);
}

// Two pieces that meet in the middle at 60 degrees: of two bodies, or of one.
TEST(StoneTruth, AFoldIsAContactOfTwoBodiesAndACreaseOfOne) {
    const auto fold = [](std::uint16_t object, float slope) {
        sim::Scene scene;
        scene.copies = {piece({0, -3, 3}, {-3, 0, 3 * slope}, {0, 6, 0}, 2), piece({0, -3, 3}, {3, 0, 3 * slope}, {0, 6, 0}, object)};
        return scene;
    };
    const sim::TruthSet two = truthOf(fold(3, 0.577F)), one = truthOf(fold(2, 0.577F));
    EXPECT_DOUBLE_EQ(shareInTheMiddle(two, EdgeClass::Contact), 1.0);
    EXPECT_DOUBLE_EQ(shareInTheMiddle(one, EdgeClass::Crease), 1.0);
    EXPECT_EQ(countOf(one, EdgeClass::Contact), 0);
    // 15 degrees on each side: too weak to be scored
    const sim::TruthSet weak = truthOf(fold(2, 0.268F));
    EXPECT_EQ(countOf(weak, EdgeClass::Crease), 0);
    EXPECT_GT(std::ranges::count(weak.edges.ignore.cells, 255), kLines / 2);
}

TEST(StoneTruth, TheRimOfTheOpenIsAnEdge) {
    sim::Scene scene;
    scene.copies = {piece({0, -3, 3}, {3, 0, 0}, {0, 6, 0}, 2)};
    EXPECT_DOUBLE_EQ(shareInTheMiddle(truthOf(scene), EdgeClass::Void), 1.0);
}

TEST(StoneTruth, StonesOfAFewCellsAreNotScored) {
    const sim::TruthSet truth = truthOf(wallWith({piece({0, 0, 3}, {0.03F, 0, 0}, {0, 0.03F, 0}, 2)}));
    EXPECT_GT(std::ranges::count(truth.object.cells, 2), 0);
    EXPECT_EQ(std::ranges::count(truth.edges.edgeClass.cells, 0), kLines * kBeams);
    EXPECT_GT(std::ranges::count(truth.edges.ignore.cells, 255), 4);
}

TEST(StoneTruth, IsTheSameForAnyNumberOfThreads) {
    const sim::Scene scene = wallWith({piece({0, -1, 3}, {1, 0, 0.5F}, {0, 2, 0}, 2), piece({0, -1, 3}, {-1, 0, 0.7F}, {0, 2, 0}, 3)});
    const sim::TruthSet one = truthOf(scene, 1), three = truthOf(scene, 3);
    EXPECT_EQ(one.edges.edgeClass, three.edges.edgeClass);
    EXPECT_EQ(one.edges.ignore, three.edges.ignore);
    EXPECT_EQ(one.cleanMm, three.cleanMm);
}

} // namespace
} // namespace edgescan::lab
