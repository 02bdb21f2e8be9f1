// The legend of a comparison.
#include "ui/panels/change/change_legend.h"

#include "core/inspect/change_detection/change_report.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/base/tool_tips.h"
#include "ui/panels/change/comparison.h"
#include "ui/views/cloud/cloud_colours.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QRegularExpression>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kBarsHigh = 44, kUnderBars = 18, kWide = 220; // px
constexpr int kBesideCount = 6;                             // px
constexpr int kForGloves = 48;                              // px
constexpr int kLeastLetters = 12;                           // px

QString nameOf(ChangeRow row) {
    switch (row) {
    case ChangeRow::Gained:
        return ChangeLegend::tr("+ edges gained");
    case ChangeRow::Lost:
        return ChangeLegend::tr("− edges lost");
    case ChangeRow::Unchanged:
        return ChangeLegend::tr("edges kept");
    case ChangeRow::Unseen:
        return ChangeLegend::tr("? edges not seen");
    case ChangeRow::Nearer:
        return ChangeLegend::tr("surface nearer");
    default:
        return ChangeLegend::tr("surface farther");
    }
}

/// Where the edges of each are: the rows count those of both, and an edge of one may be next to several of the other.
QString sumOf(const Comparison& comparison) {
    const inspect::EdgeChanges& edges = comparison.change.edges;
    const auto sum = [](const QString& words, std::size_t all, std::size_t changed, std::size_t kept) {
        return words.arg(countText(all), countText(changed), countText(kept), countText(all - std::min(all, changed + kept)));
    };
    return sum(ChangeLegend::tr("A has %1 edge cells: %2 lost, %3 next to edges of B, %4 without a point of B"),
               comparison.earlier->detection->edges->size(), edges.lost, edges.earlierUnchanged) +
           '\n' +
           sum(ChangeLegend::tr("B has %1 edge cells: %2 gained, %3 kept, %4 without a point of A"),
               comparison.asked.now->detection->edges->size(), edges.gained, edges.unchanged);
}

QString outOfSpecWords() { return ChangeLegend::tr("▲ OUT OF SPEC"); }

/// No line begins with a unit, or ends with "±".
QString unitsKept(QString text) {
    static const QRegularExpression space("(?<=±) | (?=(?:mm?|cm|m²)(?:\\W|$))");
    return text.replace(space, QChar(QChar::Nbsp));
}

QLabel* wordsOf(QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

} // namespace

/// The histogram of distances between two clouds, in the colours of the points. Bars of the square root of the counts: a few changed
/// surfaces stay visible next to many that are the same.
class DistanceView : public QWidget {
public:
    explicit DistanceView(QWidget* parent = nullptr);

    /// Null: nothing to show.
    void showDistances(std::shared_ptr<const SurfaceDistances> distances);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::shared_ptr<const SurfaceDistances> distances_;
};

DistanceView::DistanceView(QWidget* parent) : QWidget(parent) {
    setObjectName("change-histogram");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMinimumSize(sizeHint());
    hide();
}

QSize DistanceView::sizeHint() const { return {kWide, kBarsHigh + kUnderBars}; }

void DistanceView::showDistances(std::shared_ptr<const SurfaceDistances> distances) {
    distances_ = std::move(distances);
    setVisible(distances_ != nullptr);
    update();
}

