// A run over an archive from outside: broken scans, kill -9, shards and their merge. The table equals that of an undisturbed run.
#include "core/base/bounded_json.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/folders.h"
#include "tests/support/rock_scene.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <set>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::fileText;
using test::runCli;
using test::TemporaryFolder;

// Scans of three formats in folders. Two have the same name, four are broken.
void makeArchive(const fs::path& folder, int scans) {
    const char* extensions[]{".pcd", ".json", ".mcap"};
    for (int i = 0; i < scans; ++i) {
        const fs::path place = folder / ("bell" + std::to_string(i % 5));
        fs::create_directories(place);
        ASSERT_TRUE(files::saveScan(test::boxesScan(24, 30, static_cast<unsigned>(i)),
                                    place / ("scan" + std::to_string(i / 5) + extensions[i % 3])));
    }
    std::ofstream(folder / "bell0/empty.pcd");
    std::ofstream(folder / "bell1/page.mcap") << "<html>404</html>";
    std::ofstream(folder / "bell2/cut.pcd", std::ios::binary) << fileText(folder / "bell0/scan0.pcd").substr(0, 900);
    fs::create_symlink("/nowhere/gone.las", folder / "bell3/gone.las");
}

// The rows without times and durations.
std::vector<json> rowsOf(const fs::path& results) {
    std::vector<json> rows;
    std::istringstream lines(fileText(results / "results.ndjson"));
    for (std::string line; std::getline(lines, line);) {
        rows.push_back(json::parse(line));
        rows.back().erase("times");
    }
    return rows;
}

std::vector<std::string> filesBelow(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder).string());
    }
    std::ranges::sort(files);
    return files;
}

std::string inArchive(const TemporaryFolder& folder, const std::string& results, const std::string& more = "") {
    return "batch " + (folder / "archive").string() + " -o " + (folder / results).string() + " --jobs 2 " + more;
}

TEST(CliBatch, EveryScanHasARowAndABrokenOneEndsNothing) {
    const TemporaryFolder folder;
    makeArchive(folder / "archive", 20);
    const auto run = runCli(inArchive(folder, "r", "--results mask,gray,json,edges.ply"));
    ASSERT_EQ(run.code, 4) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report["scans"], 24);
    EXPECT_EQ(report["done"], 20);
    EXPECT_EQ(report["refused"].get<int>() + report["failed"].get<int>(), 4) << run.out;
    const auto rows = rowsOf(folder / "r");
    ASSERT_EQ(rows.size(), 24U);
    std::string before;
    for (const json& row : rows) {
        const std::string input = row["input"];
        EXPECT_LT(before, input); // in the order of the inputs
        before = input;
        if (row["outcome"] != "done") {
            EXPECT_NE(row["error"].get<std::string>().find("; "), std::string::npos) << row;
            EXPECT_FALSE(fs::exists(folder / "r" / row["results"].get<std::string>()));
            continue;
        }
        // The same results as `detect`.
        const json alone = json::parse(runCli("detect " + input + " --json -").out);
        for (const char* key : {"edges", "cells", "lines", "beams", "edge_mask_sha256", "warnings"})
            EXPECT_EQ(row[key], alone[key]) << input;
        const fs::path results = folder / "r" / row["results"].get<std::string>();
        for (const char* name : {"edges.png", "gray.png", "detect.json", "edges_LOCAL.ply", "edges.png.provenance.json"})
            EXPECT_TRUE(fs::exists(results / name)) << results / name;
    }
    EXPECT_EQ(runCli(inArchive(folder, "r", "--results mask,gray,json,edges.ply ")).code, 4);
    const auto again = json::parse(runCli(inArchive(folder, "r", "--results mask,gray,json,edges.ply")).out);
    EXPECT_EQ(again["unchanged"], 23) << again; // a missing file is searched for again
    EXPECT_TRUE(fileText(folder / "r/survey.html").find("scan0.pcd") != std::string::npos);
}

TEST(CliBatch, OnlyWhatChangedIsDoneAgain) {
    const TemporaryFolder folder;
    makeArchive(folder / "archive", 10);
    const auto worked = [&](const std::string& more = "") {
        return json::parse(runCli(inArchive(folder, "r", more)).out)["worked"].get<int>();
    };
    EXPECT_EQ(worked(), 14);
    fs::remove(folder / "archive/bell3/gone.las");
    EXPECT_EQ(worked(), 0);
    ASSERT_TRUE(files::saveScan(test::boxesScan(24, 30, 77), folder / "archive/bell0/scan0.pcd")); // other content
    EXPECT_EQ(worked(), 1);
    const fs::path counts = folder / "archive/bell1/scan0.u16"; // the data file of the named description
    std::string bytes = fileText(counts);
    bytes[40] = static_cast<char>(bytes[40] + 1);
    std::ofstream(counts, std::ios::binary) << bytes;
    EXPECT_EQ(worked(), 1);
    fs::remove(folder / "r" / rowsOf(folder / "r")[1]["results"].get<std::string>() / "edges.png"); // a deleted result
    EXPECT_EQ(worked(), 1);
    EXPECT_EQ(worked("--sensitivity 2"), 13); // other settings
    EXPECT_EQ(worked("--sensitivity 2"), 0);
    EXPECT_EQ(worked("--sensitivity 2 --retry"), 3);
    EXPECT_EQ(worked("--sensitivity 2 --results gray"), 13);
    for (const std::string& file : filesBelow(folder / "r/scans"))
        EXPECT_TRUE(file.ends_with("gray.png") || file.ends_with("gray.png.provenance.json")) << file << " is of an earlier run";
}

