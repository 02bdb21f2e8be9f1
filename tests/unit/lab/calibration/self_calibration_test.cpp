// The assembly estimated from one turn, compared with the errors simulated for every ray.
#include "app/lab/calibration/calibration_file.h"
#include "app/lab/calibration/self_calibration.h"
#include "app/lab/calibration/views_picture.h"
#include "app/lab/sim/simulate.h"
#include "core/scan/georef/rotations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace edgescan::inspect {
namespace {

AssemblyErrors someErrors() { return {{12.0, -8.0, 0.4, -0.3, 0.2}}; }

PolarGeometry turning(Axis axis, double way) {
    PolarGeometry polar;
    polar.axis = axis;
    polar.lineDirection = way;
    return polar;
}

std::shared_ptr<const Scan> spun(double turnDeg, const AssemblyErrors& errors, std::uint64_t seed = 31, double skewDeg = 0) {
    sim::SimulationSettings settings;
    settings.axis = Axis::Spin;
    settings.motorSkewDeg = skewDeg;
    settings.seed = seed;
    settings.turnDeg = turnDeg;
    settings.lines = static_cast<int>(turnDeg * 1.5);
    settings.beams = 286;
    settings.assembly = errors;
    const Result<sim::Simulation> simulation = sim::simulate(settings);
    EXPECT_TRUE(simulation);
    return std::make_shared<const Scan>(simulation->scan);
}

std::shared_ptr<const Scan> swept(double turnDeg, const AssemblyErrors& errors, std::uint64_t seed = 31) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.turnDeg = turnDeg;
    settings.lines = static_cast<int>(turnDeg * 2);
    settings.beams = 381;
    settings.assembly = errors;
    const Result<sim::Simulation> simulation = sim::simulate(settings);
    EXPECT_TRUE(simulation);
    return std::make_shared<const Scan>(simulation->scan);
}

Result<SelfCalibration> calibrated(const std::shared_ptr<const Scan>& scan) { return calibrateFromSweeps(std::span(&scan, 1)); }

} // namespace

TEST(TwiceSeen, OfAnIdealAssemblyTheOtherViewIsHalfATurnAwayAndMirrored) {
    const double a = 35.0;
    const SeenCell cell{0, 0, 190.0, {4.0 * std::cos(radians(a)), 0, 4.0 * std::sin(radians(a))}};
    const auto seen = otherViewOf(cell, View::Late, mountingWithErrors(turning(Axis::Spin, 1.0), {}));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->lineDeg, 10.0, 1e-9);
    EXPECT_NEAR(seen->beamDeg, 180.0 - a, 1e-9);
    EXPECT_NEAR(seen->rangeM, 4.0, 1e-12);
    const auto later = otherViewOf(cell, View::Early, mountingWithErrors(turning(Axis::Spin, -1.0), {}));
    ASSERT_TRUE(later);
    EXPECT_NEAR(later->lineDeg, 370.0, 1e-9);
}

TEST(TwiceSeen, TheOtherViewMeasuresTheSamePoint) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const double way : {1.0, -1.0}) {
            for (const double a : {5.0, 40.0, 75.0, 110.0, 170.0}) {
                const AssemblyErrors errors = someErrors();
                const MountingWithErrors mounting = mountingWithErrors(turning(axis, way), errors);
                const SeenCell cell{0, 0, 193.0, {6.0 * std::cos(radians(a)), 0, 6.0 * std::sin(radians(a))}};
                const auto seen = otherViewOf(cell, View::Late, mounting);
                ASSERT_TRUE(seen);
                // Both by the chain of docs/reference/coordinates.md, "Step 1".
                const auto inBase = [&](double lineDeg, const Eigen::Vector3d& inSensor) {
                    const double turned = radians(lineDeg * errors.turnFactor() * way);
                    return Eigen::Vector3d((axis == Axis::Spin ? rotationZ(turned) : rotationX(turned)) *
                                           (mounting.sensorInMover * inSensor));
                };
                const double b = radians(seen->beamDeg);
                const Eigen::Vector3d again = inBase(seen->lineDeg, seen->rangeM * Eigen::Vector3d(std::cos(b), 0, std::sin(b)));
                EXPECT_LT((inBase(cell.lineDeg, cell.inSensorM) - again).norm(), 1e-4) << a << " " << way;
            }
        }
    }
}

