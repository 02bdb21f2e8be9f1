// edgescan-lab evaluate from outside.
#include "core/containers/png/png.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;
using test::runLab;

struct LabEvaluate : public ::testing::Test {
    test::TemporaryFolder folder;
    std::string scan = (folder / "bell.json").string();
    std::string truth = (folder / "truth").string();

    void SetUp() override {
        const auto run = runLab("simulate -o " + scan + " --truth " + truth + " --lines 100 --beams 120 --seed 5");
        ASSERT_EQ(run.code, 0) << run.err;
    }

    // A mask whose edges are the cells of gt_class.png for which `wanted` is true.
    template <class Wanted>
    std::string maskOf(const std::string& name, Wanted wanted) {
        Grid<std::uint8_t> mask = *containers::readPng8(truth + "/gt_class.png");
        for (std::uint8_t& cell : mask.cells) cell = wanted(cell) ? 255 : 0;
        const std::string path = (folder / name).string();
        EXPECT_TRUE(containers::savePng8(mask, path));
        return path;
    }

    json evaluated(const std::string& file, const std::string& flags = "") const {
        const auto run = runLab("evaluate " + file + " --truth " + truth + " --json - " + flags);
        EXPECT_EQ(run.code, 0) << run.err;
        return json::parse(run.out);
    }
};

TEST_F(LabEvaluate, TheTruthAsAMaskIsPerfect) {
    const json all = evaluated(maskOf("truth.png", [](std::uint8_t cell) { return cell > 0; }), "--tolerance 0");
    EXPECT_FALSE(all.contains("sweep"));
    EXPECT_GT(all["fixed"]["all"]["truth"], 100);
    EXPECT_DOUBLE_EQ(all["fixed"]["all"]["f"], 1.0);
    EXPECT_DOUBLE_EQ(all["fixed"]["pratt"], 1.0);

    // Occluding edges alone. Thinning without the other edges may remove a cell or two.
    const json occluding = evaluated(maskOf("occluding.png", [](std::uint8_t cell) { return cell == 1; }), "--tolerance 1")["fixed"];
    EXPECT_GT(occluding["occluding"]["f"], 0.97);
    EXPECT_DOUBLE_EQ(occluding["all"]["precision"], 1.0);
    EXPECT_LT(occluding["all"]["recall"], 0.4);

    const json nothing = evaluated(maskOf("nothing.png", [](std::uint8_t) { return false; }))["fixed"];
    EXPECT_EQ(nothing["all"]["found"], 0);
    EXPECT_DOUBLE_EQ(nothing["all"]["f"], 0.0);
}

TEST_F(LabEvaluate, ASweepHoldsItsFixedThresholdAndTheBest) {
    const json report = evaluated(scan, "--method edgescan+ --sweep --thresholds 0.7,1,1.4,2.5");
    EXPECT_EQ(report["swept"], "sensitivity");
    EXPECT_EQ(report["sweep"]["thresholds"], json::array({0.7, 1.0, 1.4, 2.5}));
    const json& best = report["sweep"]["all"];
    const double fixed = report["fixed"]["all"]["f"].get<double>(); // sensitivity 1 is the default and one of the four
    EXPECT_GT(fixed, 0.8);
    EXPECT_GE(best["ods"].get<double>(), fixed);
    // one scan: the best threshold for all scans is the best for each
    EXPECT_DOUBLE_EQ(best["ois"].get<double>(), best["ods"].get<double>());
    const std::string threshold = std::to_string(best["ods_threshold"].get<double>());
    const json alone = evaluated(scan, "--method edgescan+ --sensitivity " + threshold);
    EXPECT_DOUBLE_EQ(alone["fixed"]["all"]["f"], best["ods"].get<double>());
    EXPECT_EQ(evaluated(scan, "--preset thesis --sweep --thresholds 6")["swept"], "lower");
}

