// edgescan-cli why and edgescan-lab benchmark from outside.
#include "core/containers/png/png.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;
using test::runLab;

struct LabBenchmark : public ::testing::Test {
    test::TemporaryFolder folder;
    std::string scanPath = (folder / "boxes.json").string();

    void SetUp() override { ASSERT_TRUE(files::saveScan(test::boxesScan(60, 80, 3, 0.02), scanPath)); }
};

TEST_F(LabBenchmark, WhyAnswersForACellAndItsThresholdHolds) {
    const std::string cell = "why " + scanPath + " --cell 20,30 --preset log";
    const auto run = runCli(cell);
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report["line"], 20);
    EXPECT_EQ(report["beam"], 30);
    EXPECT_EQ(report["thresholds"]["upper"], 18.0);
    EXPECT_FALSE(report["verdict"].get<std::string>().empty());
    if (report["appears_at"].is_null()) return;
    const std::string limit = std::to_string(report["appears_at"]["lower"].get<double>());
    EXPECT_TRUE(json::parse(runCli(cell + " --lower " + limit).out)["edge"].get<bool>());
}

TEST_F(LabBenchmark, WhyRefusesCellsThatDoNotExist) {
    const auto run = runCli("why " + scanPath + " --cell 60,0");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("lines run from 0 to 59"), std::string::npos) << run.err;
    EXPECT_NE(runCli("why " + scanPath + " --cell 3").err.find("LINE,BEAM"), std::string::npos);
}

TEST_F(LabBenchmark, ALowerThresholdCanBeADepth) {
    const auto metres = runCli("detect " + scanPath + " --preset window --near 0 --far 25500 --lower 0.5m --json -");
    ASSERT_EQ(metres.code, 0) << metres.err;
    EXPECT_EQ(json::parse(metres.out)["settings"]["lower"], 15); // 5 levels x 3
    const auto share = runCli("detect " + scanPath + " --preset log --near 2000 --far 8000 --lower 5% --json -");
    ASSERT_EQ(share.code, 0) << share.err;
    EXPECT_EQ(runCli("detect " + scanPath + " --preset window --lower 5%").code, 2);
    EXPECT_EQ(runCli("detect " + scanPath + " --preset window --lower 5x").code, 2);
}

TEST_F(LabBenchmark, EveryMethodAndPeerIsOneRow) {
    const std::string pictures = (folder / "pictures").string();
    const auto run = runLab("benchmark " + scanPath + " --json - --repeats 1 --peer-seconds 2 --pictures " + pictures);
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    std::set<std::string> names;
    for (const json& method : report["methods"]) {
        names.insert(method["method"].get<std::string>());
        EXPECT_TRUE(method["run"].get<bool>() || method.contains("note")) << method.dump();
        if (!method["run"].get<bool>()) continue;
        EXPECT_GT(method["ms"]["total"].get<double>(), 0.0) << method["name"];
        if (method["method"] != "PCL RangeImageBorderExtractor") continue;
        EXPECT_EQ(method["kinds"]["object border"], method["edges"]); // the other kinds are not edges of the nearer surface
        EXPECT_TRUE(method["kinds"].contains("shadow border") && method["kinds"].contains("veil point"));
    }
    for (const char* name : {"thesis", "canny", "log-range", "roberts", "sobel", "prewitt", "kirsch", "robinson", "marr-hildreth", "log",
                             "log-eight", "log-5x5", "jumps", "outlines", "edgescan+"})
        EXPECT_EQ(names.count(name), 1U) << name;
    EXPECT_EQ(names.size(), 20U);
    EXPECT_EQ(names.count("edgescan+as-measured"), 0U); // this scan has no displaced beams or lines
    EXPECT_EQ(report["table_6_1"]["total"]["thesis_printed_ms"], 297);
    EXPECT_EQ(report["table_6_2"]["pcl_boundary"]["thesis_printed_ms"], 1852880);
    const auto sheet = containers::readPng8(pictures + "/comparison.png");
    ASSERT_TRUE(sheet) << sheet.error().sentence();
    EXPECT_GT(sheet->beams, 4 * 460);
    const auto mask = containers::readPng8(pictures + "/sobel.png");
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->lines, 60);
}