TEST(SelfCalibration, SlopesAreThoseOfTheResiduals) {
    const auto scan = spun(200, {});
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    const PreparedSweep sweep = preparedSweep(*scan, polar);
    SurfaceFits fits(sweep.inverse, 4);
    const auto cells = cellsSeenTwice(polar, sweep.inverse, View::Late, 300);
    ASSERT_GT(cells.size(), 200U);
    for (std::size_t q = 0; q < AssemblyErrors::kCount; ++q) {
        // So small that hardly any cell gets another neighbour.
        const double step = q < 2 ? 0.01 : 0.0005;
        AssemblyErrors more;
        more.values[q] = step;
        std::size_t compared = 0, same = 0;
        for (const SeenCell& cell : cells) {
            const auto here = residualsOf(sweep, fits, {cell}, View::Late, {});
            const auto there = residualsOf(sweep, fits, {cell}, View::Late, more);
            if (here.empty() || there.empty()) continue;
            const double slope = (there[0].apartMm - here[0].apartMm) / step;
            ++compared;
            if (std::abs(slope - here[0].slope[static_cast<Eigen::Index>(q)]) < 0.02 * (1 + std::abs(slope))) ++same;
        }
        EXPECT_GT(compared, 150U);
        EXPECT_GT(static_cast<double>(same), 0.9 * static_cast<double>(compared)) << q;
    }
}

TEST(SelfCalibration, FindsTheErrorsOfTheAssembly) {
    for (const double turn : {200.0, 360.0}) {
        const auto found = calibrated(spun(turn, someErrors()));
        ASSERT_TRUE(found) << found.error().sentence();
        const std::array<double, AssemblyErrors::kCount> limits{0.5, 1.5, 0.03, 0.01, 0.03};
        for (std::size_t q = 0; q < AssemblyErrors::kCount; ++q) {
            const double off = found->errors.values[q] - someErrors().values[q];
            EXPECT_LT(std::abs(off), limits[q]) << turn << " " << q;
            EXPECT_LT(std::abs(off), 3.5 * found->sd.values[q]) << turn << " " << q;
            EXPECT_GT(found->sd.values[q], 0) << q;
        }
        EXPECT_NEAR(found->overlapDeg, turn - 180, 1.0);
        EXPECT_GT(found->medianBeforeMm, 2 * found->medianAfterMm);
    }
}

TEST(SelfCalibration, KnowsThatTheStepperMovesOnWhileTheMirrorSweeps) {
    constexpr double kSkewDeg = 0.4;
    Scan scan = *spun(200, someErrors(), 31, kSkewDeg);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (const double beam : polar.beamDeg) polar.lineSkewDeg.push_back(kSkewDeg * (beam - polar.beamDeg.front()) / 190.0);
    const auto found = calibrated(std::make_shared<const Scan>(scan));
    ASSERT_TRUE(found) << found.error().sentence();
    const std::array<double, AssemblyErrors::kCount> limits{0.5, 1.5, 0.03, 0.01, 0.03};
    for (std::size_t q = 0; q < AssemblyErrors::kCount; ++q)
        EXPECT_LT(std::abs(found->errors.values[q] - someErrors().values[q]), limits[q]) << q;
}

TEST(SelfCalibration, ASweepDeterminesAllButTheTurnFromTheEndsOfItsAxis) {
    const auto found = calibrated(swept(360, someErrors()));
    ASSERT_TRUE(found) << found.error().sentence();
    const std::array<double, 4> limits{1.0, 1.0, 0.03, 0.02};
    for (std::size_t q = 0; q < limits.size(); ++q) {
        const double off = found->errors.values[q] - someErrors().values[q];
        EXPECT_LT(std::abs(off), limits[q]) << q;
        EXPECT_LT(std::abs(off), 3.5 * found->sd.values[q]) << q;
        EXPECT_GT(found->sd.values[q], 0) << q;
    }
    EXPECT_FALSE(found->turnIsEstimated);
    EXPECT_EQ(found->errors.turnDeg(), 0);
    EXPECT_GT(found->medianBeforeMm, 2 * found->medianAfterMm);

    const auto text =
        calibrationText(R"({"format": "edgescan-calibration/1", "stepper": {"axis": [1, 0, 0], "step_deg": 0.36}})", "r.json", *found, {});
    ASSERT_TRUE(text) << text.error().sentence();
    const auto read = parseCalibration(*text, "new.json");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->degPerStep, 0.36);
    EXPECT_NEAR(read->mountM.y(), 0.012, 0.001);
    EXPECT_NEAR(read->mountRpyDeg.z(), 0.4, 0.03);
    EXPECT_NE(text->find("\"turn_deg\": null"), std::string::npos);
}

TEST(SelfCalibration, SeveralScansOfOneAssemblyCountTogether) {
    const std::vector<std::shared_ptr<const Scan>> scans{spun(200, someErrors(), 31), spun(200, someErrors(), 32)};
    const auto one = calibrated(scans[0]);
    const auto both = calibrateFromSweeps(scans);
    ASSERT_TRUE(one && both);
    EXPECT_GT(both->cells, one->cells * 3 / 2);
    EXPECT_LT(std::abs(both->errors.t2Mm() - someErrors().t2Mm()), 1.5);
}

