// Every kind of file that the core writes (docs/measurements/reliability.md, "Files"), written by two and by twenty processes at the same
// time, and by processes that are killed. EDGESCAN_WRITER_ROUNDS=1000 is the long form.
#include "core/base/audit_log/audit_check.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/batch/archive/journal.h"
#include "core/containers/mcap/writer.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/exports/html/scan_page.h"
#include "core/exports/provenance.h"
#include "core/exports/record_parts.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/rocks/selection/preset.h"
#include "tests/support/example_session.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <thread>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::fileText;
using test::TemporaryFolder;

constexpr int kMostWriters = 20;

int roundsOfWriters() {
    const char* text = std::getenv("EDGESCAN_WRITER_ROUNDS");
    return text == nullptr ? 3 : std::max(1, std::atoi(text));
}

/// How a file is written when several processes write it.
enum class Manner {
    Last,    ///< the last content replaces the others
    Record,  ///< the same; contains the time, so it is known by its hash of the file that it belongs to
    First,   ///< the others are refused
    Appended ///< every process adds its line
};

struct WrittenFile {
    std::string name;
    Manner manner = Manner::Last;
};

/// Files that belong together.
struct WriterKind {
    const char* name;
    std::vector<WrittenFile> files;
    std::function<Result<Done>(const fs::path& folder, int writer)> write;
};

/// What the writers write: another scan or other words for each.
class Material {
public:
    Material() {
        for (int writer = 0; writer < kMostWriters; ++writer)
            detections_.push_back(edges::detectEdges(std::make_shared<const Scan>(test::boxesScan(24, 30, static_cast<unsigned>(writer))),
                                                     edges::Settings{}));
    }
    [[nodiscard]] const edges::Detection& detection(int writer) const { return *detections_[static_cast<std::size_t>(writer)]; }

private:
    std::vector<std::shared_ptr<const edges::Detection>> detections_;
};

const Material& material() {
    static const Material kMaterial;
    return kMaterial;
}

Result<Done> exported(exports::ExportContent content, const fs::path& path, int writer) {
    const auto written = exports::exportWithProvenance(content, material().detection(writer), path);
    if (!written) return written.error();
    return Done{};
}

std::string nameOf(int writer) { return "writer " + std::to_string(writer); }

Result<Done> writtenSession(const fs::path& folder, int writer) {
    inspect::ViewerState state = test::exampleSession("/scans/bell.json");
    state.targets.notebook.targets.front().name = nameOf(writer);
    return writeWholeFile(folder / "a.edgescan", inspect::sessionText(state, folder, "2026-11-22T00:00:00Z"));
}

Result<Done> writtenTargets(const fs::path& folder, int writer) {
    inspect::Notebook notebook = test::exampleSession("/scans/bell.json").targets.notebook;
    notebook.targets.front().name = nameOf(writer);
    return writeWholeFile(folder / "targets.json", inspect::notebookText(notebook, {std::string(64, 'a'), "bell", 100, 1200}));
}

Result<Done> writtenTables(const fs::path& folder, int writer) {
    std::vector<std::string> texts;
    for (const char* name : {"results.csv", "results.ndjson", "settings.json", "survey.html"})
        texts.push_back(name + std::string(static_cast<std::size_t>(100 * writer), 'x') + nameOf(writer));
    return writeWholeFiles({{folder / "results.csv", std::as_bytes(std::span(texts[0]))},
                            {folder / "results.ndjson", std::as_bytes(std::span(texts[1]))},
                            {folder / "settings.json", std::as_bytes(std::span(texts[2]))},
                            {folder / "survey.html", std::as_bytes(std::span(texts[3]))}});
}

