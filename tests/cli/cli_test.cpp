// edgescan-cli from outside: exit codes, JSON, files, and error messages.
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/command_text.h"
#include "core/edges/settings/presets.h"
#include "core/exports/report.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/folders.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;
using test::runLab;

struct Cli : public ::testing::Test {
    test::TemporaryFolder folder;
    std::string scanPath = (folder / "boxes.json").string();

    void SetUp() override { ASSERT_TRUE(files::saveScan(test::boxesScan(40, 60, 3, 0.05), scanPath)); }
};

TEST(CliReference, TheThesisMaskOfTheProjectsOwnScan) {
    const auto run = runCli("detect " + (test::ownData() / "thesis/steps.json").string() + " --preset thesis --lower 10 --json -");
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    const json reference = json::parse(test::fileText(test::ownData() / "thesis/reference.json"))["cases"][1];
    EXPECT_EQ(report["edges"], reference["edges"]);
    EXPECT_EQ(report["edge_mask_sha256"], reference["mask_sha256"]);
}

TEST(CliReference, TheFoundingFigureThroughBothFiles) {
    EDGESCAN_NEEDS_SHARED("data/lms200_corridor");
    const std::string corridor = (test::sharedFolder() / "data/lms200_corridor/").string();
    for (const char* file : {"scan000.json", "scan000.u16", "scan000.3d"}) {
        const auto run = runCli("detect " + corridor + file + " --preset thesis --lower 10 --json -");
        ASSERT_EQ(run.code, 0) << run.err;
        const json report = json::parse(run.out);
        EXPECT_EQ(report["edges"], 3414) << file;
        EXPECT_EQ(report["edge_mask_sha256"], "69e2b5c7c8390318c76d9fb9fcf395e4580fcc837c599f93354c8a369fd94cbf") << file;
    }
}

TEST_F(Cli, DetectReportsEverythingOfTheContract) {
    const auto run = runCli("detect " + scanPath + " --json - --preset window --lower 20");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const json report = json::parse(run.out);
    for (const char* key : {"input", "sha256", "lines", "beams", "cells", "range_mm", "settings", "edges", "edge_mask_sha256", "timings_ms",
                            "warnings", "version"}) {
        EXPECT_TRUE(report.contains(key)) << key;
    }
    std::size_t sum = 0;
    for (const char* state : {"valid", "no_return", "status", "out_of_window", "masked", "lost"})
        sum += report["cells"].at(state).get<std::size_t>();
    EXPECT_EQ(sum, 40U * 60U);
    EXPECT_EQ(report["settings"]["lower"], 20);
    EXPECT_EQ(report["settings"]["scaling"], "window");
    EXPECT_EQ(report["settings"]["mask-missing"], "off");
    EXPECT_EQ(report["sha256"].get<std::string>().size(), 64U);
}

TEST_F(Cli, EveryOutputIsWrittenAndBelongsToTheSameMask) {
    const auto path = [&](const char* name) { return (folder / name).string(); };
    const auto run = runCli("detect " + scanPath + " --json " + path("r.json") + " --mask " + path("m.png") + " --gray " + path("g.png") +
                            " --range " + path("s.png") + " --edges " + path("e.csv") + " --cloud " + path("c.pcd"));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "");
    const json report = json::parse(test::fileText(folder / "r.json"));
    const auto mask = containers::readPng8(folder / "m.png");
    ASSERT_TRUE(mask) << mask.error().sentence();
    EXPECT_EQ(exports::maskSha256(*mask), report["edge_mask_sha256"].get<std::string>());
    const std::string edges = test::fileText(folder / "e.csv");
    const auto rows = std::count(edges.begin(), edges.end(), '\n');
    EXPECT_GE(rows, report["edges"].get<int>());
    EXPECT_LE(rows, report["edges"].get<int>() + 12); // header and comments
    const auto gray = containers::readPng8(folder / "g.png");
    ASSERT_TRUE(gray);
    EXPECT_EQ(gray->lines, 40);
    EXPECT_EQ(gray->beams, 60);
    EXPECT_GT(std::filesystem::file_size(folder / "s.png"), 100U);
    EXPECT_GT(std::filesystem::file_size(folder / "c.pcd"), 1000U);
}

