// Undo and redo of what the sliders set.
#include "ui/main/settings_undo.h"

#include "core/settings/parameters.h"

#include <QObject>

namespace edgescan::ui {
namespace {

// "Lower threshold 10 to 25": the first parameter that differs.
QString describe(const Settings& before, const Settings& after) {
    for (const Parameter& p : parameters()) {
        const std::string from = formatValue(p, p.get(before));
        const std::string to = formatValue(p, p.get(after));
        if (from != to)
            return QObject::tr("%1 %2 to %3").arg(QString::fromUtf8(p.label), QString::fromStdString(from), QString::fromStdString(to));
    }
    return QObject::tr("settings");
}

} // namespace

SettingsChange::SettingsChange(const Settings& before, const Settings& after, int drag, std::function<void(const Settings&)> apply)
    : QUndoCommand(describe(before, after)), before_(before), after_(after), drag_(drag), apply_(std::move(apply)) {}

bool SettingsChange::mergeWith(const QUndoCommand* later) {
    if (later->id() != id()) return false;
    after_ = static_cast<const SettingsChange*>(later)->after_;
    setText(describe(before_, after_));
    return true;
}

} // namespace edgescan::ui
