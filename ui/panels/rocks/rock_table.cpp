// The table of rocks.
#include "ui/panels/rocks/rock_table.h"

#include "ui/base/count_text.h"
#include "ui/base/flow_layout.h"
#include "ui/panels/rocks/size_curve_view.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QShowEvent>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kRowHeight = 24;
constexpr int kWide = 560;     // px: from here on the size curve is at the side of the table
constexpr int kHigh = 460;     // px: from here on it has room below the table
constexpr int kLeastRows = 8;  // of height: a lower one shows no more than the rows
constexpr int kSizeColumn = 2; // column of the visible width b, the size of a rock: the initial order

} // namespace

RockTable::RockTable(QWidget* parent)
    : QWidget(parent), model_(new RockTableModel(this)), shown_(new ShownRocks(this)), table_(new QTableView),
      numbers_(new QTableView(table_)), curve_(new SizeCurveView), sides_(new QSplitter), tools_(new QWidget),
      bar_(new QBoxLayout(QBoxLayout::LeftToRight)), smallest_(new QDoubleSpinBox), sureOnly_(new QCheckBox(tr("hide uncertain"))),
      export_(new QPushButton(tr("Export…"))), count_(new QLabel) {
    setObjectName("rock-table");
    shown_->setSourceModel(model_);
    for (QTableView* view : {table_, numbers_}) {
        view->setModel(shown_);
        view->setSortingEnabled(true);
        view->setSelectionBehavior(QAbstractItemView::SelectRows);
        view->setSelectionMode(QAbstractItemView::ExtendedSelection);
        view->setEditTriggers(QAbstractItemView::NoEditTriggers);
        view->verticalHeader()->hide();
        view->verticalHeader()->setDefaultSectionSize(kRowHeight);
        view->horizontalHeader()->setDefaultAlignment(Qt::AlignCenter);
        view->horizontalHeader()->setMinimumSectionSize(40);
    }
    connectNumbers();
    table_->sortByColumn(kSizeColumn, Qt::DescendingOrder);
    connect(table_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, table_, &QTableView::scrollToTop, Qt::QueuedConnection);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->viewport()->installEventFilter(this);

    smallest_->setRange(0.0, 10.0);
    smallest_->setSingleStep(0.1);
    smallest_->setDecimals(2);
    smallest_->setSuffix(tr(" m"));
    const QString smallestHelp =
        tr("Rocks with a smaller visible width b are left out of the table, and in the views only their outline is drawn");
    auto* least = new QLabel(tr("b at least"));
    for (QWidget* each : std::initializer_list<QWidget*>{least, smallest_}) each->setToolTip(smallestHelp);
    sureOnly_->setToolTip(tr("Rocks with a confidence p below 0.85, which are hatched, are left out of the table, and in the views only "
                             "their outline is drawn"));

    count_->setWordWrap(true);
    count_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* tools = new FlowLayout(tools_);
    tools->setContentsMargins(8, 2, 8, 2);
    tools->setSpacing(8);
    for (QWidget* each : std::initializer_list<QWidget*>{least, smallest_, sureOnly_, export_}) tools->addWidget(each);
    bar_->setContentsMargins(8, 2, 0, 0);
    bar_->setSpacing(0);
    bar_->addWidget(count_, 1);
    bar_->addWidget(tools_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar_);
    sides_->addWidget(table_);
    sides_->addWidget(curve_);
    sides_->setStretchFactor(0, 1);
    sides_->setCollapsible(0, false);
    column->addWidget(sides_, 1);

    const auto follow = [this] {
        shown_->setFilter({smallest_->value(), sureOnly_->isChecked()});
        showCount();
        emit filterChanged();
    };
    connect(smallest_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, follow);
    connect(sureOnly_, &QCheckBox::toggled, this, follow);
    connect(export_, &QPushButton::clicked, this, &RockTable::askWhichToExport);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &RockTable::emitChosen);
    for (QTableView* view : {table_, numbers_}) {
        connect(view, &QTableView::doubleClicked, this, [this](const QModelIndex& index) { emit jumpRequested(labelOf(index)); });
        view->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(view, &QTableView::customContextMenuRequested, this, [this, view](const QPoint& at) {
            const QModelIndex index = view->indexAt(at);
            if (index.isValid()) emit menuRequested(labelOf(index), view->viewport()->mapToGlobal(at));
        });
    }
    showCount();
}