TEST_F(Cli, AFolderTakesAllResultsOfSeveralScansAndABadOneDoesNotStopTheRest) {
    const std::string second = (folder / "second.json").string();
    ASSERT_TRUE(files::saveScan(test::boxesScan(20, 30, 4), second));
    const auto run =
        runCli("detect " + scanPath + " " + (folder / "missing.pcd").string() + " " + second + " -o " + (folder / "out").string());
    EXPECT_EQ(run.code, 4) << "two of three are done";
    EXPECT_NE(run.err.find("missing.pcd"), std::string::npos);
    for (const char* name : {"boxes_edges.json", "boxes_edges.png", "boxes_gray.png", "boxes_range.png", "boxes_edges_LOCAL.pcd",
                             "boxes_cloud_LOCAL.pcd", "second_edges.json"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name;
    }
}

TEST_F(Cli, WrongUsageIsTwoAndARefusedInputIsOne) {
    for (const char* usage : {"", "nonsense", "detect", "detect --lower", "simulate", "convert a.json", "info"})
        EXPECT_EQ(runCli(usage).code, 2) << usage;
    for (const std::string flags :
         {"--lower abc", "--lower 20001", "--lower ''", "--kernel 4", "--norm l3", "--preset nonsense",
          "--scaling window --near 5m --far 4m", "--edges e.docx", "--nonsense 3", "--axis up", "--beam-step nan", "--edges e.json"}) {
        const auto run = runCli("detect " + scanPath + " " + flags);
        EXPECT_EQ(run.code, 2) << flags;
        EXPECT_EQ(run.out, "") << flags;
        EXPECT_FALSE(run.err.empty()) << flags;
    }
    EXPECT_EQ(runCli("detect " + scanPath + " " + scanPath + " --mask m.png").code, 2);
    EXPECT_EQ(runCli("detect /nonexistent.json").code, 1);
    EXPECT_EQ(runCli("detect " + scanPath + " " + scanPath + " -o " + folder.path().string()).code, 2); // one name for two results
    const int full = std::system((test::programFolder() + "/edgescan-cli info " + scanPath + " >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(full), 1);
    EXPECT_EQ(runCli("--help").code, 0);
    EXPECT_EQ(runCli("--version").code, 0);
}

TEST_F(Cli, AResultThatCannotBeWrittenIsOneAndNamesThePath) {
    const auto run = runCli("detect " + scanPath + " --mask /nonexistent-folder/m.png");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("/nonexistent-folder/m.png"), std::string::npos) << run.err;
}

TEST_F(Cli, FlagsOfGrayLevelsAskForCanny) {
    const auto method = [this](const std::string& flags) {
        const auto run = runCli("detect " + scanPath + " --json - " + flags);
        EXPECT_EQ(run.code, 0) << run.err;
        return json::parse(run.out);
    };
    EXPECT_EQ(method("")["settings"]["method"], "edgescan+");
    EXPECT_EQ(method("--crease 50")["settings"]["method"], "edgescan+");
    const json low = method("--lower 3");
    EXPECT_EQ(low["settings"]["method"], "canny");
    EXPECT_GT(low["edges"], method("--lower 30")["edges"]);
    EXPECT_EQ(low["edge_mask_sha256"], method("--preset log --lower 3")["edge_mask_sha256"]);
    // Contradicting flags and flags without effect are refused. If a method is given, every setting of a record may be typed.
    for (const char* usage : {"--lower 3 --crease 50", "--log-mask 8"})
        EXPECT_EQ(runCli("detect " + scanPath + " " + usage).code, 2) << usage;
    EXPECT_EQ(runCli("detect " + scanPath + " --method canny --lower 3 --crease 50").code, 2)
        << "not used by a method that is named either";
}

TEST_F(Cli, HelpListsEveryParameterWithLimitsAndDefault) {
    const std::string help = runCli("detect --help").out;
    for (const char* text : {"--lower", "--kernel", "--mask-missing", "0 to 20000", "default 6", "l1|l2", "--preset", "--beam-start"}) {
        EXPECT_NE(help.find(text), std::string::npos) << text;
    }
}

TEST_F(Cli, ConvertKeepsTheGridInEveryFormat) {
    const json before = json::parse(runCli("detect " + scanPath + " --json -").out);
    for (const char* name : {"a.json", "a.pcd", "a.ply", "a.csv", "a.xyz", "a.las", "a.ptx", "a.mcap"}) {
        const std::string out = (folder / name).string();
        const auto run = runCli("convert " + scanPath + " " + out);
        ASSERT_EQ(run.code, 0) << name << run.err;
        const auto again = runCli("detect " + out + " --json -");
        ASSERT_EQ(again.code, 0) << name << again.err;
        const json report = json::parse(again.out);
        EXPECT_EQ(report["edge_mask_sha256"], before["edge_mask_sha256"]) << name;
        EXPECT_EQ(report["cells"], before["cells"]) << name;
    }
}

TEST_F(Cli, SimulateRefusesFlagsThatChangeNothingInItsScene) {
    const std::string out = (folder / "x.json").string();
    const std::string simulate = "simulate -o " + out + " --lines 20 --beams 30 ";
    const auto refused = runLab(simulate + "--scene pile --hole-shape round");
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.err, "edgescan-lab: --hole-shape: the scene pile does not use this flag; leave it out, or choose --scene wall.\n");
    for (const char* flags :
         {"--surface a.ply", "--scene wall --surface-scale 2", "--scene hangup --distance 3", "--scene staircase --hole-size 1",
          "--scene empty --rock-count 5", "--scene staircase --wall-roughness 5", "--scene rescan --hole-count 2",
          "--scene wall --hole-shape none --hole-count 2", "--scene wall --rock-rounding 0.1", "--scene wall --wall-kind rough",
          "--wall-kind granite", "--wall-kind tunnel"}) {
        const auto run = runLab(simulate + flags);
        EXPECT_EQ(run.code, 2) << flags;
        EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
    for (const char* flags :
         {"--rock-count 5", "--scene wall --hole-count 3", "--scene wall --hole-shape square --hole-size 1 --wall-roughness 10",
          "--scene staircase --distance 2 --range-step 2", "--scene empty --wall-kind tunnel"})
        EXPECT_EQ(runLab(simulate + flags).code, 0) << flags;
}

TEST_F(Cli, SimulateNamesEveryFormatThatItWrites) {
    const auto help = runLab("simulate --help");
    const auto refused = runLab("simulate --lines 20 --beams 30 -o " + (folder / "x.doc").string());
    EXPECT_EQ(refused.code, 2);
    for (const char* extension : {".json", ".mcap", ".pcd", ".ply", ".csv", ".xyz", ".las", ".dxf", ".ptx", ".obj"}) {
        EXPECT_NE(help.out.find(extension), std::string::npos) << extension;
        EXPECT_NE(refused.err.find(extension), std::string::npos) << extension;
        const std::string out = (folder / ("x" + std::string(extension))).string();
        EXPECT_EQ(runLab("simulate --lines 20 --beams 30 -o " + out).code, 0) << extension;
        EXPECT_TRUE(std::filesystem::exists(out));
    }
}

TEST_F(Cli, SimulateGivesTheSameBytesForTheSameSeed) {
    const std::string flags = " --lines 60 --beams 80 --seed 9";
    ASSERT_EQ(runLab("simulate -o " + (folder / "one.json").string() + flags + " --threads 1").code, 0);
    ASSERT_EQ(runLab("simulate -o " + (folder / "two.json").string() + flags + " --threads 2").code, 0);
    ASSERT_EQ(runLab("simulate -o " + (folder / "three.json").string() + " --lines 60 --beams 80 --seed 10").code, 0);
    EXPECT_EQ(test::fileText(folder / "one.u16"), test::fileText(folder / "two.u16"));
    EXPECT_NE(test::fileText(folder / "one.u16"), test::fileText(folder / "three.u16"));
    EXPECT_EQ(runLab("simulate -o " + (folder / "x.json").string() + " --scene nonsense").code, 2);
}

TEST_F(Cli, TheCopiedCommandComputesTheSameMask) {
    edges::Settings settings = edges::findPreset("window")->settings;
    settings.lower = 17.5;
    settings.kernel = 7;
    settings.norm = edges::Norm::L2;
    settings.farMm = 6500;
    const auto strange = (folder / "it's a $scan.json").string();
    ASSERT_TRUE(files::saveScan(test::boxesScan(40, 60, 3, 0.05), strange));
    const std::string command = edges::detectCommand("edgescan-cli", strange, "--unit mm", settings);
    EXPECT_EQ(command.find("edgescan-cli detect "), 0U);
    const auto run = runCli(command.substr(std::string("edgescan-cli ").size()));
    ASSERT_EQ(run.code, 0) << command << run.err;
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(strange)), settings);
    EXPECT_EQ(json::parse(run.out)["edge_mask_sha256"], exports::maskSha256(*detection->mask)) << command;
}

TEST_F(Cli, NonAsciiPathsWork) {
    const auto strange = folder / "Sprengung Süd 天井.json";
    ASSERT_TRUE(files::saveScan(test::boxesScan(10, 12, 1), strange));
    const auto run = runCli("info '" + strange.string() + "'");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["lines"], 10);
}

} // namespace
} // namespace edgescan
