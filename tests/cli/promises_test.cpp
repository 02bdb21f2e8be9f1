// The promises of docs/reference/rules.md, tried from outside with the programs alone; and docs/measurements/make-reliability, which lists
// for each promise the tests that try it.
#include "tests/support/folders.h"
#include "tests/support/robot_files.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::fileText;
using test::runCli;
using test::runLab;

class Promises : public testing::Test {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string simulated(const std::string& name, const std::string& how) const {
        EXPECT_EQ(runLab("simulate -o " + path(name) + " " + how).code, 0) << how;
        return path(name);
    }
    [[nodiscard]] static json detected(const std::string& arguments) {
        const auto run = runCli("detect " + arguments + " --json -");
        EXPECT_EQ(run.code, 0) << arguments << run.err;
        return run.code == 0 ? json::parse(run.out) : json();
    }
    // A scan and the same with a place in the mine.
    [[nodiscard]] std::string placed(const std::string& scan, const std::string& name) const {
        Calibration robot = test::exampleCalibration();
        robot.axis = {1, 0, 0}; // of a sweep
        std::ofstream(path("robot.json")) << test::calibrationText(robot);
        std::ofstream(path("pose.json")) << R"({"format": "edgescan-pose/1", "robot": "example robot", "boom": {"azimuth_deg": 33.5},
            "inclinometer": {"tilt_x_deg": 14.25, "tilt_y_deg": -3.4},
            "talin": {"easting_m": 620765.432, "northing_m": 6200123.456, "elevation_m": 287.654, "heading_deg": 217.4,
                      "pitch_deg": 5.75, "roll_deg": -2.1}})";
        const auto run =
            runCli("convert " + scan + " " + path(name) + " --pose " + path("pose.json") + " --calibration " + path("robot.json"));
        EXPECT_EQ(run.code, 0) << run.err;
        return path(name);
    }

    test::TemporaryFolder folder_;
};

TEST_F(Promises, S3DropOutsOfAFlatWallAreNoEdgesAndTheRimOfAnOpeningIsAClassOfItsOwn) {
    const auto whole = detected(simulated("whole.json", "--scene wall --seed 4 --lines 160 --beams 241"));
    for (const char* share : {"0.002", "0.05", "0.2"}) {
        const auto wall =
            detected(simulated("wall.json", "--scene wall --seed 4 --lines 160 --beams 241 --dropouts " + std::string(share)));
        EXPECT_EQ(wall["edges"], wall["classes"]["rim"]) << share; // where the wall ends, and not at a drop-out:
        EXPECT_LE(wall["classes"]["rim"], whole["classes"]["rim"]) << share;
        EXPECT_GT(wall["cells"]["no_return"], 0);
    }
    const std::string opening = simulated("opening.json", "--scene wall --hole-shape round --seed 4 --lines 160 --beams 241");
    const auto usual = detected(opening), without = detected(opening + " --classes jump,convex,concave,silhouette");
    for (const char* rock : {"jump", "convex", "concave"}) {
        EXPECT_EQ(usual["classes"][rock], 0) << rock;
        EXPECT_EQ(without["classes"][rock], 0) << rock;
    }
    EXPECT_GT(usual["classes"]["rim"], 20);
    EXPECT_EQ(usual["edges"], usual["classes"]["rim"].get<int>() + usual["classes"]["silhouette"].get<int>());
    EXPECT_EQ(without["edges"], without["classes"]["silhouette"]);
}

