// record on slow and full disks, killed and stopped: the content of the file, and the messages.
#include "core/files/recording/recording.h"
#include "core/files/recording/replay.h"
#include "tests/support/folders.h"
#include "tests/support/live_session.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

#include <sys/wait.h>
#include <unistd.h>

namespace edgescan {
namespace {

using nlohmann::json;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EDGESCAN_NEEDS_PRELOAD() GTEST_SKIP() << "a sanitizer's own library must come first"
#else
#define EDGESCAN_NEEDS_PRELOAD() static_cast<void>(0)
#endif

int linesOf(const std::shared_ptr<const files::Recording>& recording) { return recording ? files::Replay(recording).lines() : 0; }

/// edgescan-cli record on a disk that the environment variables describe.
class Recorder {
public:
    Recorder(const scanner::EmulatedScanner& scanner, std::string path, const std::string& environment, const std::string& arguments)
        : path_(std::move(path)) {
        const std::string command = "LD_PRELOAD=" + test::slowDiskLibrary() + " " + environment + " exec " + test::programFolder() +
                                    "/edgescan-cli record 127.0.0.1:" + std::to_string(scanner.port()) + " -o " + path_ + " " + arguments +
                                    " >" + path_ + ".out 2>" + path_ + ".err";
        process_ = ::fork();
        if (process_ == 0) {
            ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            ::_exit(127);
        }
    }
    ~Recorder() {
        if (process_ > 0) kill();
    }
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void kill() {
        ::kill(process_, SIGKILL);
        ::waitpid(std::exchange(process_, 0), nullptr, 0);
    }
    int wait() {
        int status = 0;
        ::waitpid(std::exchange(process_, 0), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    [[nodiscard]] std::string output(const char* stream) const { return test::fileText(path_ + stream); }
    [[nodiscard]] std::shared_ptr<const files::Recording> recording() const {
        const auto opened = files::Recording::open(path_);
        EXPECT_TRUE(opened) << opened.error().sentence();
        return opened ? *opened : nullptr;
    }
    [[nodiscard]] int linesSoFar() const {
        const auto opened = files::Recording::open(path_);
        return opened ? linesOf(*opened) : 0;
    }
    /// As the progress on stderr says: the newest "LIVE  312 lines" or "LIVE  312/1000 lines".
    [[nodiscard]] int linesReceived() const {
        const std::string text = output(".err");
        const std::size_t end = text.rfind(" lines");
        if (end == std::string::npos) return 0;
        const std::size_t space = text.rfind(' ', end - 1);
        return std::stoi(text.substr(space + 1, end - space - 1)); // ends at the slash
    }

private:
    std::string path_;
    pid_t process_ = 0;
};

/// The progress counts the lines of a sweep, which begin with 1 again after so many.
std::unique_ptr<scanner::EmulatedScanner> scannerOf(double linesPerSecond, int linesOfSweep = 100) {
    scanner::EmulatedScannerSettings settings;
    settings.linesPerSecond = linesPerSecond;
    return test::served(test::countingScan(linesOfSweep, 381), settings);
}

} // namespace

TEST(SlowDiskRecord, KilledTwentyTimesWhileEverySyncHangs) {
    EDGESCAN_NEEDS_PRELOAD();
    const test::TemporaryFolder folder;
    std::mt19937 random(11);
    std::vector<std::unique_ptr<scanner::EmulatedScanner>> scanners; // eight clients each
    std::vector<std::unique_ptr<Recorder>> recorders;
    constexpr double kRate = 50;
    constexpr int kWhole = 20'000; // lines: no sweep ends before its recorder is killed
    // A chunk of 64 KiB is written when it is full, and five times a second.
    constexpr int kTelegramBytes = 900, kMostMissing = 2 * 65'536 / kTelegramBytes;
    for (int i = 0; i < 20; ++i) {
        if (i % 5 == 0) scanners.push_back(scannerOf(kRate, kWhole));
        recorders.push_back(std::make_unique<Recorder>(*scanners.back(), (folder / ("k" + std::to_string(i) + ".mcap")).string(),
                                                       "EDGESCAN_SLOW_SYNC_MS=600000", "--progress"));
    }
    ASSERT_TRUE(test::waitUntil(
        [&] { return std::all_of(scanners.begin(), scanners.end(), [](const auto& s) { return s->statistics().sent > 5 * 100; }); }));
    int worst = 0, lines = 0;
    for (const auto& recorder : recorders) {
        // Lines come into the file all the time, though it is not closed and no sync ends.
        const int before = recorder->linesSoFar();
        EXPECT_TRUE(test::waitUntil([&] { return recorder->linesSoFar() > before; }));
        const int last = recorder->linesReceived() + static_cast<int>(random() % 5); // so that it is killed at any moment
        EXPECT_TRUE(test::waitUntil([&] { return recorder->linesReceived() >= last; }));
        recorder->kill();
        const int received = recorder->linesReceived();
        const auto recording = recorder->recording();
        ASSERT_TRUE(recording);
        ASSERT_FALSE(recording->messages().empty());
        worst = std::max(worst, received - linesOf(recording));
        lines += linesOf(recording);
    }
    std::printf(
        "[ measured ] kill -9 of 20 recordings on a disk whose syncs take 10 minutes: %d lines there, at most the last %d missing\n", lines,
        worst);
    EXPECT_LE(worst, kMostMissing);
    EXPECT_GT(lines, 20 * 50);
}

TEST(SlowDiskRecord, StoppingEndsWithAWordWhileEverySyncHangs) {
    EDGESCAN_NEEDS_PRELOAD();
    const test::TemporaryFolder folder;
    const auto scanner = scannerOf(50);
    Recorder recorder(*scanner, (folder / "a.mcap").string(), "EDGESCAN_SLOW_SYNC_MS=600000",
                      "--lines 200 --seconds 120"); // four seconds
    EXPECT_EQ(recorder.wait(), 0) << recorder.output(".err");
    EXPECT_NE(recorder.output(".err").find("the disk is"), std::string::npos) << recorder.output(".err");
    const json summary = json::parse(recorder.output(".out"));
    EXPECT_GT(summary["disk"]["unsynced_bytes"].get<int>(), 100'000);
    EXPECT_GT(summary["disk"]["worst_lag_s"].get<double>(), 2.0);
    EXPECT_NE(summary["warnings"].dump().find("has not confirmed"), std::string::npos) << summary["warnings"];
    EXPECT_EQ(linesOf(recorder.recording()), summary["lines"]);
}

// A slow disk loses no line unless power fails.
TEST(SlowDiskRecord, FiveSlowDisksLoseNoLine) {
    EDGESCAN_NEEDS_PRELOAD();
    const test::TemporaryFolder folder;
    const auto scanner = scannerOf(100);
    std::vector<std::unique_ptr<Recorder>> recorders;
    constexpr int kSyncs[] = {50, 200, 500, 1000, 2000};
    for (const int ms : kSyncs)
        recorders.push_back(std::make_unique<Recorder>(*scanner, (folder / (std::to_string(ms) + ".mcap")).string(),
                                                       "EDGESCAN_SLOW_SYNC_MS=" + std::to_string(ms), "--lines 250 --seconds 120"));
    int lines = 0, lost = 0;
    double lag = 0;
    for (const auto& recorder : recorders) {
        ASSERT_EQ(recorder->wait(), 0) << recorder->output(".err");
        const json summary = json::parse(recorder->output(".out"));
        const auto recording = recorder->recording();
        EXPECT_TRUE(recording && recording->clean());
        lines += linesOf(recording);
        lost += summary["lines"].get<int>() - linesOf(recording) + summary["disk"]["dropped"].get<int>();
        lag = std::max(lag, summary["disk"]["worst_lag_s"].get<double>());
    }
    std::printf("[ measured ] five disks whose syncs take 0.05 to 2 s: %d lines there, %d lost, %.1f s behind at worst\n", lines, lost,
                lag);
    EXPECT_EQ(lost, 0);
    EXPECT_GE(lines, 5 * 250);
}

TEST(SlowDiskRecord, FiveFullDisksKeepWhatWasThereAndSaySo) {
    EDGESCAN_NEEDS_PRELOAD();
    const test::TemporaryFolder folder;
    const auto scanner = scannerOf(400);
    int lines = 0;
    for (const int bytes : {20'000, 77'777, 131'072, 300'001, 500'000}) {
        Recorder recorder(*scanner, (folder / (std::to_string(bytes) + ".mcap")).string(), "EDGESCAN_FULL_AFTER=" + std::to_string(bytes),
                          "--seconds 120");
        EXPECT_EQ(recorder.wait(), 1);
        EXPECT_NE(recorder.output(".err").find("disk is full"), std::string::npos) << recorder.output(".err");
        const auto recording = recorder.recording();
        ASSERT_TRUE(recording);
        EXPECT_FALSE(recording->clean());
        lines += linesOf(recording);
        // Everything except the last chunk is in the file: 64 KiB or 200 ms.
        EXPECT_GE(linesOf(recording) * 900 + 2 * 65'536 + 12'000, bytes);
        EXPECT_EQ(files::Replay(recording).feed().torn(), 0);
    }
    std::printf("[ measured ] five disks full after 0.02 to 0.5 MB: %d lines there, the last chunk of each lost\n", lines);
    EXPECT_GT(lines, 300);
}

} // namespace edgescan
