// Edges of the early view transformed to the late one, compared with a search through all rays of docs/reference/coordinates.md, "Step 1".
#include "app/lab/calibration/seam_edges.h"

#include "app/lab/sim/simulate.h"
#include "core/base/angles.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/scan/georef/rotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::inspect {
namespace {

// Several cells of the sweep below.
AssemblyErrors seamErrors() { return {{30.0, -40.0, 1.0, -0.9, 0.5}}; }

std::shared_ptr<const Scan> turned(double turnDeg, Axis axis = Axis::Spin) {
    sim::SimulationSettings settings;
    settings.axis = axis;
    settings.seed = 33;
    settings.turnDeg = turnDeg;
    settings.lines = static_cast<int>(turnDeg * 2);
    settings.beams = 381;
    settings.assembly = seamErrors();
    const Result<sim::Simulation> simulation = sim::simulate(settings);
    EXPECT_TRUE(simulation);
    return std::make_shared<const Scan>(simulation->scan);
}

} // namespace

TEST(SeamEdges, AnEarlyEdgeLiesWhereTheRayOfTheLateViewPassesNearest) {
    const auto scan = turned(200);
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    const RigidTransform mount = sensorInMover(Axis::Spin, seamErrors());
    const auto turn = [&](int line) {
        return rotationZ(radians(polar.lineDirection * seamErrors().turnFactor() * polar.lineDeg[static_cast<std::size_t>(line)]));
    };
    const auto way = [&](int beam) {
        const double a = radians(polar.beamDeg[static_cast<std::size_t>(beam)]);
        return Eigen::Vector3d(std::cos(a), 0, std::sin(a));
    };
    int tried = 0;
    for (const auto& [line, beam] : {std::pair{12, 50}, {20, 120}, {9, 260}, {24, 310}, {16, 90}, {22, 285}}) {
        if (scan->state.at(line, beam) != CellState::Valid) continue;
        Grid<std::uint8_t> edges(scan->lines(), scan->beams());
        edges.at(line, beam) = 255;
        const SeamEdges seam = seamEdges(*scan, edges, seamErrors());
        const Eigen::Vector3d p = turn(line) * (mount * (0.001 * static_cast<double>(scan->rangeMm.at(line, beam)) * way(beam)));
        int bestLine = 0, bestBeam = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = seam.firstLine; i < scan->lines(); ++i) {
            const Eigen::Vector3d from = turn(i) * mount.translationM;
            for (int j = 0; j < scan->beams(); ++j) {
                const Eigen::Vector3d along = turn(i) * (mount.rotation * way(j));
                const double t = (p - from).dot(along);
                const double off = (p - from - t * along).norm();
                if (t <= 0 || off >= nearest) continue;
                nearest = off;
                bestLine = i;
                bestBeam = j;
            }
        }
        ++tried;
        int found = 0;
        for (int i = 0; i < seam.early.lines; ++i) {
            for (int j = 0; j < seam.early.beams; ++j) {
                if (seam.early.at(i, j) == 0) continue;
                ++found;
                EXPECT_LE(std::abs(i + seam.firstLine - bestLine), 1);
                EXPECT_LE(std::abs(j - bestBeam), 1);
            }
        }
        EXPECT_EQ(found, 1) << line << " " << beam;
    }
    EXPECT_GE(tried, 4);
}

TEST(SeamEdges, MeetOnceTheErrorsAreKnown) {
    for (const double turnDeg : {200.0, 360.0}) {
        const auto scan = turned(turnDeg);
        const auto detection = edges::detectEdges(scan, edges::Settings{});
        const SeamEdges before = seamEdges(*scan, *detection->mask, {});
        const SeamEdges after = seamEdges(*scan, *detection->mask, seamErrors());
        EXPECT_GT(after.lateEdges, 300U);
        EXPECT_GT(after.matchedShare(), 0.6) << turnDeg;
        EXPECT_LT(before.matchedShare(), after.matchedShare() - 0.2) << turnDeg;
        const Grid<Rgb> picture = seamPicture(after);
        EXPECT_EQ(picture.lines, 3 * after.late.lines);
        const Rgb white{255, 255, 255};
        for (int i = 0; i < after.late.lines; ++i) {
            for (int j = 0; j < after.late.beams; ++j)
                ASSERT_EQ(picture.at(3 * i + 1, 3 * j + 1) == white, after.late.at(i, j) != 0 && after.early.at(i, j) != 0);
        }
    }
}

TEST(SeamEdges, OfASweepLieAtTheEndsOfItsAxis) {
    const auto scan = turned(360, Axis::Sweep);
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    Grid<std::uint8_t> edges(scan->lines(), scan->beams(), 1);
    const SeamEdges seam = seamEdges(*scan, edges, seamErrors());
    ASSERT_EQ(seam.late.beams, static_cast<int>(seam.beams.size()));
    EXPECT_GT(seam.lateEdges, 2000U);
    EXPECT_GT(seam.matchedShare(), 0.7); // close to the axis one early cell covers many late lines
    for (const int beam : seam.beams) {
        const double deg = polar.beamDeg[static_cast<std::size_t>(beam)];
        EXPECT_LE(std::min(std::abs(deg), std::abs(180 - deg)), 5.001);
    }
    // An edge of one cell: its mirror image half a turn later, for an ideal assembly.
    const int line = 100, beam = 4;
    edges = Grid<std::uint8_t>(scan->lines(), scan->beams());
    edges.at(line, beam) = 1;
    ASSERT_EQ(scan->state.at(line, beam), CellState::Valid);
    const SeamEdges one = seamEdges(*scan, edges, {});
    const double lateDeg = polar.lineDeg[100] + 180, mirrored = -polar.beamDeg[4];
    for (int i = 0; i < one.early.lines; ++i) {
        for (int j = 0; j < one.early.beams; ++j) {
            if (one.early.at(i, j) == 0) continue;
            EXPECT_NEAR(polar.lineDeg[static_cast<std::size_t>(one.firstLine + i)], lateDeg, 0.51);
            EXPECT_NEAR(polar.beamDeg[static_cast<std::size_t>(one.beams[static_cast<std::size_t>(j)])], mirrored, 0.51);
        }
    }
    EXPECT_EQ(std::ranges::count(one.early.cells, 1), 1);
}

TEST(SeamEdges, AreNoneWhereNothingIsSeenTwice) {
    for (const auto& scan : {turned(180), turned(180, Axis::Sweep)}) {
        const SeamEdges seam = seamEdges(*scan, Grid<std::uint8_t>(scan->lines(), scan->beams(), 255), {});
        EXPECT_EQ(seam.late.lines, 0);
        EXPECT_EQ(seam.lateEdges, 0U);
    }
}

} // namespace edgescan::inspect
