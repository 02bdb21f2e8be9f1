// The shortcuts of commands with the operator's changes. Changes are remembered; two commands never share a shortcut.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

class QAction;

namespace edgescan::ui {

class Preferences;

/// A command with an untranslated name: "View/Look from/From Scanner".
struct KeyedCommand {
    QAction* action = nullptr;
    QString id;
    QString shown; ///< "View > From Scanner", in the language of the window
    QList<QKeySequence> usual;
};

/// Marks an action as a command. `menu` and `name`: as in the source, with their & and …
void nameCommand(QAction& action, const QString& menu, const QString& name);
/// All marked commands, in the given order, without duplicates.
[[nodiscard]] QList<KeyedCommand> keyedCommands(const QList<QAction*>& actions);

/// The action with this id, which must be one of them.
[[nodiscard]] QAction& actionOf(const QList<KeyedCommand>& commands, const QString& id);

/// The present owner of a key: a command, or a fixed key of the window (Esc, Tab, the key that flips A and B ...). Empty: the key is free.
[[nodiscard]] QString ownerOf(const QKeySequence& key, const QList<KeyedCommand>& commands, const QAction* but = nullptr);
/// Gives the command this key as its only shortcut; an empty key removes the shortcut. The change is remembered. False, without a change,
/// if the key has another owner.
bool changeKey(const KeyedCommand& command, const QKeySequence& key, const QList<KeyedCommand>& commands, Preferences& preferences);
/// Restores the command's default shortcuts. If another command owns one of them, it keeps it, and the result is false.
bool resetKey(const KeyedCommand& command, const QList<KeyedCommand>& commands, Preferences& preferences);
void resetAllKeys(const QList<KeyedCommand>& commands, Preferences& preferences);
/// At program start: restores the operator's changes, except for keys that have another owner now.
void recallKeys(const QList<KeyedCommand>& commands, const Preferences& preferences);

} // namespace edgescan::ui
