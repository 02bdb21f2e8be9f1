// How a file is read: a row per option of the table.
#include "ui/panels/dialogs/reading_dialog.h"

#include "ui/base/core_words.h"
#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr double kMostOfScreen = 0.65; // for the rows; text and buttons are above and below them

QLabel* labelOf(const ReadingOption& option) {
    auto* label = new QLabel(QObject::tr(option.help));
    label->setWordWrap(true);
    label->setMinimumWidth(280);
    return label;
}

} // namespace

ReadingDialog::ReadingDialog(const ReadingOptions& options, QWidget* parent) : QDialog(parent), options_(options), refusal_(new QLabel) {
    setObjectName("reading-dialog");
    setWindowTitle(tr("How the Scan Is Read"));
    auto* column = new QVBoxLayout(this);
    auto* about = new QLabel(tr("An empty field: from the file, or detected. The file itself is not changed."));
    about->setWordWrap(true);
    column->addWidget(about);
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    for (const ReadingOption& option : readingOptionTable()) {
        if ((option.uses & ReadingOption::kFlag) != 0) addField(option, *form);
    }
    QScrollArea* area = scrolled(*fields); // for gloves the rows are higher than a screen
    const int room = QGuiApplication::primaryScreen()->availableGeometry().height();
    area->setMinimumHeight(std::min(fields->sizeHint().height(), static_cast<int>(kMostOfScreen * room)));
    column->addWidget(area, 1);
    refusal_->setObjectName("refusal");
    refusal_->setWordWrap(true);
    refusal_->hide();
    column->addWidget(refusal_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Read Again"));
    connect(buttons, &QDialogButtonBox::accepted, this, &ReadingDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

void ReadingDialog::addField(const ReadingOption& option, QFormLayout& form) {
    const QString now = exactText(option.get(options_));
    if (option.kind == ReadingOption::Kind::Switch) return fields_.push_back({&option, [now] { return now; }}); // in the menu
    if (option.kind == ReadingOption::Kind::Word) {
        auto* choice = new QComboBox;
        choice->addItem(tr("as in the file"), QString());
        for (const std::string& word : option.words) choice->addItem(exactText(word), exactText(word));
        choice->setEditable(option.limit != nullptr); // a number in place of a word
        choice->setInsertPolicy(QComboBox::NoInsert);
        choice->setCurrentIndex(choice->findData(now));
        if (choice->currentIndex() < 0) choice->setEditText(now);
        choice->setObjectName(option.key);
        form.addRow(labelOf(option), choice);
        fields_.push_back({&option, [choice] {
                               const int known = choice->findText(choice->currentText());
                               return known < 0 ? choice->currentText().trimmed() : choice->itemData(known).toString();
                           }});
        return;
    }
    auto* edit = new QLineEdit(now);
    edit->setObjectName(option.key);
    edit->setPlaceholderText(tr("as in the file"));
    fields_.push_back({&option, [edit] { return edit->text().trimmed(); }});
    if (option.kind != ReadingOption::Kind::Path) return form.addRow(labelOf(option), edit);
    auto* row = new QHBoxLayout;
    auto* browse = new QToolButton;
    browse->setText(tr("Choose…"));
    connect(browse, &QToolButton::clicked, this, [this, edit, &option] {
        const QString path = QFileDialog::getOpenFileName(this, QObject::tr(option.help), edit->text());
        if (!path.isEmpty()) edit->setText(path);
    });
    row->addWidget(edit, 1);
    row->addWidget(browse);
    form.addRow(labelOf(option), row);
}

void ReadingDialog::accept() {
    ReadingOptions typed;
    for (const Field& field : fields_) {
        const std::string text = field.text().toStdString();
        if (text.empty()) continue;
        if (const Result<Done> sound = checked(*field.option, text); !sound) {
            refusal_->setText(QString("%1: ").arg(field.option->key) + coreSentence(sound.error().sentence()));
            refusal_->show();
            return;
        }
        field.option->set(typed, text);
    }
    options_ = typed;
    QDialog::accept();
}

} // namespace edgescan::ui

#include "moc_reading_dialog.cpp"