// The coordinates of every edge point, by two formats that hold them as text, and through a binary one and back.
TEST_F(Promises, S9MineCoordinatesAreTheSameInEveryFormatToAMillimetre) {
    const std::string scan = placed(simulated("bell.json", "--seed 6 --lines 60 --beams 91"), "placed.json");
    const auto coordinates = [&](const std::string& from, const std::string& name) {
        EXPECT_EQ(runCli("convert " + from + " " + path(name) + " --frame mine").code, 0) << from;
        std::vector<double> numbers;
        std::istringstream rows(fileText(path(name)));
        for (std::string row; std::getline(rows, row);) {
            std::istringstream cells(row);
            double e = 0, n = 0, h = 0;
            if (cells >> e >> n >> h) numbers.insert(numbers.end(), {e, n, h});
        }
        return numbers;
    };
    const auto expected = coordinates(scan, "expected.xyz");
    ASSERT_GT(expected.size(), 3000U);
    EXPECT_NEAR(expected[0], 620765, 100);
    EXPECT_NEAR(expected[1], 6200123, 100);
    for (const char* format : {"csv", "pcd", "ply", "las", "ptx", "obj", "mcap"}) {
        const std::string between = path("between." + std::string(format));
        const auto made = runCli("convert " + scan + " " + between);
        ASSERT_EQ(made.code, 0) << format << made.err;
        const auto found = coordinates(between, "back.xyz");
        ASSERT_EQ(found.size(), expected.size()) << format;
        double most = 0;
        for (std::size_t n = 0; n < found.size(); ++n) most = std::max(most, std::abs(found[n] - expected[n]));
        EXPECT_LE(most, 0.001) << format;
    }
}

TEST_F(Promises, S13WarningsAreInTheResultTheRecordsAndTheReport) {
    const std::string scan = simulated("slipped.json", "--seed 5 --lines 260 --beams 181 --slips 0.05");
    const auto warnings = detected(scan + " -o " + path("out"))["warnings"];
    ASSERT_FALSE(warnings.empty());
    std::size_t records = 0;
    for (const auto& entry : fs::directory_iterator(path("out"))) {
        if (!entry.path().string().ends_with(".provenance.json")) continue;
        ++records;
        for (const auto& warning : warnings) {
            const auto listed = json::parse(fileText(entry.path()))["record"]["warnings"];
            EXPECT_NE(std::find(listed.begin(), listed.end(), warning), listed.end()) << entry.path() << warning;
        }
    }
    EXPECT_GE(records, 4U);
    ASSERT_EQ(runCli("report " + scan + " -o " + path("report.html")).code, 0);
    const std::string first = warnings[0].get<std::string>();
    EXPECT_NE(fileText(path("report.html")).find(first.substr(0, first.find(' ', 30))), std::string::npos) << first;
}

TEST_F(Promises, S18NoSettingTakesACellAway) {
    const std::string scan = simulated("dusty.json", "--seed 7 --lines 120 --beams 161 --dust 0.02 --dropouts 0.02 --status-codes 0.01");
    const auto cells = detected(scan)["cells"];
    int sum = 0;
    for (const auto& [state, number] : cells.items()) sum += number.get<int>();
    EXPECT_EQ(sum, 120 * 161);
    for (const char* setting : {"--mask-missing off", "--mask-isolated off", "--near 3000 --far 5000 --scaling window --method canny",
                                "--min-length 50", "--sensitivity 3", "--fill 20", "--slips off", "--preset thesis", "--classes border"})
        EXPECT_EQ(detected(scan + " " + setting)["cells"], cells) << setting;
}

TEST_F(Promises, S19TheRecordNamesTheDefaultSettingsAndWhatWasChanged) {
    const std::string scan = simulated("bell.json", "--seed 8 --lines 60 --beams 91");
    const auto changed = [&](const std::string& flags) {
        EXPECT_EQ(runCli("detect " + scan + " --mask " + path("mask.png") + flags).code, 0);
        return json::parse(fileText(path("mask.png.provenance.json")))["record"]["default_settings"];
    };
    const auto usual = changed("");
    EXPECT_EQ(usual["name"], "default");
    EXPECT_TRUE(usual["version"].is_number());
    EXPECT_EQ(usual["changed"], json::array());
    EXPECT_EQ(changed(" --jump 40 --min-length 9")["changed"], json::array({"jump", "min-length"}));
}

