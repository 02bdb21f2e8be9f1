// Buttons for gloves: the tools, the button that must be held for a second, and the steps of a setting.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>

#include <utility>
#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;

namespace edgescan::ui {

class ParameterRow;

inline constexpr int kHoldMs = 1000;

/// A button that acts only after it was held for a second: for actions that a glove must not start by accident.
class HoldButton : public QToolButton {
    Q_OBJECT
public:
    explicit HoldButton(QWidget* parent = nullptr);

signals:
    void held();
    /// The operator released it too soon.
    void releasedEarly();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void tick();

    QElapsedTimer since_;
    QTimer tick_;
};

/// Large enough for gloves, with an icon and text below it.
void makeGloveButton(QToolButton& button, const char* name, const char* sign, const QString& word);
[[nodiscard]] QToolButton* gloveButton(const char* name, const char* sign, const QString& word);

/// A small triangle: a tap opens a menu.
void showMenuSign(QToolButton& button, bool on = true);

/// Icons with text in one column, or two columns in a low window; Undo and Redo are always at the bottom. GUI thread only.
class ToolColumn : public QWidget {
    Q_OBJECT
public:
    explicit ToolColumn(QWidget* parent = nullptr);

    QToolButton* add(const char* name, const char* sign, const QString& word);
    /// Sets the buttons at the bottom, the lowest first; of two columns each has one.
    void setFoot(std::vector<QToolButton*> buttons);

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();

    std::vector<QToolButton*> buttons_;
    std::vector<QToolButton*> foot_;
    QGridLayout* grid_;
    std::pair<int, int> laidOut_{}; // rows and buttons
};

/// A row of the settings, large: its value with buttons that repeat while they are pressed; they replace the slider. GUI thread only. The
/// row must outlive it.
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