void DistanceView::paintEvent(QPaintEvent*) {
    if (!distances_) return;
    QPainter painter(this);
    const inspect::DistanceHistogram& histogram = distances_->histogram;
    // Up to the end of the colour scale; the last bar has what is farther.
    const auto shown = static_cast<std::size_t>(
        std::clamp(std::ceil(distances_->scaleM / histogram.stepM), 1.0, static_cast<double>(histogram.counts.size())));
    std::vector<std::size_t> bars(histogram.counts.begin(), histogram.counts.begin() + static_cast<std::ptrdiff_t>(shown));
    std::size_t farther = histogram.beyond;
    for (std::size_t n = shown; n < histogram.counts.size(); ++n) farther += histogram.counts[n];
    bars.push_back(farther);
    const double most = std::sqrt(static_cast<double>(std::max<std::size_t>(1, *std::ranges::max_element(bars))));
    const double wide = static_cast<double>(width()) / static_cast<double>(bars.size());
    for (std::size_t n = 0; n < bars.size(); ++n) {
        const double high = kBarsHigh * std::sqrt(static_cast<double>(bars[n])) / most;
        const QRectF bar(static_cast<double>(n) * wide, kBarsHigh - high, std::max(1.0, wide - 1.0), high);
        painter.fillRect(bar, QColor(colourAt(static_cast<double>(n) / static_cast<double>(bars.size() - 1))));
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect under(0, kBarsHigh, width(), kUnderBars);
    painter.drawText(under, Qt::AlignLeft | Qt::AlignVCenter, "0");
    painter.drawText(under, Qt::AlignRight | Qt::AlignVCenter, "≥ " + shortLength(distances_->scaleM));
}

ChangeLegend::ChangeLegend(QWidget* parent)
    : QWidget(parent), title_(wordsOf(this, "change-title")), unit_(wordsOf(this, "change-unit")), how_(wordsOf(this, "change-how")),
      sum_(wordsOf(this, "change-sum")), overRocks_(wordsOf(this, "change-over-rocks")), region_(wordsOf(this, "change-region")),
      summary_(wordsOf(this, "change-summary")), byDistance_(new QCheckBox(tr("colour by distance from A"), this)),
      histogram_(new DistanceView(this)), distances_(wordsOf(this, "change-distances")), fold_(new QToolButton(this)),
      previous_(new QToolButton(this)), next_(new QToolButton(this)), end_(new QToolButton(this)), buttons_(new QWidget(this)) {
    setObjectName("change-legend");
    auto* content = new QWidget;
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kBesideCount);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    unit_->setText(tr("cells"));
    grid->addWidget(unit_, 1, 1, Qt::AlignRight);
    for (int n = 0; n < kChangeRows; ++n) {
        const auto row = static_cast<ChangeRow>(n);
        Row& made = rows_[static_cast<std::size_t>(n)];
        made = {new QCheckBox, new QLabel};
        made.box->setObjectName(QString("change-%1").arg(n));
        made.count->setObjectName(QString("change-count-%1").arg(n));
        made.box->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard focus in the view
        made.box->setChecked(true);
        QPixmap swatch(16, row == ChangeRow::Nearer || row == ChangeRow::Farther ? 11 : 5);
        swatch.fill(changeColour(row));
        setSign(*made.box, swatch);
        grid->addWidget(made.box, n + 2, 0);
        grid->addWidget(made.count, n + 2, 1, Qt::AlignRight);
        connect(made.box, &QCheckBox::toggled, this, &ChangeLegend::emitRows);
    }
    byDistance_->setObjectName("change-by-distance");
    byDistance_->setFocusPolicy(Qt::TabFocus);
    connect(byDistance_, &QCheckBox::toggled, this, &ChangeLegend::distancesRequested);
    overRocks_->setText(tr("Other points have the colours of rocks"));
    overRocks_->hide();
    previous_->setToolTip(tr("Previous changed region"));
    previous_->setAccessibleName(previous_->toolTip());
    next_->setToolTip(tr("Next changed region"));
    next_->setAccessibleName(next_->toolTip());
    fold_->setObjectName("change-fold");
    fold_->setCheckable(true);
    end_->setObjectName("change-end");
    end_->setText(tr("End"));
    end_->setToolTip(tr("Ends the comparison: A is forgotten"));
    auto* foot = new QVBoxLayout(buttons_);
    foot->setContentsMargins(0, 0, 0, 0);
    auto* buttons = new QHBoxLayout;
    foot->addLayout(switchOfTwo());
    foot->addLayout(buttons);
    foot->addWidget(byDistance_);
    for (QToolButton* button : {end_, fold_, previous_, next_}) { // what ends it is never where another button was
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button, 0, Qt::AlignBottom); // where it is when the legend unfolds
        if (button == fold_) buttons->addWidget(summary_);
    }
    buttons->addStretch(1);
    summary_->setTextFormat(Qt::RichText);
    summary_->setWordWrap(false);
    connect(fold_, &QToolButton::toggled, this, &ChangeLegend::showRows);
    connect(end_, &QToolButton::clicked, this, &ChangeLegend::endRequested);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(buttons_);
    column->addWidget(title_);
    column->addWidget(content);
    for (QWidget* each : std::initializer_list<QWidget*>{sum_, how_, overRocks_, histogram_, distances_, region_}) column->addWidget(each);
    connect(previous_, &QToolButton::clicked, this, &ChangeLegend::previousRegionRequested);
    connect(next_, &QToolButton::clicked, this, &ChangeLegend::nextRegionRequested);
    hide();
}

