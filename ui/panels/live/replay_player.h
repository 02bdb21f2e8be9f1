// Plays a recording on a thread of its own: the newest line asked for wins, and going back costs one sweep at most.
#pragma once

#include "core/files/recording/replay.h"

#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace edgescan::ui {

/// Where a sweep lies in a recording: its last line is that before the next one's first.
struct RecordedSweep {
    int firstLine = 0; ///< position in the recording before the sweep's first line
    int received = 0;  ///< rows of which nothing is missing
};

/// What there is to play.
struct RecordingContents {
    std::vector<std::int64_t> lineNs; ///< when each line was received, ns since 1970 UTC
    std::vector<RecordedSweep> sweeps;
};

/// The recording at a place.
struct ReplayedSweep {
    int position = 0; ///< lines played
    SweepSoFar sweep;
};

/// GUI thread only; signals arrive there.
class ReplayPlayer : public QObject {
    Q_OBJECT
public:
    /// Starts to read at once. `options`: as the file was opened with.
    ReplayPlayer(const std::filesystem::path& path, const ReadingOptions& options, QObject* parent = nullptr);
    ~ReplayPlayer() override;

    /// To just behind `line` lines. What was asked for before and is not done yet is dropped.
    void seek(int line);

signals:
    void loaded(const edgescan::ui::RecordingContents& contents);
    /// Not a recording that can be played; the sentence says why.
    void refused(const QString& sentence);
    void arrived(const edgescan::ui::ReplayedSweep& at);

private:
    void work(const std::filesystem::path& path);
    RecordingContents survey(Replay& replay);
    ReplayedSweep at(Replay& replay, int line);
    [[nodiscard]] bool stopping() const;

    const ReadingOptions options_;
    std::vector<Replay> starts_; // a copy at the beginning of each sweep; the thread's own
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<int> wanted_;
    bool stop_ = false;
    std::thread thread_; // last
};

} // namespace edgescan::ui
