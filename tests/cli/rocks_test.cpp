// edgescan-cli rocks from outside: files, JSON, records, edits, and refusals.
#include "core/containers/png/png.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/placements.h"
#include "tests/support/rock_scene.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;

// A scene on disk with a pose in the mine, once for all tests.
class CliRocks : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = new test::TemporaryFolder;
        Scan scan = *test::rockScene("hangup", 77, 240, 274).scan;
        scan.placement = test::randomPlacement(4, 1, true);
        ASSERT_TRUE(files::saveScan(scan, *folder / "bell.json"));
    }
    static void TearDownTestSuite() {
        delete folder;
        folder = nullptr;
    }
    static std::string path(const std::string& name) { return (*folder / name).string(); }
    static json rocks(const std::string& flags) {
        const auto run = runCli("rocks " + path("bell.json") + " --json - " + flags);
        EXPECT_EQ(run.code, 0) << run.err;
        return run.code == 0 ? json::parse(run.out) : json();
    }
    static test::TemporaryFolder* folder;
};
test::TemporaryFolder* CliRocks::folder = nullptr;

TEST_F(CliRocks, WritesEverythingIntoAFolderAndVerifyMakesItAgain) {
    const auto run =
        runCli("rocks " + path("bell.json") + " -o " + path("out") + " --hulls " + path("h.obj") + " --min-cells 60 --level 0.5");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "");
    std::vector<std::string> exports{path("h.obj")};
    for (const auto& entry : std::filesystem::directory_iterator(path("out"))) {
        const std::string name = entry.path().string();
        if (!name.ends_with(".provenance.json")) exports.push_back(name);
    }
    EXPECT_EQ(exports.size(), 7U);
    for (const std::string& name : exports) {
        const auto verify = runCli("verify " + name + " --scans " + folder->path().string());
        EXPECT_EQ(verify.code, 0) << verify.out << verify.err;
        const std::string text = test::fileText(name) + test::fileText(name + ".provenance.json");
        EXPECT_NE(text.find("candidate - geometry only, one viewpoint"), std::string::npos) << name;
    }
    // Altered labels are detected.
    std::string csv = test::fileText(path("out/bell_rocks.csv"));
    ASSERT_FALSE(csv.empty());
    csv[csv.find('\n') + 3] ^= 1;
    std::ofstream(path("out/bell_rocks.csv"), std::ios::binary) << csv;
    EXPECT_EQ(runCli("verify " + path("out/bell_rocks.csv") + " --scans " + folder->path().string()).code, 1);
}

