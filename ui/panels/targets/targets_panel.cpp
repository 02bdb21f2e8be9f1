// The panel of targets.
#include "ui/panels/targets/targets_panel.h"

#include "ui/base/icons.h"
#include "ui/base/narrow_button.h"
#include "ui/base/scrolled.h"
#include "ui/panels/targets/target_card.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace edgescan::ui {
namespace {

// Of a list before it scrolls: a target has two lines, and its card stays in sight at 1280 x 768.
constexpr int kMostTargets = 4, kMostWithMeasures = 2, kMostMeasures = 2, kMostNextToCard = 1;
constexpr double kShareOfTargets = 0.27; // of the panel's height, for more of them

/// So that the panel has one scroll bar instead of three: whole lines, `most` of them, and more where `free` px of the panel are empty.
/// `constant`: at least as high as `most` lines, so that one more line moves nothing below the list. Its own bar makes its lines no lower,
/// so that what has no room without the bar has none with it.
void fitHeight(QListWidget& list, int most, bool constant, int free) {
    int high = 0, tallest = list.fontMetrics().height(), shown = 0;
    std::vector<int> lines;
    for (int n = 0; n < list.count(); ++n) {
        lines.push_back(list.visualItemRect(list.item(n)).height());
        tallest = std::max(tallest, lines.back());
    }
    const int room = list.minimumHeight() + free - 2 * list.frameWidth() - 2;
    for (const int line : lines) {
        if (shown >= most && high + line > room) break;
        high += line;
        ++shown;
    }
    list.setVerticalScrollBarPolicy(list.count() > shown ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    if (constant) high = std::max(high, most * tallest);
    const int before = list.minimumHeight();
    list.setFixedHeight((list.count() > 0 ? high : tallest) + 2 * list.frameWidth() + 2);
    if (list.minimumHeight() != before && list.currentItem() != nullptr) list.scrollToItem(list.currentItem());
}

constexpr int kLettersOfName = 10;       // with the two blanks before it
constexpr int kLettersOfPart = 6;        // with three blanks; a part with fewer would be an unexplained "…"
constexpr int kShortPart = 12;           // letters
constexpr int kShortened = Qt::UserRole; // TargetLine::shortened
constexpr int kLockPx = 16;

/// Without the ends of those parts that it can do without. Of the last one, a name, the beginning stays.
QString fittedRow(QString row, const QStringList& shortened, const QFontMetrics& metrics, int room) {
    for (const QString& part : shortened) {
        const int over = metrics.horizontalAdvance(row) - room;
        const auto at = row.indexOf(part);
        if (over <= 0 || at < 0) continue;
        const bool isName = part == shortened.back();
        const bool isShort = !isName && part.size() <= kShortPart; // a number of a rock is whole, or not there
        const int least = metrics.horizontalAdvance(isShort ? part : part.left(isName ? kLettersOfName : kLettersOfPart) + "…");
        const int left = metrics.horizontalAdvance(part) - over;
        row.replace(at, part.size(), left < least && !isName ? QString() : metrics.elidedText(part, Qt::ElideRight, std::max(left, least)));
    }
    return metrics.elidedText(row, Qt::ElideRight, room);
}

/// One row of text of each line is shortened where it has no room, so that it makes no line higher: the first of a target (note and name),
/// the last of a measurement (kind and warning).
class TargetRows : public QStyledItemDelegate {
public:
    enum class Shortened { First, Last };
    TargetRows(QObject* parent, Shortened row) : QStyledItemDelegate(parent), row_(row) {}

    /// The sign of a lock is at the end of the first row, which alone gives room for it: numbers and positions stay below each other.
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const auto lock = index.data(Qt::DecorationRole).value<QIcon>();
        if (lock.isNull()) return;
        const int right = option.rect.right() - marginOf(*option.widget);
        lock.paint(painter, QRect(right - kLockPx, option.rect.top(), kLockPx, option.fontMetrics.height()));
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const auto* list = qobject_cast<const QListWidget*>(option->widget);
        if (list == nullptr) return;
        const int margin = marginOf(*list), sign = option->icon.isNull() ? 0 : kLockPx + margin;
        const int room = list->viewport()->width() - 2 * margin - 2;
        option->icon = QIcon(); // paint() draws it
        option->features &= ~QStyleOptionViewItem::HasDecoration;
        QStringList rows = option->text.split(QChar::LineSeparator); // Qt writes \n so
        if (row_ == Shortened::First)
            rows.front() = fittedRow(rows.front(), index.data(kShortened).toStringList(), option->fontMetrics, room - sign);
        if (row_ == Shortened::Last && rows.size() > 1) rows.back() = option->fontMetrics.elidedText(rows.back(), Qt::ElideRight, room);
        option->text = rows.join(QChar::LineSeparator);
    }

private:
    [[nodiscard]] static int marginOf(const QWidget& list) {
        return list.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &list) + 1;
    }
    Shortened row_;
};

} // namespace