/// A, the difference, B: as in docs/guide/compare.md.
QHBoxLayout* ChangeLegend::switchOfTwo() {
    const std::array<std::pair<QString, QString>, 3> words{{{"A", tr("Shows A; hold \\ for a short look")},
                                                            {tr("Difference"), tr("Shows B with what changed since A")},
                                                            {"B", tr("Shows B alone")}}};
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    for (std::size_t n = 0; n < shown_.size(); ++n) {
        shown_[n] = new QToolButton(this);
        shown_[n]->setObjectName(QString("change-shown-%1").arg(n));
        shown_[n]->setText(words[n].first);
        shown_[n]->setToolTip(words[n].second);
        shown_[n]->setCheckable(true);
        shown_[n]->setFocusPolicy(Qt::TabFocus);
        row->addWidget(shown_[n]);
        connect(shown_[n], &QToolButton::clicked, this, [this, n] {
            emit shownRequested(static_cast<ShownOfTwo>(n));
            showRows(); // a refused choice
        });
    }
    row->addStretch(1);
    followColours(*this, [this](const Theme& theme) { // a border too: colour is not the only sign
        const QString look = QString("QToolButton { border: 1px solid %1; padding: 2px 7px; }"
                                     "QToolButton:checked { background: %2; color: white; border: 2px solid %3; padding: 1px 6px; }")
                                 .arg(theme.edge.name(), theme.chosen.name(), theme.accent.name());
        for (QToolButton* each : shown_) each->setStyleSheet(look);
    });
    return row;
}

void ChangeLegend::showKept(const NamesOfTwo& names, const Comparison* comparison, bool working, bool refused) {
    names_ = names;
    for (int n = 0; n < kChangeRows; ++n) {
        const bool ofSurfaces = n >= static_cast<int>(ChangeRow::Nearer);
        const Row& row = rows_[static_cast<std::size_t>(n)];
        const bool some = comparison != nullptr && (row.box->objectName() != "change-3" || comparison->count(ChangeRow::Unseen) > 0);
        const bool shown = some && (!ofSurfaces || comparison->isOfTwoScans());
        row.count->setText(shown ? countText(comparison->count(static_cast<ChangeRow>(n))) : QString());
        row.count->setEnabled(!working); // what is not of this picture is gray
    }
    for (QLabel* each : {sum_, distances_, region_, summary_}) each->setEnabled(!working);
    QString how = working   ? comparison == nullptr ? tr("comparing …") : tr("comparing …\nGray counts are older.")
                    : refused ? tr("not compared with the scan on the screen")
                            : tr("nothing to compare with yet:\nchange a setting, or open another scan");
    if (comparison != nullptr && !working) {
        how = coreWords(inspect::registrationText(comparison->change.earlier.how)).replace("; ", "\n");
        if (comparison->change.earlier.how.outOfSpec) how = outOfSpecWords() + '\n' + how;
        if (comparison->isOfTwoScans())
            how += '\n' + tr("median difference along the beams %1 mm\na change is more than %2 mm at 5 m")
                              .arg(comparison->change.differMm, 0, 'f', 0)
                              .arg(inspect::kChangeSigmas * comparison->change.noise.at(5.0), 0, 'f', 0);
    }
    howWords_ = unitsKept(how);
    sum_->setText(comparison != nullptr && comparison->isOfTwoScans() ? sumOf(*comparison) : QString());
    const auto distances = comparison != nullptr && rowsShown_ ? comparison->distances : nullptr;
    histogram_->showDistances(distances);
    hasDistances_ = distances != nullptr;
    if (distances)
        distances_->setText(
            unitsKept(tr("median distance to the points of A %1\n%2 are farther than %3")
                          .arg(shortLength(distances->histogram.medianM))
                          .arg(countText(distances->histogram.beyond))
                          .arg(shortLength(distances->histogram.stepM * static_cast<double>(distances->histogram.counts.size())))));
    regions_ = comparison == nullptr ? 0 : comparison->change.regions.size();
    compared_ = comparison != nullptr;
    ofTwoScans_ = comparison != nullptr && comparison->isOfTwoScans();
    warned_ = comparison != nullptr && comparison->change.earlier.how.outOfSpec;
    if (!compared_) showRegion(QString());
    if (compared_ && !std::exchange(begun_, true)) foldInCab();
    showFlipped(flipped_);
    show();
}

