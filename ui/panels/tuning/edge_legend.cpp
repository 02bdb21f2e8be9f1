// The legend of edges.
#include "ui/panels/tuning/edge_legend.h"

#include "core/edges/rock_borders/rock_borders.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "ui/base/count_text.h"
#include "ui/base/icons.h"
#include "ui/base/themes.h"
#include "ui/base/tool_tips.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QToolButton>

#include <algorithm>
#include <span>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kForGloves = 48, kArrow = 22; // px

int bitOf(std::size_t n) { return 1 << n; } // EdgeClassBits are in the order of DepthEdge

constexpr std::array<int, kEdgeStrengths> kStrengthFrom{edges::kStrongBorder, edges::kWeakBorder, 0}; // %
constexpr std::size_t kOfRocks = 3;                                                                   // jump, convex, concave
/// The order in which the classes take cells: the first three by strength, each other class what is left.
constexpr std::array<std::size_t, kEdgeClasses> kTakes{0, 1, 2, 4, 5, 3};

QString classLabel(std::size_t n) { return QObject::tr(edges::findParameter("classes")->choices[n].label); }

/// Classes that are off and whose cells can count in another class.
QString textOfMovedCells(int classes) {
    QStringList off;
    for (std::size_t place = 0; place < kTakes.size(); ++place) {
        const auto takers = std::span(kTakes).subspan(place < kOfRocks ? 0 : place);
        const auto isOn = [classes](std::size_t n) { return (classes & bitOf(n)) != 0; };
        if (!isOn(kTakes[place]) && std::ranges::any_of(takers, isOn)) off << classLabel(kTakes[place]);
    }
    if (off.isEmpty()) return {};
    return (off.size() == 1 ? EdgeLegend::tr("Without %1:").arg(off.front()) : EdgeLegend::tr("Without %1 classes:").arg(off.size())) +
           '\n' + EdgeLegend::tr("other classes take some of its cells, and chains get shorter: fewer edges, here and in files");
}

QLabel* signOf(const QLabel* words) { return static_cast<QLabel*>(words->parentWidget()->layout()->itemAt(0)->widget()); }

} // namespace

EdgeLegend::EdgeLegend(QWidget* parent) : QWidget(parent) {
    setObjectName("edge-legend");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setColumnStretch(0, 1);
    grid->setVerticalSpacing(2);
    const Row all = addRow(*grid, tr("Edges"), "legend-edges");
    edges_ = all.box;
    total_ = all.count;
    for (QWidget* each : {static_cast<QWidget*>(edges_), static_cast<QWidget*>(total_)}) {
        QFont bold = each->font();
        bold.setBold(true);
        each->setFont(bold);
    }
    showTick();
    connect(edges_, &QCheckBox::toggled, this, [this](bool on) {
        if (showing_) return;
        if (!isCovered_) emit edgesRequested(on);
        if (!on || !isCovered_) return;
        showTick(); // until they are drawn over the rocks
        emit overRocksRequested(true);
    });
    unfold_ = new QToolButton;
    unfold_->setObjectName("legend-unfold");
    unfold_->setAccessibleName(QObject::tr("Classes"));
    unfold_->setIcon(toolIcon("layers"));
    unfold_->setAutoRaise(true);
    unfold_->setCheckable(true);
    unfold_->setChecked(true);
    unfold_->setFocusPolicy(Qt::TabFocus);
    connect(unfold_, &QToolButton::toggled, this, [this](bool open) {
        showRows();
        if (brief_ || isCovered_) return;
        openAtDesk_ = open;
        emit unfolded(open);
    });
    constexpr std::array kStrengthNames{"legend-strong", "legend-weak", "legend-thin"};
    for (std::size_t n = 0; n < kEdgeStrengths; ++n) {
        strengths_[n] = addSign(*grid, kStrengthNames[n]);
        strengths_[n]->setToolTip(tr("How likely an edge is the border of a rock; where that is unknown, it is drawn like one."));
    }
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        rows_[n] = addRow(*grid, classLabel(n), nullptr);
        rows_[n].box->setObjectName(QString("legend-%1").arg(n));
        rows_[n].box->setToolTip(QObject::tr(edges::findParameter("classes")->help) + "\n" +
                                 tr("Without one class the other numbers change too: a cell has one class, and a weak cell counts where it "
                                    "continues a strong one of any class.") +
                                 (n < kOfRocks ? QString()
                                               : '\n' + tr("With a higher edge strength this number can rise: cells that were "
                                                           "jumps or folds before count here.")));
        connect(rows_[n].box, &QCheckBox::toggled, this, &EdgeLegend::emitClasses);
    }
    taken_ = new QLabel;
    taken_->setWordWrap(true);
    taken_->setObjectName("legend-taken");
    taken_->hide();
    grid->addWidget(taken_, grid->rowCount(), 0, 1, 2);
    const Row byClass = addRow(*grid, tr("Colours by class"), "legend-by-class");
    byClass.count->hide(); // uses no row while the switch is hidden
    byClass_ = byClass.box;
    grid->addWidget(byClass_, grid->rowCount() - 1, 0, 1, 2);
    byClass_->setToolTip(tr("Each class in its own colour, or all edges in one: C"));
    connect(byClass_, &QCheckBox::toggled, this, [this](bool on) {
        paintSwatches();
        if (!showing_) emit byClassRequested(on);
    });
    covered_ = new QLabel(tr("Rocks cover them in the cloud"));
    covered_->setWordWrap(true);
    covered_->setObjectName("legend-covered");
    covered_->setToolTip(tr("Rocks > Edges over Rocks draws them over the rocks; the images show them."));
    covered_->hide();
    grid->addWidget(covered_, grid->rowCount(), 0, 1, 2);
    filled_ = new QLabel;
    filled_->setWordWrap(true);
    filled_->setObjectName("legend-filled");
    filled_->setToolTip(tr("Striped green in the images; no beam measured these cells, and the cloud does not show them."));
    filled_->hide();
    grid->addWidget(filled_, grid->rowCount(), 0, 1, 2);
    addOthers(*grid);
    auto* head = new QHBoxLayout;
    head->addStretch(1);
    grid->addLayout(head, 0, 0);
    foot_ = new QHBoxLayout;
    foot_->addStretch(1);
    grid->addLayout(foot_, grid->rowCount(), 0, 1, 3);
    setBrief(false);
    hide(); // no content yet
}

