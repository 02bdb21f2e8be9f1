// The warnings' button in the status bar.
#include "ui/panels/tuning/warning_button.h"

#include "ui/base/themes.h"

#include <algorithm>

namespace edgescan::ui {

WarningButton::WarningButton(QWidget* parent) : QToolButton(parent) {
    setObjectName("warnings");
    setAutoRaise(true);
    connect(this, &QToolButton::clicked, this, &WarningButton::acknowledge);
    followColours(*this, [this](const Theme&) { showState(); });
}

void WarningButton::showWarnings(const QStringList& warnings, const QString& of) {
    if (warnings == warnings_ && of == of_) return;
    warnings_ = warnings;
    of_ = of;
    const QSet<QString>& read = read_[of];
    acknowledged_ = !warnings.isEmpty() && std::ranges::all_of(warnings, [&](const QString& each) { return read.contains(each); });
    showState();
    emit warningsRaised(warnings_);
}

void WarningButton::showInstead(const std::optional<QStringList>& warnings) {
    instead_ = warnings;
    showState();
}

void WarningButton::acknowledge() {
    if (instead_) return;
    acknowledged_ = true;
    for (const QString& each : warnings_) read_[of_].insert(each);
    showState();
    emit warningsAcknowledged();
}

void WarningButton::showState() {
    const QString count = warnings().size() == 1 ? tr("1 warning") : tr("%1 warnings").arg(warnings().size());
    const bool acknowledged = acknowledged_ && !instead_;
    // The sign repeats the meaning of the colour. Both are as wide: what is next to it must not move under the pointer.
    setText((acknowledged ? "\u2713 " : "\u26A0 ") + count);
    const QString colour = acknowledged ? QString() : QString("color: %1; ").arg(themeInUse().warn.name());
    setStyleSheet(QString("QToolButton { %1font-weight: bold; }").arg(colour));
    setToolTip((acknowledged ? tr("Acknowledged.") + ' ' : QString()) +
               tr("Shows the warnings of this scan and acknowledges them. They remain in records and screenshots."));
    setVisible(!warnings().isEmpty());
}

} // namespace edgescan::ui

#include "moc_warning_button.cpp"
