// The legend of a comparison over the cloud: what is compared with what, how many of each, each row a switch.
#pragma once

#include "ui/base/view_plate.h"
#include "ui/panels/change/comparison.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Shows what it is told and says what the operator wants.
class ChangeLegend : public ViewPlate {
    Q_OBJECT
public:
    explicit ChangeLegend(QWidget* parent = nullptr);

    /// `before`: what A is. Null: nothing to compare with yet.
    void showKept(const QString& before, const Comparison* comparison, bool working);
    /// Off: the differences are not shown, and no row tells of them.
    void setRowsShown(bool on);
    void setRows(const ChangeRows& rows);
    /// Which of the two is on the screen.
    void showFlipped(bool flipped);
    /// The cloud does not show them: rocks cover them there.
    void showCovered(bool on);
    /// Words about a region; empty = none.
    void showRegion(const QString& words);
    [[nodiscard]] QCheckBox* row(ChangeRow row) const { return rows_[static_cast<std::size_t>(row)].box; }
    [[nodiscard]] QString counted(ChangeRow row) const;
    [[nodiscard]] QString howText() const;
    [[nodiscard]] QString titleText() const;
    [[nodiscard]] QString regionText() const;
    [[nodiscard]] QToolButton* next() const { return next_; }

signals:
    void rowsWanted(const edgescan::ui::ChangeRows& rows);
    void nextRegionWanted();

private:
    struct Row {
        QCheckBox* box = nullptr;
        QLabel* count = nullptr;
    };
    void tellRows();

    QLabel *title_, *how_, *covered_, *region_;
    std::array<Row, kChangeRows> rows_;
    QToolButton* next_;
    QString before_;
    bool flipped_ = false;
    bool rowsShown_ = true;
};

} // namespace edgescan::ui