TEST(CliBatch, KilledThreeTimesAndContinuedItsTableIsThatOfAnUndisturbedRun) {
    const TemporaryFolder folder;
    makeArchive(folder / "archive", 120);
    ASSERT_EQ(runCli(inArchive(folder, "whole")).code, 4);
    const auto scans = static_cast<std::ptrdiff_t>(rowsOf(folder / "whole").size());
    const fs::path journal = folder / "r/.batch/rows.ndjson";
    const auto rowsDone = [&] {
        const std::string text = fileText(journal);
        return std::ranges::count(text, '\n');
    };
    for (int kill = 1; kill <= 3; ++kill) {
        const pid_t process = ::fork();
        ASSERT_GE(process, 0);
        if (process == 0) {
            const std::string program = test::programFolder() + "/edgescan-cli";
            const std::string archive = (folder / "archive").string(), results = (folder / "r").string();
            static_cast<void>(std::freopen("/dev/null", "w", stdout));
            static_cast<void>(std::freopen("/dev/null", "w", stderr));
            ::execl(program.c_str(), program.c_str(), "batch", archive.c_str(), "-o", results.c_str(), "--jobs", "2", nullptr);
            ::_exit(127);
        }
        const bool far = test::waitUntil([&] { return rowsDone() >= 25 * kill; });
        ::kill(process, SIGKILL);
        int status = 0;
        ::waitpid(process, &status, 0);
        ASSERT_TRUE(far) << "killed " << kill - 1 << " times, " << rowsDone() << " rows, exit status " << status;
        EXPECT_TRUE(rowsDone() == scans || !fs::exists(folder / "r/results.csv")) << "a table before all is done";
    }
    const auto last = runCli(inArchive(folder, "r"));
    ASSERT_EQ(last.code, 4) << last.err;
    EXPECT_GE(json::parse(last.out)["unchanged"].get<int>(), 74);
    EXPECT_EQ(rowsOf(folder / "r"), rowsOf(folder / "whole"));
    EXPECT_EQ(filesBelow(folder / "r/scans"), filesBelow(folder / "whole/scans"));
    EXPECT_FALSE(fs::exists(folder / "r/.batch/work"));
}

/// 4 where the run refused a scan or failed, else 0. Which scans a part has depends on their paths, also on that of the temporary folder.
int exitOf(const test::ProgramRun& run) {
    const json report = json::parse(run.out);
    return report["refused"].get<int>() + report["failed"].get<int>() > 0 ? 4 : 0;
}

TEST(CliBatch, PartsAndTheirMergeAreTheWhole) {
    const TemporaryFolder folder;
    makeArchive(folder / "archive", 30);
    ASSERT_EQ(runCli(inArchive(folder, "whole")).code, 4);
    const auto runPart = [&](int part) {
        const auto run = runCli(inArchive(folder, "r", "--shard " + std::to_string(part) + "/4"));
        EXPECT_EQ(run.code, exitOf(run)) << run.out << run.err;
    };
    for (const int part : {1, 2, 4}) runPart(part);
    const auto early = runCli(inArchive(folder, "r", "--merge"));
    EXPECT_EQ(early.code, 1);
    EXPECT_EQ(json::parse(early.out)["missing_elements"], json::array({3}));
    EXPECT_NE(early.err.find("run again with --shard 3/4, then the merge"), std::string::npos) << early.err;
    EXPECT_FALSE(fs::exists(folder / "r/results.csv"));
    runPart(3);
    ASSERT_EQ(runCli(inArchive(folder, "r", "--merge")).code, 4);
    EXPECT_EQ(rowsOf(folder / "r"), rowsOf(folder / "whole"));
}

