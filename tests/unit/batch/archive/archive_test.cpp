// A run over an archive: its input files, the names of its results, its journal, its workers, its tables.
#include "core/batch/archive/journal.h"
#include "core/batch/archive/output_names.h"
#include "core/batch/archive/results_table.h"
#include "core/batch/archive/worker_processes.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <future>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace edgescan::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::TemporaryFolder;

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> below(const fs::path& folder, const std::vector<std::string>& paths) {
    std::vector<std::string> names;
    for (const std::string& path : paths) names.push_back(fs::path(path).lexically_relative(folder).string());
    return names;
}

TEST(ArchiveListing, AFolderGivesItsScansInOrderAndEachOnce) {
    const TemporaryFolder folder;
    for (const char* name :
         {"b/2.pcd", "b/1.mcap", "a.las", "a.pcd.gz", "notes.txt.bak", ".hidden/x.pcd", "results/old.pcd", "grid.u16", "lone.u16"})
        write(folder / name, "x");
    write(folder / "grid.json", "{}"); // its counts are in the file next to it
    write(folder / "record.json", R"({"format":"something else"})");
    write(folder / "described.json", R"({"format":"edgescan-raw-grid/1"})");
    write(folder / "edges.pcd", "x");
    write(folder / "edges.pcd.provenance.json", R"({"record":{"content":"edge cloud"}})");
    write(folder / "whole.pcd", "x");
    write(folder / "whole.pcd.provenance.json", R"({"record":{"content":"whole scan"}})");
    write(folder / "whole.pcd.pose.json", "{}"); // it is read with its scan
    write(folder / "earlier/.batch/rows.ndjson", "");
    write(folder / "earlier/results.csv", "x");
    fs::create_symlink("/nowhere/at/all.pcd", folder / "gone.pcd");
    const auto listing = listArchive({folder.path().string()}, folder / "results");
    ASSERT_TRUE(listing) << listing.error().sentence();
    ASSERT_EQ(listing->notRead.size(), 1U);
    EXPECT_NE(listing->notRead.front().why.find("the results of a run"), std::string::npos);
    EXPECT_EQ(below(folder.path(), listing->inputs), (std::vector<std::string>{"a.las", "a.pcd.gz", "b/1.mcap", "b/2.pcd", "described.json",
                                                                               "gone.pcd", "grid.json", "lone.u16", "whole.pcd"}));
    const auto out = below(folder.path(), listing->leftOut);
    EXPECT_EQ(std::set<std::string>(out.begin(), out.end()),
              (std::set<std::string>{"edges.pcd", "edges.pcd.provenance.json", "record.json", "whole.pcd.provenance.json"}));
    const auto twice = listArchive({folder.path().string(), (folder / "b/../b/1.mcap").string(), (folder / "b/*.pcd").string()}, "");
    ASSERT_TRUE(twice);
    EXPECT_EQ(std::ranges::count_if(twice->inputs, [](const std::string& path) { return path.ends_with("1.mcap"); }), 1);
    EXPECT_FALSE(listArchive({(folder / "no*such").string()}, ""));
    EXPECT_FALSE(listArchive({folder.path().string()}, folder.path())); // the results folder is among the scans
}

// The records of formats that have no room for the grid hold its description.
TEST(ArchiveListing, ARecordThatHoldsAGridIsNoScan) {
    const TemporaryFolder folder;
    write(folder / "bell.pcd", "x");
    for (const char* name : {"edges.csv", "edges.xyz", "edges.obj", "edges.ptx"}) {
        write(folder / name, "x");
        write(folder / (std::string(name) + ".provenance.json"),
              R"({"format":"edgescan-provenance/1","record":{"content":"edge cloud"},"grid":{"format":"edgescan-raw-grid/1"}})");
    }
    write(folder / "list.json", R"([{"format":"edgescan-raw-grid/1"}])");
    write(folder / "says.json", R"({"note":"edgescan-raw-grid/1"})");
    const auto listing = listArchive({folder.path().string()}, folder / "results");
    ASSERT_TRUE(listing) << listing.error().sentence();
    EXPECT_EQ(below(folder.path(), listing->inputs), (std::vector<std::string>{"bell.pcd"}));
}

