// Rounded rocks: their surface is one radius off the core everywhere, and truth has edges where such a surface has some.
#include "app/lab/sim/caster.h"
#include "app/lab/sim/cell_seams.h"
#include "app/lab/sim/convex_rock.h"
#include "app/lab/sim/rounded_core.h"
#include "app/lab/sim/truth/truth.h"
#include "core/scan/grid/cartesian.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan::sim {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

Points cube(double half, const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
    Points corners;
    for (const double x : {-half, half})
        for (const double y : {-half, half})
            for (const double z : {-half, half}) corners.push_back(turn * Vector3d{x, y, z});
    return corners;
}

Vector3d nearestOnSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    return a + std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) * (b - a);
}

/// The point of a hull that is nearest to a point outside, triangle by triangle.
Vector3d nearestOnHull(const RoundedCore& core, const Vector3d& p) {
    Vector3d best = core.corners.front();
    for (const HullTriangle& t : core.hull) {
        std::array<Vector3d, 3> corner;
        for (std::size_t e = 0; e < 3; ++e) corner[e] = core.corners[static_cast<std::size_t>(t[e])];
        const Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
        const Vector3d foot = p - normal.dot(p - corner[0]) * normal;
        bool over = true;
        for (std::size_t e = 0; e < 3; ++e) over = over && normal.dot((corner[(e + 1) % 3] - corner[e]).cross(foot - corner[e])) >= 0.0;
        Points candidates;
        if (over) candidates.push_back(foot);
        for (std::size_t e = 0; e < 3; ++e) candidates.push_back(nearestOnSegment(p, corner[e], corner[(e + 1) % 3]));
        for (const Vector3d& c : candidates)
            if ((c - p).norm() < (best - p).norm()) best = c;
    }
    return best;
}

TEST(SimRoundedRock, AWornCubeHasItsKnownMeasures) {
    const Points corners = cube(1.0);
    const RoundedCore sharp = roundedCore(corners, convexHull(corners), 0.0);
    EXPECT_EQ(sharp.radiusM, 0.0);
    EXPECT_TRUE(sharp.ridges.empty());
    EXPECT_NEAR(sharp.volumeM3, 8.0, 1e-9);
    const double r = 0.4;
    const double c = 1.0 - r;
    const RoundedCore worn = roundedCore(corners, convexHull(corners), r);
    EXPECT_NEAR(worn.radiusM, r, 1e-9);
    EXPECT_EQ(worn.ridges.size(), 12U); // the diagonals of its sides are not ridges
    const double pi = std::numbers::pi;
    EXPECT_NEAR(worn.volumeM3, 8 * c * c * c + 24 * c * c * r + 12 * 2 * c * pi * r * r / 4 + 4.0 / 3 * pi * r * r * r, 1e-6);
    Scene scene;
    addRock(scene, corners, {0, 0, 5}, r);
    EXPECT_NEAR(scene.rocks[0].spansM[0], 2 * c * std::sqrt(3.0) + 2 * r, 1e-5);
    EXPECT_NEAR(scene.rocks[0].volumeM3, worn.volumeM3, 1e-5);
    EXPECT_NEAR(scene.bodies[0].box.max().z(), 6.0, 1e-5); // flat sides keep their place
    EXPECT_NEAR(scene.bodies[0].box.min().x(), -1.0, 1e-5);
}

TEST(SimRoundedRock, RaysEndOneRadiusOffTheCoreAndNotBehindIt) {
    RandomSequence dice(31, Purpose::Shapes);
    int hit = 0;
    int missed = 0;
    int round = 0;
    for (int trial = 0; trial < 24; ++trial) {
        const Points corners = rockCorners(dice.uniform(0.3, 2.5), dice);
        const Vector3d centre{dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(3, 9)};
        const double share = dice.uniform(0.05, 0.9);
        Scene scene;
        addRock(scene, corners, centre, share);
        const RoundedCore core = roundedCore(corners, convexHull(corners), share);
        for (int ray = 0; ray < 20; ++ray) {
            const Vector3d aim = centre + Vector3d{dice.normal(), dice.normal(), dice.normal()} * 0.5;
            const RayBundle bundle = bundleAlong(aim.normalized(), {});
            BundleHits hits;
            meet(scene.bodies[0], bundle, hits);
            const auto heightAt = [&](double t) {
                const Vector3d p =
                    Vector3d(bundle.ox[0], bundle.oy[0], bundle.oz[0]) + t * Vector3d(bundle.dx[0], bundle.dy[0], bundle.dz[0]) - centre;
                return (p - nearestOnHull(core, p)).norm() - core.radiusM;
            };
            const bool met = hits.surface[0] >= 0;
            const double end = met ? static_cast<double>(hits.distanceM[0]) : centre.norm() + 4.0;
            for (int n = 0; n < 40; ++n) EXPECT_GT(heightAt(end * n / 40.0), -1e-4) << "the ray went through rock";
            if (!met) {
                ++missed;
                continue;
            }
            ++hit;
            EXPECT_NEAR(heightAt(end), 0.0, 1e-4);
            const Surface& surface = scene.surfaces[static_cast<std::size_t>(hits.surface[0])];
            round += surface.ridge >= 0 ? 1 : 0;
            const Eigen::Vector3f place = placeOf(bundle, hits, 0);
            const Vector3d p = place.cast<double>() - centre;
            const Vector3d outward = (p - nearestOnHull(core, p)).normalized();
            EXPECT_GT(outward.dot(normalAt(scene, surface, place).cast<double>()), 0.9999);
        }
    }
    EXPECT_GT(hit, 100);
    EXPECT_GT(missed, 50);
    EXPECT_GT(round, 40);
    EXPECT_GT(hit - round, 20);
}

