// Five steps for the first start, in a strip above the views that covers nothing.
#pragma once

#include <QFrame>

#include <array>

class QLabel;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Displays one step after the other and signals the operator's choices.
class Tour : public QFrame {
    Q_OBJECT
public:
    static constexpr int kSteps = 5;

    explicit Tour(QWidget* parent = nullptr);

    /// Begins with the first step.
    void start();
    void end();
    [[nodiscard]] bool running() const { return running_; }
    /// From 0.
    [[nodiscard]] int step() const { return step_; }
    void showStep(int step);
    /// The step has a tick from now on.
    void tick(int step);
    /// While the program opens a scan, the first step has nothing to open.
    void setOpening(bool on);

signals:
    /// The operator wants to see what the step is about.
    void tryRequested(int step);

private:
    QLabel* number_;
    QLabel* text_;
    QToolButton *try_, *back_, *next_, *end_;
    bool running_ = false;
    int step_ = 0;
    std::array<bool, kSteps> done_{};
    bool opening_ = false;
};

} // namespace edgescan::ui