TEST(ArchiveListing, LinkedFoldersAreFollowedOnceAndWhatIsNotReadIsListed) {
    const TemporaryFolder folder, elsewhere;
    const fs::path archive = folder / "archive";
    write(archive / "own/1.pcd", "x");
    write(archive / "own/deep/2.pcd", "x");
    write(folder / "beside/3.pcd", "x");
    write(elsewhere / "out/4.pcd", "x");
    write(elsewhere / "closed/5.pcd", "x");
    fs::create_directory_symlink("../beside", archive / "neighbour");
    fs::create_directory_symlink(elsewhere / "out", archive / "a_link");
    fs::create_directory_symlink(archive / "a_link", archive / "b_link"); // a link to a link, to the same folder
    fs::create_directory_symlink(elsewhere / "out", folder / "beside/c_link");
    fs::create_directory_symlink("..", archive / "own/up");
    fs::create_directory_symlink(folder.path(), archive / "above");
    fs::create_directory_symlink(archive / "own", archive / "twice");
    fs::create_directory_symlink("ring_b", archive / "ring_a");
    fs::create_directory_symlink("ring_a", archive / "ring_b");
    fs::create_directory_symlink("/nowhere/at/all", archive / "lost");
    fs::create_symlink(archive / "own/1.pcd", archive / "file.pcd");
    fs::create_symlink("/nowhere/at/all.pcd", archive / "gone.pcd");
    ASSERT_EQ(::mkfifo((archive / "pipe.pcd").c_str(), 0600), 0);
    for (const std::string& asked : {archive.string(), (folder / "arch*").string()}) {
        const auto listing = listArchive({asked}, folder / "results");
        ASSERT_TRUE(listing) << listing.error().sentence();
        EXPECT_EQ(below(archive, listing->inputs),
                  (std::vector<std::string>{"a_link/4.pcd", "file.pcd", "gone.pcd", "neighbour/3.pcd", "own/1.pcd", "own/deep/2.pcd"}));
        std::map<std::string, std::string> why;
        for (const auto& one : listing->notRead) why[fs::path(one.path).lexically_relative(archive).string()] = one.why;
        ASSERT_EQ(why.size(), 9U);
        for (const char* again : {"b_link", "neighbour/c_link", "twice"})
            EXPECT_NE(why[again].find("read already"), std::string::npos) << again;
        for (const char* back : {"own/up", "above"}) EXPECT_NE(why[back].find("above it"), std::string::npos) << back;
        for (const char* lost : {"ring_a", "ring_b", "lost"}) EXPECT_NE(why[lost].find("leads nowhere"), std::string::npos) << lost;
        EXPECT_NE(why["pipe.pcd"].find("not a file"), std::string::npos);
    }
}

TEST(ArchiveListing, AFolderThatCannotBeReadIsListed) {
    if (::geteuid() == 0) GTEST_SKIP() << "root reads every folder";
    const TemporaryFolder folder;
    write(folder / "a/1.pcd", "x");
    write(folder / "closed/2.pcd", "x");
    fs::permissions(folder / "closed", fs::perms::none);
    const auto listing = listArchive({folder.path().string()}, "");
    fs::permissions(folder / "closed", fs::perms::owner_all);
    ASSERT_TRUE(listing) << listing.error().sentence();
    EXPECT_EQ(below(folder.path(), listing->inputs), (std::vector<std::string>{"a/1.pcd"}));
    ASSERT_EQ(listing->notRead.size(), 1U);
    EXPECT_NE(listing->notRead.front().why.find("cannot be read"), std::string::npos);
}

TEST(ArchiveListing, AListIsReadInItsOrderAndAPointListIsAScan) {
    const TemporaryFolder folder;
    write(folder / "a.pcd", "x");
    write(folder / "list.txt", "# mine 7\n" + (folder / "b.pcd").string() + "\r\n\n" + (folder / "a.pcd").string() + "\n");
    write(folder / "points.txt", "1 2 3\n4 5 6\n");
    const auto listing = listArchive({(folder / "list.txt").string(), (folder / "points.txt").string()}, "");
    ASSERT_TRUE(listing);
    EXPECT_EQ(below(folder.path(), listing->inputs), (std::vector<std::string>{"b.pcd", "a.pcd", "points.txt"}));
}