TEST(CliBatch, WhatIsNotAJournalOrOfOtherSettingsIsRefusedWithASentence) {
    const TemporaryFolder folder;
    makeArchive(folder / "archive", 20); // a part of fewer may be empty, by the names of their files
    const auto first = runCli(inArchive(folder, "r", "--shard 1/2"));
    ASSERT_EQ(first.code, exitOf(first)) << first.err;
    const auto before = filesBelow(folder / "r/scans");
    const auto other = runCli(inArchive(folder, "r", "--shard 1/3 --jump 200"));
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("other settings were used in part 1 of 2"), std::string::npos) << other.err;
    EXPECT_EQ(filesBelow(folder / "r/scans"), before);
    const auto later = runCli(inArchive(folder, "r", "--shard 2/2 --jump 200"));
    EXPECT_EQ(later.code, exitOf(later));
    EXPECT_NE(later.err.find("part 1 of 2; run these again before the merge"), std::string::npos) << later.err;
    ASSERT_EQ(runCli(inArchive(folder, "s")).code, 4);
    std::ofstream(folder / "s/.batch/rows.ndjson", std::ios::app) << "[1, 2]\n";
    const auto odd = runCli(inArchive(folder, "s"));
    EXPECT_EQ(odd.code, 1);
    EXPECT_NE(odd.err.find("this line is not a row of a run"), std::string::npos) << odd.err;
}

TEST(CliBatch, NoTableAndNoResultReplacesAScanOrAReadOnlyFile) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "r");
    ASSERT_TRUE(files::saveScan(test::boxesScan(24, 30, 5), folder / "r/results.csv"));
    const std::string scan = fileText(folder / "r/results.csv"), command = "batch " + (folder / "r/results.csv").string() + " -o ";
    const auto input = runCli(command + (folder / "r").string());
    EXPECT_EQ(input.code, 1);
    EXPECT_NE(input.err.find("read as an input"), std::string::npos) << input.err;
    EXPECT_EQ(fileText(folder / "r/results.csv"), scan);
    ASSERT_EQ(runCli(command + (folder / "s").string()).code, 0);
    const auto rows = rowsOf(folder / "s");
    ASSERT_EQ(rows.size(), 1U);
    const fs::path mask = folder / "s" / rows[0]["results"].get<std::string>() / "edges.png";
    const std::string old = fileText(mask);
    fs::permissions(mask, fs::perms(0444));
    const auto again = runCli(command + (folder / "s").string() + " --jump 60");
    EXPECT_NE(again.err.find("edges.png: this file is read-only"), std::string::npos) << again.err;
    EXPECT_EQ(fileText(mask), old);
    EXPECT_EQ(rowsOf(folder / "s")[0]["outcome"], "failed");
}

TEST(CliBatch, WrongUsageIsRefusedBeforeAnythingIsRead) {
    const TemporaryFolder folder;
    makeArchive(folder / "archive", 5);
    for (const char* wrong : {"--results nothing", "--results edges", "--results edges.png", "--results mask.png", "--shard 5/4",
                              "--shard x", "--merge --shard 1/2", "--jobs -1", "--method none", "--memory nan"})
        EXPECT_EQ(runCli(inArchive(folder, "r", wrong)).code, 2) << wrong;
    const auto collide = runCli(inArchive(folder, "r", "--names '{stem}'"));
    EXPECT_EQ(collide.code, 1);
    EXPECT_NE(collide.err.find("{path}"), std::string::npos) << collide.err;
    EXPECT_EQ(runCli("batch " + (folder / "archive").string() + " -o " + (folder / "archive").string()).code, 1);
    EXPECT_FALSE(fs::exists(folder / "r"));
}

// A name is bytes. Two names that differ in a byte that is not UTF-8 stay two, in the tables and when the run goes on.
TEST(CliBatch, NamesThatAreNotUtf8HaveTheirRows) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "archive/d\xfe");
    const std::vector<std::string> names{"a\xfe.pcd",
                                         "a\xff.pcd",
                                         "a\xee\xbe\xbf.pcd",
                                         "a\\xff.pcd",
                                         "Gr\xc3\xb6\xc3\x9f"
                                         "e;=1+1.pcd",
                                         "d\xfe/b\xe4.pcd"};
    for (std::size_t n = 0; n < names.size(); ++n)
        ASSERT_TRUE(files::saveScan(test::boxesScan(24, 30, static_cast<unsigned>(n)), (folder / "archive").native() + "/" + names[n]));
    const auto run = runCli(inArchive(folder, "r", "--results mask,json,report"));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["missing"], 0);
    const std::string text = fileText(folder / "r/results.ndjson");
    std::set<std::string> inputs;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto row = parseJson(line, "");
        ASSERT_TRUE(row) << line;
        const std::string input = row->at("input");
        inputs.insert(fs::path(input).lexically_relative(folder / "archive").native());
        EXPECT_TRUE(fs::exists(input)) << line;
        EXPECT_TRUE(fs::exists(folder / "r" / row->at("results").get<std::string>() / "edges.png")) << line;
        const json detected = json::parse(fileText(folder / "r" / row->at("results").get<std::string>() / "detect.json"));
        const auto verified = runCli("verify '" + (folder / "r" / row->at("results").get<std::string>() / "edges.png").native() +
                                     "' --scans '" + fs::path(input).parent_path().native() + "'");
        EXPECT_EQ(verified.code, 0) << verified.err;
        EXPECT_EQ(detected["input"], json::parse(line)["input"]); // one escape in all documents
    }
    EXPECT_EQ(inputs, std::set<std::string>(names.begin(), names.end()));
    EXPECT_NE(text.find("a\\uefff.pcd"), std::string::npos);
    const std::string table = fileText(folder / "r/results.csv"), survey = fileText(folder / "r/survey.html");
    EXPECT_NE(table.find("a\uefff.pcd,"), std::string::npos);
    EXPECT_NE(table.find("e;'=1+1.pcd,"), std::string::npos);
    EXPECT_NE(survey.find("/a\\\\xfe.pcd\""), std::string::npos);
    EXPECT_NE(survey.find("/a%FF.pcd/report.html\""), std::string::npos);
    EXPECT_EQ(json::parse(runCli(inArchive(folder, "r", "--results mask,json,report")).out)["unchanged"], names.size());
    const auto info = runCli("info '" + (folder / "archive").native() + "/a\xff.pcd'");
    EXPECT_EQ(parseJson(info.out, "")->at("input"), (folder / "archive").native() + "/a\xff.pcd") << info.out;
}