TEST_F(LabBenchmark, OnlySomeMethodsAreComparedWhicheverTheyAre) {
    const auto run = runLab("benchmark " + scanPath + " --only sobel,jumps --repeats 1 --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    ASSERT_EQ(report["methods"].size(), 2U);
    EXPECT_EQ(report["methods"][0]["method"], "sobel");
    EXPECT_TRUE(report["table_6_1"].is_null());
    EXPECT_NE(runLab("benchmark " + scanPath + " --only sobel --repeats 1").out.find("Sobel"), std::string::npos);
    for (const char* only : {"nonsense", "sobel,nonsense", "nonsense,thesis"}) {
        const auto refused = runLab("benchmark " + scanPath + " --repeats 1 --only " + only);
        EXPECT_EQ(refused.code, 2) << only;
        EXPECT_EQ(refused.out, "");
        EXPECT_EQ(refused.err,
                  "edgescan-lab: --only: no method is called \"nonsense\"; use thesis, roberts, sobel, prewitt, kirsch, robinson, "
                  "marr-hildreth, log, log-eight, log-5x5, canny, log-range, jumps, outlines, edgescan+as-measured, edgescan+.\n");
    }
}

TEST_F(LabBenchmark, InterlacedBeamsAreShownBeforeAndAfterTheirCorrection) {
    const std::string bell = (folder / "bell.json").string();
    ASSERT_EQ(runLab("simulate -o " + bell + " --lines 260 --beams 300 --interlace 0.35 --seed 3").code, 0);
    const auto run = runLab("benchmark " + bell + " --no-peers --repeats 1 --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    std::map<std::string, std::size_t> edges;
    const json report = json::parse(run.out);
    for (const json& method : report["methods"]) edges[method["method"].get<std::string>()] = method["edges"].get<std::size_t>();
    ASSERT_EQ(edges.count("edgescan+as-measured"), 1U);
    const auto detected = [&](const char* slips) {
        return json::parse(runCli("detect " + bell + " --slips " + slips + " --json -").out)["edges"].get<std::size_t>();
    };
    EXPECT_EQ(edges["edgescan+as-measured"], detected("off"));
    EXPECT_EQ(edges["edgescan+"], detected("on"));
    EXPECT_NE(edges["edgescan+"], edges["edgescan+as-measured"]);
}

TEST_F(LabBenchmark, WithTruthEveryMethodHasAScore) {
    const std::string bell = (folder / "bell.json").string();
    const std::string truth = (folder / "truth").string();
    ASSERT_EQ(runLab("simulate -o " + bell + " --lines 90 --beams 110 --seed 4 --truth " + truth).code, 0);
    const auto run = runLab("benchmark " + bell + " --truth " + truth + " --no-peers --best --repeats 1 --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    for (const json& method : report["methods"]) {
        const double fixed = method["score"]["all"]["f"].get<double>();
        EXPECT_GT(fixed, 0.0) << method["name"];
        EXPECT_LE(fixed, 1.0);
        EXPECT_GE(method["best"]["score"]["all"]["f"].get<double>(), fixed) << method["name"];
    }
    const std::string pictures = (folder / "pictures").string();
    ASSERT_EQ(runLab("benchmark " + bell + " --truth " + truth + " --only thesis,edgescan+ --best --repeats 1 --pictures " + pictures).code,
              0);
    const auto found = containers::readPng8(pictures + "/truth.png");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_GT(found->beams, 2 * 1100); // 10 pixels per cell
    EXPECT_EQ(runLab("benchmark " + bell + " --truth " + truth + " --no-peers --tolerance nan").code, 2);
    EXPECT_EQ(runLab("benchmark " + bell + " --no-peers --best").code, 2); // --best needs a ground truth
    const auto table = runLab("benchmark " + bell + " --truth " + truth + " --no-peers --repeats 1");
    EXPECT_NE(table.out.find("Thesis, table 6.1"), std::string::npos);
    EXPECT_NE(table.out.find("1852880 ms"), std::string::npos);
    EXPECT_EQ(runLab("benchmark " + scanPath + " --truth " + truth + " --no-peers").code, 1); // of another grid size
}

} // namespace
} // namespace edgescan
