// The legend of a comparison.
#include "ui/panels/change/change_legend.h"

#include "core/inspect/change_detection/change_report.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/panels/change/distance_view.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QRegularExpression>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace edgescan::ui {

namespace {

constexpr int kAround = 32;        // px: of the plate and of the view
constexpr int kBeforeName = 70;    // px of a row: switch, colour, gaps
constexpr int kBetweenButtons = 6; // px
constexpr int kForGloves = 48;     // px
constexpr int kBesideZoom = 80;    // px: of the zoom buttons of a cab
constexpr int kLeastLetters = 12;  // px

QString nameOf(ChangeRow row) {
    switch (row) {
    case ChangeRow::Gained:
        return ChangeLegend::tr("+ edges gained");
    case ChangeRow::Lost:
        return ChangeLegend::tr("− edges lost");
    case ChangeRow::Unchanged:
        return ChangeLegend::tr("edges kept (cells of B)");
    case ChangeRow::Unseen:
        return ChangeLegend::tr("? edges not seen in the other");
    case ChangeRow::Nearer:
        return ChangeLegend::tr("surface nearer than in A");
    default:
        return ChangeLegend::tr("surface farther than in A");
    }
}

/// Breaks lines that are wider, at blanks.
QString broken(const QString& text, const QFontMetrics& letters, int width) {
    static const QRegularExpression space("(?<!±) (?!(?:mm?|cm|m²)(?:\\W|$))"); // no line begins with a unit
    QString result;
    for (const QString& line : text.split('\n')) {
        QString begun;
        for (const QString& word : line.split(space)) {
            const QString longer = begun.isEmpty() ? word : begun + ' ' + word;
            if (begun.isEmpty() || letters.horizontalAdvance(longer) <= width) {
                begun = longer;
                continue;
            }
            result += begun + '\n';
            begun = word;
        }
        result += begun + '\n';
    }
    return result.chopped(1);
}

/// Where the edges of A are: the rows count those of B too, and an edge of one may be next to several of the other.
QString sumOf(const Comparison& comparison) {
    const inspect::EdgeChanges& edges = comparison.change.edges;
    const std::size_t all = comparison.earlier->detection->edges->size(), counted = edges.lost + edges.earlierUnchanged;
    return ChangeLegend::tr("A has %1 edge cells: %2 lost, %3 next to edges of B, %4 without a point of B")
        .arg(countText(all), countText(edges.lost), countText(edges.earlierUnchanged), countText(all - std::min(all, counted)));
}

QString outOfSpecWords() { return ChangeLegend::tr("▲ OUT OF SPEC"); }

QLabel* wordsOf(QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText); // line breaks are set in code: a plate over the cloud must know its height
    return label;
}

} // namespace

