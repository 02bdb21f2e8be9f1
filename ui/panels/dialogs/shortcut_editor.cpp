// The table of shortcuts.
#include "ui/panels/dialogs/shortcut_editor.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {

ShortcutEditor::ShortcutEditor(std::vector<ShortcutRow> rows, std::function<void()> resetAll, QWidget* parent)
    : QDialog(parent), rows_(std::move(rows)), words_(new QLineEdit), table_(new QTableWidget(static_cast<int>(rows_.size()), 2)),
      key_(new QKeySequenceEdit), none_(new QPushButton(tr("&No Key"))), reset_(new QPushButton(tr("&Reset"))), message_(new QLabel) {
    setObjectName("shortcut-editor");
    setWindowTitle(tr("Change Keys"));
    words_->setObjectName("shortcut-words");
    words_->setPlaceholderText(tr("A few letters of a command, or a key"));
    key_->setObjectName("shortcut-key");
    none_->setObjectName("shortcut-none");
    reset_->setObjectName("shortcut-reset");
    message_->setObjectName("shortcut-said");
    message_->setWordWrap(true);
    message_->setTextFormat(Qt::PlainText);
    table_->setObjectName("shortcut-table");
    table_->setHorizontalHeaderLabels({tr("Command"), tr("Key")});
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    for (int n = 0; n < table_->rowCount(); ++n) {
        table_->setItem(n, 0, new QTableWidgetItem(rows_[static_cast<std::size_t>(n)].name));
        table_->setItem(n, 1, new QTableWidgetItem);
    }
    auto* all = new QPushButton(tr("Reset &All"));
    all->setObjectName("shortcut-reset-all");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    for (QPushButton* each : {none_, reset_, all}) each->setAutoDefault(false); // here Return is a shortcut like other keys
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    auto* line = new QHBoxLayout;
    line->addWidget(new QLabel(tr("Press the new key:")));
    line->addWidget(key_, 1);
    line->addWidget(none_);
    line->addWidget(reset_);
    line->addWidget(all);
    auto* column = new QVBoxLayout(this);
    column->addWidget(words_);
    column->addWidget(table_, 1);
    column->addLayout(line);
    column->addWidget(message_);
    column->addWidget(buttons);
    resize(620, 560);
    connect(words_, &QLineEdit::textChanged, this, &ShortcutEditor::find);
    connect(table_, &QTableWidget::currentCellChanged, this, [this] { key_->clear(); });
    connect(key_, &QKeySequenceEdit::editingFinished, this, &ShortcutEditor::takeKey);
    connect(none_, &QPushButton::clicked, this, [this] {
        if (ShortcutRow* row = current()) say(row->change(QKeySequence()), tr("%1 has no key now.").arg(row->name));
    });
    connect(reset_, &QPushButton::clicked, this, [this] {
        if (ShortcutRow* row = current()) say(row->reset(), tr("%1 has its original key again.").arg(row->name));
    });
    connect(all, &QPushButton::clicked, this, [this, resetAll] {
        resetAll();
        say(QString(), tr("Every command has its original key again."));
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showAll();
    table_->setCurrentCell(0, 0);
}

ShortcutRow* ShortcutEditor::current() {
    const int row = table_->currentRow();
    return row < 0 || table_->isRowHidden(row) ? nullptr : &rows_[static_cast<std::size_t>(row)];
}

/// One key, not a sequence of keys.
void ShortcutEditor::takeKey() {
    const QKeySequence typed = key_->keySequence();
    ShortcutRow* row = current();
    if (typed.isEmpty() || row == nullptr) return;
    const QKeySequence key(typed[0]);
    key_->clear();
    say(row->change(key), tr("%1: %2").arg(row->name, key.toString(QKeySequence::NativeText)));
}

void ShortcutEditor::say(const QString& refusal, const QString& done) {
    message_->setText(refusal.isEmpty() ? "✓ " + done : "▲ " + refusal);
    showAll();
}

QString ShortcutEditor::message() const { return message_->text(); }

void ShortcutEditor::showAll() {
    for (int n = 0; n < table_->rowCount(); ++n) show(n);
}

// A changed shortcut has a mark, so that colour is not the only sign.
void ShortcutEditor::show(int n) {
    const ShortcutRow& row = rows_[static_cast<std::size_t>(n)];
    const bool usual = row.isUsual();
    table_->item(n, 1)->setText(usual ? row.keys() : tr("%1 • changed").arg(row.keys()));
}

void ShortcutEditor::find() {
    const QStringList typed = words_->text().simplified().split(' ');
    int first = -1;
    for (int n = 0; n < table_->rowCount(); ++n) {
        const QString all = table_->item(n, 0)->text() + " " + table_->item(n, 1)->text();
        const bool holds =
            std::all_of(typed.begin(), typed.end(), [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
        table_->setRowHidden(n, !holds);
        if (holds && first < 0) first = n;
    }
    if (first >= 0 && current() == nullptr) table_->setCurrentCell(first, 0);
}

} // namespace edgescan::ui

#include "moc_shortcut_editor.cpp"
