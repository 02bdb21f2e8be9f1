// A number with - and + that repeat while they are held, in place of a slider.
#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Shows what it is told and says what the operator wants.
class Stepper : public QWidget {
    Q_OBJECT
public:
    explicit Stepper(const QString& name, QWidget* parent = nullptr);

    void showName(const QString& name);
    void showValue(const QString& value);
    [[nodiscard]] QString value() const;
    [[nodiscard]] QToolButton* less() const { return less_; }
    [[nodiscard]] QToolButton* more() const { return more_; }

signals:
    /// More of them at a time the longer it is held. stepEnded() follows when it is let go.
    void stepped(int steps);
    void stepEnded();

private:
    void addButton(QToolButton& button, int direction);

    QLabel* name_;
    QToolButton* less_;
    QLabel* value_;
    QToolButton* more_;
    int repeats_ = 0;
};

} // namespace edgescan::ui