TEST(SimRoundedRock, TurnsAndGrowsWithItsScene) {
    RandomSequence dice(33, Purpose::Shapes);
    Scene scene;
    addRock(scene, rockCorners(1.5, dice), {0.3, -0.2, 4.0}, 0.5);
    const Eigen::Matrix3f turn = Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
    const Scene other = rotated(scaled(scene, 2.0F), turn);
    int round = 0;
    for (int ray = 0; ray < 200; ++ray) {
        const Vector3d aim = (Vector3d{0.3, -0.2, 4.0} + 0.3 * Vector3d{dice.normal(), dice.normal(), dice.normal()}).normalized();
        const Footprint line{0.0, 0.0};
        BundleHits here;
        BundleHits there;
        meet(scene.bodies[0], bundleAlong(aim, line), here);
        meet(other.bodies[0], bundleAlong(turn.cast<double>() * aim, line), there);
        ASSERT_EQ(here.surface[0], there.surface[0]);
        if (here.surface[0] < 0) continue;
        EXPECT_NEAR(2.0F * here.distanceM[0], there.distanceM[0], 1e-3);
        round += scene.surfaces[static_cast<std::size_t>(here.surface[0])].ridge >= 0 ? 1 : 0;
    }
    EXPECT_GT(round, 20);
}

/// A cube of 1 m, 5 m away, one ridge towards the scanner, in front of a wall; cells are 35 mm wide there.
struct Cube {
    Scan scan;
    SimulationTruth truth;
    EdgeTruth edges;

    explicit Cube(double rounding) {
        constexpr int kCells = 70;
        PolarGeometry polar;
        polar.axis = Axis::Sweep;
        for (int i = 0; i < kCells; ++i) polar.lineDeg.push_back(0.4 * (i - kCells / 2));
        for (int j = 0; j < kCells; ++j) polar.beamDeg.push_back(90.0 + 0.4 * (j - kCells / 2));
        scan.geometry = polar;
        scan.rangeMm = {kCells, kCells};
        scan.state = {kCells, kCells, CellState::Valid};
        const CartesianTables tables(scan);
        const Vector3d ahead = tables.direction(kCells / 2, kCells / 2);
        const Vector3d across = tables.direction(kCells / 2 + 1, kCells / 2) - ahead;
        Eigen::Matrix3d turn;
        turn.col(0) = (ahead + across.normalized()).normalized();
        turn.col(1) = (ahead - across.normalized()).normalized();
        turn.col(2) = turn.col(0).cross(turn.col(1));
        Scene scene;
        addRock(scene, cube(0.5, turn), 5.0 * ahead, rounding);
        const auto plate = [&](int i, int j) {
            return Vector3d(9.0 * ahead + 9.0 * (i - 0.5) * turn.col(2) + 9.0 * (j - 0.5) * across.normalized());
        };
        addLattice(scene, scene.solids, {2, 2, false, plate}, {.texture = Texture::Smooth});
        const RayCaster caster(scene, {});
        truth = {{kCells, kCells},
                 {kCells, kCells},
                 {kCells, kCells},
                 {kCells, kCells, Eigen::Vector3f::Zero().eval()},
                 {kCells, kCells},
                 {kCells, kCells},
                 {kCells, kCells},
                 {kCells, kCells},
                 {}};
        for (std::size_t k = 0; k < truth.object.size(); ++k) {
            const Vector3d direction = tables.direction(static_cast<int>(k) / kCells, static_cast<int>(k) % kCells);
            const RayBundle bundle = bundleAlong(direction, {});
            const BundleHits hits = caster.cast(bundle);
            const Surface& surface = scene.surfaces[static_cast<std::size_t>(hits.surface[0])];
            truth.object[k] = surface.object;
            truth.face[k] = surface.face;
            truth.cleanMm[k] = 1000.0F * hits.distanceM[0];
            truth.normal[k] = normalAt(scene, surface, placeOf(bundle, hits, 0));
            truth.rounded[k] = surface.ridge >= 0 ? 1 : 0;
        }
        for (int i = 0; i < kCells; ++i) findSeams({scene, caster, {&tables, &tables}}, i, truth);
        edges = edgeTruth(truth);
    }

