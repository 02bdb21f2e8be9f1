// The status bar: what is under the mouse, how much of what there is, how long the last update took, what draws it.
#pragma once

#include "core/explain/probe.h"

#include <QStatusBar>
#include <QTimer>

#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace edgescan::ui {

/// "line 12  beam 400  at 2.160° / 61.667°  range 5.123 m  gray 87  x 1.234  y ... m  N 5150118.058  E ...  El ...  EDGE"; dashes for
/// the mine grid where it is not known.
[[nodiscard]] QString probeText(const Probe& probe);

class StatusLine : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);

    void showProbe(const std::optional<Probe>& probe);
    void showCounts(const Detection& detection);
    /// Which frame the scan stands in, with the origin of local coordinates.
    void showPlace(const Scan& scan);
    /// Milliseconds from the change of a setting to its result.
    void showTime(double milliseconds);
    void showRenderer(const QString& name);
    /// Work that ends at once is not shown.
    void startWork(const QString& title);
    void showProgress(const QString& stage, double fraction);
    void endWork();
    [[nodiscard]] QString probeShown() const;
    [[nodiscard]] QString countsShown() const;
    [[nodiscard]] QString placeShown() const;

signals:
    void cancelWanted();

private:
    QLabel* probe_;
    QLabel* place_;
    QLabel* counts_;
    QLabel* time_;
    QLabel* renderer_;
    QWidget* work_;
    QLabel* stage_;
    QProgressBar* bar_;
    QString workTitle_;
    QTimer untilWorkIsShown_;
};

} // namespace edgescan::ui
