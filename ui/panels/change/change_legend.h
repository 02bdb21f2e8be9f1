// The legend of a comparison: names of the two scans, and the count of each kind of change. Each row is a switch.
#pragma once

#include "ui/panels/change/comparison.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace edgescan::ui {

class DistanceView;

/// What the views show of a comparison.
enum class ShownOfTwo { A, Difference, B };

/// Scans, or two settings of one scan.
struct NamesOfTwo {
    QString a, b;          ///< b empty: there is nothing to compare with yet
    bool reversed = false; ///< by the times of their files, B was before A
};

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class ChangeLegend : public QWidget {
    Q_OBJECT
public:
    explicit ChangeLegend(QWidget* parent = nullptr);

    /// Null: no comparison yet. Refused: the two could not be compared; a notice has the reason.
    void showKept(const NamesOfTwo& names, const Comparison* comparison, bool working, bool refused);
    /// Off: the differences are hidden, and so are their rows.
    void setRowsShown(bool on);
    /// On: for a cab, without explanations and without rows that count nothing. That of two scans begins folded.
    void setBrief(bool on);
    void setRows(const ChangeRows& rows);
    void setByDistance(bool on);
    /// Shows which of the two scans is on the screen.
    void showFlipped(bool flipped);
    /// On: the cloud does not show the changes, because rocks cover them.
    void showOverRocks(bool on);
    /// Text about a region, and a short one, in html, for a folded legend; empty = no text.
    void showRegion(const QString& words, const QString& brief = {});
    [[nodiscard]] QCheckBox* row(ChangeRow row) const { return rows_[static_cast<std::size_t>(row)].box; }
    [[nodiscard]] QString counted(ChangeRow row) const;
    [[nodiscard]] QString howText() const;
    [[nodiscard]] QString sumText() const;
    [[nodiscard]] QString titleText() const;
    [[nodiscard]] QString regionText() const;
    [[nodiscard]] QToolButton* next() const { return next_; }
    [[nodiscard]] QToolButton* previous() const { return previous_; }

signals:
    void rowsRequested(const edgescan::ui::ChangeRows& rows);
    /// The points are to have the colours of their distances from A, or not.
    void distancesRequested(bool on);
    void shownRequested(edgescan::ui::ShownOfTwo shown);
    void nextRegionRequested();
    void previousRegionRequested();
    void endRequested();

private:
    struct Row {
        QCheckBox* box = nullptr;
        QLabel* count = nullptr;
    };
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    [[nodiscard]] QHBoxLayout* switchOfTwo();
    void showRows();
    void breakNames();
    void emitRows();

    [[nodiscard]] bool isOneLine() const;
    [[nodiscard]] QString summaryText() const;
    void foldInCab();

    QLabel *title_, *unit_, *how_, *sum_, *overRocks_, *region_;
    QLabel* summary_; // next to the buttons, while all else is folded in a cab
    std::array<Row, kChangeRows> rows_;
    QCheckBox* byDistance_;
    DistanceView* histogram_;
    QLabel* distances_;
    QToolButton *fold_, *previous_, *next_, *end_;
    QWidget* buttons_;
    std::array<QToolButton*, 3> shown_{}; // one per ShownOfTwo
    QString regionBrief_;
    NamesOfTwo names_;
    QString howWords_;
    bool hasDistances_ = false, overRocksOn_ = false;
    bool flipped_ = false;
    bool rowsShown_ = true;
    bool brief_ = false;
    bool begun_ = false;                                          // since the legend came, a comparison was shown
    std::size_t regions_ = 0;                                     // that changed
    bool compared_ = false, ofTwoScans_ = false, warned_ = false; // of the comparison
};

} // namespace edgescan::ui