Result<Done> startedRecording(const fs::path& folder, int writer) {
    auto file = containers::GrowingFile::create(folder / "sweep.mcap");
    if (!file) return file.error();
    const std::string text = nameOf(writer);
    return file->append({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

Result<Done> appendedRow(const fs::path& folder, int writer) {
    auto journal = batch::Journal::open(folder / "r", {writer + 1, kMostWriters}, false, "settings");
    if (!journal) return journal.error();
    return journal->append({{"input", nameOf(writer)}, {"times", {{"finished_utc", "2026-11-22T00:00:00Z"}}}}, "");
}

const std::vector<WriterKind>& writerKinds() {
    using exports::ExportContent;
    static const std::vector<WriterKind> kKinds{
        {"points and record",
         {{"e.csv"}, {"e.csv.provenance.json", Manner::Record}},
         [](const fs::path& folder, int writer) { return exported(ExportContent::EdgeCloud, folder / "e.csv", writer); }},
        {"picture and record",
         {{"m.png"}, {"m.png.provenance.json", Manner::Record}},
         [](const fs::path& folder, int writer) { return exported(ExportContent::EdgeImage, folder / "m.png", writer); }},
        {"raw grid and record",
         {{"g.u16"}, {"g.json"}, {"g.json.provenance.json", Manner::Record}},
         [](const fs::path& folder, int writer) { return exported(ExportContent::WholeScan, folder / "g.json", writer); }},
        {"report page",
         {{"p.html"}},
         [](const fs::path& folder, int writer) {
             const exports::PageWords words{"report", nameOf(writer), "", "2026-11-22T00:00:00Z"};
             return writeWholeFile(folder / "p.html", exports::scanPage(material().detection(writer), words, {}));
         }},
        {"session", {{"a.edgescan"}}, writtenSession},
        {"targets", {{"targets.json"}}, writtenTargets},
        {"preset",
         {{"preset.json"}},
         [](const fs::path& folder, int writer) {
             return writeWholeFile(folder / "preset.json", edges::presetText({nameOf(writer), "", edges::Settings{}, ""}));
         }},
        {"edits of rocks",
         {{"s.rocks.json"}},
         [](const fs::path& folder, int writer) {
             const rocks::Preset preset{std::nullopt, {{rocks::EditKind::NotRock, {static_cast<std::uint32_t>(writer)}}}, ""};
             return writeWholeFile(folder / "s.rocks.json", rocks::rockPresetText(preset, 24, 30));
         }},
        {"tables of an archive", {{"results.csv"}, {"results.ndjson"}, {"settings.json"}, {"survey.html"}}, writtenTables},
        {"recording", {{"sweep.mcap", Manner::First}}, startedRecording},
        {"audit log",
         {{"audit.jsonl", Manner::Appended}},
         [](const fs::path& folder, int writer) {
             return AuditLog(folder / "audit.jsonl").append("opened", {{"by", nameOf(writer)}});
         }},
        {"journal", {{"r/.batch/rows-N.ndjson", Manner::Appended}}, appendedRow}};
    return kKinds;
}

/// Counts that several processes change.
struct Shared {
    std::array<std::atomic<int>, 16> succeeded{}; ///< by kind
    std::atomic<int> started{0};
};

class SharedCounts {
public:
    SharedCounts() : counts_(new (::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) Shared) {}
    ~SharedCounts() { ::munmap(counts_, sizeof(Shared)); }
    SharedCounts(const SharedCounts&) = delete;
    SharedCounts& operator=(const SharedCounts&) = delete;
    Shared* operator->() { return counts_; }

private:
    Shared* counts_;
};

/// Starts one process per writer. All begin when the last one has started.
void runWriters(int writers, const std::function<void(int writer)>& work) {
    std::array<int, 2> gate{};
    ASSERT_EQ(::pipe(gate.data()), 0);
    std::vector<pid_t> processes;
    for (int writer = 0; writer < writers; ++writer) {
        const pid_t process = ::fork();
        ASSERT_GE(process, 0);
        if (process == 0) {
            ::close(gate[1]);
            char nothing = 0;
            static_cast<void>(::read(gate[0], &nothing, 1)); // ends when the test closes its end
            work(writer);
            ::_exit(0);
        }
        processes.push_back(process);
    }
    ::close(gate[0]);
    ::close(gate[1]);
    for (const pid_t process : processes) {
        int status = 0;
        ::waitpid(process, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "a writer failed";
    }
}

/// The files of a kind as one writer alone writes them.
using Contents = std::map<std::string, std::string>;
Contents contentsOf(const WriterKind& kind, const fs::path& folder) {
    Contents contents;
    for (const WrittenFile& file : kind.files) {
        if (file.manner == Manner::Last) contents[file.name] = fileText(folder / file.name);
    }
    return contents;
}

std::vector<std::vector<Contents>> contentsAlone(int writers) {
    std::vector<std::vector<Contents>> alone;
    for (const WriterKind& kind : writerKinds()) {
        alone.emplace_back();
        for (int writer = 0; writer < writers; ++writer) {
            const TemporaryFolder folder;
            EXPECT_TRUE(kind.write(folder.path(), writer)) << kind.name;
            alone.back().push_back(contentsOf(kind, folder.path()));
        }
    }
    return alone;
}

/// Each record is the one that was written for its file.
void checkRecords(const WriterKind& kind, const fs::path& folder) {
    for (const WrittenFile& file : kind.files) {
        if (file.manner != Manner::Record) continue;
        const Json record = Json::parse(fileText(folder / file.name), nullptr, false);
        ASSERT_TRUE(record.is_object()) << file.name;
        EXPECT_TRUE(exports::sidecarIsWhole(record)) << file.name;
        const std::string of = fileText(folder / record["export"]["file"].get<std::string>());
        EXPECT_EQ(record["export"]["sha256"], sha256Hex(std::as_bytes(std::span(of)))) << file.name;
    }
}

/// The files are those of one writer; nothing is missing, torn or left over.
void checkRound(const fs::path& folder, int writers, const std::vector<std::vector<Contents>>& alone, const Shared& counts, int before) {
    for (std::size_t n = 0; n < writerKinds().size(); ++n) {
        const WriterKind& kind = writerKinds()[n];
        const Manner manner = kind.files.front().manner;
        const int succeeded = counts.succeeded[n];
        if (manner == Manner::First) {
            EXPECT_EQ(succeeded, 1) << kind.name;
            continue;
        }
        EXPECT_EQ(succeeded, writers) << kind.name;
        if (manner == Manner::Appended) continue;
        const Contents found = contentsOf(kind, folder);
        EXPECT_NE(std::ranges::find(alone[n], found), alone[n].end()) << kind.name << ": missing, torn, or of several writers";
        checkRecords(kind, folder);
    }
    const auto log = checkAudit(folder / "audit.jsonl");
    ASSERT_TRUE(log);
    EXPECT_TRUE(log->faults.empty());
    EXPECT_EQ(log->lines, static_cast<std::uint64_t>(before + writers));
    const auto rows = batch::readJournals(folder / "r");
    ASSERT_TRUE(rows) << rows.error().sentence();
    EXPECT_EQ(rows->size(), static_cast<std::size_t>(writers));
}

int partsLeft(const fs::path& folder) {
    int left = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) left += entry.path().extension() == ".part" ? 1 : 0;
    return left;
}

void writeTogether(int writers) {
    const int rounds = roundsOfWriters();
    const auto alone = contentsAlone(writers);
    const auto start = std::chrono::steady_clock::now();
    const TemporaryFolder folder;
    SharedCounts counts;
    int missing = 0;
    for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
        for (auto& succeeded : counts->succeeded) succeeded = 0;
        fs::remove(folder / "sweep.mcap");
        std::atomic<bool> done = false;
        // What was there stays there: a reader never finds a name without its file.
        std::thread reader([&] {
            while (round > 0 && !done) {
                for (const WriterKind& kind : writerKinds()) {
                    for (const WrittenFile& file : kind.files)
                        missing += file.manner <= Manner::Record && !fs::exists(folder / file.name) ? 1 : 0;
                }
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        });
        runWriters(writers, [&](int writer) {
            for (std::size_t n = 0; n < writerKinds().size(); ++n) {
                if (writerKinds()[n].write(folder.path(), writer)) ++counts->succeeded[n];
            }
        });
        done = true;
        reader.join();
        checkRound(folder.path(), writers, alone, *counts.operator->(), round * writers);
        EXPECT_EQ(partsLeft(folder.path()), 0);
    }
    EXPECT_EQ(missing, 0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::cout << "[ measured ] " << writers << " processes write " << writerKinds().size() << " kinds of files at the same time, " << rounds
              << " rounds: " << missing << " files missing, " << partsLeft(folder.path()) << " temporary files left ("
              << static_cast<int>(seconds + 0.5) << " s)\n";
}

TEST(Writers, OfTwoProcessesEveryFileIsWholeAndOfOneOfThem) { writeTogether(2); }
TEST(Writers, OfTwentyProcessesEveryFileIsWholeAndOfOneOfThem) { writeTogether(kMostWriters); }

/// A file of `letter` whose second file has its hash.
Result<Done> writePair(const fs::path& folder, char letter) {
    const std::string text(std::size_t{1} << 20U, letter), hash = sha256Hex(std::as_bytes(std::span(text)));
    return writeWholeFiles({{folder / "file", std::as_bytes(std::span(text))}, {folder / "hash", std::as_bytes(std::span(hash))}});
}

TEST(Writers, KilledAtRandomMomentsLeaveTheOldFileOrTheNewOne) {
    const TemporaryFolder folder;
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int kills = std::max(20, roundsOfWriters());
    int left = 0, apart = 0;
    SharedCounts counts;
    const auto writeOnce = [&] { // in a process of its own: a program removes leftovers when it first writes into a folder
        runWriters(1, [&](int /*writer*/) { counts->succeeded[0] += writePair(folder.path(), 'a') ? 1 : 0; });
    };
    writeOnce();
    for (int kill = 0; kill < kills && !testing::Test::HasFailure(); ++kill) {
        counts->started = 0;
        const pid_t process = ::fork();
        ASSERT_GE(process, 0);
        if (process == 0) {
            for (char letter = 'a';; letter = letter == 'z' ? 'a' : static_cast<char>(letter + 1)) {
                if (!writePair(folder.path(), letter)) ::_exit(1);
                counts->started = 1;
            }
        }
        EXPECT_TRUE(test::waitUntil([&] { return counts->started == 1; }));
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 8000));
        ::kill(process, SIGKILL);
        int status = 0;
        ::waitpid(process, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status)) << "it could not write";
        const std::string text = fileText(folder / "file"), hash = fileText(folder / "hash");
        ASSERT_EQ(text.size(), std::size_t{1} << 20U);
        EXPECT_EQ(text.find_first_not_of(text.front()), std::string::npos) << "torn";
        ASSERT_EQ(hash.size(), 64U);
        apart += hash != sha256Hex(std::as_bytes(std::span(text))) ? 1 : 0;
        left += partsLeft(folder.path());
        // Another program that writes into the folder removes what the dead one left.
        writeOnce();
        EXPECT_EQ(partsLeft(folder.path()), 0);
    }
    EXPECT_EQ(counts->succeeded[0], kills + 1);
    std::cout << "[ measured ] kill -9 of " << kills << " writers (seed " << seed << "): every file whole; " << left
              << " temporary files left and removed by the next writer; " << apart << " kills between the renames of two files\n";
}

TEST(Writers, ATemporaryFileOfARunningProgramIsNotRemoved) {
    const TemporaryFolder folder;
    const std::string host = [] {
        std::array<char, 256> name{};
        ::gethostname(name.data(), name.size() - 1);
        return std::string(name.data()).substr(0, 64);
    }();
    const fs::path running = folder / (".edgescan-" + host + "-1-0.part"), dead = folder / (".edgescan-" + host + "-1-1.part");
    const fs::path elsewhere = folder / (".edgescan-" + host + "x-1-1.part"), other = folder / "mine.part";
    for (const fs::path& path : {running, dead, elsewhere, other}) std::ofstream(path) << "x";
    const int file = ::open(running.c_str(), O_RDWR);
    ASSERT_EQ(::flock(file, LOCK_EX), 0);
    ASSERT_TRUE(writeWholeFile(folder / "a", std::string("a")));
    ::close(file);
    EXPECT_TRUE(fs::exists(running));
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(elsewhere)) << "of another machine, where it may be in use";
    EXPECT_TRUE(fs::exists(other));
}