TEST(ArchiveShards, EachScanIsInOnePartWhateverElseThereIs) {
    std::vector<int> sizes(20);
    for (int i = 0; i < 4000; ++i) {
        const std::string path = "mine/scan" + std::to_string(i) + ".mcap";
        int parts = 0;
        for (int n = 1; n <= 20; ++n) {
            if (!Shard{n, 20}.holds(path)) continue;
            ++parts;
            ++sizes[static_cast<std::size_t>(n - 1)];
        }
        ASSERT_EQ(parts, 1) << path;
    }
    EXPECT_GT(*std::ranges::min_element(sizes), 130); // 200 on average
    for (const char* wrong : {"", "3", "0/3", "4/3", "1.5/3", "a/b", "1/0", "1/1e9", "-1/3"}) EXPECT_FALSE(shardOf(wrong)) << wrong;
    EXPECT_EQ(shardOf("3/20")->number, 3);
}

TEST(OutputNames, NoTwoScansShareAFolder) {
    const std::vector<std::string> inputs{"a/x.pcd", "b/x.pcd", "/a/x.pcd", "../a/x.pcd", "%2E%2E/a/x.pcd", "a/x.ply", "a%2Fx.pcd"};
    for (const char* pattern : {"{path}", "{key}", "{folder}/{name}", "{stem}-{key}"}) {
        const auto names = outputNames(inputs, pattern);
        ASSERT_TRUE(names) << pattern << names.error().sentence();
        EXPECT_EQ(std::set<std::string>(names->begin(), names->end()).size(), inputs.size()) << pattern;
        for (const std::string& name : *names)
            EXPECT_TRUE(!name.starts_with("/") && ("/" + name + "/").find("/../") == std::string::npos) << name;
    }
    EXPECT_FALSE(outputNames(inputs, "{stem}"));
    EXPECT_FALSE(outputNames(inputs, "all"));
    EXPECT_FALSE(outputNames(inputs, "{what}"));
    EXPECT_FALSE(outputNames(inputs, "{path"));
    EXPECT_FALSE(outputNames({"a"}, ".."));
    EXPECT_FALSE(outputNames({"r/x.pcd", "r/sub/y.pcd"}, "{folder}")); // one folder inside the other
    EXPECT_TRUE(outputNames({"a", "a-b", "a.c"}, "{path}"));           // names with the same beginning
    const auto longName = outputNames({std::string(250, 'a') + ".pcd", std::string(250, 'a') + ".ply"}, "{path}");
    ASSERT_TRUE(longName);
    EXPECT_LT(longName->front().size(), 255U);
}

Json rowOf(const std::string& input, const std::string& finished, int edges = 0) {
    return {{"input", input}, {"edges", edges}, {"times", {{"finished_utc", finished}}}};
}