/// The names of rows break into lines: a switch does not do so by itself.
void ChangeLegend::breakNames() {
    setBrokenText(*byDistance_, tr("colour by distance from A"), width());
    int counts = 0;
    for (const Row& row : rows_) counts = std::max(counts, kBesideCount + row.count->sizeHint().width());
    for (int n = 0; n < kChangeRows; ++n)
        setBrokenText(*rows_[static_cast<std::size_t>(n)].box, nameOf(static_cast<ChangeRow>(n)), width() - counts);
}

void ChangeLegend::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    breakNames();
}

bool ChangeLegend::event(QEvent* event) {
    if (event->type() == QEvent::HideToParent) begun_ = false;
    return QWidget::event(event);
}

/// In a cab the rows that count something: the rocks must stay in sight. A warning is always there. Folded: the title and the
/// buttons.
void ChangeLegend::showRows() {
    breakNames();
    const bool open = !fold_->isChecked() && !flipped_; // A has the colours of edges
    // The arrows of the style are too small for gloves.
    fold_->setArrowType(brief_ ? Qt::NoArrow : open ? Qt::DownArrow : Qt::UpArrow);
    previous_->setArrowType(brief_ ? Qt::NoArrow : Qt::LeftArrow);
    next_->setArrowType(brief_ ? Qt::NoArrow : Qt::RightArrow);
    fold_->setText(!brief_ ? "" : open ? "▼" : "▲");
    previous_->setText(brief_ ? "◀" : "");
    next_->setText(brief_ ? tr("Next") : QString());
    for (QToolButton* each : {fold_, previous_}) each->setMinimumSize(brief_ ? QSize(kForGloves, kForGloves) : QSize(0, 0));
    fold_->setToolTip(open ? tr("Folds the legend") : tr("Unfolds the legend"));
    fold_->setAccessibleName(fold_->toolTip());
    fold_->setVisible(compared_ && rowsShown_ && !flipped_);
    next_->setVisible(regions_ > 0); // also over A and over B alone: the region is outlined there
    previous_->setVisible(regions_ > 0 && !isOneLine());
    title_->setVisible(!isOneLine());
    summary_->setVisible(isOneLine());
    summary_->setText(summaryText());
    region_->setVisible(!region_->text().isEmpty() && !isOneLine());
    for (const Row& row : rows_) {
        const QString count = row.count->text();
        const bool shown = open && rowsShown_ && !count.isEmpty() && (!brief_ || count != "0");
        for (QWidget* each : {static_cast<QWidget*>(row.box), static_cast<QWidget*>(row.count)}) each->setVisible(shown);
    }
    const ShownOfTwo shown = flipped_ ? ShownOfTwo::A : rowsShown_ ? ShownOfTwo::Difference : ShownOfTwo::B;
    for (std::size_t n = 0; n < shown_.size(); ++n) {
        shown_[n]->setVisible(compared_ && !isOneLine());
        shown_[n]->setMinimumSize(brief_ ? QSize(kForGloves, kForGloves) : QSize(0, 0));
        shown_[n]->setChecked(n == static_cast<std::size_t>(shown));
    }
    sum_->setVisible(open && rowsShown_ && !sum_->text().isEmpty());
    const Row& lost = rows_[static_cast<std::size_t>(ChangeRow::Lost)];
    for (QWidget* each : {static_cast<QWidget*>(lost.box), static_cast<QWidget*>(lost.count)}) each->setToolTip(sum_->text());
    unit_->setVisible(open && compared_ && rowsShown_ && !brief_);
    how_->setVisible(!compared_ || (rowsShown_ && (warned_ || (open && !brief_))));
    how_->setText(open || !warned_ ? howWords_ : outOfSpecWords());
    byDistance_->setVisible(open && rowsShown_ && ofTwoScans_ && !brief_);
    histogram_->setVisible(open && hasDistances_);
    distances_->setVisible(open && hasDistances_);
    overRocks_->setVisible(open && overRocksOn_);
}