TEST(Writers, AReadOnlyFileIsNotReplacedAndTheMessageSaysHowToGoOn) {
    const TemporaryFolder folder;
    ASSERT_TRUE(exported(exports::ExportContent::EdgeCloud, folder / "e.csv", 0));
    const std::string record = fileText(folder / "e.csv.provenance.json");
    fs::permissions(folder / "e.csv.provenance.json", fs::perms(0444));
    const std::string before = fileText(folder / "e.csv");
    const auto refused = exported(exports::ExportContent::EdgeCloud, folder / "e.csv", 1);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("e.csv.provenance.json: this file is read-only, so it was not replaced; allow writing"),
              std::string::npos)
        << refused.error().sentence();
    EXPECT_EQ(fileText(folder / "e.csv"), before) << "neither of the two is written";
    EXPECT_EQ(fileText(folder / "e.csv.provenance.json"), record);
    EXPECT_EQ(partsLeft(folder.path()), 0);
    EXPECT_FALSE(moveWholeFiles({{folder / "e.csv", folder / "e.csv.provenance.json"}}));
    fs::create_symlink("e.csv.provenance.json", folder / "link");
    EXPECT_FALSE(writeWholeFile(folder / "link", std::string("x")));
}

TEST(Writers, TheRecordOfAPrivateExportIsPrivate) {
    const TemporaryFolder folder;
    const fs::path file = folder / "e.csv", record = folder / "e.csv.provenance.json";
    std::ofstream(file) << "old";
    fs::permissions(file, fs::perms(0600));
    ASSERT_TRUE(exported(exports::ExportContent::EdgeCloud, file, 0));
    for (const fs::path& path : {file, record}) EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600)) << path;
}

TEST(Writers, TwoFilesOfOneCallAreTwoFilesWhateverTheirNames) {
    const TemporaryFolder folder;
    const std::string text = "x";
    fs::create_symlink("a", folder / "link");
    EXPECT_FALSE(writeWholeFiles({{folder / "a", std::as_bytes(std::span(text))}, {folder / "link", std::as_bytes(std::span(text))}}));
    EXPECT_FALSE(writeWholeFiles({{folder / "a", std::as_bytes(std::span(text))}, {folder / "./a", std::as_bytes(std::span(text))}}));
    EXPECT_FALSE(fs::exists(folder / "a"));
}

} // namespace
} // namespace edgescan
