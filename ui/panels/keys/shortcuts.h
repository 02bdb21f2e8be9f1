// Commands by untranslated names.
#pragma once

#include <QList>
#include <QString>

class QAction;

namespace edgescan::ui {

/// A command with an untranslated name: "View/Look from/From Scanner".
struct KeyedCommand {
    QAction* action = nullptr;
    QString id;
    QString shown; ///< "View > From Scanner", in the language of the window
};

/// Marks an action as a command. `menu` and `name`: as in the source, with their & and …
void nameCommand(QAction& action, const QString& menu, const QString& name);
/// All marked commands, in the given order, without duplicates.
[[nodiscard]] QList<KeyedCommand> keyedCommands(const QList<QAction*>& actions);

/// The action with this id, which must be one of them.
[[nodiscard]] QAction& actionOf(const QList<KeyedCommand>& commands, const QString& id);

} // namespace edgescan::ui