ChangeLegend::ChangeLegend(QWidget* parent)
    : ViewPlate(parent), title_(wordsOf(this, "change-title")), unit_(wordsOf(this, "change-unit")), how_(wordsOf(this, "change-how")),
      sum_(wordsOf(this, "change-sum")), overRocks_(wordsOf(this, "change-over-rocks")), region_(wordsOf(this, "change-region")),
      summary_(wordsOf(this, "change-summary")), byDistance_(new QCheckBox(tr("colour by distance from A"), this)),
      histogram_(new DistanceView(this)), distances_(wordsOf(this, "change-distances")), fold_(new QToolButton(this)),
      previous_(new QToolButton(this)), next_(new QToolButton(this)), end_(new QToolButton(this)) {
    setObjectName("change-legend");
    for (QLabel* label : {title_, how_, sum_, region_}) words_[label] = QString();
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    auto* content = new QWidget;
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(2);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    grid->addWidget(title_, 0, 0, 1, 2);
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
        made.box->setIconSize(swatch.size());
        made.box->setIcon(QIcon(swatch));
        grid->addWidget(made.box, n + 2, 0);
        grid->addWidget(made.count, n + 2, 1, Qt::AlignRight);
        connect(made.box, &QCheckBox::toggled, this, &ChangeLegend::emitRows);
    }
    byDistance_->setObjectName("change-by-distance");
    byDistance_->setFocusPolicy(Qt::TabFocus);
    connect(byDistance_, &QCheckBox::toggled, this, &ChangeLegend::distancesRequested);
    grid->addWidget(sum_, kChangeRows + 2, 0, 1, 2);
    grid->addWidget(how_, kChangeRows + 3, 0, 1, 2);
    setWords(*overRocks_, tr("Other points have the colours of rocks"));
    overRocks_->hide();
    grid->addWidget(overRocks_, kChangeRows + 4, 0, 1, 2);
    previous_->setToolTip(tr("Previous changed region"));
    previous_->setAccessibleName(previous_->toolTip());
    next_->setToolTip(tr("Next changed region"));
    next_->setAccessibleName(next_->toolTip());
    fold_->setObjectName("change-fold");
    fold_->setCheckable(true);
    end_->setObjectName("change-end");
    end_->setText(tr("End"));
    end_->setToolTip(tr("Ends the comparison: A is forgotten"));
    // At the foot, which stays where it is while the plate grows upwards.
    auto* foot = new QVBoxLayout;
    auto* buttons = new QHBoxLayout;
    foot->addWidget(byDistance_);
    foot->addLayout(switchOfTwo());
    foot->addLayout(buttons);
    for (QToolButton* button : {end_, fold_, previous_, next_}) { // what ends it is never where another button was
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button, 0, Qt::AlignBottom); // where it is when the legend unfolds
        if (button == fold_) buttons->addWidget(summary_);
    }
    buttons->addStretch(1); // they stay where they are when the plate gets wider
    summary_->setTextFormat(Qt::RichText);
    connect(fold_, &QToolButton::toggled, this, &ChangeLegend::showRows);
    connect(end_, &QToolButton::clicked, this, &ChangeLegend::endRequested);
    grid->addWidget(histogram_, kChangeRows + 5, 0, 1, 2);
    grid->addWidget(distances_, kChangeRows + 6, 0, 1, 2);
    grid->addWidget(region_, kChangeRows + 7, 0, 1, 2);
    setContent(*content, foot);
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
    row->addStretch(1);                               // they stay where they are, however wide the plate is
    followColours(*this, [this](const Theme& theme) { // a border too: colour is not the only sign
        const QString look = QString("QToolButton { border: 1px solid %1; padding: 2px 7px; }"
                                     "QToolButton:checked { background: %2; color: white; border: 2px solid %3; padding: 1px 6px; }")
                                 .arg(theme.edge.name(), theme.chosen.name(), theme.accent.name());
        for (QToolButton* each : shown_) each->setStyleSheet(look);
    });
    return row;
}

void ChangeLegend::showKept(const QString& before, const QString& now, const Comparison* comparison, bool working, bool refused) {
    before_ = before;
    now_ = now;
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
    howWords_ = how;
    setWords(*sum_, comparison != nullptr && comparison->isOfTwoScans() ? sumOf(*comparison) : QString());
    const auto distances = comparison != nullptr && rowsShown_ ? comparison->distances : nullptr;
    histogram_->showDistances(distances);
    hasDistances_ = distances != nullptr;
    if (distances)
        setWords(*distances_, tr("median distance to the points of A %1\n%2 are farther than %3")
                                  .arg(shortLength(distances->histogram.medianM))
                                  .arg(countText(distances->histogram.beyond))
                                  .arg(shortLength(distances->histogram.stepM * static_cast<double>(distances->histogram.counts.size()))));
    regions_ = comparison == nullptr ? 0 : comparison->change.regions.size();
    compared_ = comparison != nullptr;
    ofTwoScans_ = comparison != nullptr && comparison->isOfTwoScans();
    warned_ = comparison != nullptr && comparison->change.earlier.how.outOfSpec;
    if (!compared_) showRegion(QString());
    if (compared_ && !std::exchange(begun_, true)) foldInCab();
    showFlipped(flipped_);
    show();
    fit();
}

void ChangeLegend::setWords(QLabel& label, const QString& words) {
    words_[&label] = words;
    fit();
}

