// Large numbers and steppers.
#include "ui/panels/cab/numbers_side.h"

#include "core/edges/settings/parameters.h"
#include "ui/base/flow_layout.h"
#include "ui/base/icons.h"
#include "ui/base/themes.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/cab/gloves.h"
#include "ui/panels/tuning/parameter_row.h"

#include <QEvent>
#include <QFontMetrics>
#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kNumberPx = 42, kLowNumberPx = 32, kCoordinatePx = 25, kTextPx = 19, kNotePx = 17, kLeastNotePx = 15;
constexpr int kLeastScrolled = 90;
constexpr int kPageHigh = 48; // px: of the button that turns the page
constexpr int kAroundPose = 14;
constexpr int kLockPx = 16;
constexpr int kTuneSign = 28, kLowTuneSign = 16; // px: of Tune, the lower one above two lines
constexpr int kLowestPx = 480;                   // a lower side has no stepper next to the numbers: Tune has it
constexpr int kLowPx = 720;                      // a lower side, as of a screen of 768, has smaller letters, so that all rows are seen

QScrollArea* scrolledColumn(QWidget* content, Qt::ScrollBarPolicy bar) {
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBarPolicy(bar);
    scroll->setMinimumHeight(kLeastScrolled); // the large arrows of its bar would ask for more than a screen of 480 has
    scroll->setWidget(content);
    return scroll;
}

QToolButton* arrow(const char* name, const char* sign, const QString& words) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setIcon(toolIcon(sign));
    button->setIconSize({28, 28});
    button->setFixedSize(56, 56);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(words);
    return button;
}

} // namespace

NumbersSide::NumbersSide(const std::vector<ParameterRow*>& settings, QWidget* parent)
    : QWidget(parent), pages_(new QStackedWidget), previous_(arrow("cab-previous", "previous", tr("Previous target or measurement"))),
      next_(arrow("cab-next", "next", tr("Next target or measurement"))), title_(new QLabel), lock_(new QLabel),
      facts_(new FactList("cab-")), below_(new QWidget), page_(new QToolButton), main_(new Stepper(*settings.front())),
      foot_(new QGridLayout) {
    main_->setObjectName("cab-main-stepper");
    title_->setObjectName("cab-target");
    title_->setTextFormat(Qt::PlainText);
    title_->setWordWrap(true);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold); // fitTitle() sizes it
    title_->setAlignment(Qt::AlignCenter);
    title_->installEventFilter(this);
    lock_->setObjectName("cab-locked");
    followColours(*lock_, [this](const Theme&) { lock_->setPixmap(toolIcon("lock").pixmap(kLockPx, kLockPx)); });
    auto* head = new QHBoxLayout;
    head->addWidget(previous_);
    head->addWidget(title_, 1);
    head->addWidget(lock_);
    head->addWidget(next_);
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(head);
    facts_->setObjectName("cab-rows");
    facts_->installEventFilter(this);
    scroll_ = scrolledColumn(facts_, Qt::ScrollBarAlwaysOff);
    scroll_->setProperty(kPaged, true);
    column->addWidget(scroll_, 1);
    for (QWidget* each : {below_, static_cast<QWidget*>(page_)}) each->setParent(scroll_);
    below_->setAutoFillBackground(true);
    below_->setObjectName("cab-below");
    page_->setObjectName("cab-page");
    page_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    page_->setFocusPolicy(Qt::TabFocus);
    page_->hide();
    connect(page_, &QToolButton::clicked, this, [this] {
        fitPages();
        shownPage_ = (shownPage_ + 1) % (starts_.size() + 1);
        showPage();
    });
    column->addWidget(main_);
    pages_->addWidget(numbers);
    pages_->addWidget(scrolledColumn(makeSettings(settings), Qt::ScrollBarAsNeeded));
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(12, 8, 8, 8);
    all->setSpacing(8);
    all->addWidget(pages_, 1);
    all->addLayout(foot_);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    connect(previous_, &QToolButton::clicked, this, [this] { emit entryStepRequested(-1); });
    connect(next_, &QToolButton::clicked, this, [this] { emit entryStepRequested(+1); });
    show({});
}

/// The thresholds first.
QWidget* NumbersSide::makeSettings(const std::vector<ParameterRow*>& settings) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    settingsHead_ = new FlowLayout;
    column->addLayout(settingsHead_);
    auto rows = settings;
    std::ranges::stable_partition(rows, [](const ParameterRow* row) { return row->parameter().feeds == edges::Stage::Threshold; });
    for (ParameterRow* row : rows) {
        Stepper* stepper = steppers_.emplace_back(new Stepper(*row, content));
        stepper->setObjectName(QString("step-") + row->parameter().key);
        stepper->setHidden(!row->visible());
        connect(row, &ParameterRow::shown, stepper, [this, stepper, row] {
            stepper->setHidden(!row->visible());
            showValueInTune();
        });
        column->addWidget(stepper);
    }
    column->addStretch(1);
    return content;
}

