// edgescan-cli rocks from outside: files, JSON, records, edits, and refusals.
#include "core/containers/png/png.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/placements.h"
#include "tests/support/rock_scene.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

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
        auto placement = std::make_shared<Placement>(*test::randomPlacement(4, 1, true));
        placement->grid = "UTM 17N, WGS84";
        scan.placement = placement;
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
    EXPECT_EQ(exports.size(), 8U);
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
    EXPECT_EQ(runCli("verify " + path("out/bell_rocks.csv") + " --scans " + folder->path().string()).code, 3);
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
    EXPECT_TRUE(table.starts_with("rock,line,beam,cells,x_m,y_m,z_m,visible_long_m,visible_wide_m,tolerance_m,distance_m,"));
}

TEST_F(CliRocks, NamesOfCoordinatesSayTheirFrame) {
    const auto header = [&](const std::string& flags) {
        const auto run = runCli("rocks " + path("bell.json") + " --csv - " + flags);
        EXPECT_EQ(run.code, 0) << run.err;
        return run.out.substr(0, run.out.find('\n'));
    };
    EXPECT_NE(header("").find(",easting_m,northing_m,elevation_m,"), std::string::npos);
    EXPECT_NE(header("--frame local").find(",east_m,north_m,up_m,"), std::string::npos);
    EXPECT_NE(header("--frame scanner").find(",x_m,y_m,z_m,"), std::string::npos);
    EXPECT_EQ(header("").find("x_m"), std::string::npos);
    const json rock = rocks("")["rocks"][0];
    EXPECT_TRUE(rock.contains("easting_m"));
    EXPECT_FALSE(rock.contains("x_m"));
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

TEST_F(CliRocks, PictureOutlinesArePolygonsAroundTheLabels) {
    const auto run = runCli("rocks " + path("bell.json") + " --picture-outlines -.json");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["schema"], "edgescan-picture-outlines/1");
    ASSERT_EQ(runCli("rocks " + path("bell.json") + " --picture-outlines " + path("o.json") + " --labels " + path("o.png")).code, 0);
    const json outlines = json::parse(test::fileText(path("o.json")));
    const auto picture = containers::pngValues(test::fileText(path("o.png")), "o.png");
    ASSERT_TRUE(picture);
    for (const json& rock : outlines["rocks"]) {
        double area = 0;
        for (const json& polygon : rock["polygons"]) {
            for (const json& ring : polygon) {
                EXPECT_EQ(ring.front(), ring.back());
                for (std::size_t n = 1; n < ring.size(); ++n)
                    area += 0.5 * (ring[n - 1][0].get<double>() * ring[n][1].get<double>() -
                                   ring[n][0].get<double>() * ring[n - 1][1].get<double>());
            }
        }
        EXPECT_EQ(area, static_cast<double>(std::count(picture->cells.begin(), picture->cells.end(), rock["rock"].get<int>())));
    }
    EXPECT_GT(outlines["rocks"].size(), 10U);
}

TEST_F(CliRocks, GeoJsonIsInTheMineGridOrRefused) {
    ASSERT_EQ(runCli("rocks " + path("bell.json") + " --outlines " + path("o.geojson")).code, 0);
    const json outlines = json::parse(test::fileText(path("o.geojson")));
    EXPECT_EQ(outlines["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::32617");
    ASSERT_GT(outlines["features"].size(), 10U);
    for (const json& feature : outlines["features"]) {
        const json& rock = feature["properties"];
        EXPECT_EQ(feature["id"], rock["rock"]);
        for (const json& line : feature["geometry"]["coordinates"]) {
            EXPECT_EQ(line.front(), line.back());
            for (const json& place : line) {
                EXPECT_NEAR(place[0].get<double>(), rock["easting_m"].get<double>(), 5);
                EXPECT_NEAR(place[1].get<double>(), rock["northing_m"].get<double>(), 5);
                EXPECT_NEAR(place[2].get<double>(), rock["elevation_m"].get<double>(), 5);
            }
        }
    }
    for (const char* flags : {" --frame scanner", " --frame local"}) {
        const auto run = runCli("rocks " + path("bell.json") + flags + " --outlines " + path("n.geojson"));
        EXPECT_EQ(run.code, 1) << flags;
        EXPECT_NE(run.err.find("--frame mine"), std::string::npos) << run.err;
    }
    ASSERT_TRUE(files::saveScan(*test::rockScene("hangup", 77, 120, 137).scan, *folder / "noplace.json"));
    const auto run = runCli("rocks " + path("noplace.json") + " --outlines " + path("n.geojson"));
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("give a pose"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("n.geojson")));
    ASSERT_EQ(runCli("rocks " + path("noplace.json") + " -o " + path("plain")).code, 0);
    EXPECT_FALSE(std::filesystem::exists(path("plain/noplace_rocks.geojson")));
    EXPECT_TRUE(std::filesystem::exists(path("plain/noplace_rocks_LOCAL.dxf")));
}

TEST_F(CliRocks, ADrawingHasTheNumberOfEachRockAtItsPlace) {
    const json report = rocks("--outlines " + path("o.dxf"));
    std::istringstream drawing(test::fileText(path("o.dxf")));
    std::map<std::string, std::array<double, 3>> places;
    std::string code, value, kind, layer;
    std::array<double, 3> place{};
    while (std::getline(drawing, code) && std::getline(drawing, value)) {
        const int number = std::stoi(code);
        if (number == 0) kind = value;
        if (number == 8) layer = value;
        if (kind != "TEXT") continue;
        if (number == 11 || number == 21 || number == 31) place[static_cast<std::size_t>(number / 10 - 1)] = std::stod(value);
        if (number == 1) {
            EXPECT_EQ(layer, "ROCK_NUMBERS");
            layer = value;
        }
        if (number == 73) places[layer] = place;
    }
    ASSERT_EQ(places.size(), report["rocks"].size());
    for (const json& rock : report["rocks"]) {
        const auto& at = places[std::to_string(rock["rock"].get<int>())];
        EXPECT_NEAR(at[0], rock["easting_m"].get<double>(), 0.0006);
        EXPECT_NEAR(at[1], rock["northing_m"].get<double>(), 0.0006);
        EXPECT_NEAR(at[2], rock["elevation_m"].get<double>(), 0.0006);
    }
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
    refused(path("bell.json") + " --split 1", 2, "--split");
    refused(path("bell.json") + " --json " + path("bell.json"), 2, "bell.json");
    std::ofstream(*folder / "bad.json") << R"({"format": "edgescan-rock-edits/1", "lines": 3, "beams": 3, "edits": []})";
    refused(path("bell.json") + " --edits " + path("bad.json"), 1, "bad.json");
    refused(path("bell.json") + " --edits " + path("bad.json") + " --json " + path("bad.json"), 2, "bad.json");
    EXPECT_EQ(runCli("rocks " + path("bell.json") + " --json - --edits " + path("bad.json")).out.find("{"), 0U);
}

} // namespace
} // namespace edgescan
