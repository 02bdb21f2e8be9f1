// What the operator says of the stepper: without it nobody knows how long a sweep is and where its lines lie.
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

    void showSettings(const SweepSettings& settings);
    /// The settings shown last with what was typed since.
    [[nodiscard]] SweepSettings settings() const;

private:
    SweepSettings shown_;
    QSpinBox* lines_;
    QDoubleSpinBox* step_;
    QDoubleSpinBox* first_;
    QDoubleSpinBox* ticks_;
    QComboBox* axis_;
    QCheckBox* standing_;
};

} // namespace edgescan::ui
