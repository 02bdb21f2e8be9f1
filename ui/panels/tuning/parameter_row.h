// One row of the panel: label, slider, number, unit; built from a row of the parameter table.
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
class QWidget;

namespace edgescan::ui {

/// GUI thread only. `parameter` must outlive it (the table does).
class ParameterRow : public QObject {
    Q_OBJECT
public:
    /// Adds its widgets as the next row of `grid`.
    ParameterRow(const Parameter& parameter, QGridLayout& grid, QWidget* parent);

    /// Shows the value without telling anybody. `inUse`: what an automatic value came out as, NaN when unknown.
    void show(double value, double inUse);
    void setEnabled(bool enabled);
    void setVisible(bool visible);
    /// What a text typed into the number stands for, such as "0.5 m", or why it stands for nothing; else as the table reads it.
    using Reading = std::function<Result<double>(const QString&)>;
    void read(Reading reading);
    /// Behind the switch of one of several choices: its colour, and what it stands for in numbers.
    void mark(std::size_t choice, const QColor& colour, const QString& remark);
    [[nodiscard]] const Parameter& parameter() const { return parameter_; }
    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QDoubleSpinBox* number() const { return number_; }
    [[nodiscard]] QComboBox* choice() const { return choice_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The user turned it. `dragging`: more will follow before dragEnded().
    void changed(double value, bool dragging);
    void dragEnded();
    /// What was typed stands for no value, and the old one is back: a sentence that says why.
    void refused(const QString& sentence);
    /// A double-click: back to the value of the preset.
    void resetWanted();

private:
    void addNumber(QGridLayout& grid, int row, QWidget* parent);
    void addChoice(QGridLayout& grid, int row, QWidget* parent);
    void addSwitches(QGridLayout& grid, int row, QWidget* parent);
    [[nodiscard]] std::vector<QWidget*> widgets() const;
    void tell(double value);
    bool stepByKey(const QKeyEvent& event);
    [[nodiscard]] bool numericChoices() const;

    const Parameter& parameter_;
    QLabel* label_ = nullptr;
    QSlider* slider_ = nullptr;            // null for a choice without order
    QDoubleSpinBox* number_ = nullptr;     // null for choices
    QComboBox* choice_ = nullptr;          // null for numbers
    std::vector<QCheckBox*> switches_;     // one per choice where several can be taken
    QWidget* strip_ = nullptr;             // that they lie in
    QAbstractButton* automatic_ = nullptr; // null where there is no automatic value
    bool showing_ = false;
};

} // namespace edgescan::ui
