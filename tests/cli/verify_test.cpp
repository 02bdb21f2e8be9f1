// edgescan-cli verify from outside, on files written by detect.
#include "core/files/open_save/save_scan.h"
#include "tests/support/placements.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace edgescan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using test::runCli;

TEST(CliVerify, WhatDetectWroteIsIdenticalUntilAByteChanges) {
    const test::TemporaryFolder folder;
    Scan scan = test::boxesScan(40, 60, 3, 0.05);
    scan.placement = test::randomPlacement(3, 1, true);
    const std::string scanPath = (folder / "boxes.json").string();
    ASSERT_TRUE(files::saveScan(scan, scanPath));
    const auto path = [&](const char* name) { return (folder / name).string(); };
    const auto detect = runCli("detect " + scanPath + " --preset log --lower 11 --mask " + path("m.png") + " --gray " + path("g.png") +
                               " --range " + path("r.png") + " --edges " + path("e.ply") + " --cloud " + path("c.csv"));
    ASSERT_EQ(detect.code, 0) << detect.err;
    const std::string all = path("m.png") + " " + path("g.png") + " " + path("r.png") + " " + path("e.ply") + " " + path("c.csv");
    const auto verify = runCli("verify " + all);
    EXPECT_EQ(verify.code, 0) << verify.out << verify.err;
    EXPECT_EQ(std::count(verify.out.begin(), verify.out.end(), '\n'), 5);
    EXPECT_EQ(verify.out.find("NOT identical"), std::string::npos) << verify.out;
    EXPECT_EQ(verify.err, "");
    const auto everything = runCli("verify " + path("?.png*") + " " + path("e.ply.provenance.json"));
    EXPECT_EQ(everything.code, 0) << everything.err;
    EXPECT_EQ(std::count(everything.out.begin(), everything.out.end(), '\n'), 4)
        << "a record beside an export stands for it: " << everything.out;
    // The scan has a pose, so the clouds are in mine coordinates.
    EXPECT_TRUE(test::fileText(folder / "c.csv").starts_with("easting_m,northing_m,elevation_m,line,beam,range_mm,edge\n"));
    std::string bytes = test::fileText(folder / "e.ply");
    bytes[bytes.size() - 5] = static_cast<char>(bytes[bytes.size() - 5] ^ 4);
    std::ofstream(folder / "e.ply", std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto bad = runCli("verify --json - " + path("e.ply"));
    EXPECT_EQ(bad.code, 3);
    const json report = json::parse(bad.out);
    EXPECT_EQ(report["identical"], false);
    EXPECT_EQ(report["first_difference"], bytes.size() - 5);
    // The export is far from the scan; --scans finds it.
    const test::TemporaryFolder away;
    std::filesystem::copy(folder / "m.png", away / "m.png");
    const auto lost = runCli("verify " + (away / "m.png").string());
    EXPECT_EQ(lost.code, 1);
    EXPECT_NE(lost.err.find("--scans"), std::string::npos) << lost.err;
    EXPECT_EQ(runCli("verify " + (away / "m.png").string() + " --scans " + folder.path().string()).code, 0);
    EXPECT_EQ(runCli("verify " + (away / "m.png").string() + " " + path("g.png")).code, 4) << "one of two cannot be checked";
    EXPECT_EQ(runCli("verify " + (away / "m.png").string() + " " + path("e.ply")).code, 3)
        << "a difference counts more than a missing scan";
    EXPECT_EQ(runCli("verify").code, 2);
    const auto old = runCli("verify --json " + path("g.png"));
    EXPECT_EQ(old.code, 2) << "--json was a switch once";
    EXPECT_NE(old.err.find("not a name for JSON"), std::string::npos) << old.err;
    ASSERT_EQ(runCli("verify " + path("g.png") + " --json " + path("said.json")).code, 0);
    EXPECT_EQ(json::parse(test::fileText(path("said.json")))["identical"], true);
    EXPECT_EQ(json::parse(runCli("info " + scanPath).out)["pose"]["origin_enh_m"], json({620000.0, 6200000.0, 250.0}));
}

// "verify RESULTS/*" names reports, too: no record is ever written for them, and they do not count as failed.
TEST(CliVerify, ReportsHaveNoRecord) {
    const test::TemporaryFolder folder;
    const std::string scan = (folder / "boxes.json").string(), results = (folder / "results").string();
    ASSERT_TRUE(files::saveScan(test::boxesScan(40, 60, 3, 0.05), scan));
    const auto detect = runCli("detect " + scan + " -o " + results);
    ASSERT_EQ(detect.code, 0);
    EXPECT_NE(detect.err.find("edge cells of 2400"), std::string::npos) << "it says what it found and wrote: " << detect.err;
    EXPECT_NE(detect.err.find("boxes_edges.png"), std::string::npos) << detect.err;
    ASSERT_EQ(runCli("report " + scan + " -o " + results + "/page.html").code, 0);
    const auto all = runCli("verify --scans " + folder.path().string() + " " + results + "/*");
    EXPECT_EQ(all.code, 0) << all.err;
    EXPECT_NE(all.err.find("page.html: this is a report, for which no record is written"), std::string::npos) << all.err;
    EXPECT_NE(all.err.find("boxes_edges.json: this is a report"), std::string::npos) << all.err;
    const auto only = runCli("verify " + results + "/page.html");
    EXPECT_EQ(only.code, 1);
    EXPECT_EQ(only.err.find("copy"), std::string::npos) << "of a record that nothing writes: " << only.err;
}

TEST(CliVerify, EveryPartOfTheRecordIsCovered) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(files::saveScan(test::boxesScan(20, 30, 3), folder / "boxes.json"));
    const std::string exported = (folder / "e.pcd").string();
    const std::filesystem::path sidecar = exported + ".provenance.json";
    ASSERT_EQ(runCli("detect " + (folder / "boxes.json").string() + " --edges " + exported).code, 0);
    const ordered_json original = ordered_json::parse(test::fileText(sidecar));
    const auto verifyWith = [&](const ordered_json& altered) {
        std::ofstream(sidecar) << altered.dump();
        return runCli("verify " + exported);
    };
    EXPECT_EQ(verifyWith(original).code, 0) << "as it was, laid out otherwise";
    for (const auto& [key, value] : original["export"].items()) {
        ordered_json altered = original;
        altered["export"][key] = value.is_number() ? ordered_json(value.get<double>() + 1) : ordered_json("another");
        const auto run = verifyWith(altered);
        EXPECT_EQ(run.code, 3) << key;
        EXPECT_NE(run.out.find(": identical to what"), std::string::npos) << key << run.out << run.err;
        EXPECT_NE(run.out.find("The file next to the export was altered"), std::string::npos) << key << run.out << run.err;
    }
    for (const char* key : {"cells", "warnings", "coordinates", "settings", "scanner"}) {
        ordered_json altered = original;
        altered["record"][key] = "another";
        EXPECT_EQ(verifyWith(altered).code, 3) << key;
    }
    std::ofstream(sidecar) << original.dump().substr(0, 500);
    const auto cut = runCli("verify " + exported);
    EXPECT_EQ(cut.code, 3) << cut.err;
    EXPECT_NE(cut.out.find(": identical to what"), std::string::npos) << cut.out;
    EXPECT_NE(cut.out.find("The record next to the export is damaged"), std::string::npos) << cut.out;
    EXPECT_EQ(cut.out.find("SHA-256"), std::string::npos) << cut.out;
    ordered_json later = original;
    later["format"] = "edgescan-provenance/7";
    const auto unknown = verifyWith(later);
    EXPECT_EQ(unknown.code, 1);
    EXPECT_NE(unknown.err.find("edgescan-provenance/7"), std::string::npos) << unknown.err;
    std::filesystem::remove(sidecar);
    EXPECT_EQ(runCli("verify " + exported).code, 0) << "the record inside is enough";
}

// Of `scan` in the folder `scans`: exported edges and clouds of every format verify.
void expectVerified(const std::string& scans, const std::string& scan) {
    const test::TemporaryFolder folder;
    std::string all;
    for (const char* name : {"e.pcd", "e.ply", "e.csv", "e.xyz"}) {
        const std::string path = (folder / name).string();
        ASSERT_EQ(runCli("detect " + scans + scan + " --edges " + path + " --cloud " + (folder / (std::string("c") + name)).string()).code,
                  0);
        all += path + " " + (folder / (std::string("c") + name)).string() + " ";
    }
    const auto verify = runCli("verify --scans " + scans + " " + all);
    EXPECT_EQ(verify.code, 0) << verify.out << verify.err;
}

TEST(CliVerify, AScanInEveryFormat) { expectVerified((test::ownData() / "thesis/").string(), "steps.json"); }

TEST(CliVerify, ARealScanInEveryFormat) {
    EDGESCAN_NEEDS_SHARED("data/lms200_corridor");
    expectVerified((test::sharedFolder() / "data/lms200_corridor/").string(), "scan000.3d");
}

} // namespace
} // namespace edgescan
