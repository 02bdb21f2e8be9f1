// Two pages of rows, one per field of the core's tables.
#include "ui/panels/dialogs/place_dialog.h"

#include "ui/base/elided_label.h"
#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/base/window_room.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShowEvent>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <string_view>

namespace edgescan::ui {
namespace {

constexpr int kDialogWide = 78;  // letters
constexpr int kDialogHigh = 600; // px
// E, N and RL in a row: the fields of a pose are in sight above keys on the screen.
constexpr int kPoseColumns = 3, kMountingColumns = 2;

/// The words of pose and mounting files, and how the lists show them.
struct ShownWord {
    std::string_view word;
    const char* shown;
};
constexpr std::array<ShownWord, 11> kShownWords{{
    {"grid", QT_TRANSLATE_NOOP("QObject", "grid north")},
    {"true", QT_TRANSLATE_NOOP("QObject", "true north")},
    {"vertical", QT_TRANSLATE_NOOP("QObject", "the vertical")},
    {"robot_z", QT_TRANSLATE_NOOP("QObject", "the robot's z axis")},
    {"forward", QT_TRANSLATE_NOOP("QObject", "forward")},
    {"up", QT_TRANSLATE_NOOP("QObject", "up")},
    {"down", QT_TRANSLATE_NOOP("QObject", "down")},
    {"rpy", QT_TRANSLATE_NOOP("QObject", "by three angles")},
    {"matrix", QT_TRANSLATE_NOOP("QObject", "by nine numbers")},
    {"elevations", QT_TRANSLATE_NOOP("QObject", "two elevations")},
    {"pitch_roll", QT_TRANSLATE_NOOP("QObject", "pitch and roll")},
}};

QString shownWord(const std::string& word) {
    const auto found = std::ranges::find(kShownWords, std::string_view(word), &ShownWord::word);
    return found == kShownWords.end() ? exactText(word) : QObject::tr(found->shown);
}

QLabel* wrappedLabel(const QString& text = {}) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

bool anyFault(const PlaceTexts& faults) {
    return std::ranges::any_of(faults, [](const std::string& fault) { return !fault.empty(); });
}

} // namespace

PlaceDialog::PlaceDialog(QWidget* parent) : QDialog(parent), tabs_(new QTabWidget), state_(wrappedLabel()) {
    setObjectName("place-dialog");
    setWindowTitle(tr("Pose and Mounting"));
    const QSize room = roomForDialog(*this);
    low_ = room.height() < kDialogHigh;
    tabs_->setObjectName("place-tabs");
    tabs_->setUsesScrollButtons(false);               // both fit
    tabs_->addTab(scrolled(*posePage()), tr("Pose")); // also on a low screen the buttons below are in sight
    tabs_->addTab(scrolled(*mountingPage()), tr("Mounting"));
    state_->setObjectName("place-state");
    state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    if (!low_) state_->setMinimumHeight(3 * state_->fontMetrics().lineSpacing()); // the fields do not move while numbers are typed
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    keep_ = buttons->addButton(tr("&Store with the Scan"), QDialogButtonBox::AcceptRole);
    remove_ = buttons->addButton(tr("&Remove Pose"), QDialogButtonBox::DestructiveRole);
    keep_->setObjectName("place-keep");
    remove_->setObjectName("place-remove");
    connect(keep_, &QPushButton::clicked, this, &PlaceDialog::keepRequested);
    connect(remove_, &QPushButton::clicked, this, &PlaceDialog::removeRequested);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(tabs_, 1);
    column->addWidget(state_);
    if (low_)
        tabs_->setCornerWidget(buttons); // keys on the screen have no room below them
    else
        column->addWidget(buttons);
    resize(QSize(low_ ? room.width() : kDialogWide * fontMetrics().averageCharWidth(), kDialogHigh).boundedTo(room));
    showState({}, false);
}

QWidget* PlaceDialog::posePage() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    line_ = new QLineEdit;
    line_->setObjectName("survey-line");
    line_->setPlaceholderText("P7; 498765.432; 5150123.456; 287.654");
    order_ = new QComboBox;
    order_->setObjectName("survey-order");
    order_->addItems({"E, N, RL", "N, E, RL"});
    auto* useLine = new QPushButton(tr("&Fill In"));
    useLine->setObjectName("survey-take");
    useLine->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addWidget(order_);
    row->addWidget(useLine);
    row->addStretch(1);
    const auto emitLine = [this] { emit surveyLineTyped(line_->text(), order_->currentIndex() == 1); };
    connect(useLine, &QPushButton::clicked, this, emitLine);
    connect(line_, &QLineEdit::returnPressed, this, emitLine);
    auto* fields = new QGridLayout;
    for (const PlaceField& field : poseFields()) addField(*fields, kPoseColumns, field, pose_);
    column->addLayout(fields);
    column->addWidget(
        wrappedLabel(tr("A line of the survey: point, E, N, RL, and heading, pitch and roll if it has them. E is easting, N northing, RL "
                        "the height above the mine's zero: a higher place has a larger RL.")));
    column->addWidget(line_); // alone: its example is read whole
    column->addLayout(row);
    column->addStretch(1);
    return page;
}