TargetsPanel::TargetsPanel(QWidget* parent)
    : QWidget(parent), hint_(new QLabel), targets_(new QListWidget), copyAll_(new NarrowButton(tr("Copy All"))),
      letGoOfAll_(new NarrowButton(tr("Remove All"))), card_(new TargetCard), measuresTitle_(new QLabel(tr("Measured"))),
      measures_(new QListWidget), remarks_(new QLabel), section_(new NarrowButton(tr("Section"))),
      removeMeasure_(new NarrowButton(tr("Remove"))), note_(new QLabel) {
    setObjectName("targets-panel");
    hint_->setObjectName("targets-asked");
    targets_->setObjectName("target-list");
    measures_->setObjectName("measure-list");
    for (QListWidget* list : {targets_, measures_}) {
        list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        list->setWordWrap(true); // an uncertainty is never cut off
        list->setResizeMode(QListView::Adjust);
        list->viewport()->installEventFilter(this);
        list->installEventFilter(this);
    }
    targets_->setItemDelegate(new TargetRows(targets_, TargetRows::Shortened::First));
    measures_->setItemDelegate(new TargetRows(measures_, TargetRows::Shortened::Last));
    copyAll_->setToolTip(tr("The positions of all targets as a table with units, for a spreadsheet"));
    letGoOfAll_->setToolTip(tr("All but those that are locked"));
    section_->setToolTip(tr("A vertical section through the selected measurement, or through the last one"));
    removeMeasure_->setToolTip(tr("The selected measurement"));
    remarks_->setObjectName("measure-remarks");
    for (QLabel* label : {hint_, remarks_, note_}) label->setWordWrap(true);
    QFont bold = measuresTitle_->font();
    bold.setBold(true);
    measuresTitle_->setFont(bold);
    auto* titleOfMeasures = new QHBoxLayout;
    titleOfMeasures->addWidget(measuresTitle_, 1);
    for (QPushButton* button : {section_, removeMeasure_}) titleOfMeasures->addWidget(button);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(4);
    column->addWidget(hint_);
    column->addWidget(targets_); // above the card, which is long: the list remains in sight in a low window
    auto* ofAll = new QHBoxLayout;
    ofAll->addStretch(1);
    ofAll->addWidget(copyAll_);
    ofAll->addWidget(letGoOfAll_);
    column->addLayout(ofAll);
    column->addLayout(titleOfMeasures); // above the card, too
    column->addWidget(measures_);
    column->addWidget(remarks_);
    column->addWidget(card_);
    column->addWidget(note_);
    column->addStretch(1);
    // Not currentRowChanged: a list that gets the focus sets a current row itself.
    for (const auto chosen : {&QListWidget::itemClicked, &QListWidget::itemActivated}) {
        for (QListWidget* list : {targets_, measures_})
            connect(list, chosen, this, [this, list](QListWidgetItem* item) { choose(*list, list->row(item)); });
    }
    connect(targets_, &QListWidget::itemDoubleClicked, this, [this](QListWidgetItem* item) { emit nameRequested(targets_->row(item)); });
    targets_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(targets_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        if (QListWidgetItem* item = targets_->itemAt(at))
            emit targetMenuRequested(targets_->row(item), targets_->viewport()->mapToGlobal(at));
    });
    connect(copyAll_, &QPushButton::clicked, this, &TargetsPanel::copyAllRequested);
    connect(letGoOfAll_, &QPushButton::clicked, this, &TargetsPanel::removeAllRequested);
    connect(measures_, &QListWidget::itemSelectionChanged, this, &TargetsPanel::showRemarks);
    connect(removeMeasure_, &QPushButton::clicked, this, [this] {
        if (const auto chosen = measures_->selectedItems(); !chosen.isEmpty()) emit measureRemoved(measures_->row(chosen.front()));
    });
    removeMeasure_->setEnabled(false);
    showAsked({});
    showTargets({});
    showMeasures({});
    showNote({});
}

/// The items stay: a list that is cleared first would scroll, and the next click would meet another line.
void TargetsPanel::fill(QListWidget& list, std::vector<TargetLine>& shown, const std::vector<TargetLine>& lines) {
    const int count = static_cast<int>(lines.size());
    if (shown == lines && list.count() == count) return;
    shown = lines;
    while (list.count() > count) delete list.takeItem(list.count() - 1);
    while (list.count() < count) list.addItem(QString());
    int chosen = -1;
    for (int n = 0; n < count; ++n) {
        const TargetLine& line = lines[static_cast<std::size_t>(n)];
        list.item(n)->setText(line.words);
        list.item(n)->setToolTip(line.tip);
        list.item(n)->setData(kShortened, line.shortened);
        list.item(n)->setIcon(line.locked ? toolIcon("lock") : QIcon());
        if (line.chosen) chosen = n;
    }
    list.setCurrentRow(chosen);
    fit(list);
    if (chosen >= 0) list.scrollToItem(list.item(chosen));
}