void NumbersSide::show(const SideFacts& facts) {
    if (titleWords_.section('\n', 0, 0) != facts.title.section('\n', 0, 0)) shownPage_ = 0;
    titleWords_ = facts.title;
    for (QToolButton* each : {previous_, next_}) each->setEnabled(facts.arrows);
    lock_->setVisible(facts.locked);
    title_->setAccessibleName(facts.locked ? titleWords_ + " · " + tr("locked") : titleWords_);
    fitTitle();
    facts_->show(facts.rows);
    fitHeight();
    QMetaObject::invokeMethod(this, &NumbersSide::fitPages, Qt::QueuedConnection); // after the rows have their widths
}

bool NumbersSide::eventFilter(QObject* watched, QEvent* event) {
    if (watched == title_ && event->type() == QEvent::MouseButtonRelease) emit titleTapped();
    QRect pose;
    for (const FactRow* each : facts_->rows()) pose |= each->fact().underlined ? each->geometry() : QRect();
    // The line is lower than a finger.
    if (watched == facts_ && event->type() == QEvent::MouseButtonRelease && !pose.isEmpty() &&
        pose.adjusted(0, -kAroundPose, 0, kAroundPose).contains(static_cast<QMouseEvent*>(event)->pos()))
        emit poseRequested();
    return QWidget::eventFilter(watched, event);
}

/// Smaller letters, if a line, or at least a word, is wider than the room between the arrows; a name that is still wider breaks anywhere.
void NumbersSide::fitTitle() {
    QFont letters = title_->font();
    letters.setPixelSize(kTextPx);
    const int room = title_->contentsRect().width();
    static const QRegularExpression between("\\s+"), anywhere("(?<=\\S)(?=\\S)");
    QString shown = titleWords_;
    const auto isWide = [&](const QString& line) { return QFontMetrics(letters).horizontalAdvance(line) > room; };
    const QStringList lines = titleWords_.split('\n');
    while (letters.pixelSize() > kLeastNotePx && std::ranges::any_of(lines, isWide)) letters.setPixelSize(letters.pixelSize() - 1);
    if (std::ranges::any_of(lines, isWide)) letters.setPixelSize(kTextPx); // they need more lines anyway
    for (const QString& word : titleWords_.split(between)) {
        while (letters.pixelSize() > kLeastNotePx - 2 && QFontMetrics(letters).horizontalAdvance(word) > room)
            letters.setPixelSize(letters.pixelSize() - 1);
        if (QFontMetrics(letters).horizontalAdvance(word) > room) shown.replace(word, QString(word).replace(anywhere, QChar(0x200B)));
    }
    title_->setText(shown);
    if (letters.pixelSize() != title_->font().pixelSize()) title_->setFont(letters);
}

void NumbersSide::fitHeight() {
    facts_->layout()->setContentsMargins(0, 0, 0, 0); // without the rest of the last page
    const bool low = height() < kLowPx;
    // The part of it that is in the window: with the stepper it would not become lower than the stepper needs.
    const int seen = std::min(height(), window()->height() - mapTo(window(), QPoint()).y());
    const bool lowest = seen < kLowestPx;
    for (FactRow* each : facts_->rows()) {
        using Look = FactRow::Look;
        const Look look = each->look();
        const int note = (look == Look::Line && low) || (look == Look::Warning && lowest) ? kLeastNotePx : kNotePx;
        const int number = lowest ? kLowNumberPx : kNumberPx, coordinate = low ? kTextPx : kCoordinatePx;
        each->setLetters(look == Look::Line ? note : kNotePx, look == Look::Number ? number : look == Look::Short ? coordinate : note);
    }
    const bool held = main_->less()->isDown() || main_->more()->isDown();
    main_->setVisible(seen >= kLowestPx && (held || factsFitAbove(main_->sizeHint().height())));
    showValueInTune();
    fitPages();
}

/// If the stepper does not fit, the button Tune has its value.
void NumbersSide::showValueInTune() {
    if (tune_ == nullptr) return;
    const bool hidden = !tuning() && !main_->isVisibleTo(this);
    tune_->setText(hidden ? tuneWord_ + '\n' + main_->value() : tuneWord_);
    tune_->setIconSize(hidden ? QSize(kLowTuneSign, kLowTuneSign) : QSize(kTuneSign, kTuneSign));
}