QWidget* PlaceDialog::mountingPage() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->addWidget(
        wrappedLabel(tr("How the scanner is mounted, under a name for the next scan. An empty field has the value shown in it.")));
    scanner_ = new QComboBox;
    scanner_->setObjectName("scanner-names");
    auto* keep = new QPushButton(tr("Store &As…"));
    forget_ = new QPushButton(tr("For&get"));
    auto* file = new QPushButton(tr("From Fi&le…"));
    keep->setObjectName("scanner-keep");
    forget_->setObjectName("scanner-forget");
    file->setObjectName("scanner-file");
    column->addWidget(scanner_);
    auto* row = new QHBoxLayout;
    for (QPushButton* each : {keep, forget_, file}) {
        each->setAutoDefault(false);
        row->addWidget(each);
    }
    row->addStretch(1);
    column->addLayout(row);
    connect(scanner_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int index) { emit scannerChosen(scanner_->itemData(index).toString()); });
    connect(keep, &QPushButton::clicked, this, &PlaceDialog::scannerKept);
    connect(forget_, &QPushButton::clicked, this, [this] { emit scannerForgotten(scanner_->currentData().toString()); });
    connect(file, &QPushButton::clicked, this, &PlaceDialog::fileRequested);
    auto* fields = new QGridLayout;
    for (const PlaceField& field : mountingFields()) addField(*fields, kMountingColumns, field, mounting_);
    column->addLayout(fields);
    column->addStretch(1);
    return page;
}

/// In the next place of the grid: its name, the field, and one line for its fault.
void PlaceDialog::addField(QGridLayout& grid, int columns, const PlaceField& field, std::vector<Row>& rows) {
    auto* label = wrappedLabel(QObject::tr(field.label));
    label->setAlignment(Qt::AlignLeft | Qt::AlignBottom); // next to the field, where others in the row have more lines
    auto* fault = new ElidedLabel; // in one line, whose place is there before: no field moves while numbers are typed
    fault->setFixedHeight(fault->fontMetrics().height());
    QSizePolicy stays = fault->sizePolicy();
    stays.setRetainSizeWhenHidden(true);
    fault->setSizePolicy(stays);
    fault->setObjectName(QString("fault-%1-%2").arg(field.group, field.key));
    followColours(*fault, [fault](const Theme& theme) {
        QPalette palette = fault->palette();
        palette.setColor(QPalette::WindowText, theme.bad);
        fault->setPalette(palette);
    });
    fault->hide();
    Row row{{}, {}, fault, nullptr, {}};
    QWidget* cell = nullptr;
    const auto noteTyped = [this] {
        if (showing_) return;
        typed_ = true;
        emit changed();
    };
    const QString name = QString("%1-%2").arg(field.group, field.key);
    if (field.kind == PlaceField::Kind::Word) {
        auto* choice = new QComboBox;
        choice->setObjectName(name);
        for (const std::string& word : field.words) choice->addItem(shownWord(word), exactText(word));
        connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, noteTyped);
        row.text = [choice] { return choice->currentData().toString(); };
        row.show = [choice, usual = QString(field.usual)](const QString& text) {
            if (const int at = choice->findData(text.isEmpty() ? usual : text); at >= 0) choice->setCurrentIndex(at);
        };
        cell = choice;
        label->setBuddy(choice);
    } else {
        auto* edit = new QLineEdit;
        edit->setObjectName(name);
        row.edit = edit;
        row.usual = field.usual != nullptr ? QString(field.usual) : QString();
        if (field.kind != PlaceField::Kind::Text) edit->setInputMethodHints(Qt::ImhPreferNumbers);
        edit->setPlaceholderText(row.usual);
        connect(edit, &QLineEdit::textChanged, this, noteTyped);
        row.text = [edit] { return edit->text(); };
        row.show = [edit](const QString& text) { edit->setText(text); };
        cell = edit;
        label->setBuddy(edit);
    }
    const int at = static_cast<int>(rows.size()), top = at / columns * 3, left = at % columns;
    grid.setVerticalSpacing(1); // the lines of the faults keep the fields apart
    grid.addWidget(label, top, left);
    grid.addWidget(cell, top + 1, left);
    grid.addWidget(fault, top + 2, left);
    grid.setColumnStretch(left, 1);
    rows.push_back(std::move(row));
}

