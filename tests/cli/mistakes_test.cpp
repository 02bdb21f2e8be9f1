// What a person types wrong, from tests/data/mistakes.txt: each mistake has its exit code and one message with what, where and what to do.
#include "tests/support/robot_files.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

/// A fresh folder with the files that the mistakes name, because some of them write.
void fill(const fs::path& folder, const fs::path& bell) {
    for (const char* name : {"BELL.json", "BELL.u16", "BELL.pcd", "BELL.csv"}) fs::copy_file(bell / name, folder / name);
    const std::string cloud = test::fileText(folder / "BELL.pcd");
    std::ofstream(folder / "empty.pcd");
    fs::copy_file(bell / "BELL.pcd", folder / "-x.pcd");
    std::ofstream(folder / "cut.pcd", std::ios::binary) << cloud.substr(0, cloud.size() / 2);
    std::ofstream(folder / "text.pcd") << "hello\nworld\n";
    std::ofstream table(folder / "ten.csv");
    for (int line = 0; line < 20; ++line) {
        for (int beam = 0; beam < 10; ++beam) table << 1 + line * beam % 7 << (beam < 9 ? "," : "\n");
    }
    const auto changed = [&](const char* name, const std::string& from, const std::string& to) {
        std::string text = test::fileText(folder / "BELL.json");
        std::ofstream(folder / name) << text.replace(text.find(from), from.size(), to);
    };
    changed("keys.json", "\"no_return\"", "\"no_retrun\"");
    changed("nodata.json", "BELL.u16", "NOPE.u16");
    changed("far.json", "\"unit_mm\": 1.0", "\"unit_mm\": 100.0");
    changed("near.json", "\"unit_mm\": 1.0", "\"unit_mm\": 0.001");
    changed("flat.json", "\"step\": 4.5", "\"step\": 0");
    std::ofstream(folder / "key.json") << R"({"format": "edgescan-preset/1", "settings": {"crease": 20}, "jump": 50})";
    std::ofstream(folder / "plain.json") << R"({"format": "edgescan-preset/1"})";
    const auto preset = [&](const char* name, const std::string& settings) {
        std::ofstream(folder / name) << R"({"format": "edgescan-preset/1", "settings": {)" << settings << "}}";
    };
    preset("nothing.json", "");
    preset("null.json", R"("jump": null)");
    preset("jump.json", R"("jump": 50)");
    preset("gray.json", R"("method": "edgescan+", "lower": 20, "kernel": 5)");
    preset("both.json", R"("sensitivity": 2, "edge-strength": 3)");
    preset("typo.json", R"("jmp": 50)");
    std::ofstream(folder / "scan000.pose") << "0 0 0\n0 0 0\n";
    std::ofstream(folder / "comma.json") << "{\"format\": \"edgescan-pose/1\",\n \"heading_deg\": 217,4}\n";
    Calibration robot = test::exampleCalibration();
    robot.axis = Eigen::Vector3d::UnitX();
    std::ofstream(folder / "robot.json") << test::calibrationText(robot);
    std::ofstream(folder / "BELL_edges.json") << R"({"schema": "edgescan-detect/1"})";
    std::ofstream(folder / "cal.json") << R"({"format": "x"})";
    for (const char* name : {"a.fls", "a.zfs", "a.rcp", "a.lgs"}) {
        std::ofstream file(folder / name, std::ios::binary);
        for (int n = 0; n < 1024; ++n) file.put(static_cast<char>(n));
    }
    std::ofstream(folder / "one.csv") << "1,2,3\n";
    const auto pose = [&](const char* name, double eastingM, const char* zone, const char* north) {
        std::ofstream(folder / name) << R"({"format": "edgescan-pose/1", "boom": {"azimuth_deg": 0},
            "inclinometer": {"tilt_x_deg": 0.4, "tilt_y_deg": -0.2},
            "talin": {"easting_m": )" << eastingM
                                     << R"(, "northing_m": 312345, "elevation_m": 287, "heading_deg": 90, "heading_ref": ")" << north
                                     << R"(", "pitch_deg": 0, "roll_deg": 0, "zone": ")" << zone << R"(", "datum": "WGS84"},
            "calibration": {"format": "edgescan-calibration/1", "stepper": {"axis": [1, 0, 0]},
                            "inclinometer": {"viewing": "up", "reads": "pitch_roll"}}})";
    };
    pose("swapped.json", 5150123, "17N", "grid");
    pose("zone.json", 312345, "99N", "grid");
    pose("magnetic.json", 312345, "17N", "magnetic");
    fs::create_directory(folder / "folder");
    fs::create_directory(folder / "fold");
    fs::copy_file(bell / "BELL.pcd", folder / "fold/BELL.pcd");
    fs::copy_file(bell / "BELL.mcap", folder / "fold/BELL.mcap");
}

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(' ');
    return from == std::string::npos ? std::string() : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

TEST(Mistakes, EachHasItsExitCodeAndMessage) {
    const test::TemporaryFolder bell;
    ASSERT_EQ(test::runLab("simulate -o " + (bell / "BELL.json").string() + " --seed 7 --lines 40 --beams 60").code, 0);
    for (const char* name : {"BELL.pcd", "BELL.csv", "BELL.mcap"})
        ASSERT_EQ(test::runCli("convert " + (bell / "BELL.json").string() + " " + (bell / name).string()).code, 0);
    std::istringstream rows(test::fileText(fs::path(test::sourceFolder()) / "tests/data/mistakes.txt"));
    int mistakes = 0;
    for (std::string row; std::getline(rows, row);) {
        if (row.empty() || row.starts_with('#')) continue;
        const std::size_t first = row.find(" | "), second = row.find('|', first + 3);
        ASSERT_TRUE(first != std::string::npos && second != std::string::npos) << row;
        std::string typed = row.substr(0, first);
        const int code = std::stoi(row.substr(first + 3));
        const std::string message = trimmed(row.substr(second + 1));
        const bool ofLab = typed.starts_with("lab ");
        if (ofLab) typed.erase(0, 4);
        const test::TemporaryFolder folder;
        fill(folder.path(), bell.path());
        const std::string there = "--version >/dev/null && cd " + folder.path().string() + " && " + test::programFolder() + "/";
        const auto run = test::runProgram("edgescan-cli", there + (ofLab ? "edgescan-lab " : "edgescan-cli ") + typed);
        ++mistakes;
        EXPECT_EQ(run.code, code) << row << "\n" << run.err;
        EXPECT_NE(run.err.find(message), std::string::npos) << row << "\n" << run.err;
        EXPECT_EQ(run.err.find("--help)"), std::string::npos) << row << "\n" << run.err; // the message of the parser
    }
    EXPECT_GE(mistakes, 240);
}

} // namespace
} // namespace edgescan
