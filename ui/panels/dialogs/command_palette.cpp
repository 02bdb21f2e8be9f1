// The list of commands, filtered by the typed words.
#include "ui/panels/dialogs/command_palette.h"

#include <QAction>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

QString plain(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

// "Measure > Distance": the menu separates commands with the same name.
QString nameOf(const QAction& action) {
    for (const QObject* holder : action.parent() != nullptr ? QList<QObject*>{action.parent()} : QList<QObject*>{}) {
        if (const auto* menu = qobject_cast<const QMenu*>(holder); menu != nullptr && !menu->title().isEmpty())
            return plain(menu->title()) + " > " + plain(action.text());
    }
    return plain(action.text());
}

bool holdsAll(const QString& name, const QString& typed) {
    const QStringList words = typed.simplified().split(' ');
    return std::all_of(words.begin(), words.end(), [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
}

} // namespace

CommandPalette::CommandPalette(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent), words_(new QLineEdit), list_(new QListWidget),
      none_(new QLabel(tr("No command has these words, or it cannot be used now."), list_)) {
    setObjectName("command-palette");
    setWindowTitle(tr("Commands"));
    for (QAction* action : actions) {
        if (!action->isSeparator() && !action->text().isEmpty()) actions_ << action;
    }
    words_->setObjectName("palette-words");
    words_->setPlaceholderText(tr("A few letters of a command"));
    words_->installEventFilter(this);
    list_->setFocusPolicy(Qt::NoFocus); // arrow keys in the text field move the selection
    none_->setObjectName("palette-none");
    none_->setWordWrap(true);
    none_->setAlignment(Qt::AlignCenter);
    auto* over = new QVBoxLayout(list_->viewport());
    over->addWidget(none_);
    auto* column = new QVBoxLayout(this);
    column->addWidget(words_);
    column->addWidget(list_);
    auto* close = new QPushButton(tr("Close")); // a cab has no Escape key
    close->setObjectName("palette-close");
    close->setAutoDefault(false); // Return runs the command
    column->addWidget(close, 0, Qt::AlignRight);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    resize(520, 420);
    connect(words_, &QLineEdit::textChanged, this, &CommandPalette::find);
    connect(words_, &QLineEdit::returnPressed, this, &CommandPalette::chooseCurrent);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::chooseCurrent);
    find();
}

/// Commands that are disabled now are not listed.
void CommandPalette::find() {
    list_->clear();
    for (int n = 0; n < actions_.size(); ++n) {
        const QAction& action = *actions_[n];
        const QString name = nameOf(action);
        if (!action.isEnabled() || !holdsAll(name + ' ' + action.whatsThis(), words_->text())) continue;
        const QString keys = action.shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(keys.isEmpty() ? name : name + "   " + keys, list_);
        item->setData(Qt::UserRole, n);
    }
    list_->setCurrentRow(list_->count() > 0 ? 0 : -1);
    none_->setVisible(list_->count() == 0);
}

void CommandPalette::chooseCurrent() {
    if (list_->currentItem() == nullptr) return;
    chosen_ = actions_[list_->currentItem()->data(Qt::UserRole).toInt()];
    accept();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0 && list_->count() > 0) {
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void runFromPalette(QWidget* parent, const QList<QAction*>& actions) {
    CommandPalette palette(actions, parent);
    if (palette.exec() == QDialog::Accepted && palette.chosen() != nullptr) palette.chosen()->trigger();
}

} // namespace edgescan::ui

#include "moc_command_palette.cpp"
