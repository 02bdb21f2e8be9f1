// Backlash from two passes, compared with the shift of the stepper's zero in the simulator.
#include "app/lab/calibration/backlash.h"

#include "app/lab/sim/simulate.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

// The second half of a turn, with the stepper `aheadDeg` ahead of its recorded angles.
Scan passOf(double aheadDeg, std::uint64_t seed, int repeat, Axis axis) {
    sim::SimulationSettings settings;
    settings.axis = axis;
    settings.seed = seed;
    settings.repeat = repeat;
    settings.lines = 360;
    settings.beams = 286;
    settings.zeroJumpDeg = aheadDeg;
    Result<sim::Simulation> simulation = sim::simulate(settings);
    EXPECT_TRUE(simulation);
    Scan scan = std::move(simulation->scan);
    for (int i = 0; i < 185; ++i) std::fill_n(scan.state.line(i), scan.beams(), CellState::NoReturn);
    return scan;
}

// As the stepper measures on its way back: last line first.
Scan turnedRound(const Scan& scan) {
    Scan back = scan;
    auto& polar = std::get<PolarGeometry>(back.geometry);
    std::ranges::reverse(polar.lineDeg);
    for (int i = 0; i < scan.lines(); ++i) {
        std::copy_n(scan.rangeMm.line(scan.lines() - 1 - i), scan.beams(), back.rangeMm.line(i));
        std::copy_n(scan.state.line(scan.lines() - 1 - i), scan.beams(), back.state.line(i));
    }
    return back;
}

TEST(Backlash, IsWhatTheStepperLagsBehind) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        const Scan there = passOf(0, 41, 0, axis);
        for (const double ahead : {-0.3, 0.0, 0.15}) {
            const Result<Backlash> found = backlashOf(there, turnedRound(passOf(ahead, 41, 1, axis)));
            ASSERT_TRUE(found) << found.error().sentence();
            EXPECT_NEAR(found->deg, ahead, 3 * found->sdDeg) << ahead;
            EXPECT_LT(found->sdDeg, 0.02);
            EXPECT_GT(found->sdDeg, 0.0001);
            if (ahead < 0) {
                EXPECT_LT(found->apartAfterMm, found->apartBeforeMm);
            }
        }
    }
}

TEST(Backlash, WhatDoesNotFitIsRefused) {
    const Scan there = passOf(0, 41, 0, Axis::Spin);
    Scan others = there;
    for (double& deg : std::get<PolarGeometry>(others.geometry).beamDeg) deg += 1;
    EXPECT_FALSE(backlashOf(there, others));
    Scan elsewhere = there;
    for (double& deg : std::get<PolarGeometry>(elsewhere.geometry).lineDeg) deg += 400;
    EXPECT_FALSE(backlashOf(there, elsewhere));
}

} // namespace
} // namespace edgescan::inspect
