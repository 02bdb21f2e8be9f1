// A live scanner on the GUI thread: passes the growing sweep to the engine as fast as it can be displayed, and monitors the scanner's
// health.
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
#include <vector>

namespace edgescan::ui {

/// GUI thread only; no function here waits for network or disk.
class ScannerLink : public QObject {
    Q_OBJECT
public:
    /// `engine` must outlive this.
    explicit ScannerLink(Engine& engine, QObject* parent = nullptr);
    ~ScannerLink() override;
    /// A new picture is on the screen.
    void followPicture();

    /// Closes an open connection first. EdgeScan sends only read requests and a subscription.
    void connectTo(const scanner::ConnectionSettings& scanner, const scanner::SweepSettings& sweep);
    /// Ends recording and connection; the sweep stays on the screen.
    void disconnectScanner();
    /// Applies another mounting or other steps from now on, including the current sweep. Returns the number of its lines to which they
    /// cannot be applied. Empty: not connected, or the values are already in use.
    std::optional<int> useSweep(const scanner::SweepSettings& sweep);
    [[nodiscard]] bool connected() const { return feed_ != nullptr; }
    [[nodiscard]] scanner::ConnectionState connection() const { return feed_ ? feed_->status().connection : scanner::ConnectionState{}; }
    [[nodiscard]] std::optional<files::LiveStatus> status() const { return feed_ ? std::optional(feed_->status()) : std::nullopt; }
    /// Topics of a robot's bridge; empty: not connected to one, or not known yet.
    [[nodiscard]] std::vector<files::OfferedTopic> topics() const { return feed_ ? feed_->offered() : std::vector<files::OfferedTopic>(); }
    [[nodiscard]] bool recording() const { return recording_; }
    /// Path of the newest recording of this connection; empty: no recording.
    [[nodiscard]] const QString& recordingPath() const { return recordingPath_; }
    /// The recording is completely written and closed.
    [[nodiscard]] bool recordingClosed() const { return recordingClosed_; }

    /// Writes every telegram from now on to a new file.
    void startRecording(const QString& path);
    void stopRecording();
    /// Writes the last minute to its own file.
    void keepRecent(const QString& path);

    /// Of the operator. On: the picture follows sweep after sweep. Off: it does not change while the scanner continues.
    void follow(bool on);
    [[nodiscard]] bool following() const { return following_; }
    /// On: until the operator chose to follow, following ends with the first whole sweep of the connection, so that the next one does not
    /// replace the picture. A part of a sweep is not held: the next sweep replaces it. Switched on while the picture follows: with this
    /// sweep.
    void setHoldAtEnd(bool on) {
        holdAtEnd_ = on;
        throughEnds_ = false;
    }
    /// The newest finished sweep, where it is only a part because the scanner was in the middle of it when EdgeScan connected.
    [[nodiscard]] const std::optional<scanner::SweepProgress>& part() const { return part_; }
    /// The connection ended while the picture was held in the middle of its sweep.
    [[nodiscard]] bool heldAtStop() const { return heldAtStop_; }
    /// After the connection ended: the sweeps that are held besides that on the screen, ascending. They are the newest that was under way,
    /// the newest that was finished before it, and what was on the screen meanwhile.
    [[nodiscard]] std::vector<scanner::SweepState> others() const;
    /// Shows one of them.
    void showOther(std::size_t place);
    /// Progress of the sweep on the screen, as far as the picture shows it.
    [[nodiscard]] const scanner::SweepProgress& shown() const { return shown_; }

    [[nodiscard]] const files::LiveHealth& health() const { return health_; }
    /// True if the picture comes from this scanner and is outdated.
    [[nodiscard]] bool showsStale() const;
    /// PictureSource::stream of its pictures; 0: never connected.
    [[nodiscard]] std::uint64_t stream() const { return stream_; }

signals:
    void connectedChanged(bool connected);
    void recordingChanged(bool recording);
    void followingChanged(bool following);
    void otherChanged();
    void healthChanged();
    /// `linesBefore`: lines of the sweep under way that are in it although they came before the operator asked for the recording.
    void written(const QString& path, int linesBefore);
    void failed(const QString& sentence);

private:
    void tick();
    void setFollowing(bool on, bool throughEnds);
    void showStopped();
    void storeStopped(const std::vector<scanner::SweepState>& sweeps, bool shows);
    void hold(const scanner::SweepState& sweep);
    [[nodiscard]] scanner::SweepState onScreen() const;
    void showSweep();
    void showFinal(const scanner::SweepState& sweep);
    void post(const scanner::SweepState& sweep, bool growing);
    void reportRecorded(const Result<files::RecordingState>& closed, const QString& path);
    void noticeTroubles(const files::LiveStatus& status);
    void runInThread(std::function<std::function<void()>()> work); // on its own thread; the returned function is called on the GUI thread

    Engine& engine_;
    std::shared_ptr<files::LiveFeed> feed_;
    std::shared_ptr<std::atomic<bool>> news_ = std::make_shared<std::atomic<bool>>(false);
    files::LiveHealth health_;
    std::uint64_t stream_ = 0;
    QTimer timer_;

    bool following_ = false;
    bool holdAtEnd_ = true;
    bool throughEnds_ = false; // the operator chose to follow
    bool heldAtStop_ = false;
    bool recording_ = false;
    bool recordingClosed_ = false;
    QString recordingPath_;
    int linesBefore_ = 0; // in that recording
    bool recordingErrorReported_ = false;
    int heldNumber_ = -1;                         // number of the newest sweep that was shown complete
    std::optional<scanner::SweepState> finished_; // waits to be shown
    std::optional<scanner::SweepState> newest_;   // finished, shown or not
    std::optional<scanner::SweepProgress> part_;
    std::vector<scanner::SweepState> held_; // after the connection ended, that on the screen too; ascending
    files::LiveStatus last_;                // of the connection that has ended
    scanner::SweepState posted_;            // the newest state that was passed to the session
    bool again_ = false;                    // it is to be passed once more
    scanner::SweepProgress shown_;          // the progress that the picture on the screen shows
    QElapsedTimer sincePost_;
    qint64 restMs_ = 0; // pause between two posts
    bool awaiting_ = false;
};

} // namespace edgescan::ui