TEST_F(LabEvaluate, TheUsualSweepIsNeverWorseThanTheSettings) {
    const json report = evaluated(scan, "--method jumps --sensitivity 1.03 --sweep");
    const json& thresholds = report["sweep"]["thresholds"];
    EXPECT_NE(std::find(thresholds.begin(), thresholds.end(), json(1.03)), thresholds.end()) << thresholds.dump();
    EXPECT_TRUE(std::is_sorted(thresholds.begin(), thresholds.end()));
    for (const char* group : {"occluding", "outline", "strict_outline", "crease", "all"})
        EXPECT_GE(report["sweep"][group]["ods"].get<double>(), report["fixed"][group]["f"].get<double>()) << group;
}

TEST_F(LabEvaluate, TheTruthOfAnotherSceneIsRefused) {
    const std::string other = (folder / "other.json").string();
    const auto make = [&](const std::string& flags) {
        const auto run = runLab("simulate -o " + other + " --lines 100 --beams 120 " + flags);
        ASSERT_EQ(run.code, 0) << run.err;
    };
    for (const char* flags :
         {"--seed 6", "--scene pile --seed 5", "--scene empty --seed 5", "--seed 5 --rock-count 200", "--scene wall --distance 4"}) {
        make(flags);
        for (const char* command : {"evaluate ", "benchmark --no-peers "}) {
            const auto run = runLab(command + other + " --truth " + truth);
            EXPECT_EQ(run.code, 1) << flags;
            EXPECT_NE(run.err.find("the truth is of another scene: "), std::string::npos) << flags << run.err;
        }
    }
    // Other simulated files of the same scene are accepted too.
    for (const char* flags :
         {"--noise 10", "--noise 0", "--dropouts 0.4", "--dust 0.2", "--slips 0.2", "--interlace 0.9", "--line-jitter 0.3",
          "--profile standard --noise 3", "--status-codes 0.3", "--motor-skew 1", "--no-footprint --no-echo-loss"}) {
        const std::string own = (folder / "own").string();
        make(std::string("--seed 5 ") + flags + " --truth " + own);
        const auto run = runLab("evaluate " + other + " --truth " + own);
        EXPECT_EQ(run.code, 0) << flags << run.err;
    }
}

TEST_F(LabEvaluate, RocksAreListedOneByOne) {
    const json report = evaluated(scan);
    const json& rocks = report["rocks"];
    ASSERT_EQ(rocks.size(), report["fixed"]["rocks"]["count"]);
    ASSERT_GT(rocks.size(), 3U);
    std::size_t good = 0;
    for (const json& rock : rocks) {
        EXPECT_EQ(rock["file"], 0);
        EXPECT_GE(rock["object"], 2);
        EXPECT_GE(rock["outline_cells"], 10);
        EXPECT_DOUBLE_EQ(rock["share"].get<double>(), rock["found"].get<double>() / rock["outline_cells"].get<double>());
        good += rock["share"].get<double>() >= 0.8 ? 1 : 0;
    }
    EXPECT_DOUBLE_EQ(report["fixed"]["rocks"]["at_least_80_percent"].get<double>(),
                     static_cast<double>(good) / static_cast<double>(rocks.size()));
    // Two files: the second file's rocks name it.
    const auto twice = runLab("evaluate " + scan + " " + scan + " --truth " + truth + " --truth " + truth + " --json -");
    ASSERT_EQ(twice.code, 0) << twice.err;
    const json both = json::parse(twice.out)["rocks"];
    ASSERT_EQ(both.size(), 2 * rocks.size());
    EXPECT_EQ(both.back()["file"], 1);
    EXPECT_EQ(both.back()["object"], rocks.back()["object"]);
}

TEST_F(LabEvaluate, AMaskWithItsRangesHasThe3DErrorOfItsScan) {
    const std::string mask = (folder / "edges.png").string();
    ASSERT_EQ(runCli("detect " + scan + " --mask " + mask).code, 0);
    EXPECT_FALSE(evaluated(mask)["fixed"].contains("error_mm"));
    const json with = evaluated(mask, "--scan-of-mask " + scan)["fixed"];
    const json direct = evaluated(scan)["fixed"];
    EXPECT_EQ(with["error_mm"], direct["error_mm"]);
    EXPECT_EQ(with["all"], direct["all"]);
    EXPECT_EQ(runLab("evaluate " + scan + " --truth " + truth + " --scan-of-mask " + scan).code, 2);
    EXPECT_EQ(runLab("evaluate " + mask + " --truth " + truth + " --scan-of-mask " + scan + " --scan-of-mask " + scan).code, 2);
}