/// Words with a sign before them, hidden.
QLabel* EdgeLegend::addSign(QGridLayout& grid, const char* name) {
    auto* place = new QWidget;
    place->setObjectName(name);
    auto* row = new QHBoxLayout(place);
    row->setContentsMargins(0, 0, 0, 0);
    auto* words = new QLabel;
    words->setWordWrap(true);
    row->addWidget(new QLabel, 0, Qt::AlignTop);
    row->addWidget(words, 1);
    place->hide();
    grid.addWidget(place, grid.rowCount(), 0, 1, 2);
    return words;
}

void EdgeLegend::showStrengths(const std::optional<std::array<std::size_t, kEdgeStrengths>>& cells, int leastPercent) {
    if (!cells && !byStrength_) return;
    byStrength_ = cells.has_value();
    leastPercent_ = leastPercent;
    const std::array names{tr("Rock border, %1 % and more: %2").arg(std::max(kStrengthFrom[0], leastPercent)),
                           tr("Perhaps, %1 to 69 %: %2").arg(std::max(kStrengthFrom[1], leastPercent)),
                           leastPercent > 0 ? tr("Fold in a rock, %1 to 29 %: %2").arg(leastPercent)
                                            : tr("Fold in a rock, below 30 %: %1")};
    for (std::size_t n = 0; cells && n < kEdgeStrengths; ++n) // no line begins with "%"
        strengths_[n]->setText(names[n].arg(countText((*cells)[n])).replace(" %", QChar(QChar::Nbsp) + QString("%")));
    showRows();
}

/// What else has a colour of its own in the views: hatched violet and dark red cells, a thin red line.
void EdgeLegend::addOthers(QGridLayout& grid) {
    const auto addHatched = [&](const char* name, QColor colour, QColor stripes, const QString& about) {
        QPixmap hatch(16, 11);
        hatch.fill(colour);
        QPainter(&hatch).fillRect(hatch.rect(), QBrush(stripes, Qt::BDiagPattern));
        QLabel* words = addSign(grid, name);
        signOf(words)->setPixmap(onViewGround(hatch));
        words->setToolTip(about);
        return words;
    };
    missing_ =
        addHatched("legend-missing", QColor(112, 72, 160), QColor(24, 12, 36),
                   tr("Violet stripes in the images: no return, outside of the range window, or masked. The status bar counts each."));
    status_ = addHatched("legend-status", QColor(70, 20, 50), QColor(140, 60, 100),
                         tr("Dark red stripes in the images: the scanner sent a status code in place of a range."));
    QPixmap line(16, 11);
    line.fill(Qt::transparent);
    QPainter(&line).fillRect(QRect(0, 5, 16, 2), QColor(255, 90, 80));
    ray_ = addSign(grid, "legend-ray");
    signOf(ray_)->setPixmap(onViewGround(line));
    ray_->setText(tr("Laser ray to the marked cell"));
}

