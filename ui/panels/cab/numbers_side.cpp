// Large numbers and steppers.
#include "ui/panels/cab/numbers_side.h"

#include "ui/base/count_text.h"
#include "ui/base/flow_layout.h"
#include "ui/base/icons.h"
#include "ui/base/themes.h"
#include "ui/panels/cab/fitted_label.h"
#include "ui/panels/cab/stepper.h"
#include "ui/panels/cab/swipes.h"

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
constexpr int kAroundPose = 14;
constexpr int kLockPx = 16, kBeforeLock = 4;
constexpr int kSign = 28, kLowSign = 16; // px: of Tune, the lower one above two lines
constexpr int kLowestPx = 480;           // a lower side has no stepper next to the numbers: Tune has it
constexpr int kLowPx = 720;              // a lower side, as of a screen of 768, has smaller letters, so that all rows are seen

/// What is tapped is underlined.
void underline(QLabel& label, bool on) {
    QFont letters = label.font();
    letters.setUnderline(on);
    label.setFont(letters);
}

QLabel* label(const char* name, int px, bool bold) {
    auto* made = new QLabel;
    made->setObjectName(name);
    QFont letters = made->font();
    letters.setPixelSize(px);
    letters.setBold(bold);
    made->setFont(letters);
    made->setTextFormat(Qt::PlainText);
    return made;
}

FittedLabel* fitted(const char* name, int px) {
    auto* made = new FittedLabel(px, kTextPx);
    made->setObjectName(name);
    return made;
}

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

NumbersSide::NumbersSide(QWidget* parent)
    : QWidget(parent), pages_(new QStackedWidget), previous_(arrow("cab-previous", "previous", tr("Previous target or measurement"))),
      next_(arrow("cab-next", "next", tr("Next target or measurement"))), title_(label("cab-target", kTextPx, true)),
      lock_(new QLabel(title_)), hint_(label("cab-hint", kTextPx, false)), facts_(new QWidget),
      distance_(fitted("cab-distance", kNumberPx)), tolerance_(label("cab-tolerance", kNotePx, false)),
      rock_(label("cab-rock", kNotePx, false)), sizeTolerance_(label("cab-size-tolerance", kNotePx, false)), rockHead_(new QWidget),
      size_(fitted("cab-size", kNumberPx)), sizeRemark_(label("cab-size-remark", kNotePx, false)), pose_(label("cab-pose", kNotePx, false)),
      warned_(label("cab-warned", kNotePx, false)), coordinates_(new QGridLayout), rows_(new QGridLayout), below_(new QWidget),
      page_(new QToolButton), main_(new Stepper(QString())), foot_(new QGridLayout) {
    for (QLabel* each : {title_, hint_, tolerance_, rock_, sizeRemark_, pose_, warned_}) each->setWordWrap(true);
    main_->setObjectName("cab-main-stepper");
    title_->setAlignment(Qt::AlignCenter);
    title_->installEventFilter(this);
    lock_->setObjectName("cab-locked");
    lock_->setAttribute(Qt::WA_TransparentForMouseEvents);
    followColours(*lock_, [this](const Theme&) { lock_->setPixmap(toolIcon("lock").pixmap(kLockPx, kLockPx)); });
    auto* head = new QHBoxLayout;
    head->addWidget(previous_);
    head->addWidget(title_, 1);
    head->addWidget(next_);
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(head);
    scroll_ = scrolledColumn(makeNumbers(), Qt::ScrollBarAlwaysOff);
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
    pages_->addWidget(scrolledColumn(makeSettings(), Qt::ScrollBarAsNeeded));
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(12, 8, 8, 8);
    all->setSpacing(8);
    all->addWidget(pages_, 1);
    all->addLayout(foot_);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    connect(previous_, &QToolButton::clicked, this, [this] { emit entryStepRequested(-1); });
    connect(next_, &QToolButton::clicked, this, [this] { emit entryStepRequested(+1); });
    connect(main_, &Stepper::stepped, this, [this](int steps) { emit stepped(mainKey_, steps); });
    connect(main_, &Stepper::stepEnded, this, &NumbersSide::stepEnded);
    showNumbers({});
}

