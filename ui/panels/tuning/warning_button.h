// How many warnings the scan on the screen has. They can be looked at and acknowledged, and stay.
#pragma once

#include <QStringList>
#include <QToolButton>

namespace edgescan::ui {

/// Hidden where there are none. docs/operator.md, "S13".
class WarningButton : public QToolButton {
    Q_OBJECT
public:
    explicit WarningButton(QWidget* parent = nullptr);

    /// Other warnings than before are not acknowledged yet.
    void showWarnings(const QStringList& warnings);
    void acknowledge();
    [[nodiscard]] const QStringList& warnings() const { return warnings_; }
    [[nodiscard]] bool acknowledged() const { return acknowledged_; }

signals:
    void warningsRaised(const QStringList& warnings);
    void warningsAcknowledged();

private:
    void showState();

    QStringList warnings_;
    bool acknowledged_ = false;
};

} // namespace edgescan::ui