void EdgeLegend::showMissing(const Scan& scan) {
    const auto counts = countCells(scan);
    const auto of = [&](CellState state) { return counts[static_cast<std::size_t>(state)]; };
    const std::size_t none = of(CellState::NoReturn), others = of(CellState::OutOfWindow) + of(CellState::Masked);
    const auto show = [](QLabel& row, const QString& words, std::size_t cells) {
        row.setText(cells > 0 ? words.arg(countText(cells)) : QString());
    };
    show(*missing_, others == 0 ? tr("No return: %1") : tr("No range: %1"), none + others);
    show(*status_, tr("Status code: %1"), of(CellState::DeviceStatus));
}

EdgeLegend::Row EdgeLegend::addRow(QGridLayout& grid, const QString& name, const char* objectName) {
    Row row{new QCheckBox(name), new QLabel};
    row.box->setObjectName(objectName);
    row.box->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard focus in the view
    const int at = grid.rowCount();
    grid.addWidget(row.box, at, 0);
    grid.addWidget(row.count, at, 1, Qt::AlignRight);
    return row;
}

void EdgeLegend::showResult(const edges::Detection& detection) {
    showing_ = true;
    const bool known = detection.classes != nullptr;
    const bool chosen = edges::reads(detection.settings.method, edges::kReadsClasses);
    const auto counts = edges::countClasses(detection);
    const int classes = chosen ? detection.settings.classes : edges::traitsOf(detection.settings.method).classes;
    total_->setText(countText(detection.edges->size()));
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const bool counted = (classes & bitOf(n)) != 0;
        offered_[n] = known && (chosen || counted);
        rows_[n].box->setEnabled(chosen);
        rows_[n].box->setChecked(counted);
        rows_[n].count->setText(counted ? countText(counts[n + 1]) : QString());
    }
    known_ = known;
    isFilled_ = detection.filled != nullptr;
    showMissing(*detection.scan);
    taken_->setText(chosen && known ? textOfMovedCells(classes) : QString());
    showRows();
    if (detection.filled) filled_->setText(tr("▥ Filled, not measured: %1").arg(countText(detection.filled->cells.size())));
    show();
    showing_ = false;
}

/// The names of rows break into lines: a switch does not do so by itself.
void EdgeLegend::breakNames() {
    const int gap = static_cast<QGridLayout*>(layout())->horizontalSpacing();
    int counts = gap + total_->sizeHint().width();
    for (const Row& row : rows_) counts = std::max(counts, gap + row.count->sizeHint().width());
    for (std::size_t n = 0; n < rows_.size(); ++n) setBrokenText(*rows_[n].box, classLabel(n), brief_ ? QWIDGETSIZE_MAX : width() - counts);
}

void EdgeLegend::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    breakNames();
}

void EdgeLegend::showRows() {
    breakNames();
    const bool open = unfold_->isChecked();
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const QString count = rows_[n].count->text();
        const bool counts = !count.isEmpty() && count != "0"; // the rows add up to the total
        const bool shown = offered_[n] && open && (!brief_ || n < kOfRocks || n == kRimClass || counts);
        for (QWidget* each : {static_cast<QWidget*>(rows_[n].box), static_cast<QWidget*>(rows_[n].count)}) each->setVisible(shown);
    }
    for (std::size_t n = 0; n < kEdgeStrengths; ++n) // those that the limit leaves
        strengths_[n]->parentWidget()->setVisible(byStrength_ && open && !brief_ && (n == 0 || leastPercent_ < kStrengthFrom[n - 1]));
    byClass_->setVisible(known_ && !brief_ && open);
    unfold_->setVisible(known_);
    unfold_->setArrowType(brief_ ? Qt::NoArrow : open ? Qt::DownArrow : Qt::UpArrow);
    unfold_->setToolTip(open ? tr("Folds the legend") : tr("Unfolds the legend"));
    covered_->setVisible(isCovered_ && (open || !brief_));
    const QString words = (isCovered_ ? tr("Edges, under rocks") : tr("Edges")) + ' ' + total_->text(); // the number is that of the images
    const QFontMetrics letters = edges_->fontMetrics();
    edges_->setText(brief_ ? brokenText(words, letters, 3 * letters.horizontalAdvance(words) / 5) : tr("Edges"));
    total_->setHidden(brief_);
    filled_->setVisible(isFilled_ && (open || !brief_));
    for (QLabel* row : {missing_, status_}) row->parentWidget()->setVisible(!row->text().isEmpty() && open);
    ray_->parentWidget()->setVisible(open);
    taken_->setVisible(!taken_->text().isEmpty() && open);
}

