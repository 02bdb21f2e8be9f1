// Commands by name.
#include "ui/panels/keys/shortcuts.h"

#include <QAction>
#include <QMenu>
#include <QVariant>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr const char* kId = "commandId";

QString plainName(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

} // namespace

void nameCommand(QAction& action, const QString& menu, const QString& name) {
    action.setProperty(kId, plainName(menu) + "/" + plainName(name));
}

QList<KeyedCommand> keyedCommands(const QList<QAction*>& actions) {
    QList<KeyedCommand> commands;
    QStringList seen;
    for (QAction* action : actions) {
        const QString id = action->property(kId).toString();
        if (id.isEmpty() || seen.contains(id)) continue;
        seen << id;
        const auto* menu = qobject_cast<const QMenu*>(action->parent());
        const QString shown = (menu != nullptr ? plainName(menu->title()) : id.section('/', 0, 0)) + " > " + plainName(action->text());
        commands.push_back({action, id, shown});
    }
    return commands;
}

QAction& actionOf(const QList<KeyedCommand>& commands, const QString& id) {
    const auto found = std::ranges::find(commands, id, &KeyedCommand::id);
    if (found == commands.end()) qFatal("no command has the id %s", qPrintable(id));
    return *found->action;
}

} // namespace edgescan::ui
