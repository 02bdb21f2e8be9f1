// edgescan-lab calibrate: its output file, and its refusals.
#include "core/scan/georef/calibration.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace edgescan {
namespace {

using test::fileText;
using test::runCli;
using test::runLab;

TEST(CliCalibrate, WritesAFileThatOpensAndSaysHowSureItIs) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    ASSERT_EQ(runLab("simulate -o " + path("a.json") +
                     " --axis spin --turn 200 --lines 300 --beams 286 --seed 31 --mount-t1 12 --mount-t2 -8" +
                     " --mount-tilt 0.4 --mount-index -0.3 --turn-error 0.2")
                  .code,
              0);
    const auto run = runLab("calibrate " + path("a.json") + " -o " + path("robot.json") + " --picture " + path("views.png") + " --seam " +
                            path("seam.png") + " --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["schema"], "edgescan-calibrate/1");
    EXPECT_NEAR(report["errors"]["t1_mm"].get<double>(), 12, 1);
    EXPECT_GT(report["one_sd"]["tilt_deg"].get<double>(), 0);
    const auto file = openCalibration(path("robot.json"));
    ASSERT_TRUE(file) << file.error().sentence();
    EXPECT_NEAR(file->mountM.x(), 0.012, 0.001);
    EXPECT_GT(std::filesystem::file_size(path("views.png")), 1000U);
    EXPECT_GT(std::filesystem::file_size(path("seam.png")), 1000U);
    EXPECT_GT(report["seam_edges"].get<std::size_t>(), 100U);
    EXPECT_GT(report["seam_edges_met_after"].get<double>(), 0.9);
    EXPECT_GT(report["seam_edges_met_before"].get<double>(), 0.5);

    // With the robot's present file as base; neither this file nor the scan is overwritten.
    const std::string robot = fileText(path("robot.json"));
    EXPECT_NE(runLab("calibrate " + path("a.json") + " --base " + path("robot.json") + " -o " + path("robot.json")).code, 0);
    EXPECT_EQ(fileText(path("robot.json")), robot);
    EXPECT_NE(runLab("calibrate " + path("a.json") + " -o " + path("a.json")).code, 0);
    EXPECT_EQ(runLab("calibrate " + path("a.json") + " --base " + path("robot.json") + " -o " + path("new.json")).code, 0);
}

TEST(CliCalibrate, BacklashIsToldOfTwoPassesAndGoesIntoNoFile) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    for (const int repeat : {0, 1}) {
        const std::string pass = path(repeat == 0 ? "there.json" : "said.json");
        ASSERT_EQ(
            runLab("simulate -o " + pass + " --axis spin --lines 180 --beams 190 --seed 7 --sweep-number " + std::to_string(repeat)).code,
            0);
    }
    // Angles that are 0.2 degrees too small: the stepper is 0.2 degrees ahead of them.
    ASSERT_EQ(runCli("convert " + path("said.json") + " " + path("back.json") + " --line-start=-0.2").code, 0);
    const auto run = runLab("calibrate " + path("there.json") + " " + path("back.json") + " --backlash --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["schema"], "edgescan-backlash/1");
    EXPECT_NEAR(report["backlash_deg"].get<double>(), 0.2, 3 * report["one_sd_deg"].get<double>());
    EXPECT_NE(runLab("calibrate " + path("there.json") + " " + path("back.json") + " --backlash -o " + path("new.json")).code, 0);
    EXPECT_NE(runLab("calibrate " + path("there.json") + " --backlash").code, 0);
    EXPECT_NE(runLab("calibrate " + path("there.json")).code, 0);
    EXPECT_FALSE(std::filesystem::exists(path("new.json")));
}

TEST(CliCalibrate, RefusesHalfATurnAndLeavesNoFile) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    ASSERT_EQ(runLab("simulate -o " + path("a.json") + " --axis spin --lines 60 --beams 60").code, 0);
    const auto run = runLab("calibrate " + path("a.json") + " -o " + path("robot.json"));
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("turn 200 degrees"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("a.json"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("robot.json")));
    EXPECT_EQ(runLab("simulate -o " + path("b.json") + " --truth " + path("t") + " --mount-t1 3").code, 2) << "the truth is of one point";
}

} // namespace
} // namespace edgescan