TEST_F(LabEvaluate, RocksAreScoredAgainstTheTrueOnes) {
    const std::string pictures = (folder / "pictures").string();
    const auto run = runLab("evaluate --rocks " + scan + " --truth " + truth + " --json - --pictures " + pictures);
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report["schema"], "edgescan-evaluate-rocks/1");
    std::vector<std::string> answers;
    for (const json& one : report["answers"]) answers.push_back(one["answer"]);
    EXPECT_EQ(answers, (std::vector<std::string>{"recipe", "watershed"}));
    const json& strict = report["answers"][0]["at_least_100_cells"]["strict"];
    EXPECT_GT(strict["found"], 0);
    EXPECT_EQ(strict["rocks"], report["rocks"].size());
    std::size_t found = 0;
    for (const json& rock : report["rocks"]) found += rock["found"].get<bool>() ? 1U : 0U;
    EXPECT_EQ(strict["found"], found);
    EXPECT_TRUE(std::filesystem::exists(pictures + "/rocks-1.png"));
    const auto table = runLab("evaluate --rocks " + scan + " --truth " + truth);
    EXPECT_EQ(table.code, 0);
    EXPECT_NE(table.out.find("EdgeScan+ rocks"), std::string::npos);

    const std::string other = (folder / "other").string();
    ASSERT_EQ(runLab("simulate -o " + (folder / "other.json").string() + " --truth " + other + " --lines 100 --beams 120 --seed 6").code,
              0);
    EXPECT_EQ(runLab("evaluate --rocks " + scan + " --truth " + other).code, 1) << "the truth of another scene";
    for (const char* flags : {"--rocks --sweep", "--rocks --tolerance 3", "--rocks --method sobel", "--peers", "--level 2"}) {
        const auto refused = runLab("evaluate " + scan + " --truth " + truth + " " + flags);
        EXPECT_EQ(refused.code, 2) << flags;
        EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    }
}

TEST_F(LabEvaluate, RefusesWhatDoesNotBelongTogether) {
    const auto twice = runLab("evaluate " + scan + " --truth " + truth + " --truth " + truth);
    EXPECT_EQ(twice.code, 2);
    EXPECT_NE(twice.err.find("once per file"), std::string::npos) << twice.err;
    const std::string mask = maskOf("mask.png", [](std::uint8_t cell) { return cell > 0; });
    EXPECT_EQ(runLab("evaluate " + mask + " --truth " + truth + " --sweep").code, 2);
    EXPECT_EQ(runLab("evaluate " + mask + " --truth " + truth + " --method canny").code, 2);
    EXPECT_EQ(runLab("evaluate " + mask + " --truth " + truth + " --tolerance nan").code, 2);
    const std::string sweep = "evaluate " + scan + " --truth " + truth + " --method edgescan+ ";
    EXPECT_EQ(runLab(sweep + "--thresholds 1,2").code, 2); // without --sweep
    for (const char* wrong : {"2,1", "1,1", "0.1,1", "1,nan", "1,5"}) {
        const auto run = runLab(sweep + "--sweep --thresholds " + wrong);
        EXPECT_EQ(run.code, 2) << wrong;
        EXPECT_NE(run.err.find("rising values of --sensitivity, from 0.3 to 3"), std::string::npos) << wrong << run.err;
    }
    EXPECT_EQ(runLab("evaluate " + scan + " --truth " + (folder / "nowhere").string()).code, 1);

    ASSERT_TRUE(containers::savePng8(Grid<std::uint8_t>(10, 12), folder / "small.png"));
    const auto small = runLab("evaluate " + (folder / "small.png").string() + " --truth " + truth);
    EXPECT_EQ(small.code, 1);
    EXPECT_NE(small.err.find("10 x 12 cells and its truth 100 x 120"), std::string::npos) << small.err;
}

} // namespace
} // namespace edgescan
