// edgescan-cli compare: its report on a bell before and after a blast, and its refusals.
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace edgescan {
namespace {

using test::runCli;
using test::runLab;

TEST(CliChange, TellsWhatABlastDid) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    const std::string size = " --lines 150 --beams 190";
    ASSERT_EQ(runLab("simulate -o " + path("a.json") + size).code, 0);
    ASSERT_EQ(runLab("simulate -o " + path("b.json") + size + " --after-blast").code, 0);
    ASSERT_EQ(runLab("simulate -o " + path("again.json") + size + " --sweep-number 1").code, 0);
    const auto run = runCli("compare " + path("a.json") + " " + path("b.json") + " --json - --picture " + path("c.png"));
    ASSERT_EQ(run.code, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["schema"], "edgescan-compare/1");
    EXPECT_EQ(report["lined_up_by"], "surfaces");
    EXPECT_TRUE(report["out_of_spec"]);
    EXPECT_GT(report["cells"]["farther"], 100);
    EXPECT_GT(report["cells"]["nearer"], 100);
    ASSERT_GE(report["regions"].size(), 2U);
    EXPECT_GE(report["regions"][0]["area_m2"], report["regions"][1]["area_m2"]);
    EXPECT_TRUE(std::filesystem::exists(path("c.png")));
    const auto table = runCli("compare " + path("a.json") + " " + path("b.json"));
    EXPECT_NE(table.out.find("OUT OF SPEC"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("+ gained"), std::string::npos);
    // Noise alone must not count as a moved surface.
    const auto same = nlohmann::json::parse(runCli("compare " + path("a.json") + " " + path("again.json") + " --json -").out);
    EXPECT_EQ(same["regions"].size(), 0U);
    EXPECT_LT(same["cells"]["farther"], report["cells"]["farther"].get<int>() / 10);
    // Existing pose files are used.
    std::ofstream(path("a.pose")) << "0 0 0\n0 0 0\n";
    const auto posed =
        runCli("compare " + path("a.json") + " " + path("b.json") + " --poses-3dtk " + path("a.pose") + " " + path("a.pose") + " --json -");
    ASSERT_EQ(posed.code, 0) << posed.err;
    EXPECT_EQ(nlohmann::json::parse(posed.out)["lined_up_by"], "poses");
    EXPECT_FALSE(nlohmann::json::parse(posed.out)["out_of_spec"]);
}

TEST(CliChange, RefusesWhatItCannotCompare) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    ASSERT_EQ(runLab("simulate -o " + path("a.json") + " --lines 40 --beams 50").code, 0);
    EXPECT_EQ(runCli("compare " + path("a.json")).code, 2);
    EXPECT_EQ(runCli("compare " + path("a.json") + " /nowhere.json").code, 1);
    const auto onto = runCli("compare " + path("a.json") + " " + path("a.json") + " --json " + path("a.json"));
    EXPECT_EQ(onto.code, 2) << "an input is never written over";
    EXPECT_EQ(runLab("simulate -o " + path("b.json") + " --scene wall --after-blast").code, 2);
}

} // namespace
} // namespace edgescan
