// edgescan-lab repeatability A B: the table for two scans of one place, and its refusals.
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace edgescan {
namespace {

using test::runCli;
using test::runLab;

TEST(LabRepeatability, TellsWhatIsRepeatedAndHowTheScansCameTogether) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    ASSERT_EQ(runLab("simulate -o " + path("a.json") + " --lines 200 --beams 240 --seed 5").code, 0);
    ASSERT_EQ(runLab("simulate -o " + path("b.json") + " --lines 180 --beams 280 --seed 5").code, 0);
    std::ofstream(path("a.pose")) << "0 0 0\n0 0 0\n";
    std::ofstream(path("b.pose")) << "4 -3 2\n0.5 0.2 -0.4\n";
    const std::string both = "repeatability " + path("a.json") + " " + path("b.json");
    const std::string posed = both + " --poses-3dtk " + path("a.pose") + " " + path("b.pose");
    const auto run = runLab(posed + " --refine --only edgescan+,thesis --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["schema"], "edgescan-repeatability/1");
    EXPECT_LT(report["alignment"]["residual_m"], report["alignment"]["residual_before_m"]);
    ASSERT_EQ(report["methods"].size(), 2U);
    for (const auto& row : report["methods"]) EXPECT_GT(row["at_equal_number"]["found"], 0) << row;
    const auto table = runLab(posed + " --only edgescan+");
    EXPECT_NE(table.out.find("EdgeScan+"), std::string::npos) << table.out;

    EXPECT_NE(runLab(both).err.find("no place in the mine"), std::string::npos);
    EXPECT_EQ(runLab(both + " --truth " + folder.path().string()).code, 2);
    EXPECT_EQ(runLab("repeatability " + path("a.json") + " --refine").code, 2);
    EXPECT_NE(runLab(both + " --poses-3dtk " + path("a.pose") + " " + path("a.json")).err.find("not a pose of 3DTK"), std::string::npos);
}

} // namespace
} // namespace edgescan
