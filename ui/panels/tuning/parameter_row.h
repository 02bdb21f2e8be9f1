// One row of the panel: label, slider, number, unit; made from a row of the parameter table.
#pragma once

#include "core/edges/settings/parameters.h"

#include <QObject>

#include <functional>
#include <vector>

class QAbstractButton;
class QCheckBox;
class QColor;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QKeyEvent;
class QLabel;
class QSlider;
class QToolButton;
class QWidget;

namespace edgescan::ui {

/// GUI thread only. `parameter` must outlive it (the table does).
class ParameterRow : public QObject {
    Q_OBJECT
public:
    /// Adds its widgets as the next row of `grid`.
    ParameterRow(const edges::Parameter& parameter, QGridLayout& grid, QWidget* parent);

    /// Shows the value without a signal. `inUse`: the value of an automatic parameter, NaN if unknown. A value that differs from `preset`
    /// gets a button that restores it; where the preset is automatic, "auto" does that.
    void show(double value, double inUse, double preset);
    void setEnabled(bool enabled);
    void setVisible(bool visible);
    /// On: buttons at both ends of the slider change the value by steps.
    void setForGloves(bool on);
    /// Parses a text typed into the number, such as "0.5 m"; error: the reason why it is not a value. By default the table parses it.
    using Reading = std::function<Result<double>(const QString&)>;
    void read(Reading reading);
    [[nodiscard]] const edges::Parameter& parameter() const { return parameter_; }
    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QDoubleSpinBox* number() const { return number_; }
    [[nodiscard]] QComboBox* choice() const { return choice_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The operator changed it. `dragging`: more changes will follow before dragEnded().
    void changed(double value, bool dragging);
    void dragEnded();
    /// The typed text is not a value and the former value is restored; the sentence gives the reason.
    void refused(const QString& sentence);
    /// The button, or a double-click: restore the value of the preset.
    void resetRequested();

private:
    void addNumber(QGridLayout& grid, int row, QWidget* parent);
    void addChoice(QGridLayout& grid, int row, QWidget* parent);
    void addReset(QWidget* parent);
    void addSlider(QGridLayout& grid, int row, QWidget* parent);
    void step(int steps);
    [[nodiscard]] std::vector<QWidget*> widgets() const;
    void changeTo(double value);
    bool stepByKey(const QKeyEvent& event);
    [[nodiscard]] bool numericChoices() const;

    const edges::Parameter& parameter_;
    QLabel* label_ = nullptr;
    QSlider* slider_ = nullptr;            // null for a choice without order
    QDoubleSpinBox* number_ = nullptr;     // null for choices
    QComboBox* choice_ = nullptr;          // null for numbers
    QAbstractButton* automatic_ = nullptr; // null: the parameter has no automatic value
    QToolButton* reset_ = nullptr;
    double value_ = edges::kAutomatic, inUse_ = edges::kAutomatic;
    bool differs_ = false; // from the preset
    bool visible_ = true;
    bool forGloves_ = false;
    int repeats_ = 0;                // of a button that is held
    std::vector<QWidget*> ofGloves_; // buttons and their words
    bool showing_ = false;
};

} // namespace edgescan::ui
