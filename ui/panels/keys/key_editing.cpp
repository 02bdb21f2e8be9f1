// Opens the table of shortcuts for the commands of a window.
#include "ui/panels/keys/key_editing.h"

#include "ui/panels/dialogs/shortcut_editor.h"
#include "ui/panels/keys/shortcuts.h"

#include <QAction>

namespace edgescan::ui {
namespace {

QString keysOf(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& key : action.shortcuts()) keys << key.toString(QKeySequence::NativeText);
    return keys.join(", ");
}

} // namespace

void editKeys(QWidget& window, Preferences& preferences) {
    const QList<KeyedCommand> commands = keyedCommands(window.actions());
    std::vector<ShortcutRow> rows;
    for (const KeyedCommand& command : commands) {
        const auto isUsual = [command] { return command.action->shortcuts() == command.usual; };
        const auto change = [command, commands, &preferences](const QKeySequence& key) {
            if (changeKey(command, key, commands, preferences)) return QString();
            return QObject::tr("%1 belongs to %2: nothing was changed.")
                .arg(key.toString(QKeySequence::NativeText), ownerOf(key, commands, command.action));
        };
        const auto reset = [command, commands, &preferences] {
            if (resetKey(command, commands, preferences)) return QString();
            return QObject::tr("A key of %1 belongs to another command now: change that one first.").arg(command.shown);
        };
        rows.push_back({command.shown, [command] { return keysOf(*command.action); }, isUsual, change, reset});
    }
    ShortcutEditor editor(
        std::move(rows), [&commands, &preferences] { resetAllKeys(commands, preferences); }, &window);
    editor.exec();
}

} // namespace edgescan::ui
