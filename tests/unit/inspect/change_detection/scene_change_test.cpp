// Changes between scans: compared with slow versions, and on the simulator's bell before and after a blast.
#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/open_scan.h"
#include "core/inspect/change_detection/change_report.h"
#include "core/scan/georef/rotations.h"
#include "tests/support/placements.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace edgescan::inspect {
namespace {

std::shared_ptr<const Scan> bell(int repeat, bool after, int lines = 150, int beams = 190) {
    sim::SimulationSettings settings;
    settings.lines = lines;
    settings.beams = beams;
    settings.repeat = repeat;
    settings.afterBlast = after;
    return std::make_shared<const Scan>(sim::simulate(settings)->scan);
}

ScanEdges edgesOf(const std::shared_ptr<const Scan>& scan) { return {scan, edges::detectEdges(scan, {})->mask}; }

TEST(EdgeChanges, AreThoseOfASlowVersion) {
    std::mt19937 dice(5);
    for (int round = 0; round < 60; ++round) {
        const int lines = 1 + static_cast<int>(dice() % 12), beams = 1 + static_cast<int>(dice() % 12),
                  reach = static_cast<int>(dice() % 3);
        Grid<std::uint8_t> later(lines, beams), earlier(lines, beams);
        Grid<CellState> laterState(lines, beams, CellState::Valid), earlierState(lines, beams, CellState::Valid);
        for (std::size_t k = 0; k < later.size(); ++k) {
            later[k] = dice() % 5 == 0 ? 255 : 0;
            earlier[k] = dice() % 5 == 0 ? 255 : 0;
            if (dice() % 2 == 0) laterState[k] = CellState::NoReturn;
            if (dice() % 2 == 0) earlierState[k] = CellState::Lost;
        }
        const auto near = [&](int i, int j, int within, auto is) {
            for (int a = 0; a < lines; ++a) {
                for (int b = 0; b < beams; ++b) {
                    if (std::max(std::abs(a - i), std::abs(b - j)) <= within && is(a, b)) return true;
                }
            }
            return false;
        };
        const EdgeChanges found = edgeChanges(later, earlier, laterState, earlierState, reach);
        std::array<std::size_t, 5> counts{};
        std::size_t earlierUnchanged = 0;
        for (int i = 0; i < lines; ++i) {
            for (int j = 0; j < beams; ++j) {
                const bool hasLater = near(i, j, reach, [&](int a, int b) { return later.at(a, b) != 0; });
                const bool hasEarlier = near(i, j, reach, [&](int a, int b) { return earlier.at(a, b) != 0; });
                const int looks = std::max(1, reach);
                const bool sawLater = near(i, j, looks, [&](int a, int b) { return laterState.at(a, b) == CellState::Valid; });
                const bool sawEarlier = near(i, j, looks, [&](int a, int b) { return earlierState.at(a, b) == CellState::Valid; });
                earlierUnchanged += earlier.at(i, j) != 0 && hasLater ? 1 : 0;
                EdgeChange expected = EdgeChange::None;
                if (later.at(i, j) != 0)
                    expected = hasEarlier ? EdgeChange::Unchanged : sawEarlier ? EdgeChange::Gained : EdgeChange::Unknown;
                else if (earlier.at(i, j) != 0 && !hasLater)
                    expected = sawLater ? EdgeChange::Lost : EdgeChange::Unknown;
                ASSERT_EQ(found.cells.at(i, j), expected) << round << " " << i << " " << j;
                ++counts[static_cast<std::size_t>(expected)];
            }
        }
        EXPECT_EQ(found.unchanged, counts[1]);
        EXPECT_EQ(found.earlierUnchanged, earlierUnchanged);
        EXPECT_EQ(found.gained, counts[2]);
        EXPECT_EQ(found.lost, counts[3]);
        EXPECT_EQ(found.unknown, counts[4]);
    }
}

TEST(SceneChange, OfTwoSweepsOfOneSceneIsNextToNothing) {
    const auto a = bell(0, false), b = bell(1, false);
    const auto change = sceneChange(edgesOf(b), edgesOf(a));
    ASSERT_TRUE(change) << change.error().sentence();
    EXPECT_TRUE(change->earlier.how.sameCells);
    EXPECT_TRUE(change->earlier.how.outOfSpec) << "without poses";
    const RangeChanges& ranges = change->ranges;
    EXPECT_LT(ranges.nearer + ranges.farther, a->cells() / 500);
    EXPECT_GT(ranges.same, a->cells() * 9 / 10);
    EXPECT_TRUE(change->regions.empty());
    EXPECT_GT(change->edges.unchanged, 5 * (change->edges.gained + change->edges.lost) / 2);
}

/// The reported cells are those whose true range changed by more than a rock's relief.
TEST(SceneChange, AfterABlastIsThatOfTheTruth) {
    sim::SimulationSettings settings;
    settings.lines = 150;
    settings.beams = 190;
    settings.truth = true;
    const sim::Simulation before = *sim::simulate(settings);
    settings.afterBlast = true;
    const sim::Simulation after = *sim::simulate(settings);
    const auto a = std::make_shared<const Scan>(before.scan), b = std::make_shared<const Scan>(after.scan);
    const auto change = sceneChange(edgesOf(b), edgesOf(a));
    ASSERT_TRUE(change) << change.error().sentence();
    const auto trueChange = [&](int line, int beam) { return after.truth->cleanMm.at(line, beam) - before.truth->cleanMm.at(line, beam); };
    // A cell whose neighbours all changed by more than any relief, in the same direction.
    const auto isInside = [&](int line, int beam) {
        for (int i = std::max(0, line - 1); i <= std::min(a->lines() - 1, line + 1); ++i) {
            for (int j = std::max(0, beam - 1); j <= std::min(a->beams() - 1, beam + 1); ++j) {
                if (std::abs(trueChange(i, j)) < 300.0F || (trueChange(i, j) > 0) != (trueChange(line, beam) > 0)) return false;
            }
        }
        return true;
    };
    std::size_t told = 0, right = 0, truly = 0, missed = 0;
    for (int line = 0; line < a->lines(); ++line) {
        for (int beam = 0; beam < a->beams(); ++beam) {
            const std::size_t k = a->rangeMm.index(line, beam);
            if (a->state[k] != CellState::Valid || b->state[k] != CellState::Valid) continue;
            const float by = trueChange(line, beam);
            const RangeChange found = change->ranges.cells[k];
            const bool isTold = found == RangeChange::Nearer || found == RangeChange::Farther;
            told += isTold ? 1 : 0;
            right += isTold && std::abs(by) > 20.0F && (by > 0.0F) == (found == RangeChange::Farther) ? 1 : 0;
            if (!isInside(line, beam)) continue;
            ++truly;
            missed += isTold ? 0 : 1;
        }
    }
    ASSERT_GT(truly, 500U);
    EXPECT_GT(right, told * 98 / 100) << told;
    EXPECT_LT(missed, truly / 20) << truly;
    EXPECT_LT(change->differMm, 12.0) << "half of the cells differ by no more than noise";
    ASSERT_GE(change->regions.size(), 3U);
    std::set<bool> ways;
    for (const ChangedRegion& region : change->regions) ways.insert(region.farther);
    EXPECT_EQ(ways.size(), 2U) << "some rocks are gone, others lie nearer than what was behind them";
    EXPECT_GT(change->regions.front().areaM2, 0.5);
    EXPECT_GT(change->edges.gained, 100U);
    EXPECT_GT(change->edges.lost, 100U);
    const auto report = changeReport(*b, *change);
    EXPECT_EQ(report["regions"].size(), change->regions.size());
    EXPECT_EQ(report["lined_up_by"], "surfaces");
    EXPECT_NE(changeText(*b, *change).find("OUT OF SPEC"), std::string::npos);
}

TEST(SceneChange, OfOneScanComparesEdgesCellByCell) {
    const auto scan = bell(0, false);
    edges::Settings other;
    other.method = edges::Method::Canny;
    const auto a = edges::detectEdges(scan, {}), b = edges::detectEdges(scan, other);
    const auto change = sceneChange({scan, b->mask}, {scan, a->mask});
    ASSERT_TRUE(change);
    EXPECT_EQ(change->edges.unchanged + change->edges.lost + change->edges.unknown, a->edges->size());
    EXPECT_GE(change->edges.unchanged + change->edges.gained + change->edges.unknown, b->edges->size());
    EXPECT_EQ(change->ranges.cells.size(), 0U);
    EXPECT_FALSE(change->earlier.how.outOfSpec);
}

/// The same scene in a rotated scan with other steps: its pose brings it back onto the cells.
TEST(LineUp, ByPosesBringsAnotherGridOntoThisOne) {
    const auto later = bell(0, false, 150, 190);
    auto turned = std::make_shared<Scan>(*bell(1, false, 180, 220));
    const double turn = 0.05;
    // Its frame is rotated about x relative to that of the other: the stepper's angle has another zero.
    auto& polar = std::get<PolarGeometry>(turned->geometry);
    for (double& angle : polar.lineDeg) angle -= turn * 180.0 / 3.14159265358979323846;
    const RigidTransform back{rotationX(turn), Eigen::Vector3d::Zero()};
    RegistrationRequest wish;
    wish.poses = std::array{RigidTransform{}, back};
    const auto edges = edgesOf(turned);
    const auto on = earlierOnGridOf(later, turned, edges.mask, wish);
    ASSERT_TRUE(on) << on.error().sentence();
    EXPECT_FALSE(on->how.sameCells);
    EXPECT_FALSE(on->how.outOfSpec) << on->how.warnings.front();
    std::size_t both = 0, alike = 0;
    for (std::size_t k = 0; k < later->cells(); ++k) {
        if (later->state[k] != CellState::Valid || on->scan->state[k] != CellState::Valid) continue;
        ++both;
        alike += std::abs(later->rangeMm[k] - on->scan->rangeMm[k]) < 150.0F ? 1 : 0;
    }
    EXPECT_GT(both, later->cells() * 8 / 10);
    EXPECT_GT(alike, both * 9 / 10);
    const auto change = sceneChange(edgesOf(later), edges, wish);
    ASSERT_TRUE(change);
    EXPECT_GT(change->edges.unchanged, change->edges.gained);
    EXPECT_LT(change->ranges.nearer + change->ranges.farther, both / 50);
    // With a wrong pose the surfaces show the error.
    wish.poses = std::array{RigidTransform{}, RigidTransform{}};
    const auto wrong = earlierOnGridOf(later, turned, edges.mask, wish);
    ASSERT_TRUE(wrong);
    EXPECT_TRUE(wrong->how.outOfSpec);
}

TEST(LineUp, RefusesWhereOnlyOneScanHasAPlace) {
    const auto later = bell(0, false, 60, 80);
    auto placed = std::make_shared<Scan>(*bell(1, false, 60, 80));
    placed->placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
    const auto edges = edgesOf(placed);
    const auto refused = earlierOnGridOf(later, placed, edges.mask);
    ASSERT_FALSE(refused);
    // Positions of the request are not the mine grid, whatever pose one of the scans has.
    RegistrationRequest given;
    given.poses = std::array{RigidTransform{}, RigidTransform{}};
    const auto byGiven = earlierOnGridOf(placed, later, edgesOf(later).mask, given);
    ASSERT_TRUE(byGiven) << byGiven.error().sentence();
    EXPECT_EQ(registrationText(byGiven->how).find("lined up by given positions"), 0U);
    EXPECT_NE(refused.error().sentence().find("has none"), std::string::npos);
    RegistrationRequest wish;
    wish.bySurfaces = true;
    const auto on = earlierOnGridOf(later, placed, edges.mask, wish);
    ASSERT_TRUE(on) << on.error().sentence();
    EXPECT_TRUE(on->how.outOfSpec);
    // Both in one place: each has its own cells.
    auto first = std::make_shared<Scan>(*later);
    first->placement = placed->placement;
    const auto same = earlierOnGridOf(first, placed, edges.mask);
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->how.sameCells);
    EXPECT_FALSE(same->how.outOfSpec) << same->how.warnings.front();
    EXPECT_EQ(same->edges, edges.mask);
}