TEST(Journal, ATornLineIsCutAndTheNewestRowCounts) {
    const TemporaryFolder folder;
    {
        auto journal = Journal::open(folder.path(), {}, true, "s");
        ASSERT_TRUE(journal);
        ASSERT_TRUE(journal->append(rowOf("a", "2026-01-01T00:00:01.000Z", 1), "PICTURE-A"));
        ASSERT_TRUE(journal->append(rowOf("b", "2026-01-01T00:00:02.000Z", 2), ""));
        ASSERT_TRUE(journal->append(rowOf("a", "2026-01-01T00:00:03.000Z", 3), "PICTURE-2"));
        EXPECT_FALSE(Journal::open(folder.path(), {}, true, "s")); // one at a time
        EXPECT_FALSE(Journal::open(folder.path(), {2, 5}, false, "s"));
    }
    std::ofstream(folder / ".batch/rows.ndjson", std::ios::app) << R"({"input":"c","edg)"; // a crash here
    {
        auto part = Journal::open(folder.path(), {2, 5}, false, "s");
        ASSERT_TRUE(part) << part.error().sentence();
        EXPECT_FALSE(Journal::open(folder.path(), {}, true, "s")); // a whole run includes this part
        ASSERT_TRUE(Journal::open(folder.path(), {3, 5}, false, "s"));
        ASSERT_TRUE(part->append(rowOf("b", "2026-01-01T00:00:01.500Z", 9), "")); // older than the existing row
    }
    EXPECT_EQ(shardsIn(folder.path()), 5);
    {
        auto again = Journal::open(folder.path(), {}, true, "s");
        ASSERT_TRUE(again) << again.error().sentence();
        ASSERT_TRUE(again->append(rowOf("d", "2026-01-01T00:00:04.000Z", 4), ""));
    }
    const auto rows = readJournals(folder.path());
    ASSERT_TRUE(rows) << rows.error().sentence();
    ASSERT_EQ(rows->size(), 3U);
    EXPECT_EQ(Json::parse(rows->at("a"))["edges"], 3);
    EXPECT_EQ(Json::parse(rows->at("b"))["edges"], 2);
    EXPECT_EQ(pictureOf(Json::parse(rows->at("a")), folder.path()), "PICTURE-2");
    EXPECT_EQ(pictureOf(Json{{"picture", {"../../etc/passwd", 0, 10}}}, folder.path()), "");
    std::ofstream(folder / ".batch/rows.ndjson", std::ios::app) << "{\"input\":3}\n";
    EXPECT_FALSE(readJournals(folder.path()));
}

// The workers of a run that was killed hold its lock until they have ended, too.
TEST(Journal, ALockThatIsFreeInAMomentIsWaitedFor) {
    const TemporaryFolder folder;
    auto first = Journal::open(folder.path(), {}, true, "s");
    ASSERT_TRUE(first);
    std::optional<Journal> held(std::move(*first));
    const int watch = ::inotify_init1(IN_CLOEXEC);
    ASSERT_GE(::inotify_add_watch(watch, (folder / ".batch/rows.ndjson").c_str(), IN_OPEN), 0);
    bool opened = false;
    std::thread next([&] { opened = static_cast<bool>(Journal::open(folder.path(), {}, true, "s")); });
    std::array<char, 4096> event{};
    EXPECT_GT(::read(watch, event.data(), event.size()), 0); // the next run has come
    held.reset();
    next.join();
    ::close(watch);
    EXPECT_TRUE(opened);
}

TEST(Journal, RowsOfOtherTypesAreRefusedWithTheirLine) {
    for (const char* row :
         {"3", "[]", "null", "\"row\"", R"({"input":"a","times":3})", R"({"input":"a","times":[]})",
          R"({"input":"a","times":{"finished_utc":"","modified":7}})", R"({"input":"a","times":{"finished_utc":"","memory_bytes":"much"}})",
          R"({"input":"a","times":{"finished_utc":""},"outcome":5})", R"({"input":"a","times":{"finished_utc":""},"results":[]})",
          R"({"input":"a","times":{"finished_utc":""},"settings_sha256":1})", R"({"input":"a","times":{"finished_utc":""},"files":[3]})",
          R"({"input":"a","times":{"finished_utc":""},"files":{}})", R"({"input":"a","times":{"finished_utc":""},"outputs":["edges.png"]})",
          R"({"input":"a","times":{"finished_utc":""},"outputs":[{"file":4}]})",
          R"({"input":"a","times":{"finished_utc":""},"warnings":"many"})"}) {
        const TemporaryFolder folder;
        std::filesystem::create_directories(folder / ".batch");
        std::ofstream(folder / ".batch/rows.ndjson") << R"({"input":"b","times":{"finished_utc":""}})"
                                                     << "\n"
                                                     << row << "\n";
        const auto rows = readJournals(folder.path());
        ASSERT_FALSE(rows) << row;
        EXPECT_NE(rows.error().sentence().find("rows.ndjson: line 2: this line is not a row of a run"), std::string::npos)
            << rows.error().sentence();
    }
}