/// Breaks texts into lines that a narrow view has room for.
void ChangeLegend::fit() {
    if (parentWidget() == nullptr) return;
    const int line = parentWidget()->width() - kAround - (brief_ ? kBesideZoom : 0); // no bar is next to the buttons
    const int room = line - style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const std::array rest{region_, sum_, how_}; // they do not make the plate wider
    const auto isInRest = [&rest](const QLabel* label) { return std::ranges::find(rest, label) != rest.end(); };
    for (const auto& [label, words] : words_) label->setText(isInRest(label) ? QString() : broken(words, label->fontMetrics(), room));
    int counts = 0;
    for (const Row& row : rows_) counts = std::max(counts, row.count->sizeHint().width());
    for (int n = 0; n < kChangeRows; ++n) {
        QCheckBox& box = *rows_[static_cast<std::size_t>(n)].box;
        box.setText(broken(nameOf(static_cast<ChangeRow>(n)), box.fontMetrics(), room - counts - kBeforeName));
    }
    next_->setText(next_->toolTip());
    const auto buttonsWide = [this] {
        int wide = 0;
        // With room for any region: the buttons stay under the finger.
        summary_->setMinimumWidth(summary_->fontMetrics().horizontalAdvance(QString::fromUtf8("%1/%1 ■ +88.88 m").arg(regions_)));
        for (const QWidget* each : std::initializer_list<const QWidget*>{fold_, summary_, previous_, next_, end_})
            wide += each->isVisibleTo(this) ? std::max(each->sizeHint().width(), each->minimumWidth()) + kBetweenButtons : 0;
        return wide;
    };
    summary_->setFont(QFont()); // that of the plate
    if (brief_ || buttonsWide() > line) next_->setText(tr("Next"));
    QFont letters = summary_->font();
    for (int px = QFontInfo(letters).pixelSize(); buttonsWide() > line && px > kLeastLetters; --px) {
        letters.setPixelSize(px);
        summary_->setFont(letters);
    }
    const int buttons = buttonsWide();
    // The text of a region does not make the plate wider: its buttons stay under the pointer.
    const int wide = std::max(region_->parentWidget()->sizeHint().width(), std::min(buttons, line));
    for (QLabel* label : rest) label->setText(broken(words_.at(label), label->fontMetrics(), wide));
    // A and B alone have less to say: the switch between them stays under the pointer.
    const bool difference = rowsShown_ && !flipped_;
    setMinimumWidth(difference || brief_ ? 0 : std::min(ofDifference_, line));
    fitContent();
    if (difference) ofDifference_ = sizeHint().width();
}

bool ChangeLegend::event(QEvent* event) {
    if (event->type() == QEvent::HideToParent) begun_ = false;
    if (event->type() == QEvent::ParentChange && parentWidget() != nullptr) {
        parentWidget()->installEventFilter(this);
        fit();
    }
    return ViewPlate::event(event);
}

bool ChangeLegend::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == parentWidget()) showRows();
    return ViewPlate::eventFilter(watched, event);
}