/// Px of the dock that nothing needs; negative: the panel scrolls.
int TargetsPanel::freeHeight() const {
    const QWidget* dock = parentWidget(); // the part of a scroll area that is seen
    return dock == nullptr || !isVisible() ? 0 : dock->height() - layout()->heightForWidth(width());
}

void TargetsPanel::fitLists() {
    for (QListWidget* list : {targets_, measures_}) {
        if (!list->isHidden()) fit(*list);
    }
}

/// The card needs the room of the measurements. The buttons below the targets do not move when it comes or goes.
void TargetsPanel::fit(QListWidget& list) {
    if (&list == measures_) return fitHeight(list, card_->isHidden() ? kMostMeasures : kMostNextToCard, false, freeHeight());
    const int room = parentWidget() == nullptr ? 0 : static_cast<int>(kShareOfTargets * parentWidget()->height());
    fitHeight(list, shownMeasures_.empty() ? kMostTargets : kMostWithMeasures, true, room - list.minimumHeight());
}

void TargetsPanel::fitSoon() {
    if (std::exchange(fits_, true)) return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            fits_ = false;
            fitLists();
        },
        Qt::QueuedConnection);
}

/// The card, the notes and the dock leave another height to the lists. While the panel scrolls, only the dock is resized.
bool TargetsPanel::event(QEvent* event) {
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::ParentChange && parentWidget() != nullptr) parentWidget()->installEventFilter(this);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize || event->type() == QEvent::Show) fitSoon();
    return done;
}

void TargetsPanel::choose(const QListWidget& list, int row) {
    if (row >= 0) &list == targets_ ? emit targetChosen(row) : emit measureChosen(row);
}

/// Another width has other lines. Return in the list of targets asks for the name. A row that a key marks is chosen, as a clicked one is:
/// Del removes what is chosen.
bool TargetsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) fitSoon();
    if (watched == targets_ && event->type() == QEvent::KeyPress && targets_->currentRow() >= 0) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            emit nameRequested(targets_->currentRow());
            return true;
        }
    }
    constexpr std::array kWays{Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_End};
    auto* list = qobject_cast<QListWidget*>(watched);
    if (list != nullptr && event->type() == QEvent::KeyPress && std::ranges::count(kWays, static_cast<QKeyEvent*>(event)->key()) > 0)
        QMetaObject::invokeMethod(
            this, [this, list] { choose(*list, list->currentRow()); }, Qt::QueuedConnection); // when it is marked
    return QWidget::eventFilter(watched, event);
}

void TargetsPanel::showTargets(const std::vector<TargetLine>& lines) {
    fill(*targets_, shownTargets_, lines);
    hint_->setVisible(lines.empty());
    targets_->setVisible(!lines.empty());
    copyAll_->setVisible(!lines.empty());
    letGoOfAll_->setVisible(!lines.empty());
}

void TargetsPanel::showAsked(const QString& words) {
    measuring_ = !words.isEmpty();
    hint_->setText(measuring_ ? words : tr("Click a cell in any view to pin it."));
}

void TargetsPanel::showMeasures(const std::vector<TargetLine>& lines) {
    const bool more = lines.size() > shownMeasures_.size();
    const bool first = lines.empty() != shownMeasures_.empty();
    fill(*measures_, shownMeasures_, lines);
    if (first) fit(*targets_);
    showRemarks();
    for (QWidget* each : {static_cast<QWidget*>(measuresTitle_), static_cast<QWidget*>(measures_), static_cast<QWidget*>(section_),
                          static_cast<QWidget*>(removeMeasure_)})
        each->setVisible(!lines.empty());
    if (more && measuring_) QMetaObject::invokeMethod(this, &TargetsPanel::showNewest, Qt::QueuedConnection); // after the layout
}

void TargetsPanel::showRemarks() {
    const auto chosen = measures_->selectedItems(); // a current row may have no mark
    removeMeasure_->setEnabled(!chosen.isEmpty());
    remarks_->setText(chosen.isEmpty() ? QString() : chosen.front()->toolTip());
    remarks_->setVisible(!remarks_->text().isEmpty());
}

/// What was just measured, though the card above it is long.
void TargetsPanel::showNewest() { scrollTo(*measures_); }

void TargetsPanel::showNote(const QString& note) {
    note_->setText(note);
    note_->setVisible(!note.isEmpty());
}

void TargetsPanel::setCardFirst(bool on) {
    constexpr int kBelowLists = 6;
    static_cast<QVBoxLayout*>(layout())->insertWidget(on ? 0 : kBelowLists, card_);
    if (!measuring_) showAsked({}); // a cab has the words of a finger
}

QString TargetsPanel::note() const { return note_->text(); }

} // namespace edgescan::ui

#include "moc_targets_panel.cpp"