TEST(CliBatch, RocksOfEachScanEqualThoseOfTheCommandAlone) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "archive");
    for (int n = 0; n < 3; ++n)
        ASSERT_TRUE(files::saveScan(*test::rockScene("hangup", 70U + static_cast<unsigned>(n), 160, 183).scan,
                                    folder / "archive" / ("bell" + std::to_string(n) + ".json")));
    const std::string wanted = "--results rocks,rock-table,rock-labels,rock-outlines.dxf,rock-hulls.obj,rock-cloud.pcd,report ";
    const auto run = runCli(inArchive(folder, "r", wanted + "--min-cells 60 --oversize 0.4"));
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = rowsOf(folder / "r");
    ASSERT_EQ(rows.size(), 3U);
    for (const json& row : rows) {
        const fs::path results = folder / "r" / row["results"].get<std::string>();
        const json alone = json::parse(runCli("rocks " + row["input"].get<std::string>() + " --min-cells 60 --oversize 0.4 --json -").out);
        ASSERT_GT(alone["rock_count"], 5);
        for (const char* key : {"rock_count", "size_curve", "fines", "labels_sha256"}) EXPECT_EQ(row["rocks"][key], alone[key]) << key;
        EXPECT_EQ(json::parse(fileText(results / "rocks.json"))["labels_sha256"], alone["labels_sha256"]);
        EXPECT_EQ(row["outputs"].size(), 7U + 6U) << row["outputs"]; // and their records
        EXPECT_NE(fileText(results / "report.html").find("<table id=\"rocks\">"), std::string::npos);
    }
    const std::string table = fileText(folder / "r" / "results.csv");
    EXPECT_NE(table.find(",rocks,rocks_visible_wide_p20_m,"), std::string::npos);
    EXPECT_NE(table.find(rows[0]["rocks"]["labels_sha256"].get<std::string>()), std::string::npos);
    const std::string survey = fileText(folder / "r/survey.html");
    const std::size_t first = survey.find("\"application/json\">") + std::string("\"application/json\">").size();
    const json shown = json::parse(survey.substr(first, survey.find("</script>", first) - first));
    ASSERT_EQ(shown.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(shown[i][0], rows[i]["input"]);
        EXPECT_EQ(shown[i][12], rows[i]["rocks"]["rock_count"]);
        EXPECT_EQ(shown[i][14], rows[i]["rocks"]["size_curve"]["visible_wide_p80_m"]);
    }
    // Other settings of rocks give other results; the same settings are recognised as unchanged.
    EXPECT_EQ(json::parse(runCli(inArchive(folder, "r", wanted + "--min-cells 60 --oversize 0.4")).out)["unchanged"], 3);
    EXPECT_EQ(json::parse(runCli(inArchive(folder, "r", wanted + "--min-cells 80 --oversize 0.4")).out)["worked"], 3);
    // Only in the table; without --rocks the flags of rocks have no effect.
    ASSERT_EQ(runCli(inArchive(folder, "t", "--results none --rocks")).code, 0);
    EXPECT_GT(rowsOf(folder / "t")[0]["rocks"]["rock_count"], 3);
    EXPECT_EQ(runCli(inArchive(folder, "u", "--min-cells 60")).code, 2);
    EXPECT_EQ(runCli(inArchive(folder, "u", "--results rock-hulls.dxf")).code, 2);
}

} // namespace
} // namespace edgescan
