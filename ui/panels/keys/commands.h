// The commands of menus and shortcuts as data, and the actions made from them.
#pragma once

#include <QAction>
#include <QString>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

class QActionGroup;
class QKeyEvent;
class QMenu;
class QWidget;

namespace edgescan::ui {

class Preferences;

/// Property of an action: the key under which a session file stores this switch.
inline constexpr const char* kInSessions = "kept-in-sessions";

/// Property of an action: it changes a setting or a result. Remembered switches have it.
inline constexpr const char* kChanges = "changes";

/// Property of an action: a switch that another scan begins without.
inline constexpr const char* kOfScan = "of-scan";

/// Property of an action: it is for a keyboard, a mouse or the layout of the desk; hidden in cab mode.
inline constexpr const char* kOfDesk = "of-desk";

/// Where the state of a switch is stored: the settings memory is for the next start.
enum class KeptIn : std::uint8_t { Both, Settings, Sessions };

/// One entry of a menu. The functions below make it.
struct Command {
    QString text{};
    QString keys{};                              ///< shortcuts: "Ctrl+Y; Ctrl+Shift+Z"
    std::function<void()> run{};                 ///< of a plain command
    std::function<void(bool on)> set{};          ///< of a switch
    const char* remembered = nullptr;            ///< of a switch: its key; null if its state is stored elsewhere
    bool on = false;                             ///< of a remembered switch: its value at the first start
    KeptIn keptIn = KeptIn::Both;                ///< of a remembered switch
    std::vector<Command> submenu{};              ///< entries of a submenu
    std::function<void(QMenu& menu)> fill{};     ///< of a menu that is filled each time it is opened
    QString source{};                            ///< the text before translation: shortcuts are stored under it
    bool ofDesk = false;                         ///< hidden in cab mode
    QAction* made = nullptr;                     ///< an existing action
    std::function<void(QAction& action)> link{}; ///< connects the action to the state that enables, checks or renames it
};

[[nodiscard]] Command command(const char* text, const char* keys, std::function<void()> run);
[[nodiscard]] Command toggle(const char* text, const char* keys, const char* remembered, bool on, std::function<void(bool)> set);
/// A switch that is remembered, but not in a session: a habit of the operator, not a property of the scan's view.
[[nodiscard]] Command habit(Command command);
/// A switch that is remembered in sessions only: another scan begins without it.
[[nodiscard]] Command ofScan(Command command);
[[nodiscard]] Command submenu(const char* text, std::vector<Command> commands);
/// A command that changes a setting or a result.
[[nodiscard]] Command changing(Command command);
/// A command or submenu for a keyboard, a mouse or the layout of the desk.
[[nodiscard]] Command ofDesk(Command command);
/// `command` with a link.
[[nodiscard]] Command linked(Command command, std::function<void(QAction&)> link);
/// One of the switches of a group, of which one is on. `name`: of its action.
[[nodiscard]] Command choice(Command command, QActionGroup& group, const QString& name, bool on);
/// A switch that `signal` of the sender sets, too.
template <class Sender, class Signal>
[[nodiscard]] Command following(Command command, Sender& sender, Signal signal) {
    return linked(std::move(command),
                  [&sender, signal](QAction& action) { QObject::connect(&sender, signal, &action, &QAction::setChecked); });
}
/// A choice() that is on while the last value of `signal` is `value`.
template <class Sender, class Signal, class Value>
[[nodiscard]] Command chosenWhile(const Command& command, Sender& sender, Signal signal, Value value) {
    return linked(command, [&sender, signal, value, link = command.link](QAction& action) {
        link(action);
        QObject::connect(&sender, signal, &action, [&action, value](Value now) {
            if (now == value) action.setChecked(true);
        });
    });
}
/// A link: enabled only if the last value of `signal` was true; disabled at first.
template <class Sender, class Signal>
[[nodiscard]] std::function<void(QAction&)> onlyWhile(Sender& sender, Signal signal) {
    return [&sender, signal](QAction& action) {
        action.setEnabled(false);
        QObject::connect(&sender, signal, &action, &QAction::setEnabled);
    };
}
/// A separator between commands.
inline const Command kLine{};

/// Adds the commands to the menu, and their shortcuts to `window`, so that they also work while the menu bar is hidden. A remembered switch
/// gets its value from the memory, which must outlive the menu. `path`: of the menu, in the language of the source.
void addCommands(QMenu& menu, const std::vector<Command>& commands, QWidget& window, Preferences& preferences, const QString& path = {});

/// Keys of the focused widget: Space presses the focused button. Home and End move the focused slider. Page Up and Page Down move the
/// focused slider, number or list. In other widgets these keys are shortcuts.
/// After the key of a command that asks for something (its text ends in "…") and opened no dialog, keys without a modifier are not commands
/// for a moment: they were typed for the dialog. A click or Esc ends that.
/// Several letters in a row outside a field may be a text: all that they changed is reported.
class KeysOfFocus : public QObject {
    Q_OBJECT
public:
    explicit KeysOfFocus(QWidget* window);
    /// All switches and tools are again as before the text.
    void putBack();
    /// The next key may belong to the same text.
    [[nodiscard]] bool hears() const { return letters_.isActive(); }
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The next key may be the first one of a text.
    void textBegins();
    /// Commands that were run, and switches with their states.
    void lettersChanged(const QStringList& names);

private:
    [[nodiscard]] bool asksInVain(const QKeyEvent& key) const;
    [[nodiscard]] bool isTypedForADialog(const QKeyEvent& key);
    [[nodiscard]] QWidget* window() const { return static_cast<QWidget*>(parent()); }
    void beginText();
    void noteKey(const QAction& action, bool letter);

    QTimer typing_;                                 // active = keys without a modifier are not commands
    QTimer letters_;                                // active = the next key may belong to the same text
    std::vector<std::pair<QAction*, bool>> before_; // switches and tools before the text
    QStringList run_;                               // commands that the text ran
    int pressed_ = 0;                               // letters of it
};

} // namespace edgescan::ui
