// A live scanner on the GUI thread: hands the growing sweep to the session as fast as it can be shown, and knows its health.
#pragma once

#include "core/files/live_feed/live_feed.h"
#include "core/files/live_feed/live_health.h"
#include "ui/engine/worker_bridge/engine.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>

namespace edgescan::ui {

/// GUI thread only; nothing here waits for network or disk.
class ScannerLink : public QObject {
    Q_OBJECT
public:
    /// `session` must outlive this.
    explicit ScannerLink(Engine& engine, QObject* parent = nullptr);
    ~ScannerLink() override;
    /// A new picture is on the screen.
    void followPicture();

    /// Hangs up first where there is a connection. Reads and a subscription are all that is sent.
    void connectTo(const SessionSettings& scanner, const SweepSettings& sweep);
    /// Ends recording and connection; the sweep stays on the screen as it is.
    void hangUp();
    /// Other mounting or steps from now on, the sweep under way included, but for so many of its lines. Nothing: not connected, or they are
    /// those in use.
    std::optional<int> useSweep(const SweepSettings& sweep);
    [[nodiscard]] bool connected() const { return feed_ != nullptr; }
    [[nodiscard]] bool recording() const { return recording_; }
    /// Of the newest recording of this connection; empty: none.
    [[nodiscard]] const QString& recordingPath() const { return recordingPath_; }
    /// It is written whole and closed.
    [[nodiscard]] bool recordingClosed() const { return recordingClosed_; }

    /// Every telegram from now on into a new file.
    void startRecording(const QString& path);
    void stopRecording();
    /// The last minute as a file of its own.
    void keepRecent(const QString& path);

    /// Off: the picture stays as it is while the scanner goes on.
    void follow(bool on);
    [[nodiscard]] bool following() const { return following_; }
    /// On: following ends by itself with the sweep, so that the next one does not take its place.
    void setHoldAtEnd(bool on) { holdAtEnd_ = on; }

    [[nodiscard]] const LiveHealth& health() const { return health_; }
    /// What is on the screen comes from this scanner and is older than it seems.
    [[nodiscard]] bool showsStale() const;
    /// PictureSource::stream of its pictures; 0: never connected.
    [[nodiscard]] std::uint64_t stream() const { return stream_; }

signals:
    void connectedChanged(bool connected);
    void recordingChanged(bool recording);
    void followingChanged(bool following);
    void healthChanged();
    void written(const QString& path);
    void failed(const QString& sentence);

private:
    void tick();
    void showSweep();
    void showFinal(const SweepSoFar& sweep);
    void post(const SweepSoFar& sweep, bool growing);
    void tellRecorded(const Result<RecordingState>& closed, const QString& path);
    void noticeTroubles(const LiveStatus& status);
    void runAside(std::function<std::function<void()>()> work); // on a thread of its own; what it returns is called here

    Engine& engine_;
    std::shared_ptr<LiveFeed> feed_;
    std::shared_ptr<std::atomic<bool>> news_ = std::make_shared<std::atomic<bool>>(false);
    LiveHealth health_;
    std::uint64_t stream_ = 0;
    QTimer timer_;

    bool following_ = false;
    bool holdAtEnd_ = true;
    bool recording_ = false;
    bool recordingClosed_ = false;
    QString recordingPath_;
    bool recordingTroubleTold_ = false;
    int heldNumber_ = -1; // newest sweep that was shown whole
    std::optional<SweepSoFar> finished_;
    SweepSoFar posted_;   // the newest that was given to the session
    SweepProgress shown_; // that the picture on the screen was computed from
    QElapsedTimer sincePost_;
    qint64 restMs_ = 0; // from the last post to the next one
    bool awaiting_ = false;
};

} // namespace edgescan::ui
