// A button that does something only when it is held for a second: what no glove should do by chance.
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
    /// It was let go of too soon.
    void releasedEarly();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void tick();

    QElapsedTimer since_;
    QTimer tick_;
};

} // namespace edgescan::ui
