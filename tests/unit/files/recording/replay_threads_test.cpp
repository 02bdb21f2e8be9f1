// Several threads scrub one recording, as the timeline does while views still hold what it showed before.
#include "core/files/recording/replay.h"
#include "tests/support/live_lines.h"

#include <gtest/gtest.h>

#include <mutex>
#include <random>
#include <thread>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

TEST(Replay, CopiesOnSeveralThreadsShareTheRecordingAndWhatTheyShow) {
    constexpr int kLines = 60, kThreads = 3, kMoves = 60;
    std::vector<RecordingMessagePtr> messages;
    for (int n = 0; n < kLines; ++n) messages.push_back(lineMessage(n, {.beams = 21}));
    const auto recording = Recording::fromBytes(recordingBytes(scanner::metadataOf({}), messages), "test");
    ASSERT_TRUE(recording);
    Replay first(*recording);
    first.seek(kLines / 2);
    std::mutex mutex;
    std::shared_ptr<const Scan> shown; // set by the last thread; released by the next
    std::vector<int> wrong(kThreads, 0);
    std::vector<std::thread> threads;
    threads.reserve(kThreads);
    for (int t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t, own = first]() mutable {
            std::mt19937 random(static_cast<unsigned>(t));
            for (int i = 0; i < kMoves; ++i) {
                const int line = 1 + static_cast<int>(random() % kLines);
                own.seek(line);
                std::shared_ptr<const Scan> now = own.snapshot();
                const int row = now->lines() - 1;
                wrong[static_cast<std::size_t>(t)] += now->lines() == line && rowHolds(*now, row, row) ? 0 : 1;
                const std::lock_guard lock(mutex);
                std::swap(shown, now);
                if (now) wrong[static_cast<std::size_t>(t)] += rowHolds(*now, now->lines() - 1, now->lines() - 1) ? 0 : 1;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(kThreads, 0));
}
