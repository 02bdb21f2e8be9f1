// Recording on slow, hanging or broken disks: arriving data are written at once, and stopping ends in time with a message.
#include "core/files/live_feed/live_health.h"
#include "core/files/recording/recording.h"
#include "core/files/recording/writer.h"
#include "tests/support/live_lines.h"
#include "tests/support/point_lists.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <unistd.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// A disk that answers on command. Threads of a writer may outlive the test, so they share it.
struct SlowDisk {
    std::mutex mutex;
    std::condition_variable changed;
    bool syncs = false; ///< answers syncs
    bool writes = true; ///< answers writes
    int syncError = 0;  ///< the result of a sync
    std::atomic<int> asked{0};

    void allow(bool sync, bool write) {
        const std::lock_guard lock(mutex);
        syncs = sync;
        writes = write;
        changed.notify_all();
    }
};

RecordingWriter::Options onto(const std::shared_ptr<SlowDisk>& disk) {
    RecordingWriter::Options options;
    options.closeWithin = std::chrono::milliseconds(200);
    options.disk.sync = [disk](int) {
        ++disk->asked;
        std::unique_lock lock(disk->mutex);
        disk->changed.wait(lock, [&] { return disk->syncs; });
        errno = disk->syncError;
        return disk->syncError == 0 ? 0 : -1;
    };
    options.disk.write = [disk](int file, const void* bytes, std::size_t size) {
        {
            std::unique_lock lock(disk->mutex);
            disk->changed.wait(lock, [&] { return disk->writes; });
        }
        return static_cast<std::ptrdiff_t>(::write(file, bytes, size));
    };
    return options;
}

std::size_t messagesIn(const std::filesystem::path& path) {
    const auto recording = Recording::open(path);
    return recording ? (*recording)->messages().size() : 0;
}

} // namespace

TEST(SlowDisk, EverythingIsWrittenWhileASyncHangs) {
    const Folder folder;
    const auto disk = std::make_shared<SlowDisk>();
    auto writer = RecordingWriter::start(folder / "a.mcap", {}, onto(disk));
    ASSERT_TRUE(writer);
    for (int n = 0; n < 400; ++n) (*writer)->post(lineMessage(n, {.beams = 571}));
    ASSERT_TRUE(waitUntil([&] { return (*writer)->state().messages == 400; }));
    EXPECT_EQ(messagesIn(folder / "a.mcap"), 400U) << "as somebody finds it after kill -9";
    const RecordingState state = (*writer)->state();
    EXPECT_EQ(state.syncedBytes, 0U);
    EXPECT_EQ(state.unsynced(), state.bytes);
    EXPECT_LE(disk->asked, 2) << "the folder and at most one more";
    EXPECT_FALSE(state.problem);
    disk->allow(true, true);
    ASSERT_TRUE((*writer)->close());
    EXPECT_EQ((*writer)->state().unsynced(), 0U);
    EXPECT_LE(disk->asked, 6) << "what was written meanwhile was one request";
}

TEST(SlowDisk, TheLagIsReported) {
    const Folder folder;
    const auto disk = std::make_shared<SlowDisk>();
    auto writer = RecordingWriter::start(folder / "a.mcap", {}, onto(disk));
    ASSERT_TRUE(writer);
    (*writer)->post(lineMessage(0));
    ASSERT_TRUE(waitUntil([&] { return (*writer)->state().lagSeconds > 2.0; }));
    LiveStatus status;
    status.recording = (*writer)->state();
    const LiveHealth health = healthOf(status);
    EXPECT_EQ(health.recorded, Condition::OutOfSpec);
    EXPECT_NE(health.recording.find("the disk is 2 s behind"), std::string::npos) << health.recording;
    disk->allow(true, true);
    ASSERT_TRUE(waitUntil([&] { return (*writer)->state().lagSeconds < 0.5; }));
    EXPECT_EQ(lagText((*writer)->state()), "");
    EXPECT_GT((*writer)->state().worstLagSeconds, 2.0);
}

TEST(SlowDisk, StoppingDoesNotWaitForASyncThatHangs) {
    const Folder folder;
    const auto disk = std::make_shared<SlowDisk>();
    auto writer = RecordingWriter::start(folder / "a.mcap", {}, onto(disk));
    ASSERT_TRUE(writer);
    for (int n = 0; n < 100; ++n) (*writer)->post(lineMessage(n));
    ASSERT_TRUE(waitUntil([&] { return (*writer)->state().messages == 100; }));
    EXPECT_TRUE((*writer)->close()) << "all is written";
    EXPECT_GT((*writer)->state().unsynced(), 0U);
    writer->reset(); // does not wait again
    const auto recording = Recording::open(folder / "a.mcap");
    ASSERT_TRUE(recording);
    EXPECT_TRUE((*recording)->clean());
    EXPECT_EQ((*recording)->messages().size(), 100U);
    disk->allow(true, true);
}

TEST(SlowDisk, StoppingDoesNotWaitForAWriteThatHangs) {
    const Folder folder;
    const auto disk = std::make_shared<SlowDisk>();
    auto writer = RecordingWriter::start(folder / "a.mcap", {}, onto(disk));
    ASSERT_TRUE(writer);
    for (int n = 0; n < 100; ++n) (*writer)->post(lineMessage(n));
    ASSERT_TRUE(waitUntil([&] { return (*writer)->state().messages > 0; }));
    disk->allow(true, false);
    for (int n = 100; n < 150; ++n) (*writer)->post(lineMessage(n));
    const auto closed = (*writer)->close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().sentence().find("did not take the end"), std::string::npos) << closed.error().sentence();
    EXPECT_TRUE((*writer)->state().ended);
    writer->reset();
    EXPECT_GT(messagesIn(folder / "a.mcap"), 0U);
    disk->allow(true, true);
}

TEST(SlowDisk, ADiskThatLosesWhatItTookSaysSo) {
    const Folder folder;
    const auto disk = std::make_shared<SlowDisk>();
    disk->syncError = EIO;
    disk->syncs = true;
    auto writer = RecordingWriter::start(folder / "a.mcap", {}, onto(disk));
    ASSERT_TRUE(writer);
    (*writer)->post(lineMessage(0));
    ASSERT_TRUE(waitUntil([&] { return (*writer)->state().ended; }));
    (*writer)->post(lineMessage(1));
    const auto closed = (*writer)->close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().sentence().find("lost some of what was recorded"), std::string::npos) << closed.error().sentence();
    EXPECT_GE((*writer)->state().dropped, 1U);
}
