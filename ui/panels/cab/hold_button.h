// A button that acts only after it was held for a second: for actions that a glove must not start by accident.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>

namespace edgescan::ui {

inline constexpr int kHoldMs = 1000;

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

} // namespace edgescan::ui