TEST(Journal, ALinkIsRefusedAndWhatItPointsToStays) {
    for (const char* name : {".batch", ".batch/rows.ndjson", ".batch/pictures.bin"}) {
        const TemporaryFolder folder, elsewhere;
        std::filesystem::create_directories(elsewhere / "work");
        std::ofstream(elsewhere / "work/mine") << "mine";
        std::ofstream(elsewhere / "file") << "a text without a line feed";
        const bool whole = name == std::string(".batch");
        if (!whole) std::filesystem::create_directories(folder / ".batch");
        std::filesystem::create_symlink(whole ? elsewhere.path() : elsewhere / "file", folder / name);
        const auto refused = Journal::open(folder.path(), {}, true, "s");
        ASSERT_FALSE(refused) << name;
        EXPECT_NE(refused.error().sentence().find("this is a link"), std::string::npos) << refused.error().sentence();
        EXPECT_EQ(test::fileText(elsewhere / "work/mine"), "mine");
        EXPECT_EQ(test::fileText(elsewhere / "file"), "a text without a line feed");
    }
}

TEST(Journal, PartsOfOtherSettingsDoNotMixTheirResults) {
    const TemporaryFolder folder;
    const auto opens = [&](const Shard& shard, const std::string& settings) -> std::string {
        const auto journal = Journal::open(folder.path(), shard, shard.of == 1, settings);
        return journal ? journal->otherSettings() : journal.error().sentence();
    };
    EXPECT_EQ(opens({1, 2}, "old"), "");
    EXPECT_EQ(opens({1, 3}, "old"), "") << "the same settings in other parts";
    EXPECT_NE(opens({2, 3}, "new").find("other settings were used in part 1 of 2"), std::string::npos);
    EXPECT_EQ(opens({}, ""), "") << "a merge changes nothing";
    EXPECT_NE(opens({2, 3}, "new").find("other settings were used in part 1 of 2"), std::string::npos);
    EXPECT_EQ(opens({}, "new"), "") << "a whole run does all of them again";
    EXPECT_EQ(opens({2, 3}, "new"), "");
    EXPECT_NE(opens({3, 3}, "newer").find("the whole run"), std::string::npos);
    EXPECT_EQ(shardsIn(folder.path()), 3);
    EXPECT_FALSE(std::filesystem::exists(folder / ".batch/rows-3-of-3.ndjson")) << "what is refused leaves nothing";
    const TemporaryFolder again;
    {
        const auto running = Journal::open(again.path(), {1, 2}, false, "old");
        ASSERT_TRUE(running);
        EXPECT_FALSE(Journal::open(again.path(), {2, 2}, false, "new")) << "part 1 is running with other settings";
        EXPECT_TRUE(Journal::open(again.path(), {2, 2}, false, "old"));
    }
    const auto later = Journal::open(again.path(), {2, 2}, false, "new");
    ASSERT_TRUE(later) << later.error().sentence();
    EXPECT_EQ(later->otherSettings(), "part 1 of 2");
}

