// What the commands write: at the same time under one name, onto a full or faulty disk, in place of read-only files and through links. Only
// the files named here write to the disk (docs/measurements/reliability.md, "Files"). EDGESCAN_WRITER_ROUNDS=1000 is the long form.
#include "core/files/open_save/save_scan.h"
#include "tests/support/folders.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <regex>
#include <set>
#include <thread>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using test::fileText;
using test::runCli;
using test::TemporaryFolder;

int roundsOfCommands() {
    const char* text = std::getenv("EDGESCAN_WRITER_ROUNDS");
    return text == nullptr ? 2 : std::max(1, std::atoi(text));
}

std::string scanIn(const TemporaryFolder& folder) {
    EXPECT_TRUE(files::saveScan(test::boxesScan(40, 60, 3), folder / "a.json"));
    return (folder / "a.json").string();
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

void exportTogether(int writers) {
    const TemporaryFolder folder;
    const std::string scan = scanIn(folder), csv = (folder / "e.csv").string(), mask = (folder / "m.png").string();
    const auto command = [&](int writer) {
        return "detect " + scan + " --edges " + csv + " --mask " + mask + " --jump " + std::to_string(100 + 20 * (writer % 2));
    };
    ASSERT_EQ(runCli(command(0)).code, 0);
    const int rounds = roundsOfCommands();
    int other = 0;
    for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
        std::vector<std::thread> all;
        std::vector<test::ProgramRun> runs(static_cast<std::size_t>(writers));
        for (int writer = 0; writer < writers; ++writer)
            all.emplace_back([&, writer] { runs[static_cast<std::size_t>(writer)] = runCli(command(writer)); });
        for (std::thread& one : all) one.join();
        for (const test::ProgramRun& run : runs) EXPECT_EQ(run.code, 0) << run.err;
        for (const std::string& path : {csv, mask}) {
            const auto verified = runCli("verify " + path + " --scans " + folder.path().string());
            other += verified.code != 0 ? 1 : 0;
            EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
        }
        EXPECT_EQ(namesIn(folder.path()),
                  (std::vector<std::string>{"a.json", "a.u16", "e.csv", "e.csv.provenance.json", "m.png", "m.png.provenance.json"}));
    }
    std::cout << "[ measured ] " << writers << " commands export under the same names at the same time, " << rounds << " rounds: " << other
              << " exports that are not identical to what their record says\n";
}

TEST(CliWrites, TwoCommandsUnderOneNameBothSucceedAndTheLastOneStays) { exportTogether(2); }
TEST(CliWrites, TwentyCommandsUnderOneNameAllSucceedAndTheLastOneStays) { exportTogether(20); }

test::ProgramRun runOnDisk(const std::string& disk, const std::string& arguments) {
    const TemporaryFolder folder;
    const std::string command = disk + " LD_PRELOAD=" + test::slowDiskLibrary() + " " + test::programFolder() + "/edgescan-cli " +
                                arguments + " >" + (folder / "out").string() + " 2>" + (folder / "err").string() + " </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileText(folder / "out"), fileText(folder / "err")};
}

TEST(CliWrites, OnAFullDiskTheMessageNamesWhatWasWrittenAndWhatWasNot) {
    const TemporaryFolder folder;
    const std::string scan = scanIn(folder), results = (folder / "r").string();
    const auto run = runOnDisk("EDGESCAN_FULL_AFTER=12000", "detect " + scan + " -o " + results); // the clouds are larger
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("the disk is full, so this file was not written"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("nothing was written"), std::string::npos) << run.err;
    const std::size_t written = run.err.find("; written: ");
    ASSERT_NE(written, std::string::npos) << run.err;
    int results_there = 0;
    for (const std::string& name : namesIn(results)) {
        EXPECT_FALSE(name.ends_with(".part")) << name;
        if (name.ends_with(".provenance.json")) continue;
        ++results_there;
        EXPECT_NE(run.err.find(name, written), std::string::npos) << name << " is there: " << run.err;
    }
    EXPECT_GT(results_there, 0);
    EXPECT_NE(run.err.find("not written either: "), std::string::npos) << run.err;
    EXPECT_LT(run.err.find("a_edges.json"), written) << run.err;
}