/// The facts of what is chosen are seen whole; Tune has the stepper too.
bool NumbersSide::factsFitAbove(int stepperHigh) const {
    if (tuning() || !isVisible()) return true; // not laid out
    QLayout& page = *pages_->widget(0)->layout();
    page.activate();
    const int above = scroll_->y(), room = pages_->height() - above - page.spacing() - stepperHigh;
    const QLayout& facts = *facts_->layout();
    return facts.heightForWidth(scroll_->width()) <= room;
}

void NumbersSide::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    pages_->widget(0)->layout()->activate(); // that of the title
    fitTitle();
    fitHeight();
}

void NumbersSide::showMain(ParameterRow& row, const QString& found) {
    main_->follow(row);
    main_->showFound(found);
    for (Stepper* each : steppers_) each->showFound(&each->row() == &row ? found : QString());
    fitHeight();
}

Stepper* NumbersSide::stepper(const QString& key) const {
    const auto found = std::ranges::find_if(steppers_, [&key](const Stepper* each) { return key == each->row().parameter().key; });
    return found == steppers_.end() ? nullptr : *found;
}

void NumbersSide::setTuning(bool on) {
    pages_->setCurrentIndex(on ? 1 : 0);
    fitHeight();
}
bool NumbersSide::tuning() const { return pages_->currentIndex() == 1; }

QString NumbersSide::shown(const char* key) const {
    const auto found = std::ranges::find_if(facts_->rows(), [key](const FactRow* each) { return QLatin1String(key) == each->fact().key; });
    return found == facts_->rows().end() ? QString() : (*found)->value().text();
}

void NumbersSide::addButton(QToolButton* button) {
    foot_->addWidget(button, 0, buttons_);
    ++buttons_;
}

void NumbersSide::addTune(QToolButton* button) {
    tune_ = button;
    tuneWord_ = button->text();
    connect(button, &QToolButton::clicked, this, &NumbersSide::setTuning);
    addButton(button);
}

void NumbersSide::addSettingsButton(QToolButton* button) { settingsHead_->addWidget(button); }

/// Where the pages after the first one begin: what belongs together is on one page, but for lines of warnings.
std::vector<int> NumbersSide::pageStarts(int room, int high) const {
    using Look = FactRow::Look;
    std::vector<int> tops;
    Look before = Look::Words;
    for (const FactRow* each : facts_->rows()) {
        const Look look = each->look();
        const int line = each->value().fontMetrics().lineSpacing(), lines = look == Look::Warning ? std::max(1, each->height() / line) : 1;
        for (int n = 0; n < lines; ++n) {
            if (look != Look::Short || before != Look::Short) tops.push_back(each->y() + n * line); // a place is whole
        }
        before = look;
    }
    std::vector<int> starts;
    for (std::size_t n = 0; n < tops.size(); ++n) {
        const int end = n + 1 < tops.size() ? tops[n + 1] : high, start = starts.empty() ? 0 : starts.back();
        if (end - start > room && tops[n] > start) starts.push_back(tops[n]);
    }
    return starts;
}

/// Where the facts have no room, they have pages of whole rows, and a button for the next one.
void NumbersSide::fitPages() {
    pages_->widget(0)->layout()->activate();
    facts_->layout()->setContentsMargins(0, 0, 0, 0);
    const QSize room = scroll_->viewport()->size();
    factsHigh_ = facts_->layout()->heightForWidth(room.width());
    starts_.clear();
    if (factsHigh_ > room.height() && isVisible()) {
        facts_->resize(room.width(), factsHigh_);
        facts_->layout()->activate();
        starts_ = pageStarts(room.height() - kPageHigh, factsHigh_);
        const int last = starts_.empty() ? 0 : starts_.back();
        facts_->layout()->setContentsMargins(0, 0, 0, std::max(0, last + room.height() - factsHigh_));
        facts_->resize(room.width(), std::max(factsHigh_, last + room.height()));
    }
    shownPage_ = std::min(shownPage_, starts_.size());
    showPage();
}

void NumbersSide::showPage() {
    facts_->layout()->activate();
    const bool last = shownPage_ == starts_.size();
    page_->setVisible(!starts_.empty());
    page_->setText(last ? "▲ " + tr("Back") : "▼ " + tr("More"));
    const QSize room = scroll_->viewport()->size();
    const int start = shownPage_ == 0 ? 0 : starts_[shownPage_ - 1], end = last ? factsHigh_ : starts_[shownPage_];
    const int from = std::min(room.height() - kPageHigh, end - start);
    below_->setVisible(!starts_.empty());
    below_->setGeometry(0, from, room.width(), room.height() - from);
    page_->setGeometry(0, room.height() - kPageHigh, room.width(), kPageHigh);
    scroll_->verticalScrollBar()->setValue(start);
}

} // namespace edgescan::ui

#include "moc_numbers_side.cpp"
