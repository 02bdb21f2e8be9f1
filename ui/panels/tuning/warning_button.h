// The number of warnings of the scan on the screen. The operator can read and acknowledge them; they stay in the list.
#pragma once

#include <QStringList>
#include <QToolButton>

namespace edgescan::ui {

/// Hidden without warnings. docs/reference/rules.md, "S13".
class WarningButton : public QToolButton {
    Q_OBJECT
public:
    explicit WarningButton(QWidget* parent = nullptr);

    /// A changed list of warnings is not acknowledged.
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