    [[nodiscard]] long count(EdgeClass wanted) const {
        return std::ranges::count(edges.edgeClass.cells, static_cast<std::uint8_t>(wanted));
    }
    /// Cells that are not scored in the row that crosses the middle of the ridge.
    [[nodiscard]] int unscored() const {
        int cells = 0;
        for (int i = 0; i < scan.lines(); ++i) cells += edges.ignore.at(i, scan.beams() / 2) != 0 ? 1 : 0;
        return cells;
    }
};

TEST(SimRoundedRock, AFoldIsACreaseOnlyWhileItTurnsWithinOneCell) {
    const Cube sharp(0.0);
    const long ridge = sharp.count(EdgeClass::Crease);
    EXPECT_GT(ridge, 20);
    EXPECT_EQ(sharp.unscored(), 0);

    const Cube hardly(0.01); // 5 mm: not visible
    EXPECT_NEAR(static_cast<double>(hardly.count(EdgeClass::Crease)), static_cast<double>(ridge), 3.0);

    const Cube worn(0.3); // 150 mm: 90 degrees over 7 cells
    EXPECT_EQ(worn.count(EdgeClass::Crease), 0);
    EXPECT_GT(worn.unscored(), 4);
    EXPECT_LT(worn.unscored(), 12);

    const Cube round(0.9); // 450 mm: 90 degrees over 18 cells and more
    EXPECT_EQ(round.count(EdgeClass::Crease), 0);
    EXPECT_EQ(round.unscored(), 0);
}

TEST(SimRoundedRock, ItsOutlineStaysAnOutline) {
    for (const double rounding : {0.0, 0.3, 0.9}) {
        const Cube rock(rounding);
        long rim = 0; // rock cells next to the wall
        for (int i = 1; i + 1 < rock.scan.lines(); ++i) {
            for (int j = 1; j + 1 < rock.scan.beams(); ++j) {
                const Grid<std::uint16_t>& object = rock.truth.object;
                const bool beside =
                    object.at(i - 1, j) == 1 || object.at(i + 1, j) == 1 || object.at(i, j - 1) == 1 || object.at(i, j + 1) == 1;
                if (object.at(i, j) != 2 || !beside) continue;
                ++rim;
                bool found = false; // thinning removes corners of stairs
                for (int di = -1; di <= 1; ++di)
                    for (int dj = -1; dj <= 1; ++dj) {
                        const bool occluding = rock.edges.edgeClass.at(i + di, j + dj) == static_cast<std::uint8_t>(EdgeClass::Occluding);
                        found = found || (occluding && rock.edges.ignore.at(i + di, j + dj) == 0);
                    }
                EXPECT_TRUE(found) << rounding << ": " << i << ", " << j;
            }
        }
        EXPECT_GT(rim, 80);
    }
}

TEST(SimRoundedRock, RoundingTakesCreasesOfAPileAndLeavesOutlines) {
    const auto truthOf = [](double rounding) {
        SimulationSettings settings;
        settings.scene = "pile";
        settings.lines = 200;
        settings.beams = 230;
        settings.rocks = 60;
        settings.rockRounding = rounding;
        settings.truth = true;
        const Result<Simulation> pile = simulate(settings);
        EdgeTruth truth = edgeTruth(*pile->truth);
        for (std::size_t k = 0; k < truth.edgeClass.size(); ++k) {
            if (pile->truth->object[k] < kFirstRock) truth.edgeClass[k] = 0; // the wall's own edges remain
        }
        return truth;
    };
    const auto count = [](const EdgeTruth& truth, EdgeClass wanted) {
        return static_cast<double>(std::ranges::count(truth.edgeClass.cells, static_cast<std::uint8_t>(wanted)));
    };
    const EdgeTruth sharp = truthOf(0.0);
    const EdgeTruth worn = truthOf(0.8);
    EXPECT_LT(count(worn, EdgeClass::Crease), 0.5 * count(sharp, EdgeClass::Crease));
    EXPECT_GT(count(worn, EdgeClass::Occluding), 0.8 * count(sharp, EdgeClass::Occluding));
    SimulationSettings nonsense;
    nonsense.rockRounding = 1.0;
    const auto refused = simulate(nonsense);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().sentence(), "simulate: rock rounding is 1; use 0 to 0.9.");
}

} // namespace
} // namespace edgescan::sim
