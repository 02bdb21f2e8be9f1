// Plays a recording on its own thread. Only the newest requested line is played; going back costs at most one sweep.
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

/// The position of a sweep in a recording: it ends before the next sweep's first line.
struct RecordedSweep {
    int firstLine = 0; ///< position in the recording before the sweep's first line
    int received = 0;  ///< complete rows
};

/// The lines and sweeps of a recording.
struct RecordingContents {
    std::vector<std::int64_t> lineNs; ///< reception time of each line, ns since 1970 UTC
    std::vector<RecordedSweep> sweeps;
    int first = 1; ///< the first position with a scan; before it the angles of a robot's laser are not known
};

/// The state of the recording at one position.
struct ReplayedSweep {
    int position = 0; ///< lines played
    scanner::SweepState sweep;
};

/// GUI thread only; signals are emitted there.
class ReplayPlayer : public QObject {
    Q_OBJECT
public:
    /// Starts to read at once. `options`: the options with which the file was opened.
    ReplayPlayer(const std::filesystem::path& path, const ReadingOptions& options, QObject* parent = nullptr);
    ~ReplayPlayer() override;

    /// Goes to the position after `line` lines. Drops requests that are not done yet.
    void seek(int line);

signals:
    void loaded(const edgescan::ui::RecordingContents& contents);
    /// The recording cannot be played; the sentence gives the reason.
    void refused(const QString& sentence);
    void arrived(const edgescan::ui::ReplayedSweep& at);

private:
    void work(const std::filesystem::path& path);
    RecordingContents survey(files::Replay& replay);
    ReplayedSweep at(files::Replay& replay, int line);
    [[nodiscard]] bool stopping() const;

    const ReadingOptions options_;
    std::vector<files::Replay> starts_; // a copy of the state at the start of each sweep; used only by the thread
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<int> wanted_;
    bool stop_ = false;
    std::thread thread_; // last
};

} // namespace edgescan::ui