TEST(WorkerProcesses, WhatEndsOneJobEndsNoOther) {
    std::map<std::size_t, JobEnd> ends;
    std::size_t next = 0;
    Jobs jobs;
    jobs.next = [&]() -> std::optional<std::size_t> { return next < 60 ? std::optional(next++) : std::nullopt; };
    jobs.work = [](std::size_t job, int) -> std::string {
        if (job == 7) std::raise(SIGSEGV);
        if (job == 11) ::_exit(3);
        if (job == 13) std::this_thread::sleep_for(std::chrono::minutes(10));
        if (job == 17) throw std::runtime_error("no");
        if (job == 19) return std::string(3'000'000, 'x');
        if (job == 23) return {};
        return std::to_string(job * job);
    };
    jobs.ended = [&](const JobEnd& end) { EXPECT_TRUE(ends.emplace(end.job, end).second) << end.job; };
    jobs.goOn = [] { return true; };
    ASSERT_TRUE(runInProcesses({3, 0, 2.0}, jobs));
    ASSERT_EQ(ends.size(), 60U);
    for (std::size_t job = 0; job < 60; ++job) {
        const JobEnd& end = ends.at(job);
        if (job == 7 || job == 11 || job == 13 || job == 17) {
            EXPECT_FALSE(end.answer) << job;
            EXPECT_FALSE(end.death.empty()) << job;
        } else if (job == 19) {
            EXPECT_EQ(end.answer->size(), 3'000'000U);
        } else {
            EXPECT_EQ(end.answer.value_or("?"), job == 23 ? "" : std::to_string(job * job)) << end.death;
        }
    }
    EXPECT_NE(ends.at(7).death.find("signal 11"), std::string::npos);
    EXPECT_NE(ends.at(13).death.find("time limit"), std::string::npos);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a worker was left";
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(WorkerProcesses, TheWishToStopEndsJobsThatLast) {
    Jobs jobs;
    std::size_t given = 0, ended = 0;
    jobs.next = [&]() -> std::optional<std::size_t> { return given < 4 ? std::optional(given++) : std::nullopt; };
    jobs.work = [](std::size_t, int) -> std::string {
        while (true) ::pause(); // until it is killed
    };
    jobs.ended = [&](const JobEnd&) { ++ended; };
    jobs.goOn = [&] { return given < 2; };
    ASSERT_TRUE(runInProcesses({2, 0, 0}, jobs));
    EXPECT_EQ(given, 2U);
    EXPECT_EQ(ended, 0U); // they have no row, and the next run does them
}

TEST(WorkerProcesses, AJobThatTakesTooMuchMemoryEndsAlone) {
    std::map<std::size_t, JobEnd> ends;
    std::size_t next = 0;
    Jobs jobs;
    jobs.next = [&]() -> std::optional<std::size_t> { return next < 6 ? std::optional(next++) : std::nullopt; };
    jobs.work = [](std::size_t job, int) {
        std::vector<char> memory(job == 2 ? 400'000'000U : 1000U, 'x');
        return std::string(1, memory[memory.size() / 2]);
    };
    jobs.ended = [&](const JobEnd& end) { ends.emplace(end.job, end); };
    jobs.goOn = [] { return true; };
    ASSERT_TRUE(runInProcesses({2, 100'000'000, 0}, jobs));
    for (std::size_t job = 0; job < 6; ++job) EXPECT_EQ(ends.at(job).answer.has_value(), job != 2) << job;
    EXPECT_NE(ends.at(2).death.find("memory"), std::string::npos) << ends.at(2).death;
}
#endif

TEST(ResultsTable, IsCsvThatNoSpreadsheetTakesForFormulas) {
    const std::string row = R"({"input":"=cmd(),\"x\"","outcome":"refused","error":"two\nlines","warnings":["a","b, c"],"edges":5,)"
                            R"("times":{"load_ms":1.5},"picture":["p",0,1]})";
    const std::string csv = csvTable({row});
    EXPECT_NE(csv.find("\r\n\"'=cmd(),\"\"x\"\"\",refused,"), std::string::npos) << csv;
    EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
    EXPECT_NE(csv.find("\"a | b, c\",two\\nlines,1.5,"), std::string::npos) << csv;
    EXPECT_EQ(ndjsonTable({row}).find("picture"), std::string::npos);
}

TEST(WorkerProcesses, AreNotMadeOfAProcessWithThreads) {
    std::promise<void> end;
    std::thread other([until = end.get_future()] { until.wait(); });
    bool asked = false;
    Jobs jobs;
    jobs.next = [&]() -> std::optional<std::size_t> {
        asked = true;
        return std::nullopt;
    };
    jobs.goOn = [] { return true; };
    const auto ran = runInProcesses({1, 0, 0}, jobs);
    end.set_value();
    other.join();
    ASSERT_FALSE(ran);
    EXPECT_NE(ran.error().sentence().find("2 threads"), std::string::npos) << ran.error().sentence();
    EXPECT_FALSE(asked);
}

} // namespace
} // namespace edgescan::batch
