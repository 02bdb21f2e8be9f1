// The number of warnings of the scan on the screen. The operator can read and acknowledge them; they stay in the list.
#pragma once

#include <QSet>
#include <QStringList>
#include <QToolButton>

#include <map>
#include <optional>

namespace edgescan::ui {

/// Hidden without warnings. docs/reference/rules.md, "S13".
class WarningButton : public QToolButton {
    Q_OBJECT
public:
    explicit WarningButton(QWidget* parent = nullptr);

    /// Of the scan or the scanner `of`. Acknowledged warnings of it stay so when they come back; a new one among them is not acknowledged.
    void showWarnings(const QStringList& warnings, const QString& of = {});
    /// Those of A while it is shown: they are not raised and not acknowledged. Empty: the scan's own again.
    void showInstead(const std::optional<QStringList>& warnings);
    void acknowledge();
    [[nodiscard]] const QStringList& warnings() const { return instead_ ? *instead_ : warnings_; }
    [[nodiscard]] bool acknowledged() const { return acknowledged_; }

signals:
    void warningsRaised(const QStringList& warnings);
    void warningsAcknowledged();

private:
    void showState();

    QStringList warnings_;
    QString of_;
    std::map<QString, QSet<QString>> read_; // by scan
    std::optional<QStringList> instead_;
    bool acknowledged_ = false;
};

} // namespace edgescan::ui
