// Output files of the commands: inputs are never overwritten, the frame is one that the format can store, and other programs can read the
// files.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/folders.h"
#include "tests/support/placements.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>
#include <sstream>
#include <sys/resource.h>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::fileText;
using test::runCli;

TEST(CliOutputs, NoInputIsReplacedByWhateverNameOrLink) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    const Scan scan = test::boxesScan(20, 30, 3);
    ASSERT_TRUE(files::saveScan(scan, folder / "a.pcd"));
    ASSERT_TRUE(files::saveScan(scan, folder / "grid.json"));
    std::ofstream(folder / "preset.json") << R"({"format":"edgescan-preset/1","settings":{"method":"canny"}})";
    fs::create_symlink("a.pcd", folder / "link.pcd");
    fs::create_hard_link(folder / "a.pcd", folder / "hard.pcd");
    fs::create_directory(folder / "deep");
    const std::string before = fileText(folder / "a.pcd"), counts = fileText(folder / "grid.u16"), grid = fileText(folder / "grid.json");
    for (const std::string& line :
         {"detect " + path("a.pcd") + " --cloud " + path("a.pcd"), "detect " + path("a.pcd") + " --edges " + path("link.pcd"),
          "detect " + path("link.pcd") + " --edges " + path("a.pcd"), "detect " + path("a.pcd") + " --json " + path("hard.pcd"),
          "detect " + path("a.pcd") + " --mask " + path("deep/../a.pcd"), "convert " + path("a.pcd") + " " + path("a.pcd"),
          "convert " + path("grid.json") + " " + path("grid.u16"), "convert " + path("grid.u16") + " " + path("grid.json"),
          "detect " + path("grid.json") + " --mask " + path("grid.u16"),
          "detect " + path("a.pcd") + " " + path("grid.json") + " -o " + folder.path().string()}) {
        const auto run = runCli(line);
        if (line.find(" -o ") == std::string::npos) {
            EXPECT_NE(run.code, 0) << line;
            // The ending of a picture and of JSON is refused first.
            const char* said = line.find(" --mask ") != std::string::npos   ? "use .png"
                               : line.find(" --json ") != std::string::npos ? "is not a name for JSON"
                                                                            : "read as an input";
            EXPECT_NE(run.err.find(said), std::string::npos) << line << "\n" << run.err;
        }
        EXPECT_EQ(fileText(folder / "a.pcd"), before) << line;
        EXPECT_EQ(fileText(folder / "grid.u16"), counts) << line;
        EXPECT_EQ(fileText(folder / "grid.json"), grid) << line;
    }
    const std::string preset = fileText(folder / "preset.json");
    EXPECT_NE(runCli("detect " + path("a.pcd") + " --preset " + path("preset.json") + " --json " + path("preset.json")).code, 0);
    EXPECT_EQ(fileText(folder / "preset.json"), preset);
    EXPECT_EQ(runCli("detect " + path("a.pcd") + " --edges " + path("x.pcd") + " --cloud " + path("deep/../x.pcd")).code, 2);
    EXPECT_FALSE(fs::exists(folder / "x.pcd"));
    EXPECT_EQ(runCli("detect " + path("a.pcd") + " --edges " + path("x.pcd")).code, 0);
    EXPECT_EQ(runCli("detect " + path("a.pcd") + " --edges " + path("x.pcd")).code, 0) << "an output may be written again";
}

TEST(CliOutputs, NoResultTakesThePlaceOfAnotherHoweverItIsSpelled) {
    const test::TemporaryFolder folder;
    const std::string scan = (folder / "a.pcd").string(), out = (folder / "x.pcd").string();
    ASSERT_TRUE(files::saveScan(test::boxesScan(20, 30, 3), scan));
    const std::string near = "nowhere-else.pcd"; // in the working directory of the program
    for (const std::string& line : {"detect " + scan + " --edges " + near + " --cloud ./" + near, "detect " + scan + " --edges - --json -",
                                    "detect " + scan + " --edges " + out + " --json " + out + ".provenance.json",
                                    "rocks " + scan + " --json " + out + " --csv " + out,
                                    "detect " + scan + " -o " + folder.path().string() + " --json " + (folder / "a_gray.png").string(),
                                    "compare " + scan + " " + scan + " --json " + near + " --picture ./" + near,
                                    "calibrate " + scan + " -o " + near + " --json " + fs::absolute(near).string()}) {
        EXPECT_NE(runCli(line).code, 0) << line;
        EXPECT_FALSE(fs::exists(near)) << line;
        EXPECT_FALSE(fs::exists(out)) << line;
    }
}