// Two bells that are not one place fit nowhere: metres of change would be those of the registration.
TEST(SceneChange, AreasAreGivenOnlyWhereTheSurfacesFit) {
    const auto later = bell(0, false);
    sim::SimulationSettings other;
    other.lines = 150;
    other.beams = 190;
    other.seed = 77;
    const auto elsewhere = std::make_shared<const Scan>(sim::simulate(other)->scan);
    const auto change = sceneChange(edgesOf(later), edgesOf(elsewhere));
    ASSERT_TRUE(change) << change.error().sentence();
    ASSERT_GT(change->earlier.how.surfaces->residualM, kMostResidualM);
    EXPECT_GT(change->ranges.nearer + change->ranges.farther, 50U);
    EXPECT_TRUE(change->regions.empty());
    const std::string text = changeText(*later, *change);
    EXPECT_NE(text.find("No areas of change are given."), std::string::npos) << text;
    EXPECT_EQ(text.find("regions of"), std::string::npos) << text;
    EXPECT_TRUE(changeReport(*later, *change)["regions"].empty());
    const auto blasted = sceneChange(edgesOf(bell(1, true)), edgesOf(later));
    ASSERT_TRUE(blasted);
    EXPECT_LT(blasted->earlier.how.surfaces->residualM, kMostResidualM);
    EXPECT_FALSE(blasted->regions.empty());
}

// Two scans of one corridor: fitted from one side only, their surfaces end 64 mm apart.
TEST(SceneChange, AreasDoNotDependOnTheOrderOfTheTwo) {
    const auto folder = test::sharedFolder() / "data/lms200_corridor";
    const auto first = files::openScan(folder / "scan000.3d"), second = files::openScan(folder / "scan001.3d");
    if (!first || !second) GTEST_SKIP() << "needs " << folder;
    const auto a = edgesOf(std::make_shared<const Scan>(*first)), b = edgesOf(std::make_shared<const Scan>(*second));
    const auto forth = sceneChange(b, a), back = sceneChange(a, b);
    ASSERT_TRUE(forth && back);
    EXPECT_LT(forth->earlier.how.surfaces->residualM, kMostResidualM);
    EXPECT_LT(back->earlier.how.surfaces->residualM, kMostResidualM);
    EXPECT_EQ(forth->regions.empty(), back->regions.empty());
}

} // namespace
} // namespace edgescan::inspect
