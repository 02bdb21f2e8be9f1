// The commands of menus and keys as data, and the actions that are made of them.
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace edgescan::ui {

class Memory;

/// Property of an action that is a switch which sessions keep: by which key.
inline constexpr const char* kInSessions = "kept-in-sessions";

/// One entry of a menu. Made by the functions below.
struct Command {
    QString text{};
    const char* keys = "";                       ///< "Ctrl+Y; Ctrl+Shift+Z"
    std::function<void()> run{};                 ///< of a plain command
    std::function<void(bool on)> set{};          ///< of a switch
    const char* remembered = nullptr;            ///< of a switch: its key in the memory; null where its state lives elsewhere
    bool on = false;                             ///< of a remembered switch: what it is at the first start
    bool inSessions = true;                      ///< of a remembered switch
    std::vector<Command> submenu{};              ///< of a menu
    std::function<void(QMenu& menu)> fill{};     ///< of a menu that is made anew each time it is opened
    const char* source = "";                     ///< the text before translation: keys are remembered by it
    QAction* made = nullptr;                     ///< an action that is there already
    std::function<void(QAction& action)> link{}; ///< what enables, checks or names the action from elsewhere
};

[[nodiscard]] Command command(const char* text, const char* keys, std::function<void()> run);
[[nodiscard]] Command toggle(const char* text, const char* keys, const char* remembered, bool on, std::function<void(bool)> set);
/// A switch that is remembered, but in no session: a habit of the person, not a look of the scan.
[[nodiscard]] Command habit(Command command);
[[nodiscard]] Command submenu(const char* text, std::vector<Command> commands);
/// `command` with a link.
[[nodiscard]] Command linked(Command command, std::function<void(QAction&)> link);
/// A line between commands.
inline const Command kLine{};

/// Adds the commands to the menu, and their keys to `window`, where they also work while the menu bar is hidden. A remembered switch is
/// set to what the memory says, which must outlive the menu. `path`: of the menu, in the words of the source.
void addCommands(QMenu& menu, const std::vector<Command>& commands, QWidget& window, Memory& memory, const QString& path = {});

/// Space presses the button that has the focus, Home and End move the slider, Page Up and Page Down the slider, number or list that has it;
/// only elsewhere they are shortcuts.
class KeysOfFocus : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace edgescan::ui
