// The table of rocks.
#include "ui/panels/rocks/rock_table.h"

#include "ui/panels/rocks/size_curve_view.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kRowHeight = 24;
constexpr int kSpanColumn = 1; // column of the length a, the initial order

} // namespace

RockTable::RockTable(QWidget* parent)
    : QWidget(parent), model_(new RockTableModel(this)), shown_(new ShownRocks(this)), table_(new QTableView), curve_(new SizeCurveView),
      smallest_(new QDoubleSpinBox), sureOnly_(new QCheckBox(tr("no doubtful ones"))), export_(new QPushButton(tr("Export…"))),
      count_(new QLabel) {
    setObjectName("rock-table");
    shown_->setSourceModel(model_);
    table_->setModel(shown_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(kSpanColumn, Qt::DescendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setAlternatingRowColors(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
    QHeaderView* heads = table_->horizontalHeader();
    heads->setSectionResizeMode(QHeaderView::Stretch);
    heads->setDefaultAlignment(Qt::AlignCenter | static_cast<Qt::Alignment>(Qt::TextWordWrap)); // a unit may be below its word
    heads->setMinimumHeight(2 * heads->fontMetrics().height() + 6);
    heads->setMinimumSectionSize(40);

    smallest_->setRange(0.0, 10.0);
    smallest_->setSingleStep(0.1);
    smallest_->setDecimals(2);
    smallest_->setSuffix(tr(" m"));
    smallest_->setToolTip(tr("Rocks whose visible b is smaller are left out of the table, not out of the pictures"));
    sureOnly_->setToolTip(tr("Rocks with p below 0.85, which are hatched, are left out of the table"));

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 2, 8, 2);
    bar->setSpacing(8);
    bar->addWidget(count_, 1);
    bar->addWidget(new QLabel(tr("b at least")));
    bar->addWidget(smallest_);
    bar->addWidget(sureOnly_);
    bar->addWidget(export_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    auto* sides = new QSplitter(Qt::Horizontal);
    sides->addWidget(table_);
    sides->addWidget(curve_);
    sides->setStretchFactor(0, 1);
    sides->setCollapsible(0, false);
    column->addWidget(sides, 1);

    connect(smallest_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double metres) {
        shown_->setSmallest(metres);
        showCount();
    });
    connect(sureOnly_, &QCheckBox::toggled, this, [this](bool on) {
        shown_->setSureOnly(on);
        showCount();
    });
    connect(export_, &QPushButton::clicked, this, &RockTable::exportRequested);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &RockTable::emitChosen);
    connect(table_, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { emit jumpRequested(static_cast<std::uint32_t>(shown_->mapToSource(index).row()) + 1); });
    showCount();
}

void RockTable::show(const std::shared_ptr<const RockPicture>& picture, const QString& remark) {
    showing_ = true;
    remark_ = remark;
    if (picture != model_->picture()) {
        model_->show(picture);
        curve_->show(picture ? edgescan::rocks::sizeCurve(picture->study.rocks, picture->study.settings.oversizeM) : rocks::SizeCurve{});
        markOnCurve({});
    }
    showing_ = false;
    showCount();
}

void RockTable::showCount() {
    const int all = model_->rowCount();
    const int shown = shown_->rowCount();
    QString text = shown == all ? tr("%1 rocks").arg(all) : tr("%1 of %2 rocks").arg(shown).arg(all);
    if (model_->picture()) {
        const std::vector<rocks::Rock>& rocks = model_->picture()->study.rocks;
        text += tr(", %1 hatched (p < 0.85)").arg(std::count_if(rocks.begin(), rocks.end(), isDoubtful));
    }
    count_->setText((remark_.isEmpty() ? QString() : remark_ + " · ") + text + " · " + rockCaveat());
    export_->setEnabled(all > 0);
}

QString RockTable::remark() const { return count_->text(); }

void RockTable::select(const std::vector<std::uint32_t>& labels) {
    showing_ = true;
    QItemSelection rows;
    QModelIndex last;
    for (const std::uint32_t label : labels) {
        const QModelIndex index = shown_->mapFromSource(model_->index(static_cast<int>(label) - 1, 0));
        if (!index.isValid()) continue;
        rows.select(index, index.sibling(index.row(), shown_->columnCount() - 1));
        last = index;
    }
    table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    if (last.isValid()) {
        table_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
        table_->scrollTo(last);
    }
    showing_ = false;
    markOnCurve(labels);
}

void RockTable::markOnCurve(const std::vector<std::uint32_t>& labels) {
    std::vector<double> widthsM;
    for (const std::uint32_t label : labels) widthsM.push_back(model_->picture()->rock(label)->shortestCaliperM);
    curve_->mark(std::move(widthsM));
}

std::vector<std::uint32_t> RockTable::selected() const {
    std::vector<std::uint32_t> labels;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows())
        labels.push_back(static_cast<std::uint32_t>(shown_->mapToSource(index).row()) + 1);
    return labels;
}

void RockTable::emitChosen() {
    if (!showing_) emit chosen(selected());
}

} // namespace edgescan::ui

#include "moc_rock_table.cpp"
