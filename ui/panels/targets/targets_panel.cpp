// The panel of targets.
#include "ui/panels/targets/targets_panel.h"

#include "ui/panels/targets/target_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kMostLines =
    3; // of a list before it scrolls: with a pose a target has three lines, and its card stays in sight at 1280 x 768

// As high as its lines, so that the panel has one scroll bar instead of three. Its own bar follows from the number of lines alone: a bar
// that comes with the height changes the width, the width the wrapped lines, and these the height, without end.
void fitHeight(QListWidget& list) {
    list.setVerticalScrollBarPolicy(list.count() > kMostLines ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    int high = list.count() > 0 ? 0 : list.fontMetrics().height();
    for (int n = 0; n < std::min(list.count(), kMostLines); ++n) high += list.visualItemRect(list.item(n)).height();
    list.setFixedHeight(high + 2 * list.frameWidth() + 2);
    if (list.currentItem() != nullptr) list.scrollToItem(list.currentItem());
}

} // namespace

TargetsPanel::TargetsPanel(QWidget* parent)
    : QWidget(parent), hint_(new QLabel), targets_(new QListWidget), copyAll_(new QPushButton(tr("Copy All"))),
      letGoOfAll_(new QPushButton(tr("Remove All"))), card_(new TargetCard), measuresTitle_(new QLabel(tr("Measured"))),
      measures_(new QListWidget), remarks_(new QLabel), removeMeasure_(new QPushButton(tr("Remove"))), note_(new QLabel) {
    setObjectName("targets-panel");
    hint_->setObjectName("targets-asked");
    targets_->setObjectName("target-list");
    measures_->setObjectName("measure-list");
    for (QListWidget* list : {targets_, measures_}) {
        list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        list->setWordWrap(true); // an uncertainty is never cut off
        list->setResizeMode(QListView::Adjust);
        list->viewport()->installEventFilter(this);
    }
    copyAll_->setToolTip(tr("The positions of all targets as a table with units, for a spreadsheet"));
    letGoOfAll_->setToolTip(tr("All but those that are locked"));
    removeMeasure_->setToolTip(tr("The selected measurement"));
    remarks_->setObjectName("measure-remarks");
    for (QLabel* label : {hint_, remarks_, note_}) label->setWordWrap(true);
    QFont bold = measuresTitle_->font();
    bold.setBold(true);
    measuresTitle_->setFont(bold);
    auto* titleOfMeasures = new QHBoxLayout;
    titleOfMeasures->addWidget(measuresTitle_, 1);
    titleOfMeasures->addWidget(removeMeasure_);
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
    column->addWidget(card_);
    column->addLayout(titleOfMeasures);
    column->addWidget(measures_);
    column->addWidget(remarks_);
    column->addWidget(note_);
    column->addStretch(1);
    // Not currentRowChanged: a list that gets the focus sets a current row itself.
    for (const auto chosen : {&QListWidget::itemClicked, &QListWidget::itemActivated}) {
        connect(targets_, chosen, this, [this](QListWidgetItem* item) { emit targetChosen(targets_->row(item)); });
        connect(measures_, chosen, this, [this](QListWidgetItem* item) { emit measureChosen(measures_->row(item)); });
    }
    connect(measures_, &QListWidget::currentRowChanged, removeMeasure_, [this](int row) { removeMeasure_->setEnabled(row >= 0); });
    targets_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(targets_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        if (QListWidgetItem* item = targets_->itemAt(at))
            emit targetMenuRequested(targets_->row(item), targets_->viewport()->mapToGlobal(at));
    });
    connect(copyAll_, &QPushButton::clicked, this, &TargetsPanel::copyAllRequested);
    connect(letGoOfAll_, &QPushButton::clicked, this, &TargetsPanel::removeAllRequested);
    connect(measures_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        remarks_->setText(item != nullptr ? item->toolTip() : QString());
        remarks_->setVisible(!remarks_->text().isEmpty());
    });
    connect(removeMeasure_, &QPushButton::clicked, this, [this] {
        if (measures_->currentRow() >= 0) emit measureRemoved(measures_->currentRow());
    });
    removeMeasure_->setEnabled(false);
    showAsked({});
    showTargets({});
    showMeasures({});
    showNote({});
}

void TargetsPanel::fill(QListWidget& list, std::vector<TargetLine>& shown, const std::vector<TargetLine>& lines) {
    if (shown == lines && list.count() == static_cast<int>(lines.size())) return;
    shown = lines;
    list.clear();
    int chosen = -1;
    for (const TargetLine& line : lines) {
        auto* item = new QListWidgetItem(line.words, &list);
        item->setToolTip(line.tip);
        if (line.chosen) chosen = list.count() - 1;
    }
    list.setCurrentRow(chosen);
    fitHeight(list);
}

/// Another width has other lines.
bool TargetsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize &&
        static_cast<QResizeEvent*>(event)->size().width() != static_cast<QResizeEvent*>(event)->oldSize().width()) {
        for (QListWidget* list : {targets_, measures_}) {
            if (watched == list->viewport())
                QMetaObject::invokeMethod(
                    list, [list] { fitHeight(*list); }, Qt::QueuedConnection);
        }
    }
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
    fill(*measures_, shownMeasures_, lines);
    for (QWidget* each : {static_cast<QWidget*>(measuresTitle_), static_cast<QWidget*>(measures_), static_cast<QWidget*>(removeMeasure_)})
        each->setVisible(!lines.empty());
    if (more && measuring_) QMetaObject::invokeMethod(this, &TargetsPanel::showNewest, Qt::QueuedConnection); // after the layout
}

/// What was just measured, though the card above it is long.
void TargetsPanel::showNewest() {
    for (QWidget* each = parentWidget(); each != nullptr; each = each->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(each)) return area->ensureWidgetVisible(measures_);
    }
}

void TargetsPanel::showNote(const QString& note) {
    note_->setText(note);
    note_->setVisible(!note.isEmpty());
}

QString TargetsPanel::note() const { return note_->text(); }

} // namespace edgescan::ui

#include "moc_targets_panel.cpp"