void PlaceDialog::showTexts(const std::vector<Row>& rows, const PlaceTexts& texts) {
    showing_ = true;
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n].show(exactText(texts[n]));
    showing_ = false;
    emit changed();
}

/// Each time at its top, without the field that was typed in last.
void PlaceDialog::showEvent(QShowEvent* event) {
    if (QWidget* last = focusWidget(); last != nullptr && !event->spontaneous()) last->clearFocus();
    for (auto* area : findChildren<QScrollArea*>()) {
        if (!event->spontaneous()) area->verticalScrollBar()->setValue(0);
    }
    QDialog::showEvent(event);
}

/// What is typed before a field was chosen goes into the first one.
void PlaceDialog::keyPressEvent(QKeyEvent* event) {
    const bool isText = !event->text().isEmpty() && event->text()[0].isPrint() && event->modifiers() == Qt::NoModifier;
    QLineEdit* first = pose_.front().edit;
    if (!isText || !first->isVisible() || !first->text().isEmpty()) return QDialog::keyPressEvent(event);
    first->setFocus();
    first->insert(event->text());
}

void PlaceDialog::showPose(const PlaceTexts& texts) {
    typed_ = std::ranges::any_of(texts, [](const std::string& text) { return !text.empty(); });
    showTexts(pose_, texts);
}
void PlaceDialog::showMounting(const PlaceTexts& texts) { showTexts(mounting_, texts); }

namespace {

template <class Rows>
PlaceTexts textsOf(const Rows& rows) {
    PlaceTexts texts;
    for (const auto& row : rows) texts.push_back(exactBytes(row.text()));
    return texts;
}

} // namespace

PlaceTexts PlaceDialog::poseTexts() const { return textsOf(pose_); }
PlaceTexts PlaceDialog::mountingTexts() const { return textsOf(mounting_); }

void PlaceDialog::showFaults(const TypedPlace& typed) {
    const auto show = [](const std::vector<Row>& rows, const PlaceTexts& faults) {
        for (std::size_t n = 0; n < rows.size(); ++n) {
            const Row& row = rows[n];
            const QString fault = shownText(faults[n]);
            row.fault->setText(fault);
            row.fault->setToolTip(fault);
            if (row.edit != nullptr) row.edit->setPlaceholderText(fault.isEmpty() ? row.usual : tr("✕ missing"));
            const bool ofText = !fault.isEmpty() && (row.edit == nullptr || !row.edit->text().isEmpty()); // else the field says it
            row.fault->setVisible(ofText);
        }
    };
    const PlaceTexts none(typed.poseFaults.size()); // what was not typed yet is not wrong
    const PlaceTexts& poseFaults = typed_ ? typed.poseFaults : none;
    show(pose_, poseFaults);
    show(mounting_, typed.mountFaults);
    tabs_->setTabText(0, (anyFault(poseFaults) ? "✕ " : "") + tr("Pose"));
    tabs_->setTabText(1, (anyFault(typed.mountFaults) ? "✕ " : "") + tr("Mounting"));
    if (!typed.isSound()) showState(shownText(typed.fault), false);
}

void PlaceDialog::showState(const QString& words, bool ready) {
    state_->setText(words);
    state_->setVisible(!low_ || !words.isEmpty());
    keep_->setEnabled(ready);
    if (!low_ || focusWidget() == nullptr) return;
    layout()->activate(); // the fields have less room then: the one that is typed in stays in sight
    scrollTo(*focusWidget());
}

void PlaceDialog::showComputing() {
    const QString older = QStringLiteral("… ");
    if (!state_->text().isEmpty() && !state_->text().startsWith(older)) state_->setText(older + state_->text());
}

void PlaceDialog::showScanners(const QStringList& names, const QString& inUse) {
    scanner_->clear();
    scanner_->addItem(tr("Nominal mounting"), QString());
    for (const QString& name : names) scanner_->addItem(shownName(name), name);
    scanner_->setCurrentIndex(std::max(0, scanner_->findData(inUse)));
    forget_->setEnabled(scanner_->currentIndex() > 0);
}

void PlaceDialog::setRemovable(bool on) { remove_->setEnabled(on); }

QString PlaceDialog::stateText() const { return state_->text(); }

} // namespace edgescan::ui

#include "moc_place_dialog.cpp"
