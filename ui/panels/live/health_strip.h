// One row that shows whether the picture is up to date: LIVE / STALE / LOST, lines and progress, time left, losses, no return, window,
// pose, recording.
#pragma once

#include "core/files/live_feed/live_health.h"

#include <QWidget>

class QLabel;

namespace edgescan::ui {

class StateBadge;
class SweepBar;

/// GUI thread only.
class HealthStrip : public QWidget {
    Q_OBJECT
public:
    explicit HealthStrip(QWidget* parent = nullptr);

    /// The relation of the picture on the screen to the scanner.
    enum class Picture { Follows, Held, Other };
    /// `note`: a sentence about the picture, shown while the scanner has nothing to say.
    void showHealth(const files::LiveHealth& health, Picture picture = Picture::Follows, const QString& note = {});
    /// While on, it becomes no lower: what is below it does not move each time that a word comes or goes.
    void setSteady(bool on);
    /// Less that is as it should be, for cab mode.
    void setBrief(bool on);
    [[nodiscard]] const files::LiveHealth& shown() const { return shown_; }
    [[nodiscard]] StateBadge& badge() { return *badge_; }
    [[nodiscard]] const SweepBar& bar() const { return *bar_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void reserveWidths();
    void keepHeight();
    [[nodiscard]] bool isNarrow() const;

    files::LiveHealth shown_;
    Picture picture_ = Picture::Follows;
    QString note_;
    bool brief_ = false, steady_ = false;
    int kept_ = 0; // px
    StateBadge* badge_;
    QLabel* lines_;
    SweepBar* bar_;
    QLabel* lost_;
    QLabel* noReturn_;
    StateBadge* remark_;
    StateBadge* window_;
    StateBadge* device_;
    QLabel* pose_;
    QLabel* end_;
    StateBadge* recording_;
    QLabel* sentence_;
};

} // namespace edgescan::ui
