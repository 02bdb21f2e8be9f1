// The status bar: the cell under the mouse, the frame, counts, the time of the measurement, changed settings.
#pragma once

#include "core/edges/explain/cell_values.h"
#include "core/edges/settings/settings.h"
#include "core/rocks/selection/rock_settings.h"

#include <QStatusBar>
#include <QTimer>

#include <array>
#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace edgescan::ui {

/// The texts about a cell, in the order of importance; dashes for unknown mine coordinates.
struct ProbeTexts {
    QString place;   ///< "E 498700.058  N ...  RL ...  x 1.234  y ...  z ... m"
    QString verdict; ///< "range 5.123 m  EDGE (jump)"
    QString cell;    ///< "line 12  beam 400  at 2.160° / 61.667°  gray 87"
};
[[nodiscard]] ProbeTexts probeWords(const edges::Probe& probe);

class StatusLine : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// Adds a widget that is shown at every width.
    void addPinned(QWidget* widget);
    enum class Cell { Pointer, Pin, MovedPin, OfA };
    /// The text says if it is the pin's, at the click or near it, or of A while that is shown.
    void showProbe(const std::optional<edges::Probe>& probe, Cell cell = Cell::Pointer);
    /// The content of the selected box; empty: no box.
    void showBox(const QString& words);
    void showCounts(const edges::Detection& detection);
    /// While the scan has only a coarse picture; empty: no scan is coming.
    void showCountsToCome(std::optional<std::size_t> cells);
    /// The frame of the scan, with the origin of local coordinates. `growing`: more lines come, so that the sweep is not incomplete yet.
    void showPlace(const Scan& scan, bool growing = false);
    /// Marks a picture from a file, with its time of measurement. A followed scanner is shown in the live panel instead.
    void showTimeOf(const Scan& scan, bool live);
    /// The number and names of the settings that differ from the defaults; those of rocks while they are shown.
    /// With a menu that resets them one by one, or all; `own`: they are not those of A.
    void showSettings(const edges::Settings& settings, const rocks::RockSettings& ofRocks = {}, bool own = true);
    /// Work that ends quickly is not shown.
    void showWork(const QString& title, const QString& stage, double fraction);
    void endWork();
    [[nodiscard]] QString probeShown() const;
    [[nodiscard]] QString countsShown() const;
    [[nodiscard]] QString placeShown() const;
    [[nodiscard]] QString recordedShown() const;
    [[nodiscard]] QString settingsShown() const;

signals:
    void cancelRequested();
    /// The operator wants to give the scan a pose.
    void poseRequested();
    /// The operator wants the default value of this parameter back; empty: all of them.
    void resetRequested(const QString& parameter);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Fact { Incomplete, Place, Counts, Recorded, Box, Settings };
    static constexpr std::size_t kFacts = 6;
    struct FactLabel {
        QLabel* label = nullptr;
        QStringList texts; // the first is the whole one; each further one is shorter
        bool always = false;
    };
    [[nodiscard]] FactLabel& factLabel(Fact fact) { return factLabels_[static_cast<std::size_t>(fact)]; }
    [[nodiscard]] const FactLabel& factLabel(Fact fact) const { return factLabels_[static_cast<std::size_t>(fact)]; }
    void showFact(Fact fact, QStringList texts, bool always);
    void fit();
    [[nodiscard]] QString probeIn(int room) const;
    [[nodiscard]] static QString mainOf(const ProbeTexts& words, Cell cell);
    void reserve(const QString& main, const QString& more);
    void paintWork();

    QWidget* strip_;
    QBoxLayout* way_; // vertical: one line or two lines
    QBoxLayout* facts_ = nullptr;
    QLabel* probe_;
    std::array<FactLabel, kFacts> factLabels_;
    std::vector<QWidget*> pinnedWidgets_;
    QString probeMain_, probeMore_;
    QString longestMain_, longestWhole_; // texts of this scan, without and with the cell; their width depends on the theme
    QToolButton* noPose_;
    QWidget* work_;
    QLabel* stage_;
    QProgressBar* bar_;
    QString workTitle_, workStage_;
    double workFraction_ = 0.0;
    QTimer untilWorkIsShown_;
    QMenu* changed_; // the settings that differ from the defaults
};

} // namespace edgescan::ui