TEST(CliWrites, OnADiskThatStoresOtherBytesTheOldFilesStay) {
    const TemporaryFolder folder;
    const std::string command = "detect " + scanIn(folder) + " --edges " + (folder / "e.csv").string();
    ASSERT_EQ(runCli(command).code, 0);
    const std::string before = fileText(folder / "e.csv"), record = fileText(folder / "e.csv.provenance.json");
    const auto run = runOnDisk("EDGESCAN_FALSE_DISK=1", command + " --jump 100");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("what was read back is not what was written"), std::string::npos) << run.err;
    EXPECT_EQ(fileText(folder / "e.csv"), before);
    EXPECT_EQ(fileText(folder / "e.csv.provenance.json"), record);
}

TEST(CliWrites, AReadOnlyFileIsNotReplaced) {
    const TemporaryFolder folder;
    const std::string scan = scanIn(folder);
    std::ofstream(folder / "old") << "old";
    fs::permissions(folder / "old", fs::perms(0444));
    for (const char* extension : {".csv", ".png", ".json", ".html", ".pcd", ".mcap"})
        fs::copy_file(folder / "old", folder / (std::string("x") + extension));
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    for (const std::string& command :
         {"detect " + scan + " --edges " + path("x.csv"), "detect " + scan + " --mask " + path("x.png"),
          "detect " + scan + " --json " + path("x.json"), "report " + scan + " -o " + path("x.html"),
          "convert " + scan + " " + path("x.pcd"), "thumbnail " + scan + " " + path("x.png"), "rocks " + scan + " --csv " + path("x.csv"),
          "simulate -o " + path("x.json") + " --lines 20 --beams 31"}) {
        const auto run = runCli(command);
        EXPECT_NE(run.code, 0) << command;
        EXPECT_NE(run.err.find("so it was not replaced"), std::string::npos) << command << "\n" << run.err;
    }
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        if (entry.path().stem() == "x") {
            EXPECT_EQ(fileText(entry.path()), "old") << entry.path();
        }
    }
}

TEST(CliWrites, ALinkToAResultThatIsNotThereYetIsThatResult) {
    const TemporaryFolder folder;
    const std::string scan = scanIn(folder);
    fs::create_symlink("x.csv", folder / "link.csv");
    const auto run = runCli("detect " + scan + " --edges " + (folder / "link.csv").string() + " --cloud " + (folder / "x.csv").string());
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("two results cannot have one file"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder / "x.csv"));
}

// Everything else goes through writeWholeFile(), moveWholeFiles() or appendWhole().
TEST(CliWrites, OnlyTheseFilesOfTheProgramTouchTheDisk) {
    static const std::regex raw(
        R"(\bofstream\b|std::fstream\b|\bfopen\b|O_CREAT|O_WRONLY|O_RDWR|[^A-Za-z]::(rename|unlink)\(|ftruncate|imwrite|QSaveFile|QTemporaryFile)"
        R"(|QSettings|(fs|filesystem)::(rename|remove|remove_all|copy|copy_file|resize_file)\(|QFile::(remove|rename|copy)|std::rename|::truncate\()"
        R"(|QDir::(remove|rename)|removeRecursively|\bQFile [a-z]+[({])");
    const std::set<std::string> known{
        "core/base/append_file.cpp",               // cuts a row that was written in part
        "core/base/audit_log/audit_log.cpp",       // appends under a lock
        "core/base/temporary_file.cpp",            // the one way to write a file
        "core/base/whole_file.cpp",                // renames it
        "core/batch/archive/journal.cpp",          // appends under a lock; removes its own folder of work
        "app/cli/batch_scan.cpp",                  // removes results of an earlier run of the same scan
        "core/files/open_save/pose_sidecar.cpp",   // removes its file when the scan has no pose of its own any more
        "core/robots/bags/database_log.cpp",       // removes its own folder of copies
        "core/containers/mcap/growing_file.cpp",   // a recording: a new name, or an error
        "ui/base/language/catalogue.cpp",          // reads a file of Qt's translations
        "ui/controllers/sessions/autosaves.cpp",   // removes old sessions of its own folder
        "ui/engine/worker_bridge/preferences.cpp", // viewer.ini: QSettings locks, merges and replaces it
        "ui/engine/worker_bridge/preferences.h",
        "ui/panels/start/start_page.cpp", // removes pictures of its cache
    };
    std::set<std::string> found;
    for (const char* storey : {"core", "ui", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(test::sourceFolder()) / storey)) {
            const auto& path = entry.path();
            if (path.extension() != ".cpp" && path.extension() != ".h") continue;
            if (std::regex_search(fileText(path), raw)) found.insert(fs::relative(path, test::sourceFolder()).string());
        }
    }
    EXPECT_EQ(found, known);
}

} // namespace
} // namespace edgescan
