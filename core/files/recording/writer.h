// Recording what arrives: to disk in a thread of its own before anything is parsed, and the last minute in memory.
#pragma once

#include "core/base/result.h"
#include "core/files/recording/layout.h"
#include "core/scanner/cola/frames.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>

namespace edgescan::files {

/// Host times of a recording: they start at the system's clock and run on evenly even when that clock is set.
class RecordingClock {
public:
    explicit RecordingClock(scanner::HostTime start = scanner::hostNow()) : start_(start) {}
    [[nodiscard]] std::int64_t ns(scanner::HostTime time) const { return start_.utcNs + (time.monotonicNs - start_.monotonicNs); }

private:
    scanner::HostTime start_;
};

[[nodiscard]] RecordingMessagePtr receivedMessage(const scanner::ColaFrame& frame, const RecordingClock& clock);
[[nodiscard]] RecordingMessagePtr sentMessage(const scanner::ColaFrame& frame, const RecordingClock& clock);
/// `reading.hostNs` must be on the recording's clock.
[[nodiscard]] RecordingMessagePtr stepperMessage(const scanner::StepperReading& reading);

struct RecordingState {
    std::uint64_t messages = 0;    ///< written: they survive the end of the program
    std::uint64_t bytes = 0;       ///< written
    std::uint64_t syncedBytes = 0; ///< the disk says that it has them: they survive a power failure
    std::uint64_t dropped = 0;     ///< not recorded: the disk was full, or slower than what arrived
    std::uint64_t waiting = 0;     ///< bytes not yet written
    double lagSeconds = 0.0;       ///< age of the oldest byte that the disk does not have yet
    double worstLagSeconds = 0.0;
    std::optional<Error> problem; ///< the first that occurred; when `ended`, nothing is recorded any more
    bool ended = false;

    /// Written, but the disk has not said that it has it.
    [[nodiscard]] std::uint64_t unsynced() const { return bytes - std::min(bytes, syncedBytes); }
};
/// Of a disk that is far behind: "the disk is 12 s behind (1.1 MB)"; empty while it keeps up.
[[nodiscard]] std::string lagText(const RecordingState& state);

/// Writes a recording. At most a quarter of a second waits to be written; after kill -9 the file opens with all before that. The disk is
/// asked to keep it (fdatasync) by a thread of its own, for all that was written meanwhile at once: a slow disk delays no other thread.
class RecordingWriter {
public:
    struct Options {
        containers::McapLimits limits;
        std::size_t queueBytes = 32U << 20U;          ///< waiting to be written at most
        std::chrono::milliseconds closeWithin{5'000}; ///< how long close() waits for the disk
        containers::DiskCalls disk;
    };

    /// Error: the file exists, the folder does not, the disk is full ...
    static Result<std::unique_ptr<RecordingWriter>> start(const std::filesystem::path& path, const scanner::SweepMetadata& metadata,
                                                          Options options);
    static Result<std::unique_ptr<RecordingWriter>> start(const std::filesystem::path& path, const scanner::SweepMetadata& metadata) {
        return start(path, metadata, Options{});
    }
    ~RecordingWriter(); ///< closes
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    /// From any thread; never waits for the disk.
    void post(RecordingMessagePtr message);
    /// Everything posted so far is written, with the index at the end, unless the disk takes longer than Options::closeWithin. What the
    /// disk has not synced by then stays unsynced (state()). Error: what went wrong since the start.
    Result<Done> close();
    /// For a recording of nothing: its name is free again.
    void closeAndRemove();
    [[nodiscard]] RecordingState state() const;

private:
    struct Work; // shared with the threads, which outlive a disk that hangs
    explicit RecordingWriter(std::shared_ptr<Work> work) : work_(std::move(work)) {}
    std::shared_ptr<Work> work_;
    std::thread writing_, syncing_;
};

/// The messages of the last minute, for "keep what just happened". From any thread.
class RecentMessages {
public:
    explicit RecentMessages(std::int64_t keptNs = 60'000'000'000, std::size_t keptBytes = 128U << 20U)
        : keptNs_(keptNs), keptBytes_(keptBytes) {}

    void push(RecordingMessagePtr message);
    [[nodiscard]] std::vector<RecordingMessagePtr> messages() const;
    [[nodiscard]] std::size_t bytes() const;

private:
    std::int64_t keptNs_;
    std::size_t keptBytes_;
    mutable std::mutex mutex_;
    std::deque<RecordingMessagePtr> messages_;
    std::size_t bytes_ = 0;
};

/// The bytes of a whole recording.
[[nodiscard]] Bytes recordingBytes(const scanner::SweepMetadata& metadata, const std::vector<RecordingMessagePtr>& messages);

/// Writes them as a file that appears whole or not at all.
Result<Done> saveMessages(const std::filesystem::path& path, const scanner::SweepMetadata& metadata,
                          const std::vector<RecordingMessagePtr>& messages);

} // namespace edgescan::files