TEST_F(CliRocks, PictureTableAndJsonSayTheSame) {
    const json report = rocks("--labels " + path("l.png") + " --csv " + path("t.csv") + " --frame scanner");
    EXPECT_EQ(report["schema"], "edgescan-rocks/1");
    EXPECT_EQ(report["note"], "candidate - geometry only, one viewpoint");
    EXPECT_EQ(report["up"]["assumed"], false);
    const auto picture = containers::pngValues(test::fileText(path("l.png")), "l.png");
    ASSERT_TRUE(picture);
    ASSERT_GT(report["rocks"].size(), 10U);
    EXPECT_EQ(report["rock_count"], report["rocks"].size());
    EXPECT_EQ(*std::max_element(picture->cells.begin(), picture->cells.end()), report["rocks"].size());
    double before = 1e9;
    for (const json& rock : report["rocks"]) {
        EXPECT_EQ(picture->at(rock["line"], rock["beam"]), rock["rock"]);
        EXPECT_LE(rock["visible_area_m2"].get<double>(), before);
        EXPECT_GE(rock["cells"], 100);
        EXPECT_LE(rock["visible_wide_m"], rock["visible_long_m"]);
        before = rock["visible_area_m2"];
    }
    const std::string table = test::fileText(path("t.csv"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')), report["rocks"].size() + 1);
    EXPECT_TRUE(table.starts_with("rock,line,beam,cells,x_m,y_m,z_m,distance_m,visible_long_m,visible_wide_m,tolerance_m,"));
}

TEST_F(CliRocks, LevelSizeAndRegionAreTaken) {
    const std::size_t usual = rocks("")["rocks"].size();
    EXPECT_LT(rocks("--min-cells 400")["rocks"].size(), usual);
    EXPECT_NE(rocks("--level -4")["labels_sha256"], rocks("--level 4")["labels_sha256"]);
    const json region = rocks("--region '60,60 160,200'");
    EXPECT_LT(region["rocks"].size(), usual);
    EXPECT_GT(region["outside_region"]["regions"], 0);
    EXPECT_EQ(region["settings"]["region"], json::parse("[[60, 60], [160, 200]]"));
    EXPECT_EQ(rocks("--farthest 0.5")["rocks"].size(), 0U);
    EXPECT_GT(rocks("--oversize 0.3")["size_curve"]["oversize_share"], 0.0);
}

TEST_F(CliRocks, AClickSplitsAndTheEditsGiveTheSameLabelsAgain) {
    std::string cell;
    json split;
    const json plain = rocks("");
    for (const json& rock : plain["rocks"]) {
        cell = std::to_string(rock["line"].get<int>()) + "," + std::to_string(rock["beam"].get<int>());
        const auto run = runCli("rocks " + path("bell.json") + " --json - --split " + cell + " --write-edits " + path("edits.json"));
        if (run.code != 0) continue;
        split = json::parse(run.out);
        break;
    }
    ASSERT_FALSE(split.is_null());
    EXPECT_NE(split["labels_sha256"], plain["labels_sha256"]);
    ASSERT_EQ(split["edits"].size(), 1U);
    EXPECT_EQ(rocks("--edits " + path("edits.json"))["labels_sha256"], split["labels_sha256"]);
    // Edits include settings; typed settings override them.
    const json coarse = rocks("--level 3 --min-cells 150 --region '10,10 200,200' --write-edits " + path("coarse.json"));
    EXPECT_NE(coarse["labels_sha256"], plain["labels_sha256"]);
    EXPECT_EQ(rocks("--edits " + path("coarse.json"))["labels_sha256"], coarse["labels_sha256"]);
    EXPECT_EQ(rocks("--edits " + path("coarse.json") + " --level 1")["settings"]["level"], 1);
    EXPECT_EQ(rocks("--edits " + path("coarse.json") + " --level 1")["settings"]["min-cells"], 150);
    const json& cells = split["edits"][0]["cells"];
    const auto text = [](const json& pair) { return std::to_string(pair[0].get<int>()) + "," + std::to_string(pair[1].get<int>()); };
    const auto why = runCli("rocks " + path("bell.json") + " --why " + text(cells[0]) + " " + text(cells[1]));
    ASSERT_EQ(why.code, 0) << why.err;
    const json report = json::parse(why.out);
    EXPECT_EQ(report["schema"], "edgescan-rocks-why/1");
    EXPECT_EQ(report["same_region"], true);
    EXPECT_LT(report["joined_from_level"], 0.0);
}

TEST_F(CliRocks, OutlinesArePolygonsOfThePicture) {
    const auto run = runCli("rocks " + path("bell.json") + " --outlines -.geojson");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["type"], "FeatureCollection");
    ASSERT_EQ(runCli("rocks " + path("bell.json") + " --outlines " + path("o.geojson") + " --labels " + path("o.png")).code, 0);
    const json outlines = json::parse(test::fileText(path("o.geojson")));
    const auto picture = containers::pngValues(test::fileText(path("o.png")), "o.png");
    ASSERT_TRUE(picture);
    for (const json& feature : outlines["features"]) {
        double area = 0;
        for (const json& polygon : feature["geometry"]["coordinates"]) {
            for (const json& ring : polygon) {
                EXPECT_EQ(ring.front(), ring.back());
                for (std::size_t n = 1; n < ring.size(); ++n)
                    area += 0.5 * (ring[n - 1][0].get<double>() * ring[n][1].get<double>() -
                                   ring[n][0].get<double>() * ring[n - 1][1].get<double>());
            }
        }
        EXPECT_EQ(area, static_cast<double>(std::count(picture->cells.begin(), picture->cells.end(), feature["id"].get<int>())));
    }
    EXPECT_GT(outlines["features"].size(), 10U);
}

TEST_F(CliRocks, WhatIsWrongIsSaidInOneSentence) {
    const auto refused = [&](const std::string& flags, int code, const char* word) {
        const auto run = runCli("rocks " + flags);
        EXPECT_EQ(run.code, code) << flags << run.err;
        EXPECT_NE(run.err.find(word), std::string::npos) << run.err;
    };
    refused(path("none.json"), 1, "none.json");
    refused(path("bell.json") + " --level 5", 2, "--level");
    refused(path("bell.json") + " --min-cells 20.5", 2, "--min-cells");
    refused(path("bell.json") + " --region 3,4", 2, "--region");
    refused(path("bell.json") + " --hulls h.pcd", 2, ".ply");
    refused(path("bell.json") + " --cloud h.txt --labels h.txt", 2, "h.txt");
    refused(path("bell.json") + " --why 1,2 999,0", 1, "--why");
    refused(path("bell.json") + " --split 1", 1, "--split");
    refused(path("bell.json") + " --json " + path("bell.json"), 1, "bell.json");
    std::ofstream(*folder / "bad.json") << R"({"format": "edgescan-rock-edits/1", "lines": 3, "beams": 3, "edits": []})";
    refused(path("bell.json") + " --edits " + path("bad.json"), 1, "bad.json");
    refused(path("bell.json") + " --edits " + path("bad.json") + " --csv " + path("bad.json"), 1, "bad.json");
    EXPECT_EQ(runCli("rocks " + path("bell.json") + " --json - --edits " + path("bad.json")).out.find("{"), 0U);
}

} // namespace
} // namespace edgescan