TEST(SelfCalibration, RefusesScansThatDoNotDetermineIt) {
    const auto half = calibrated(spun(180, someErrors()));
    ASSERT_FALSE(half);
    EXPECT_NE(half.error().sentence().find("turn 200 degrees"), std::string::npos) << half.error().sentence();

    const auto sweep = calibrated(swept(200, someErrors()));
    ASSERT_FALSE(sweep);
    EXPECT_NE(sweep.error().sentence().find("360 degrees"), std::string::npos) << sweep.error().sentence();

    Scan short180 = *swept(360, {});
    auto& polar = std::get<PolarGeometry>(short180.geometry);
    for (double& beam : polar.beamDeg) beam = 90.0 + (beam - 90.0) * 90.0 / 95.0;
    const auto half180 = calibrated(std::make_shared<const Scan>(short180));
    ASSERT_FALSE(half180);
    EXPECT_NE(half180.error().sentence().find("the fan ends at the axis"), std::string::npos) << half180.error().sentence();

    const std::vector<std::shared_ptr<const Scan>> both{spun(200, {}), swept(360, {})};
    const auto mixed = calibrateFromSweeps(both);
    ASSERT_FALSE(mixed);
    EXPECT_NE(mixed.error().sentence().find("another axis"), std::string::npos) << mixed.error().sentence();

    Scan cloud;
    cloud.rangeMm = {3, 3};
    cloud.state = {3, 3};
    cloud.geometry = PointGeometry{};
    EXPECT_FALSE(calibrated(std::make_shared<const Scan>(cloud)));
    EXPECT_FALSE(calibrateFromSweeps({}));
}

TEST(SelfCalibration, RefusesAPlaceThatChangedMeanwhile) {
    Scan scan = *spun(200, {}, 31);
    const Scan other = *spun(200, {}, 77);
    for (int i = scan.lines() * 9 / 10; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) scan.rangeMm.at(i, j) = other.rangeMm.at(i, j), scan.state.at(i, j) = other.state.at(i, j);
    }
    const auto found = calibrated(std::make_shared<const Scan>(scan));
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().sentence().find("apart"), std::string::npos) << found.error().sentence();
}

TEST(CalibrationFile, SetsTheStepperAndKeepsTheRest) {
    SelfCalibration found;
    found.errors = someErrors();
    const std::string base = R"({"format": "edgescan-calibration/1", "robot": "R7", "stepper": {"zero_deg": 3, "step_deg": 0.36},
                                 "boom": {"head_in_robot_m": [4, 1, 2]}})";
    const auto text = calibrationText(base, "r7.json", found, {{"a.json", "00ff"}});
    ASSERT_TRUE(text) << text.error().sentence();
    const auto read = parseCalibration(*text, "new.json");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->robot, "R7");
    EXPECT_EQ(read->zeroDeg, 3);
    EXPECT_EQ(read->headInRobotM, Eigen::Vector3d(4, 1, 2));
    EXPECT_LT((read->mountM - Eigen::Vector3d(0.012, -0.008, 0)).norm(), 1e-9);
    EXPECT_LT((read->mountRpyDeg - Eigen::Vector3d(0.4, -0.3, 0)).norm(), 1e-9);
    EXPECT_NEAR(read->degPerStep, 0.36 * (1 + 0.2 / 180), 1e-8);
    EXPECT_NE(text->find("\"sha256\": \"00ff\""), std::string::npos);

    EXPECT_FALSE(calibrationText(R"({"format": "edgescan-calibration/1", "stepper": {"axis": [1, 0, 0]}})", "x.json", found, {}));
    EXPECT_FALSE(calibrationText("{", "x.json", found, {}));
}

TEST(ViewsPicture, PalesWithTheRightErrors) {
    const auto scan = spun(200, someErrors());
    const Grid<Rgb> before = viewsPicture(*scan, {});
    const Grid<Rgb> after = viewsPicture(*scan, someErrors());
    ASSERT_EQ(before.beams, scan->beams());
    ASSERT_EQ(before.lines, after.lines);
    EXPECT_GT(before.lines, 20);
    const auto colour = [](const Grid<Rgb>& picture) {
        double sum = 0;
        for (const Rgb& pixel : picture.cells) sum += 255 - std::min(pixel.red, pixel.blue);
        return sum;
    };
    EXPECT_GT(colour(before), 1.3 * colour(after));
    EXPECT_EQ(oneOverTheOther(before, after).at(before.lines + 8, 3), after.at(0, 3));
}

TEST(SelfCalibration, IsGivenUpWhenAskedTo) {
    const auto scan = spun(200, someErrors());
    int asked = 0;
    const auto found = calibrateFromSweeps(std::span(&scan, 1), [&](const char*, double) { return ++asked < 4; });
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().what, "cancelled");
    EXPECT_EQ(asked, 4);
}

} // namespace edgescan::inspect
