// The timeline under the views: plays a recording, by steps or by dragging, line by line.
#pragma once

#include "ui/panels/live/replay_player.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;
class QPushButton;

namespace edgescan::ui {

class TimelineSlider;

/// GUI thread only.
class Timeline : public QWidget {
    Q_OBJECT
public:
    explicit Timeline(QWidget* parent = nullptr);

    /// Becomes visible when the recording is read and has more than one line.
    void load(const std::filesystem::path& path, const ReadingOptions& options);
    void clear();
    /// True if there is a recording to play.
    [[nodiscard]] bool active() const { return lines() > 0; }

    [[nodiscard]] int lines() const { return static_cast<int>(contents_.lineNs.size()); }
    /// The requested number of played lines; the picture may still be behind.
    [[nodiscard]] int position() const { return position_; }
    /// The position at which the file is opened: the end of its longest sweep.
    [[nodiscard]] int home() const { return home_; }
    [[nodiscard]] bool playing() const { return ticking_.isActive(); }
    [[nodiscard]] const RecordingContents& contents() const { return contents_; }
    /// The position at which this sweep is whole.
    [[nodiscard]] int endOf(std::size_t sweep) const;
    [[nodiscard]] QString labelShown() const;

    /// Goes to the end of the next (1) or previous (-1) sweep; false where the recording has none.
    bool stepSweep(int by);

public slots:
    void play(bool on);
    void togglePlay() { play(!playing()); }
    void goTo(int line);
    void stepBy(int lines);
    void setSpeed(double factor);

signals:
    void activeChanged(bool active);
    /// The recording was read, and `contents()` has its sweeps; none: there is nothing to play.
    void loaded();
    void playingChanged(bool playing);
    /// The recording cannot be played; the sentence gives the reason.
    void refused(const QString& sentence);
    void arrived(const edgescan::ui::ReplayedSweep& at);

private:
    void tick();
    void setClock();
    void showPlace();
    void seek();
    void showContents(const RecordingContents& contents);
    [[nodiscard]] int sweepAt(int position) const;

    std::unique_ptr<ReplayPlayer> player_;
    RecordingContents contents_;
    int position_ = 0, home_ = 0;
    double atNs_ = 0.0; // time in the recording while it plays
    double speed_ = 1.0;
    bool seeking_ = false; // the player has not answered the last request yet
    QTimer ticking_;
    QElapsedTimer sinceTick_;

    QPushButton* play_;
    TimelineSlider* slider_;
    QLabel* label_;
    QComboBox* speeds_;
};

} // namespace edgescan::ui
