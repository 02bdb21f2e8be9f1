// A row of the settings, large: its value with buttons - and + that repeat while they are pressed; they replace the slider.
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace edgescan::ui {

class ParameterRow;

/// GUI thread only. The row must outlive it.
class Stepper : public QWidget {
    Q_OBJECT
public:
    explicit Stepper(ParameterRow& row, QWidget* parent = nullptr);

    /// Shows and changes this row from now on.
    void follow(ParameterRow& row);
    /// Adds a button right of name and value.
    void setAside(QToolButton* button);
    [[nodiscard]] const ParameterRow& row() const { return *row_; }
    [[nodiscard]] QString value() const;
    /// Between the buttons: what the value gave; empty: nothing.
    void showFound(const QString& words);
    [[nodiscard]] QToolButton* less() const { return less_; }
    [[nodiscard]] QToolButton* more() const { return more_; }

private:
    void addButton(QToolButton& button, int direction);
    void showValue();

    ParameterRow* row_ = nullptr;
    QHBoxLayout* head_;
    QLabel* name_;
    QToolButton* less_;
    QLabel* value_;
    QLabel* found_;
    QToolButton* more_;
    QLabel *ofLess_, *ofMore_; // of a threshold: what less and more of it do
    int repeats_ = 0;
};

} // namespace edgescan::ui
