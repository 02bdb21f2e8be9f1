// Makes menus and shortcuts from a table of commands.
#include "ui/panels/keys/commands.h"

#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/keys/shortcuts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QShortcutEvent>
#include <QStringList>
#include <QWidget>

#include <algorithm>

namespace edgescan::ui {
namespace {

void makeSwitch(QAction& action, const Command& command, Preferences& preferences) {
    action.setCheckable(true);
    action.setProperty(kChanges, true);
    if (command.remembered == nullptr) {
        QObject::connect(&action, &QAction::triggered, &action, command.set);
        return;
    }
    if (command.keptIn != KeptIn::Settings) action.setProperty(kInSessions, command.remembered);
    const bool forNextStart = command.keptIn != KeptIn::Sessions;
    action.setProperty(kOfScan, !forNextStart);
    action.setChecked(forNextStart ? preferences.flag(command.remembered, command.on) : command.on);
    command.set(action.isChecked()); // also for the initial state of the action
    QObject::connect(&action, &QAction::toggled, &action,
                     [&preferences, set = command.set, key = command.remembered, forNextStart](bool on) {
                         set(on);
                         if (forNextStart) preferences.keep(key, on);
                     });
}

/// What an operator may type to find a command, in addition to its name.
struct OtherWords {
    const char* command;
    const char* words;
};
constexpr OtherWords kOtherWords[]{
    {"&Show Rocks", QT_TRANSLATE_NOOP("QObject", "stones boulders fragments sizes")},
    {"E&xport Rocks…", QT_TRANSLATE_NOOP("QObject", "export csv table list of rocks dxf outlines")},
    {"&Largest Rock by Width b", QT_TRANSLATE_NOOP("QObject", "wider widest biggest boulder oversize")},
    {"&Edge Cloud…", QT_TRANSLATE_NOOP("QObject", "export csv table edge list points")},
    {"&Full Cloud…", QT_TRANSLATE_NOOP("QObject", "export csv table all points las")},
    {"&Targets…", QT_TRANSLATE_NOOP("QObject", "export csv table pins measurements")},
    {"Re&port…", QT_TRANSLATE_NOOP("QObject", "print pdf paper page")},
    {"&Screenshot…", QT_TRANSLATE_NOOP("QObject", "picture image of the window")},
    {"Re&load", QT_TRANSLATE_NOOP("QObject", "refresh read again")},
    {"&Keep This as A", QT_TRANSLATE_NOOP("QObject", "compare before after change difference")},
};

void addOtherWords(QAction& action, const QString& command) {
    for (const OtherWords& each : kOtherWords) {
        if (command == QString::fromUtf8(each.command)) action.setWhatsThis(QObject::tr(each.words));
    }
}

} // namespace

Command command(const char* text, const char* keys, std::function<void()> run) {
    return {.text = QObject::tr(text), .keys = keys, .run = std::move(run), .source = text};
}

Command toggle(const char* text, const char* keys, const char* remembered, bool on, std::function<void(bool)> set) {
    return {.text = QObject::tr(text), .keys = keys, .set = std::move(set), .remembered = remembered, .on = on, .source = text};
}

Command habit(Command command) {
    command.keptIn = KeptIn::Settings;
    return command;
}

Command ofScan(Command command) {
    command.keptIn = KeptIn::Sessions;
    return command;
}

Command submenu(const char* text, std::vector<Command> commands) {
    return {.text = QObject::tr(text), .submenu = std::move(commands), .source = text};
}

Command ofDesk(Command command) {
    command.ofDesk = true;
    return command;
}

Command changing(Command command) {
    return linked(std::move(command), [](QAction& action) { action.setProperty(kChanges, true); });
}

Command linked(Command command, std::function<void(QAction&)> link) {
    command.link = std::move(link);
    return command;
}

Command choice(Command command, QActionGroup& group, const QString& name, bool on) {
    return linked(std::move(command), [&group, name, on](QAction& action) {
        group.addAction(&action);
        action.setObjectName(name);
        action.setChecked(on);
    });
}

void addCommands(QMenu& menu, const std::vector<Command>& commands, QWidget& window, Preferences& preferences, const QString& path) {
    for (const Command& command : commands) {
        if (!command.submenu.empty() || command.fill) {
            QMenu* submenu = menu.addMenu(command.text);
            submenu->menuAction()->setProperty(kOfDesk, command.ofDesk);
            addCommands(*submenu, command.submenu, window, preferences, path.isEmpty() ? command.source : path + "/" + command.source);
            if (command.fill) QObject::connect(submenu, &QMenu::aboutToShow, submenu, [submenu, fill = command.fill] { fill(*submenu); });
            continue;
        }
        if (command.text.isEmpty() && command.made == nullptr) {
            menu.addSeparator();
            continue;
        }
        QAction* action = command.made != nullptr ? command.made : new QAction(command.text, &menu);
        if (command.ofDesk) action->setProperty(kOfDesk, true);
        if (!command.keys.isEmpty()) action->setShortcuts(QKeySequence::listFromString(command.keys));
        if (command.run) QObject::connect(action, &QAction::triggered, action, command.run);
        if (command.set) makeSwitch(*action, command, preferences);
        addOtherWords(*action, command.source);
        if (command.link) command.link(*action);
        const QString own =
            action->objectName().isEmpty() && action->parent() != nullptr ? action->parent()->objectName() : action->objectName();
        const QString name = !command.source.isEmpty() ? command.source : own;
        if (!name.isEmpty()) nameCommand(*action, path, name);
        menu.addAction(action);
        window.addAction(action);
    }
}

namespace {

/// A field takes Undo and Redo also where it has nothing to undo: those are the window's.
bool leavesUndo(const QObject& field, const QKeyEvent& key) {
    const bool undo = key.matches(QKeySequence::Undo), redo = key.matches(QKeySequence::Redo);
    if (!undo && !redo) return false;
    const auto* edit = qobject_cast<const QLineEdit*>(&field);
    if (edit == nullptr && qobject_cast<const QAbstractSpinBox*>(&field) != nullptr) edit = field.findChild<const QLineEdit*>();
    return edit != nullptr && !(undo ? edit->isUndoAvailable() : edit->isRedoAvailable());
}

} // namespace

KeysOfFocus::KeysOfFocus(QWidget* window) : QObject(window) {
    constexpr int kTypedForMs = 1500; // since the last key
    typing_.setSingleShot(true);
    typing_.setInterval(kTypedForMs);
    letters_.setSingleShot(true);
    letters_.setInterval(kTypedForMs);
}

/// How all switches and tools are before a key that may be the first one of a text.
void KeysOfFocus::beginText() {
    if (letters_.isActive()) return;
    letters_.start(); // the next key may come before this one has worked
    pressed_ = 0;
    run_.clear();
    before_.clear();
    for (QAction* action : window()->actions()) {
        if (action->isCheckable() && action->property(kChanges).toBool()) before_.emplace_back(action, action->isChecked());
    }
    emit textBegins();
}

/// One letter alone is meant; a text has several. Other signs may belong to it.
void KeysOfFocus::noteKey(const QAction& action, bool letter) {
    letters_.start();
    pressed_ += letter ? 1 : 0;
    const QString name = action.text().remove('&');
    if (!action.isCheckable() && action.property(kChanges).toBool() && !run_.contains(name)) run_ << name;
    QStringList all = run_;
    for (const auto& [each, on] : before_) {
        if (each->isChecked() != on) all << each->text().remove('&') + ' ' + (on ? tr("off") : tr("on"));
    }
    if (pressed_ > 1 && !all.isEmpty()) emit lettersChanged(all);
}

void KeysOfFocus::putBack() {
    for (const auto& [each, on] : before_) {
        if (each->isChecked() != on) each->trigger();
    }
}

/// The key of a command that asks for something and cannot be used now.
bool KeysOfFocus::asksInVain(const QKeyEvent& key) const {
    if ((key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0) return false;
    const QKeySequence pressed(key.key() | static_cast<int>(key.modifiers()));
    return std::ranges::any_of(window()->actions(), [&](const QAction* action) {
        return !action->isEnabled() && action->text().endsWith(QStringLiteral("…")) && action->shortcuts().contains(pressed);
    });
}

bool KeysOfFocus::isTypedForADialog(const QKeyEvent& key) {
    if (!typing_.isActive()) return false;
    const bool plain = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0;
    if (!plain || key.key() == Qt::Key_Escape || key.text().isEmpty()) return false;
    typing_.start();
    return true;
}

bool KeysOfFocus::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Shortcut) {
        auto* action = qobject_cast<QAction*>(watched);
        const QKeySequence keys = static_cast<QShortcutEvent*>(event)->key();
        const int key = keys.count() == 1 ? keys[0] & ~static_cast<int>(Qt::SHIFT) : 0;
        if (action != nullptr && key > Qt::Key_Space && key <= Qt::Key_AsciiTilde) {
            beginText();
            const bool letter = key >= Qt::Key_A && key <= Qt::Key_Z;
            QTimer::singleShot(0, action, [this, action, letter] { noteKey(*action, letter); }); // after it has worked
        }
        if (action == nullptr || !action->text().endsWith(QStringLiteral("…"))) return false;
        // After the command: a dialog that it opened runs by then.
        QTimer::singleShot(0, this, [this] {
            if (QApplication::activeModalWidget() == nullptr && QApplication::activePopupWidget() == nullptr) typing_.start();
        });
        return false;
    }
    if (event->type() == QEvent::MouseButtonPress) typing_.stop();
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto& pressed = static_cast<const QKeyEvent&>(*event);
    const int key = pressed.key();
    if (key == Qt::Key_Escape) typing_.stop();
    if (asksInVain(pressed)) typing_.start();
    if (isTypedForADialog(pressed)) {
        event->accept();
        return true;
    }
    if (leavesUndo(*watched, pressed)) {
        event->ignore();
        return true;
    }
    const bool presses = qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr;
    const bool slides = qobject_cast<QAbstractSlider*>(watched) != nullptr;
    const bool pages =
        slides || qobject_cast<QAbstractSpinBox*>(watched) != nullptr || qobject_cast<QAbstractItemView*>(watched) != nullptr;
    const bool isOwn = (key == Qt::Key_Space && presses) || ((key == Qt::Key_Home || key == Qt::Key_End) && slides) ||
                       ((key == Qt::Key_PageUp || key == Qt::Key_PageDown) && pages);
    if (!isOwn) return false;
    event->accept();
    return true;
}

} // namespace edgescan::ui

#include "moc_commands.cpp"