QWidget* NumbersSide::makeNumbers() {
    auto* column = new QVBoxLayout(facts_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(hint_);
    auto* name = label("cab-distance-name", kNotePx, false);
    distanceName_ = name;
    name->setWordWrap(true);       // "Vertical Difference" is whole
    auto* above = new QHBoxLayout; // the uncertainty next to the name: a low screen has no line for it
    above->addWidget(name, 1);
    above->addWidget(tolerance_);
    column->addLayout(above);
    column->addWidget(distance_);
    column->addWidget(pose_);
    column->addLayout(coordinates_); // on the first page, whatever is warned about
    column->addWidget(warned_);
    column->addSpacing(4);
    auto* aboveSize = new QHBoxLayout(rockHead_);
    aboveSize->setContentsMargins(0, 0, 0, 0);
    aboveSize->addWidget(rock_, 1);
    aboveSize->addWidget(sizeTolerance_);
    for (QWidget* each : std::initializer_list<QWidget*>{rockHead_, size_, sizeRemark_}) column->addWidget(each);
    column->addSpacing(4);
    column->addLayout(rows_);
    column->addStretch(1);
    coordinates_->setColumnStretch(1, 1);
    coordinates_->setVerticalSpacing(2); // a low screen has room for all of them
    rows_->setColumnStretch(1, 1);
    pose_->setText(tr("▲ no pose: no E N RL"));
    underline(*pose_, true);
    facts_->installEventFilter(this);
    for (QLabel* each : {pose_, warned_}) {
        followColours(*each, [each](const Theme& theme) {
            QPalette letters = each->palette();
            letters.setColor(QPalette::WindowText, theme.warn);
            each->setPalette(letters);
        });
    }
    return facts_;
}

QWidget* NumbersSide::makeSettings() {
    auto* content = new QWidget;
    settings_ = new QVBoxLayout(content);
    settings_->setContentsMargins(0, 0, 0, 0);
    settings_->setSpacing(12);
    settingsHead_ = new FlowLayout;
    settings_->addLayout(settingsHead_);
    settings_->addStretch(1);
    return content;
}

void NumbersSide::showNumbers(const TargetNumbers& numbers) {
    const bool some = !numbers.title.isEmpty(), entries = numbers.targets + numbers.measures > 0;
    hint_->setVisible(!some);
    const QString note = numbers.note.isEmpty() ? QString() : numbers.note + "\n\n";
    const QString tap = numbers.choosesOnly
                            ? tr("Tap a rock in the cloud: its distance and its size are shown here. To set a target, tap Pin first.")
                            : tr("Tap a rock in the cloud: its distance and its size are shown here. A drag turns the cloud, two "
                                 "fingers move it.");
    hint_->setText(numbers.measuring     ? tr("Tap the ends of the measurement: its length is shown here.")
                   : numbers.targets > 0 ? tr("Tap a target, or an arrow above: its distance and its size are shown here.")
                   : entries             ? tr("The arrows above show the measurements.") + "\n\n" + tap
                                         : note + tap);
    for (QLabel* each : std::initializer_list<QLabel*>{distanceName_, distance_, tolerance_}) each->setVisible(some);
    distanceName_->setText(numbers.distanceName.isEmpty() ? tr("Distance") : numbers.distanceName);
    for (QWidget* each : std::initializer_list<QWidget*>{previous_, next_}) each->setEnabled(entries && !numbers.only);
    titleWords_ = some                  ? numbers.title + '\n' + numbers.place
                  : numbers.targets > 0 ? targetCount(static_cast<std::size_t>(numbers.targets))
                                        : tr("No target");
    lock_->setVisible(numbers.locked);
    title_->setAccessibleName(numbers.locked ? titleWords_ + " · " + tr("locked") : titleWords_);
    fitTitle();
    distance_->showText(numbers.distance);
    tolerance_->setWordWrap(!numbers.tolerance.startsWith("±"));
    tolerance_->setText(numbers.tolerance);
    rock_->setText(numbers.rock);
    rockHead_->setVisible(!numbers.rock.isEmpty());
    sizeTolerance_->setText(numbers.sizeTolerance);
    size_->showText(numbers.size);
    size_->setVisible(!numbers.size.isEmpty() && numbers.size != QStringLiteral("–")); // the remark says why there is none
    placeSize(numbers.ofRock);
    sizeRemark_->setText(numbers.sizeRemark);
    sizeRemark_->setVisible(!numbers.sizeRemark.isEmpty());
    pose_->setVisible(numbers.unposed);
    warned_->setText(numbers.warned);
    warned_->setVisible(!numbers.warned.isEmpty());
    fillRows(*coordinates_, coordinateLabels_, numbers.coordinates, true);
    for (const auto& [name, value] : coordinateLabels_) underline(*name, !numbers.unposed);
    fillRows(*rows_, rowLabels_, numbers.rows, false);
    if (std::exchange(shownTitle_, numbers.title) != numbers.title) shownPage_ = 0;
    fitHeight();
    QMetaObject::invokeMethod(this, &NumbersSide::fitPages, Qt::QueuedConnection); // after the rows have their widths
}

void NumbersSide::placeSize(bool first) {
    auto& column = *static_cast<QVBoxLayout*>(facts_->layout());
    for (QWidget* each : std::initializer_list<QWidget*>{rockHead_, size_}) column.removeWidget(each);
    const int at = first ? column.indexOf(pose_) + 1 : column.indexOf(sizeRemark_);
    column.insertWidget(at, rockHead_);
    column.insertWidget(at + 1, size_);
}

bool NumbersSide::eventFilter(QObject* watched, QEvent* event) {
    if (watched == title_ && event->type() == QEvent::MouseButtonRelease) emit titleTapped();
    // The line is lower than a finger.
    const QRect pose = pose_->isVisible() ? pose_->geometry() : coordinates_->geometry();
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
    placeLock();
}

/// Next to the last line: as a word of it, it would need a line of its own.
void NumbersSide::placeLock() {
    const QFontMetrics letters(title_->font());
    const QRect place = title_->contentsRect();
    const QRect words = letters.boundingRect(place, static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, title_->text());
    const int last = letters.horizontalAdvance(titleWords_.section('\n', -1));
    const int left = std::min(place.center().x() + last / 2 + kBeforeLock, place.right() + 1 - kLockPx);
    lock_->setGeometry(left, words.bottom() - (letters.height() + kLockPx) / 2, kLockPx, kLockPx);
}

void NumbersSide::fitHeight() {
    facts_->layout()->setContentsMargins(0, 0, 0, 0); // without the rest of the last page
    const bool low = height() < kLowPx;
    // The part of it that is in the window: with the stepper it would not become lower than the stepper needs.
    const int seen = std::min(height(), window()->height() - mapTo(window(), QPoint()).y());
    for (FittedLabel* each : {distance_, size_}) each->setMost(seen >= kLowestPx ? kNumberPx : kLowNumberPx);
    for (QLabel* each : {pose_, warned_}) {
        QFont letters = each->font();
        letters.setPixelSize(seen >= kLowestPx ? kNotePx : kLeastNotePx);
        if (letters != each->font()) each->setFont(letters);
    }
    for (const auto& [name, value] : coordinateLabels_) static_cast<FittedLabel*>(value)->setMost(low ? kTextPx : kCoordinatePx);
    for (const auto& [name, value] : rowLabels_) {
        for (QLabel* each : {name, value}) {
            QFont letters = each->font();
            letters.setPixelSize(low ? kLeastNotePx : kNotePx);
            each->setFont(letters);
        }
    }
    const bool held = main_->less()->isDown() || main_->more()->isDown();
    main_->setVisible(stepped_ && seen >= kLowestPx && (held || factsFitAbove(main_->sizeHint().height())));
    showValueInTune();
    fitPages();
}

/// If the stepper does not fit, the button Tune has its value.
void NumbersSide::showValueInTune() {
    if (tune_ == nullptr) return;
    const bool hidden = stepped_ && !tuning() && !main_->isVisibleTo(this);
    tune_->setText(hidden ? tuneWord_ + '\n' + main_->value() : tuneWord_);
    tune_->setIconSize(hidden ? QSize(kLowSign, kLowSign) : QSize(kSign, kSign));
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

void NumbersSide::fillRows(QGridLayout& grid, std::vector<std::pair<QLabel*, QLabel*>>& labels,
                           const std::vector<std::pair<QString, QString>>& rows, bool large) {
    while (labels.size() < rows.size()) {
        const int row = static_cast<int>(labels.size());
        QLabel* const value = large ? fitted(nullptr, kCoordinatePx) : label(nullptr, kNotePx, false);
        labels.emplace_back(label(nullptr, kNotePx, large), value);
        labels.back().first->setWordWrap(!large);
        value->setWordWrap(!large);
        labels.back().second->setAlignment((large ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        grid.addWidget(labels.back().first, row, 0);
        grid.addWidget(labels.back().second, row, 1);
    }
    for (std::size_t n = 0; n < labels.size(); ++n) {
        const bool some = n < rows.size();
        if (some) {
            labels[n].first->setText(rows[n].first);
            if (auto* const number = dynamic_cast<FittedLabel*>(labels[n].second))
                number->showText(rows[n].second);
            else
                labels[n].second->setText(rows[n].second);
        }
        labels[n].first->setVisible(some);
        labels[n].second->setVisible(some);
    }
}

void NumbersSide::showSettings(const std::vector<SteppedSetting>& settings) {
    stepped_ = !settings.empty();
    if (!settings.empty()) {
        mainKey_ = settings.front().key;
        main_->showName(settings.front().name);
        main_->showValue(settings.front().value);
        main_->showFound(settings.front().found);
    }
    fitHeight();
    for (const auto& [key, stepper] : steppers_) {
        stepper->setVisible(std::ranges::any_of(settings, [&k = key](const SteppedSetting& each) { return each.key == k; }));
    }
    for (const SteppedSetting& each : settings) {
        Stepper* shown = stepper(each.key);
        if (shown == nullptr) {
            shown = new Stepper(each.name);
            shown->setObjectName("step-" + each.key);
            connect(shown, &Stepper::stepped, this, [this, key = each.key](int steps) { emit stepped(key, steps); });
            connect(shown, &Stepper::stepEnded, this, &NumbersSide::stepEnded);
            settings_->insertWidget(1 + static_cast<int>(steppers_.size()), shown); // below the buttons
            steppers_.emplace_back(each.key, shown);
        }
        shown->showValue(each.value);
        shown->showFound(each.found);
        const bool first = each.key == mainKey_;
        shown->setMeaning(first ? ofLess_ : QString(), first ? ofMore_ : QString());
    }
}

void NumbersSide::setMeaning(const QString& ofLess, const QString& ofMore) {
    ofLess_ = ofLess;
    ofMore_ = ofMore;
    main_->setMeaning(ofLess, ofMore);
}

Stepper* NumbersSide::stepper(const QString& key) const {
    const auto found = std::ranges::find(steppers_, key, &std::pair<QString, Stepper*>::first);
    return found == steppers_.end() ? nullptr : found->second;
}

void NumbersSide::setTuning(bool on) {
    pages_->setCurrentIndex(on ? 1 : 0);
    fitHeight();
}
bool NumbersSide::tuning() const { return pages_->currentIndex() == 1; }
QString NumbersSide::distanceShown() const { return distance_->text(); }
QString NumbersSide::sizeShown() const { return size_->text(); }

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

} // namespace edgescan::ui

#include "moc_numbers_side.cpp"