/// What rocks cover needs no rows, unless the operator asks for them.
void EdgeLegend::showCovered(bool on) {
    if (std::exchange(isCovered_, on) != on && !brief_) fold();
    showTick();
    showRows();
}

void EdgeLegend::fold() {
    const QSignalBlocker quiet(unfold_);
    unfold_->setChecked(!brief_ && !isCovered_ && openAtDesk_);
}

/// In a cab the row with the button is the lowest, and begins with it: it stays under the finger while rows and words come and go.
void EdgeLegend::placeHead() {
    if (brief_) {
        int place = 0;
        for (QWidget* each : {static_cast<QWidget*>(unfold_), static_cast<QWidget*>(edges_), static_cast<QWidget*>(total_)})
            foot_->insertWidget(place++, each);
        return;
    }
    auto* grid = static_cast<QGridLayout*>(layout());
    auto* head = static_cast<QHBoxLayout*>(grid->itemAtPosition(0, 0)->layout()); // the arrow that folds is next to the word
    head->insertWidget(0, edges_);
    head->insertWidget(1, unfold_);
    grid->addWidget(total_, 0, 1, Qt::AlignRight);
}

void EdgeLegend::setBrief(bool on) {
    brief_ = on;
    fold();
    const int side = on ? kForGloves : kArrow;
    unfold_->setFixedSize(side, side);
    unfold_->setAutoRaise(!on);
    placeHead();
    paintSwatches();
    showRows();
}

void EdgeLegend::showColours(const EdgeColours& colours) {
    colours_ = colours;
    paintSwatches();
}

void EdgeLegend::showByClass(bool on) {
    showing_ = true;
    byClass_->setChecked(on);
    paintSwatches();
    showing_ = false;
}

void EdgeLegend::showEdges(bool on) {
    areOn_ = on;
    showTick();
}

/// The tick follows what the cloud shows.
void EdgeLegend::showTick() {
    showing_ = true;
    edges_->setChecked(areOn_ && !isCovered_);
    edges_->setToolTip(isCovered_ ? tr("Draws the edge points over the rocks") : tr("Edge points on and off: E"));
    showing_ = false;
}

void EdgeLegend::paintSwatches() {
    const EdgeColours drawn = drawnColours(colours_, byClass_->isChecked());
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        QPixmap swatch(16, 5);
        swatch.fill(Qt::transparent);
        QPainter painter(&swatch);
        painter.fillRect(swatch.rect(), drawn[n]);
        // Dashed like the rims in the images.
        if (n == kRimClass) painter.fillRect(QRect(6, 0, 4, 5), drawn[n].darker(200));
        painter.end();
        setSign(*rows_[n].box, swatch);
    }
    // Wide, narrower and dotted, as in the views.
    const EdgeColours strengths = strengthColours(colours_);
    for (int n = 0; n < static_cast<int>(kEdgeStrengths); ++n) {
        QPixmap sign(16, 11);
        sign.fill(Qt::transparent);
        QPainter line(&sign);
        const int wide = 6 - 2 * n, gap = n == kThinEdge ? 4 : 0;
        for (int x = 0; x < sign.width(); x += 4 + gap)
            line.fillRect(QRect(x, (sign.height() - wide) / 2, 4, wide), strengths[static_cast<std::size_t>(n)]);
        line.end();
        signOf(strengths_[static_cast<std::size_t>(n)])->setPixmap(onViewGround(sign));
    }
    // With gloves on the rows of the classes are folded: the switch of the edges shows their colours.
    QPixmap all(18, 8);
    QPainter painter(&all);
    for (int n = 0; n < static_cast<int>(kOfRocks); ++n) painter.fillRect(QRect(6 * n, 0, 6, 8), drawn[static_cast<std::size_t>(n)]);
    painter.end();
    setSign(*edges_, all);
    if (!brief_) edges_->setIcon({});
}

void EdgeLegend::emitClasses() {
    if (showing_) return;
    int classes = 0;
    for (std::size_t n = 0; n < rows_.size(); ++n) classes |= rows_[n].box->isChecked() ? bitOf(n) : 0;
    emit classesRequested(classes);
}

} // namespace edgescan::ui

#include "moc_edge_legend.cpp"