TEST(CliOutputs, AFileBeyondItsLimitIsRefusedAndNotTheEndOfTheProgram) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(files::saveScan(test::boxesScan(40, 60, 3), folder / "a.json"));
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 8192;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto run = runCli("detect " + (folder / "a.json").string() + " --cloud " + (folder / "x.pcd").string());
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("larger than the limit set for it"), std::string::npos) << run.err;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2) << "the grid and its counts";
}

TEST(CliOutputs, XyzIsNumbersAndCsvAHeaderAndNumbers) {
    const test::TemporaryFolder folder;
    Scan scan = test::boxesScan(20, 30, 3, 0.1);
    ASSERT_TRUE(files::saveScan(scan, folder / "s.json"));
    const std::size_t valid = countCells(scan)[static_cast<std::size_t>(CellState::Valid)];
    for (const char* command : {"convert s.json c.EXT", "detect s.json --cloud c.EXT"}) {
        for (const std::string extension : {"xyz", "csv"}) {
            std::string line = command;
            line.replace(line.find("EXT"), 3, extension);
            ASSERT_EQ(
                std::system(
                    ("cd " + folder.path().string() + " && " + test::programFolder() + "/edgescan-cli " + line + " 2>/dev/null").c_str()),
                0);
            std::istringstream text(fileText(folder / ("c." + extension)));
            std::size_t rows = 0;
            for (std::string row; std::getline(text, row); ++rows) {
                if (rows == 0 && extension == "csv") {
                    EXPECT_TRUE(row.starts_with("x_m,y_m,z_m,line,beam,range_mm")) << row;
                    continue;
                }
                EXPECT_EQ(row.find_first_not_of("0123456789.-+e ,"), std::string::npos) << row;
                if (extension == "xyz") {
                    EXPECT_EQ(std::count(row.begin(), row.end(), ' '), 2) << row;
                }
            }
            EXPECT_EQ(rows, valid + (extension == "csv" ? 1 : 0)) << line;
        }
    }
    ASSERT_EQ(runCli("convert " + (folder / "s.json").string() + " " + (folder / "all.csv").string() + " --comments").code, 0);
    EXPECT_TRUE(fileText(folder / "all.csv").starts_with("# edgescan {"));
}

TEST(CliOutputs, WhatHoldsNoPlaceIsInMineCoordinates) {
    const test::TemporaryFolder folder;
    Scan scan = test::boxesScan(20, 30, 3);
    scan.placement = test::randomPlacement(3, 1, true);
    ASSERT_TRUE(files::saveScan(scan, folder / "s.json"));
    for (const std::string extension : {"dxf", "obj", "ptx", "xyz", "csv"}) {
        const auto run = runCli("convert " + (folder / "s.json").string() + " " + (folder / ("c." + extension)).string());
        ASSERT_EQ(run.code, 0) << run.err;
        const std::string text = fileText(folder / ("c." + extension));
        EXPECT_NE(text.find("6200"), std::string::npos) << extension; // the Northing
        const auto scanner =
            runCli("convert " + (folder / "s.json").string() + " " + (folder / ("s." + extension)).string() + " --frame scanner");
        EXPECT_NE(scanner.err.find("does not hold the scan's place"), std::string::npos) << extension << scanner.err;
    }
    // The matrix of PTX stores the place: the same coordinates again, cell by cell.
    const auto info = json::parse(runCli("info " + (folder / "c.ptx").string()).out);
    EXPECT_TRUE(info["pose"].is_object()) << info.dump();
    EXPECT_EQ(runCli("convert " + (folder / "s.json").string() + " " + (folder / "f.json").string() + " --frame mine").code, 2);
}

} // namespace
} // namespace edgescan
