// A live scanner and recordings: connecting, health, recording, playing a recording on the timeline.
#pragma once

#include "ui/panels/live/scanner_link.h"

#include <QObject>

#include <functional>

namespace edgescan::ui {

class Files;
class LinkedViews;
class LivePanel;
class Preferences;
class NoticeBar;
class Timeline;
struct ReplayedSweep;

/// GUI thread only. The objects passed to it must outlive it.
class Live : public QObject {
    Q_OBJECT
public:
    Live(Engine& engine, LivePanel& panel, Timeline& timeline, LinkedViews& views, Files& files, NoticeBar& notice,
         Preferences& preferences);

    /// A new picture is on the screen.
    void followPicture();
    /// Connects to a live scanner; EdgeScan sends only read requests and a subscription. "ws://HOST" or "ws://HOST:PORT" is a robot's
    /// bridge; `topic` and `joint` are those of its laser, empty: the ones that are found.
    void connectTo(const QString& host, int port, const scanner::SweepSettings& sweep, const std::string& topic = {},
                   const std::string& joint = {});
    /// While a recording plays, a part of it is on the screen: stops playing, shows the sweep with which the file opens, then calls `then`.
    void showWhole(QObject* asker, std::function<void()> then);
    void record(bool on);
    void keepLastMinute();
    /// Sets the folder of new recordings.
    void setRecordingFolder(const QString& folder);
    void askRecordingFolder();

    /// The recording file of a stream's sweeps; empty: none.
    [[nodiscard]] QString recordingOf(std::uint64_t stream) const {
        return stream == scanner_.stream() ? scanner_.recordingPath() : QString();
    }

    /// The picture on the screen gets more lines now.
    [[nodiscard]] bool grows() const;
    [[nodiscard]] ScannerLink& scanner() { return scanner_; }
    [[nodiscard]] LivePanel& panel() { return panel_; }
    [[nodiscard]] Timeline& timeline() { return timeline_; }

    /// What a connected scanner without a line yet waits for.
    [[nodiscard]] QString waitsFor() const;

signals:
    /// grows() may have changed without a new picture.
    void growthChanged();

private:
    void connectPanel();
    void useSweep();
    void askMounting();
    void connectScanner();
    void showHealth();
    void offerOther();
    [[nodiscard]] QString note(bool held) const;
    [[nodiscard]] QString lastLine() const;
    [[nodiscard]] QString shapeNote() const;
    [[nodiscard]] std::optional<Axis> axisShownByRanges() const;
    void showReplayed(const ReplayedSweep& at);
    void loadTimeline(const QString& path);
    void reportSweepEnd();
    [[nodiscard]] bool showsScanner() const; // the picture on the screen is of the newest connection
    [[nodiscard]] QString newRecordingPath(const char* kind) const;

    Engine& engine_;
    LivePanel& panel_;
    Timeline& timeline_;
    LinkedViews& views_;
    Files& files_;
    NoticeBar& notice_;
    Preferences& preferences_;
    ScannerLink scanner_;
    QString waitNote_;
    QString endNote_;                      // of the last sweep that ended
    std::shared_ptr<const Scan> fileScan_; // of the recording on the timeline, as read from the file
    QString recordingFolder_;
    std::string topic_, joint_; // that the operator chose of the robot at the address below
    QString topicOf_;
    std::uint64_t growingStream_ = 0; // stream of the previous picture, while its scan grew
};

} // namespace edgescan::ui