/// A view of the same rows over the first column, which scrolls away below it.
void RockTable::connectNumbers() {
    numbers_->setSelectionModel(table_->selectionModel());
    for (int n = 1; n < shown_->columnCount(); ++n) numbers_->setColumnHidden(n, true);
    numbers_->setFrameShape(QFrame::NoFrame);
    numbers_->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    numbers_->setFocusPolicy(Qt::NoFocus);
    numbers_->setAutoScroll(false); // it follows the other one
    numbers_->viewport()->installEventFilter(this);
    numbers_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    numbers_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const auto follow = [](QTableView* one, QTableView* other) {
        connect(one->verticalScrollBar(), &QScrollBar::valueChanged, other->verticalScrollBar(), &QScrollBar::setValue);
        connect(one->horizontalHeader(), &QHeaderView::sortIndicatorChanged, other,
                [other](int column, Qt::SortOrder order) { other->horizontalHeader()->setSortIndicator(column, order); });
    };
    follow(table_, numbers_);
    follow(numbers_, table_);
}

void RockTable::placeNumbers() {
    const QRect rows = table_->viewport()->geometry();
    numbers_->horizontalHeader()->setFixedHeight(rows.top() - table_->frameWidth());
    numbers_->verticalHeader()->setDefaultSectionSize(table_->verticalHeader()->defaultSectionSize());
    numbers_->setColumnWidth(0, table_->columnWidth(0));
    numbers_->setGeometry(rows.left(), table_->frameWidth(), table_->columnWidth(0), rows.bottom() + 1 - table_->frameWidth());
    numbers_->verticalScrollBar()->setValue(table_->verticalScrollBar()->value());
    numbers_->raise();
}

bool RockTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == table_->viewport() && event->type() == QEvent::Resize) fitColumns();
    if (watched == numbers_->viewport() && event->type() == QEvent::MouseButtonPress) { // Qt brings the column of the click into sight
        QScrollBar& bar = *table_->horizontalScrollBar();
        QMetaObject::invokeMethod(
            this, [&bar, scrolled = bar.value()] { bar.setValue(scrolled); }, Qt::QueuedConnection);
    }
    return QWidget::eventFilter(watched, event);
}

/// Each column shows its whole head and content, and has its part of the width that is left. A table with less room scrolls; its columns in
/// sight end at its border, so that no head is cut there.
void RockTable::fitColumns() {
    QHeaderView* heads = table_->horizontalHeader();
    if (heads->count() > kSizeColumn)
        heads->moveSection(heads->visualIndex(kSizeColumn), 1); // next to the number, in sight in a narrow panel
    const QAbstractItemView& content = *table_;
    const int row = std::max(kRowHeight, content.sizeHintForRow(0)); // higher for gloves
    table_->verticalHeader()->setDefaultSectionSize(row);
    heads->setMinimumHeight(std::max(row > kRowHeight ? row : 0, 2 * heads->fontMetrics().height() + 6)); // two lines and the arrow
    std::vector<int> widths;
    for (int n = 0; n < heads->count(); ++n) widths.push_back(std::max(heads->sectionSizeHint(n), content.sizeHintForColumn(n)));
    int left = table_->viewport()->width(), inSight = 0;
    for (; inSight < heads->count(); ++inSight) {
        const int width = widths[static_cast<std::size_t>(heads->logicalIndex(inSight))];
        if (width > left) break;
        left -= width;
    }
    for (int place = 0; place < heads->count(); ++place) {
        const int n = heads->logicalIndex(place), more = place < inSight ? left / (inSight - place) : 0;
        left -= more;
        heads->resizeSection(n, widths[static_cast<std::size_t>(n)] + more);
    }
    placeNumbers();
}

/// In a narrow panel the parts are one below the other, and in a low one the rows come first.
void RockTable::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool wide = width() >= kWide;
    if (model_->setNarrow(!wide)) fitColumns();
    bar_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    sides_->setOrientation(wide ? Qt::Horizontal : Qt::Vertical);
    curve_->setVisible(wide || height() >= kHigh);
    tools_->setVisible(wide || height() >= kLeastRows * table_->verticalHeader()->defaultSectionSize());
}

const rocks::Rock& RockTable::rockAt(const QModelIndex& index) const {
    return model_->picture()->study.rocks[static_cast<std::size_t>(shown_->mapToSource(index).row())];
}

std::uint32_t RockTable::labelOf(const QModelIndex& index) const { return rockAt(index).label; }

void RockTable::show(const std::shared_ptr<const RockPicture>& picture, const QString& remark) {
    showing_ = true;
    remark_ = remark;
    if (picture != model_->picture()) {
        model_->show(picture);
        fitColumns();
        curve_->show(picture ? edgescan::rocks::sizeCurve(picture->study.rocks, picture->study.settings.oversizeM) : rocks::SizeCurve{});
        markOnCurve({});
    }
    showing_ = false;
    showCount();
}

