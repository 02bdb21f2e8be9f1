// The status bar: what is under the mouse, how much of what there is, how long the last update took, what draws it.
#pragma once

#include "core/edges/probe.h"

#include <QStatusBar>

#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace edgescan::ui {

/// "line 12  beam 400  beam 61.667°  line 2.160°  range 5.123 m  gray 87  x 1.234  y ... m  edge".
[[nodiscard]] QString probeText(const Probe& probe);

class StatusLine : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);

    void showProbe(const std::optional<Probe>& probe);
    void showCounts(const Frame& frame);
    /// Milliseconds from the change of a setting to its result.
    void showTime(double milliseconds);
    void showRenderer(const QString& name);
    void showWork(const QString& title, const QString& stage, double fraction);
    void hideWork();
    [[nodiscard]] QString probeShown() const;
    [[nodiscard]] QString countsShown() const;

signals:
    void cancelWanted();

private:
    QLabel* probe_;
    QLabel* counts_;
    QLabel* time_;
    QLabel* renderer_;
    QWidget* work_;
    QLabel* stage_;
    QProgressBar* bar_;
};

} // namespace edgescan::ui