TEST_F(Promises, S20ScansWithoutAPoseAreOutOfSpecAndOneOfTwoIsRefused) {
    const std::string bare = simulated("bare.json", "--seed 9 --lines 90 --beams 121"), inMine = placed(bare, "placed.json");
    const std::string again = simulated("again.json", "--seed 9 --lines 90 --beams 121 --sweep-number 1");
    const auto without = runCli("compare " + bare + " " + again + " --json -");
    ASSERT_EQ(without.code, 0) << without.err;
    EXPECT_EQ(json::parse(without.out)["out_of_spec"], true);
    EXPECT_NE(without.out.find("OUT OF SPEC: without a pose of both"), std::string::npos);
    const auto one = runCli("compare " + bare + " " + inMine + " --json -");
    EXPECT_EQ(one.code, 1);
    EXPECT_NE(one.err.find("give it a pose"), std::string::npos) << one.err;
    const auto both = runCli("compare " + inMine + " " + placed(again, "again-placed.json") + " --json -");
    ASSERT_EQ(both.code, 0) << both.err;
    EXPECT_EQ(json::parse(both.out)["lined_up_by"], "poses");
    const auto itself = json::parse(runCli("compare " + bare + " " + bare + " --json -").out);
    EXPECT_EQ(itself["lined_up_by"], "one scan");
    EXPECT_EQ(itself["out_of_spec"], false);
    EXPECT_EQ(itself["warnings"], json::array({"Both are one scan: the files are the same."}));
}

// ---- docs/measurements/make-reliability

std::set<std::string> found(const std::string& text, const std::string& pattern) {
    std::set<std::string> all;
    const std::regex wanted(pattern);
    for (std::sregex_iterator it(text.begin(), text.end(), wanted), end; it != end; ++it) all.insert((*it)[1]);
    return all;
}

TEST(Reliability, EveryPromiseHasARow) {
    const fs::path root = test::sourceFolder();
    const auto promised = found(fileText(root / "docs/reference/rules.md"), "## (S[0-9]+):");
    std::set<std::string> all;
    for (int n = 1; n <= 20; ++n) all.insert("S" + std::to_string(n));
    EXPECT_EQ(promised, all);
    EXPECT_EQ(found(fileText(root / "docs/measurements/make-reliability"), "\\(\"(S[0-9]+) "), promised);
    EXPECT_EQ(found(fileText(root / "docs/measurements/reliability.md"), "\\| (S[0-9]+) "), promised);
}

// Whether a pattern with stars, as those of --gtest_filter, matches a name.
bool matches(const std::string& pattern, const std::string& name) {
    std::string wanted;
    for (const char c : pattern)
        wanted += c == '*'                                                       ? ".*"
                  : std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? std::string(1, c)
                                                                                 : std::string("\\") + c;
    return std::regex_match(name, std::regex(wanted));
}

// A test that was renamed would be missing in the page without a word.
TEST(Reliability, EveryTestOfARowExists) {
    const fs::path tests = fs::path(test::sourceFolder()) / "tests";
    std::map<std::string, std::set<std::string>> names; // by program
    for (const char* folder : {"unit", "cli"}) {
        std::set<std::string>& of = names[std::string("edgescan_") + (folder == std::string("cli") ? "cli_test" : "unit")];
        for (const auto& entry : fs::recursive_directory_iterator(tests / folder)) {
            const std::string text = entry.is_regular_file() ? fileText(entry.path()) : "";
            for (const std::string& test : found(text, "\nTEST(?:_F|_P)?\\((\\w+,\\s*\\w+)\\)"))
                of.insert(std::regex_replace(test, std::regex(",\\s*"), "."));
        }
    }
    for (const auto& entry : fs::directory_iterator(tests / "ui"))
        names[entry.path().stem().string()] = found(fileText(entry.path()), "\n    void (\\w+)\\(\\)");
    const std::string script = fileText(fs::path(test::sourceFolder()) / "docs/measurements/make-reliability");
    std::size_t rows = 0;
    static const std::regex row("\\((UNIT|CLI|\"\\w+_test\"),\\s*\"([^\"]+)\"");
    for (std::sregex_iterator it(script.begin(), script.end(), row), end; it != end; ++it, ++rows) {
        const std::string which = (*it)[1];
        const std::string program = which == "UNIT"  ? "edgescan_unit"
                                    : which == "CLI" ? "edgescan_cli_test"
                                                     : which.substr(1, which.size() - 2);
        std::istringstream parts(std::regex_replace((*it)[2].str(), std::regex("[: ]"), "\n"));
        for (std::string part; std::getline(parts, part);) {
            const auto& of = names[program];
            EXPECT_TRUE(std::any_of(of.begin(), of.end(),
                                    [&](const std::string& name) { return matches(part, name) || matches("*/" + part, name); }))
                << program << " has no test " << part;
        }
    }
    EXPECT_GT(rows, 40U);
}

} // namespace
} // namespace edgescan