void RockTable::setNames(const RockNames& names) {
    model_->setNames(names);
    fitColumns();
}

void RockTable::showAll() {
    smallest_->setValue(0.0);
    sureOnly_->setChecked(false);
}

void RockTable::showCount() {
    const int all = model_->rowCount();
    const int shown = shown_->rowCount();
    QString text = shown == all ? rockCount(static_cast<std::size_t>(all)) : tr("%1 of %2 rocks").arg(shown).arg(all);
    if (model_->picture()) {
        int uncertain = 0;
        for (int row = 0; row < shown; ++row) uncertain += isDoubtful(rockAt(shown_->index(row, 0))) ? 1 : 0;
        text += tr(", %1 of them uncertain (hatched)").arg(uncertain) + " · " + rockCaveat();
    }
    count_->setText((remark_.isEmpty() ? QString() : remark_ + " · ") + text);
    export_->setEnabled(all > 0);
}

std::optional<std::vector<std::uint32_t>> RockTable::listed() const {
    std::vector<std::uint32_t> labels;
    bool inOrder = shown_->rowCount() == model_->rowCount();
    for (int row = 0; row < shown_->rowCount(); ++row) {
        labels.push_back(labelOf(shown_->index(row, 0)));
        inOrder = inOrder && labels.back() == model_->picture()->study.rocks[static_cast<std::size_t>(row)].label;
    }
    return inOrder ? std::nullopt : std::optional(std::move(labels));
}

void RockTable::askWhichToExport() {
    const int all = model_->rowCount(), shown = shown_->rowCount();
    if (shown == all || shown == 0) return emit exportRequested(shown == 0);
    QMenu menu(this);
    menu.addAction(tr("&Shown Rocks (%1)…").arg(shown), this, [this] { emit exportRequested(false); });
    menu.addAction(tr("&All Rocks (%1)…").arg(all), this, [this] { emit exportRequested(true); });
    menu.exec(export_->mapToGlobal(QPoint(0, export_->height())));
}

QString RockTable::remark() const { return count_->text(); }

void RockTable::select(const std::vector<std::uint32_t>& labels) {
    showing_ = true;
    QItemSelection rows;
    QModelIndex last;
    for (const std::uint32_t label : labels) {
        const std::vector<rocks::Rock>& rocks = model_->picture()->study.rocks;
        const auto rock = std::ranges::find(rocks, label, &rocks::Rock::label);
        const QModelIndex index = shown_->mapFromSource(model_->index(static_cast<int>(rock - rocks.begin()), 0));
        if (!index.isValid()) continue;
        rows.select(index, index.sibling(index.row(), shown_->columnCount() - 1));
        last = index;
    }
    table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    const int scrolled = table_->verticalScrollBar()->value(), sideways = table_->horizontalScrollBar()->value();
    if (last.isValid()) table_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
    table_->verticalScrollBar()->setValue(scrolled); // Qt puts a new current row at the border
    bringIntoSight();
    table_->horizontalScrollBar()->setValue(sideways);
    showing_ = false;
    markOnCurve(labels);
}

/// The last selected row, with its neighbours; a row that is in sight stays where it is.
void RockTable::bringIntoSight() {
    const QModelIndex row = table_->currentIndex();
    if (!isVisible() || !table_->selectionModel()->isRowSelected(row.row(), QModelIndex())) return;
    const QRect place = table_->visualRect(row);
    if (place.top() < 0 || place.bottom() > table_->viewport()->height()) table_->scrollTo(row, QAbstractItemView::PositionAtCenter);
}

/// It begins with its first row.
void RockTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (event->spontaneous()) return;
    const auto begin = [this] {
        table_->scrollToTop();
        bringIntoSight();
    };
    QMetaObject::invokeMethod(this, begin, Qt::QueuedConnection); // when it has its height
}

void RockTable::markOnCurve(const std::vector<std::uint32_t>& labels) {
    std::vector<double> widthsM;
    for (const std::uint32_t label : labels) widthsM.push_back(model_->picture()->rock(label)->shortestCaliperM);
    curve_->mark(std::move(widthsM));
}

std::vector<std::uint32_t> RockTable::selected() const {
    std::vector<std::uint32_t> labels;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows()) labels.push_back(labelOf(index));
    return labels;
}

void RockTable::emitChosen() {
    if (!showing_) emit chosen(selected());
}

} // namespace edgescan::ui

#include "moc_rock_table.cpp"
