// A number with buttons - and + that repeat while they are pressed; it replaces a slider.
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class Stepper : public QWidget {
    Q_OBJECT
public:
    explicit Stepper(const QString& name, QWidget* parent = nullptr);

    /// Words below the buttons: what more and less of the value do.
    void setMeaning(const QString& ofLess, const QString& ofMore);
    /// Adds a button right of name and value.
    void setAside(QToolButton* button);
    void showName(const QString& name);
    void showValue(const QString& value);
    [[nodiscard]] QString value() const;
    /// Between the buttons: what the value gave; empty: nothing.
    void showFound(const QString& words);
    [[nodiscard]] QString found() const;
    [[nodiscard]] QToolButton* less() const { return less_; }
    [[nodiscard]] QToolButton* more() const { return more_; }

signals:
    /// Steps since the last signal; the number grows while the button is pressed. stepEnded() follows on release.
    void stepped(int steps);
    void stepEnded();

private:
    void addButton(QToolButton& button, int direction);

    QHBoxLayout* head_;
    QLabel* name_;
    QToolButton* less_;
    QLabel* value_;
    QLabel* found_;
    QToolButton* more_;
    int repeats_ = 0;
};

} // namespace edgescan::ui
