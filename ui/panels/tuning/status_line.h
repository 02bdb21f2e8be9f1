// The status bar: what is under the mouse, how much of what there is, how long the last update took, what draws it.
#pragma once

#include "core/edges/explain/probe.h"
#include "core/edges/settings/settings.h"

#include <QStatusBar>
#include <QTimer>

#include <array>
#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace edgescan::ui {

/// What is told of a cell, in the order of its worth; dashes for the mine grid where it is not known.
struct ProbeWords {
    QString place;   ///< "N 5150118.058  E ...  El ...  x 1.234  y ...  z ... m"
    QString verdict; ///< "range 5.123 m  EDGE (jump)"
    QString cell;    ///< "line 12  beam 400  at 2.160° / 61.667°  gray 87"
};
[[nodiscard]] ProbeWords probeWords(const Probe& probe);

class StatusLine : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// A widget among the facts that stays whatever the width.
    void addKept(QWidget* widget);
    void showProbe(const std::optional<Probe>& probe);
    /// What a box holds; empty: there is none.
    void showBox(const QString& words);
    void showCounts(const Detection& detection);
    /// Which frame the scan stands in, with the origin of local coordinates.
    void showPlace(const Scan& scan);
    /// A picture of a file says that it is one and when it was measured; that of a scanner that is being followed is told of elsewhere.
    void showTimeOf(const Scan& scan, bool live);
    /// How many settings differ from the default ones, and which.
    void showSettings(const Settings& settings);
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
    [[nodiscard]] QString recordedShown() const;
    [[nodiscard]] QString settingsShown() const;

signals:
    void cancelWanted();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Fact { Incomplete, Place, Counts, Recorded, Box, Settings, Time, Renderer };
    static constexpr std::size_t kFacts = 8;
    struct Told {
        QLabel* label = nullptr;
        QString words, brief; // brief: where there is less room; empty: there are no fewer words
        bool kept = false;
    };
    [[nodiscard]] Told& told(Fact fact) { return told_[static_cast<std::size_t>(fact)]; }
    [[nodiscard]] const Told& told(Fact fact) const { return told_[static_cast<std::size_t>(fact)]; }
    void tell(Fact fact, const QString& words, const QString& brief, bool kept);
    void fit();

    QWidget* strip_;
    QBoxLayout* way_; // in one line or in two
    QBoxLayout* facts_ = nullptr;
    QLabel* probe_;
    std::array<Told, kFacts> told_;
    std::vector<QWidget*> kept_;
    QString probeMain_, probeMore_;
    int longestProbe_ = 0, longestCell_ = 0; // px; of this scan, without and with the cell
    QWidget* work_;
    QLabel* stage_;
    QProgressBar* bar_;
    QString workTitle_;
    QTimer untilWorkIsShown_;
};

} // namespace edgescan::ui
