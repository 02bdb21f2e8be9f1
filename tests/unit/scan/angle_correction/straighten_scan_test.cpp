// Angles estimated from the surfaces of a sweep: interlaced beams and slipped lines return to the angles at which they were measured.
#include "core/scan/angle_correction/straighten_scan.h"

#include "app/lab/sim/simulate.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace edgescan {
namespace {

sim::SimulationSettings smallBell() {
    sim::SimulationSettings settings;
    settings.lines = 250;
    settings.beams = 286;
    settings.seed = 3;
    return settings;
}

const PolarGeometry& anglesOf(const Scan& scan) { return std::get<PolarGeometry>(scan.geometry); }

TEST(Straighten, InterlacedBeamsGetTheirSkew) {
    sim::SimulationSettings settings = smallBell();
    const double stepDeg = 180.0 / settings.lines;
    for (const double displacement : {0.5 * stepDeg, -0.4 * stepDeg}) {
        settings.interlaceDeg = displacement;
        const Scan nominal = sim::simulate(settings)->scan;
        const Scan straight = straightened(nominal);
        const auto& skew = anglesOf(straight).lineSkewDeg;
        ASSERT_EQ(skew.size(), static_cast<std::size_t>(settings.beams)) << displacement;
        EXPECT_NEAR(skew[1] - skew[0], displacement, 0.2 * std::abs(displacement));
        EXPECT_EQ(straight.rangeMm, nominal.rangeMm);
        EXPECT_NE(straight.warnings.back().find("Straightened"), std::string::npos);
    }
}

TEST(Straighten, DisplacementsAreReportedAndNoLongerAfterStraightening) {
    sim::SimulationSettings settings = smallBell();
    settings.interlaceDeg = -0.36;
    const Scan nominal = sim::simulate(settings)->scan;
    const std::optional<std::string> warning = displacementWarning(nominal);
    ASSERT_TRUE(warning);
    EXPECT_TRUE(isDisplacementWarning(*warning));
    EXPECT_NE(warning->find(" degrees behind even ones"), std::string::npos) << *warning;
    EXPECT_NE(warning->find("--straighten"), std::string::npos) << *warning;
    const double degrees = std::stod(warning->substr(warning->find("odd beams lie ") + 14));
    EXPECT_NEAR(degrees, 0.36, 0.08) << *warning;
    const Scan straight = straightened(nominal);
    EXPECT_FALSE(displacementWarning(straight));
    EXPECT_EQ(anglesOf(straightened(straight)), anglesOf(straight)); // not moved twice
}

TEST(Straighten, SlipsAreReportedWithoutDisplacedBeams) {
    Scan scan = test::makeScan(
        250, 286, [](int i, int) { return std::round(2000.0 / std::cos((25 + 0.25 * (i < 180 ? i : i + 2)) * std::numbers::pi / 180)); });
    const std::optional<std::string> warning = displacementWarning(scan);
    ASSERT_TRUE(warning);
    EXPECT_NE(warning->find("the stepper slipped at 1 line (first at line 180, by up to 0.50 degrees, "), std::string::npos) << *warning;
    EXPECT_NE(warning->find(" times the usual unevenness of its steps)"), std::string::npos) << *warning;
    EXPECT_EQ(warning->find("odd beams"), std::string::npos) << *warning;
    const Scan straight = straightened(scan);
    EXPECT_TRUE(
        straight.warnings.back().starts_with("Straightened: the stepper slipped at 1 line (first at line 180, by up to 0.50 degrees, "));
    EXPECT_FALSE(displacementWarning(straight));
}

// At line 180 an object begins in front of a slanted wall, on 36 of 286 beams; the surface on the other beams hardly slants, but a slip of
// that size would show on it.
TEST(Straighten, AnOutlineNextToSlantedSurfacesIsNoSlipInAnyOrderOfLines) {
    const auto range = [](int i, int j) {
        const double inverse = j >= 120 && j < 156 ? (i < 180 ? 0.15 : 0.163) + 0.001 * (i - 180) : 0.2 + 0.0001 * (i - 180); // 1/m
        return std::round(1000 / (inverse + 0.0001 * ((i * 7 + j * 13) % 5 - 2)));
    };
    EXPECT_FALSE(displacementWarning(test::makeScan(250, 286, range)));
    EXPECT_FALSE(displacementWarning(test::makeScan(250, 286, [&](int i, int j) { return range(249 - i, j); })));
}

// Steps with a variation of one eighth: random outliers among them are not slips.
TEST(Straighten, AnUnevenMotorDoesNotSlip) {
    sim::SimulationSettings settings;
    settings.scene = "empty";
    settings.axis = Axis::Spin;
    settings.seed = 5002;
    settings.lines = 350;
    settings.beams = 400;
    settings.lineJitterDeg = 0.06;
    EXPECT_FALSE(displacementWarning(sim::simulate(settings)->scan));
}

TEST(Straighten, StraightScenesGiveNoWarning) {
    for (const char* scene : {"hangup", "pile", "empty", "wall", "staircase"}) {
        sim::SimulationSettings settings = smallBell();
        settings.scene = scene;
        settings.dropouts = 0.1;
        settings.lineJitterDeg = 0.03;
        EXPECT_EQ(displacementWarning(sim::simulate(settings)->scan).value_or(""), "") << scene;
    }
}

TEST(Straighten, AStraightSweepStaysAsItIs) {
    const Scan nominal = sim::simulate(smallBell())->scan;
    const Scan same = straightened(nominal);
    EXPECT_EQ(anglesOf(same), anglesOf(nominal));
    EXPECT_NE(same.warnings.back().find("the angles stay"), std::string::npos);
}

TEST(Straighten, LinesBehindASlipAreMovedOn) {
    // A wall seen at an increasingly grazing angle.
    Scan scan =
        test::makeScan(250, 286, [](int i, int) { return std::round(2000.0 / std::cos((25 + 0.25 * i) * std::numbers::pi / 180)); });
    const PolarGeometry before = anglesOf(scan);
    // The stepper made three steps at once at line 180, and two of them were not counted.
    const int cut = 180;
    const int lost = 2;
    Scan slipped = scan;
    for (int i = cut; i + lost < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            slipped.rangeMm.at(i, j) = scan.rangeMm.at(i + lost, j);
            slipped.state.at(i, j) = scan.state.at(i + lost, j);
        }
    }
    const PolarGeometry after = anglesOf(straightened(slipped));
    const double stepDeg = before.lineDeg[1] - before.lineDeg[0];
    EXPECT_EQ(after.lineDeg[static_cast<std::size_t>(cut) - 1], before.lineDeg[static_cast<std::size_t>(cut) - 1]);
    EXPECT_NEAR(after.lineDeg[static_cast<std::size_t>(cut)] - before.lineDeg[static_cast<std::size_t>(cut)], lost * stepDeg,
                0.6 * stepDeg);
    EXPECT_NEAR(after.lineDeg[240] - before.lineDeg[240], lost * stepDeg, 0.6 * stepDeg);
}

} // namespace
} // namespace edgescan
