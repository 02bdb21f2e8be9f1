// Shortcuts changed by the operator.
#include "ui/panels/keys/shortcuts.h"

#include "ui/engine/worker_bridge/preferences.h"

#include <QAction>
#include <QMenu>
#include <QObject>
#include <QVariant>

#include <algorithm>
#include <array>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr const char* kId = "commandId";
constexpr const char* kUsual = "usualKeys";
constexpr const char* kNone = "none"; // stored for a command whose shortcut was removed

QString plainName(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

QString kept(const QString& id) { return "keys/" + QString(id).replace('/', '|'); }

void remember(const KeyedCommand& command, Preferences& preferences) {
    const QList<QKeySequence> now = command.action->shortcuts();
    const bool usual = now == command.usual;
    const QString keys = QKeySequence::listToString(now, QKeySequence::PortableText);
    preferences.keep(kept(command.id), usual ? QString() : keys.isEmpty() ? QString(kNone) : keys);
}

// Keys that views and fields handle themselves.
QString ofTheWindow(const QKeySequence& key) {
    static const std::array<std::pair<int, const char*>, 9> taken{{
        {Qt::Key_Escape, QT_TRANSLATE_NOOP("QObject", "end the tool, or what is shown last")},
        {Qt::Key_Backspace, QT_TRANSLATE_NOOP("QObject", "take the last click back")},
        {Qt::Key_Tab, QT_TRANSLATE_NOOP("QObject", "to the next field")},
        {int(Qt::SHIFT) + Qt::Key_Tab, QT_TRANSLATE_NOOP("QObject", "to the field before")},
        {Qt::Key_Return, QT_TRANSLATE_NOOP("QObject", "pin the cell at the cursor")},
        {Qt::Key_Enter, QT_TRANSLATE_NOOP("QObject", "pin the cell at the cursor")},
        {Qt::Key_Up, QT_TRANSLATE_NOOP("QObject", "the cell cursor")},
        {Qt::Key_Down, QT_TRANSLATE_NOOP("QObject", "the cell cursor")},
        {Qt::Key_Backslash, QT_TRANSLATE_NOOP("QObject", "show A while it is held")},
    }};
    for (const auto& [taken_, what] : taken) {
        if (key == QKeySequence(taken_)) return QObject::tr(what);
    }
    return {};
}

} // namespace

void nameCommand(QAction& action, const QString& menu, const QString& name) {
    action.setProperty(kId, plainName(menu) + "/" + plainName(name));
    action.setProperty(kUsual, QKeySequence::listToString(action.shortcuts(), QKeySequence::PortableText));
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
        const QString usual = action->property(kUsual).toString();
        commands.push_back({action, id, shown, usual.isEmpty() ? QList<QKeySequence>() : QKeySequence::listFromString(usual)});
    }
    return commands;
}

QAction& actionOf(const QList<KeyedCommand>& commands, const QString& id) {
    const auto found = std::ranges::find(commands, id, &KeyedCommand::id);
    if (found == commands.end()) qFatal("no command has the id %s", qPrintable(id));
    return *found->action;
}

QString ownerOf(const QKeySequence& key, const QList<KeyedCommand>& commands, const QAction* but) {
    if (key.isEmpty()) return {};
    for (const KeyedCommand& command : commands) {
        if (command.action != but && command.action->shortcuts().contains(key)) return command.shown;
    }
    return ofTheWindow(key);
}

bool changeKey(const KeyedCommand& command, const QKeySequence& key, const QList<KeyedCommand>& commands, Preferences& preferences) {
    if (!ownerOf(key, commands, command.action).isEmpty()) return false;
    command.action->setShortcuts(key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
    remember(command, preferences);
    return true;
}

bool resetKey(const KeyedCommand& command, const QList<KeyedCommand>& commands, Preferences& preferences) {
    QList<QKeySequence> free;
    for (const QKeySequence& key : command.usual) {
        if (ownerOf(key, commands, command.action).isEmpty()) free << key;
    }
    command.action->setShortcuts(free);
    remember(command, preferences);
    return free == command.usual;
}

void resetAllKeys(const QList<KeyedCommand>& commands, Preferences& preferences) {
    for (const KeyedCommand& command : commands) command.action->setShortcuts(command.usual);
    for (const KeyedCommand& command : commands) remember(command, preferences);
}

// Two commands may have exchanged their shortcuts. Therefore all shortcuts are removed first.
void recallKeys(const QList<KeyedCommand>& commands, const Preferences& preferences) {
    QList<std::pair<const KeyedCommand*, QString>> changed;
    for (const KeyedCommand& command : commands) {
        const QString keys = preferences.text(kept(command.id));
        if (keys.isEmpty()) continue;
        changed.push_back({&command, keys});
        command.action->setShortcuts(QList<QKeySequence>());
    }
    for (const auto& [command, keys] : changed) {
        QList<QKeySequence> free;
        for (const QKeySequence& key : keys == kNone ? QList<QKeySequence>() : QKeySequence::listFromString(keys)) {
            if (!key.isEmpty() && ownerOf(key, commands, command->action).isEmpty()) free << key;
        }
        command->action->setShortcuts(free);
    }
}

} // namespace edgescan::ui
