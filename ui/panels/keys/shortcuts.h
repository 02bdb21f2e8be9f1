// The keys of commands as the operator wants them: what was changed is remembered, and no two commands share one.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

class QAction;

namespace edgescan::ui {

class Memory;

/// A command with a name that no language changes: "View/From Scanner".
struct KeyedCommand {
    QAction* action = nullptr;
    QString id;
    QString shown; ///< "View > From Scanner", in the language of the window
    QList<QKeySequence> usual;
};

/// Marks an action as a command. `menu` and `name`: as in the source, with their & and …
void nameCommand(QAction& action, const QString& menu, const QString& name);
/// All that were named, in the order given, each once.
[[nodiscard]] QList<KeyedCommand> keyedCommands(const QList<QAction*>& actions);

/// Who has the key already: a command, or something of the window that is no command (Esc, Tab, the key that flips A and B ...). Empty:
/// nobody.
[[nodiscard]] QString ownerOf(const QKeySequence& key, const QList<KeyedCommand>& commands, const QAction* but = nullptr);
/// The command has this key alone, or none where it is empty. Remembered. False, with nothing changed, where somebody else has it.
bool changeKey(const KeyedCommand& command, const QKeySequence& key, const QList<KeyedCommand>& commands, Memory& memory);
/// Back to what the program came with. What has one of its keys by now keeps that key; false then.
bool resetKey(const KeyedCommand& command, const QList<KeyedCommand>& commands, Memory& memory);
void resetAllKeys(const QList<KeyedCommand>& commands, Memory& memory);
/// At the start: what was changed before. A key that somebody else has by now is left out.
void recallKeys(const QList<KeyedCommand>& commands, const Memory& memory);

} // namespace edgescan::ui
