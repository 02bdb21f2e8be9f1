// The operator's description of the stepper. Without it the length of a sweep and the angles of its lines are unknown.
#pragma once

#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace edgescan::ui {

class SweepForm : public QWidget {
    Q_OBJECT
public:
    explicit SweepForm(QWidget* parent = nullptr);

    void showSettings(const scanner::SweepSettings& settings);
    /// The axis that the ranges show is named where none was chosen; empty: they show none.
    void showAxisFromRanges(std::optional<Axis> axis);
    /// Keys go to the first field, whose text is selected.
    void begin();
    /// The last shown settings with the operator's changes.
    [[nodiscard]] scanner::SweepSettings settings() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void followLines();
    void followStep();
    void followTurn();
    void nameFirst();

    scanner::SweepSettings shown_;
    std::optional<Axis> seen_; // that the ranges show
    QSpinBox* lines_;
    QDoubleSpinBox* turn_; // of all lines: another form of the step
    QDoubleSpinBox* step_;
    QDoubleSpinBox* first_;
    QDoubleSpinBox* ticks_;
    QComboBox* axis_;
    QCheckBox* standing_;
};

} // namespace edgescan::ui