/// The region that was visited last, with what the two colours mean.
QString ChangeLegend::summaryText() const {
    const auto meaning = [](ChangeRow row, const QString& words) {
        return QString("<span style='color:%1'>■</span>&nbsp;%2").arg(changeColour(row).name(), QString(words).replace(' ', "&nbsp;"));
    };
    const QString more = ofTwoScans_ ? tr("nearer") : nameOf(ChangeRow::Gained),
                  less = ofTwoScans_ ? tr("farther") : nameOf(ChangeRow::Lost);
    const QString head = regionBrief_.isEmpty() ? tr("Changes: %1").arg(countText(regions_)).replace(' ', "&nbsp;") : regionBrief_;
    return head + "<br>" + meaning(ChangeRow::Gained, more) + "<br>" + meaning(ChangeRow::Lost, less);
}

bool ChangeLegend::isOneLine() const { return brief_ && compared_ && rowsShown_ && regions_ > 0 && !flipped_ && fold_->isChecked(); }

/// Open, it would take the room of the view with the changes that it counts.
void ChangeLegend::foldInCab() {
    if (brief_ && regions_ > 0) fold_->setChecked(true);
}

void ChangeLegend::setBrief(bool on) {
    brief_ = on;
    QFont letters = font(); // of its three lines, next to buttons for gloves
    if (on) letters.setPixelSize(kLeastLetters);
    summary_->setFont(letters);
    // They stay under the pointer: a column grows downwards, the strip of a cab upwards.
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->removeWidget(buttons_);
    column->insertWidget(on ? column->count() : 0, buttons_);
    if (!on) fold_->setChecked(false); // the desk has room for it
    if (on && compared_) foldInCab();  // before a comparison the view may not have its height
    showFlipped(flipped_);
}

void ChangeLegend::setRowsShown(bool on) { rowsShown_ = on; }

void ChangeLegend::showFlipped(bool flipped) {
    flipped_ = flipped;
    const QString a = (names_.reversed ? tr("A, after: %1") : tr("A, before: %1")).arg(names_.a),
                  b = (names_.reversed ? tr("B, before: %1") : tr("B, after: %1")).arg(names_.b);
    const bool onlyB = compared_ && !rowsShown_;
    title_->setText(flipped              ? tr("On the screen: %1").arg(a)
                    : onlyB              ? tr("On the screen: %1").arg(b)
                    : names_.b.isEmpty() ? tr("A: %1").arg(names_.a) // nothing to compare with yet
                    : brief_             ? a
                                         : a + '\n' + b);
    showRows();
}

void ChangeLegend::showOverRocks(bool on) {
    if (std::exchange(overRocksOn_, on) == on) return;
    showRows();
}

void ChangeLegend::showRegion(const QString& words, const QString& brief) {
    regionBrief_ = brief;
    region_->setText(unitsKept(words));
    showRows();
}

QString ChangeLegend::counted(ChangeRow row) const { return rows_[static_cast<std::size_t>(row)].count->text(); }
QString ChangeLegend::howText() const { return how_->text(); }
QString ChangeLegend::sumText() const { return sum_->text(); }
QString ChangeLegend::titleText() const { return title_->text(); }
QString ChangeLegend::regionText() const { return region_->text(); }

void ChangeLegend::setRows(const ChangeRows& rows) {
    for (std::size_t n = 0; n < rows.size(); ++n) rows_[n].box->setChecked(rows[n]);
}

void ChangeLegend::setByDistance(bool on) { byDistance_->setChecked(on); }

void ChangeLegend::emitRows() {
    ChangeRows rows{};
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n] = rows_[n].box->isChecked();
    emit rowsRequested(rows);
}

} // namespace edgescan::ui

#include "moc_change_legend.cpp"