/// In a cab the rows that count something: the plate must leave the rocks in sight. A warning is always there. Folded: the title and the
/// buttons.
void ChangeLegend::showRows() {
    const bool open = !fold_->isChecked() && !flipped_; // A has the colours of edges
    // The arrows of the style are too small for gloves.
    fold_->setArrowType(brief_ ? Qt::NoArrow : open ? Qt::DownArrow : Qt::UpArrow);
    previous_->setArrowType(brief_ ? Qt::NoArrow : Qt::LeftArrow);
    fold_->setText(!brief_ ? "" : open ? "▼" : "▲");
    previous_->setText(brief_ ? "◀" : "");
    for (QToolButton* each : {fold_, previous_}) each->setMinimumSize(brief_ ? QSize(kForGloves, kForGloves) : QSize(0, 0));
    fold_->setToolTip(open ? tr("Folds the legend") : tr("Unfolds the legend"));
    fold_->setAccessibleName(fold_->toolTip());
    fold_->setVisible(compared_ && rowsShown_ && !flipped_);
    next_->setVisible(regions_ > 0); // also over A and over B alone: the region is outlined there
    previous_->setVisible(regions_ > 0 && !isOneLine());
    title_->setVisible(!isOneLine());
    summary_->setVisible(isOneLine());
    summary_->setText(summaryText());
    region_->setVisible(!words_.at(region_).isEmpty() && !isOneLine());
    for (const Row& row : rows_) {
        const QString count = row.count->text();
        const bool shown = open && rowsShown_ && !count.isEmpty() && (!brief_ || count != "0");
        for (QWidget* each : {static_cast<QWidget*>(row.box), static_cast<QWidget*>(row.count)}) each->setVisible(shown);
    }
    const ShownOfTwo shown = flipped_ ? ShownOfTwo::A : rowsShown_ ? ShownOfTwo::Difference : ShownOfTwo::B;
    for (std::size_t n = 0; n < shown_.size(); ++n) {
        shown_[n]->setVisible(compared_ && !(isOneLine() && isLow()));
        shown_[n]->setMinimumSize(brief_ ? QSize(kForGloves, kForGloves) : QSize(0, 0));
        shown_[n]->setChecked(n == static_cast<std::size_t>(shown));
    }
    const bool all = hasRoom();
    sum_->setVisible(open && rowsShown_ && all && !words_.at(sum_).isEmpty());
    const Row& lost = rows_[static_cast<std::size_t>(ChangeRow::Lost)];
    for (QWidget* each : {static_cast<QWidget*>(lost.box), static_cast<QWidget*>(lost.count)}) each->setToolTip(words_.at(sum_));
    unit_->setVisible(open && compared_ && rowsShown_ && !brief_);
    how_->setVisible(!compared_ || (rowsShown_ && (warned_ || (open && !brief_))));
    const QString how = all || !compared_ ? howWords_ : howWords_.section('\n', 0, 1);
    words_[how_] = open || !warned_ ? how : outOfSpecWords();
    how_->setToolTip(how == howWords_ ? QString() : howWords_);
    byDistance_->setVisible(open && rowsShown_ && ofTwoScans_ && !brief_);
    histogram_->setVisible(open && hasDistances_);
    distances_->setVisible(open && hasDistances_);
    overRocks_->setVisible(open && overRocksOn_);
    fit();
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

bool ChangeLegend::isLow() const {
    constexpr int kLow = 480; // px
    return brief_ && parentWidget() != nullptr && parentWidget()->height() < kLow;
}

/// For the explanations too; else they are in tips, because the legend must not cover the changes that it counts.
bool ChangeLegend::hasRoom() const {
    constexpr int kRoomForAll = 720;                                                       // px
    return brief_ || parentWidget() == nullptr || parentWidget()->height() >= kRoomForAll; // a cab has no tips, and unfolds it on purpose
}

/// Open, it would cover the changes that it counts, and most of a low view.
void ChangeLegend::foldInCab() {
    if (brief_ && (regions_ > 0 || isLow())) fold_->setChecked(true);
}

void ChangeLegend::setBrief(bool on) {
    brief_ = on;
    if (!on) fold_->setChecked(false); // the desk has room for it
    if (on && compared_) foldInCab();  // before a comparison the view may not have its height
    showFlipped(flipped_);
}

void ChangeLegend::setRowsShown(bool on) { rowsShown_ = on; }

void ChangeLegend::showFlipped(bool flipped) {
    flipped_ = flipped;
    const bool both = !flipped && !brief_ && !now_.isEmpty();
    setWords(*title_,
             (flipped ? tr("On the screen: A, %1") : tr("A: %1")).arg(before_) + (both ? "\n" + tr("B: %1").arg(now_) : QString()));
    showRows();
}

void ChangeLegend::showOverRocks(bool on) {
    if (std::exchange(overRocksOn_, on) == on) return;
    showRows();
}

void ChangeLegend::showRegion(const QString& words, const QString& brief) {
    regionBrief_ = brief;
    setWords(*region_, words);
    showRows();
}

QString ChangeLegend::counted(ChangeRow row) const { return rows_[static_cast<std::size_t>(row)].count->text(); }
QString ChangeLegend::howText() const { return words_.at(how_); }
QString ChangeLegend::sumText() const { return words_.at(sum_); }
QString ChangeLegend::titleText() const { return words_.at(title_); }
QString ChangeLegend::regionText() const { return words_.at(region_); }

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
