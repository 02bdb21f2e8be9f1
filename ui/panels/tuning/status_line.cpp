// The status bar.
#include "ui/panels/tuning/status_line.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kShowWorkAfterMs = 100;
constexpr int kBetween = 14;  // px between two facts
constexpr int kNarrow = 1000; // px

QString number(double value, int decimals) { return QString::number(value, 'f', decimals); }

QString rangeText(const edges::Probe& probe) {
    if (probe.filled)
        return QObject::tr("filled, not measured: %1 m ± %2 m")
            .arg(number(static_cast<double>(probe.filled->rangeMm) / 1000.0, 3),
                 number(shownTolerance(static_cast<double>(probe.filled->sdMm) / 1000.0, 3), 3));
    if (probe.state == CellState::Valid) return QObject::tr("range %1 m").arg(number(probe.rangeMm / 1000.0, 3));
    if (probe.state == CellState::DeviceStatus) return QObject::tr("device status %1").arg(number(probe.rangeMm, 0));
    return cellStateText(probe.state);
}

/// As long as the coordinates of this scan's cells: what is next to them has its place from the start.
edges::Probe longestProbe(const Scan& scan) {
    edges::Probe probe;
    probe.state = CellState::Valid;
    probe.rangeMm = static_cast<double>(rangeLimits(scan).maxMm);
    const double reachM = probe.rangeMm / 1000.0;
    probe.pointM = Eigen::Vector3d::Constant(-reachM);
    if (scan.placement) {
        const auto longer = [reachM](double at) { return std::abs(at - reachM) > std::abs(at + reachM) ? at - reachM : at + reachM; };
        probe.mineM = scan.placement->originEnhM.unaryExpr(longer);
    }
    probe.line = scan.lines() - 1;
    probe.beam = scan.beams() - 1;
    probe.gray = 255;
    if (std::holds_alternative<PolarGeometry>(scan.geometry)) probe.lineDeg = probe.beamDeg = -179.999;
    probe.edge = true;
    probe.kind = edges::DepthEdge::Concave;
    return probe;
}

} // namespace

ProbeTexts probeWords(const edges::Probe& probe) {
    ProbeTexts words;
    if (probe.mineM)
        words.place =
            QObject::tr("E %1  N %2  RL %3").arg(number(probe.mineM->x(), 3), number(probe.mineM->y(), 3), number(probe.mineM->z(), 3));
    if (probe.state == CellState::Valid)
        words.place +=
            (words.place.isEmpty() ? "" : "  ") +
            QObject::tr("x %1  y %2  z %3 m").arg(number(probe.pointM.x(), 3), number(probe.pointM.y(), 3), number(probe.pointM.z(), 3));
    const QString kind =
        probe.kind == edges::DepthEdge::None ? QString() : QString(" (%1)").arg(QObject::tr(edges::edgeClassLabel(probe.kind)));
    words.verdict = rangeText(probe) + "  " + (probe.edge ? QObject::tr("EDGE") + kind : QObject::tr("not an edge"));
    words.cell = QObject::tr("line %1  beam %2").arg(probe.line).arg(probe.beam);
    if (!std::isnan(probe.beamDeg)) words.cell += QObject::tr("  at %1° / %2°").arg(number(probe.lineDeg, 3), number(probe.beamDeg, 3));
    words.cell += QObject::tr("  gray %1").arg(probe.gray);
    return words;
}

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent), strip_(new QWidget), way_(new QBoxLayout(QBoxLayout::LeftToRight, strip_)), probe_(new QLabel),
      noPose_(new QToolButton), work_(new QWidget), stage_(new QLabel), bar_(new QProgressBar), changed_(new QMenu(this)) {
    setSizeGripEnabled(false);
    probe_->setObjectName("probe");
    probe_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // A long probe text must not widen the window.
    probe_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* line = new QHBoxLayout(work_);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(stage_);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(true);
    bar_->setFixedWidth(140);
    line->addWidget(bar_);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName("cancel-work");
    stage_->setObjectName("work-stage");
    connect(cancel, &QPushButton::clicked, this, &StatusLine::cancelRequested);
    line->addWidget(cancel);
    work_->hide();
    untilWorkIsShown_.setSingleShot(true);
    untilWorkIsShown_.setInterval(kShowWorkAfterMs);
    connect(&untilWorkIsShown_, &QTimer::timeout, this, &StatusLine::paintWork);

    auto* left = new QHBoxLayout;
    left->setSpacing(kBetween);
    left->addStrut(work_->sizeHint().height()); // the views keep their size when work begins and ends
    left->addWidget(work_);
    left->addWidget(probe_, 1);
    facts_ = new QHBoxLayout;
    facts_->setSpacing(kBetween);
    way_->setContentsMargins(kBetween / 2, 0, kBetween / 2, 0);
    way_->setSpacing(0);
    way_->addLayout(left, 1);
    way_->addLayout(facts_);
    strip_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the text adapts to the width, not the other way round
    addWidget(strip_, 1);
    for (const auto& [kind, name] : {std::pair{Fact::Incomplete, "incomplete"},
                                     {Fact::Place, "place"},
                                     {Fact::Counts, "counts"},
                                     {Fact::Recorded, "recorded"},
                                     {Fact::Box, "box"},
                                     {Fact::Settings, "settings"}}) {
        auto* label = new QLabel;
        label->setObjectName(name);
        // The text is never squeezed: it is shown completely or not at all.
        label->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
        label->hide();
        facts_->addWidget(label);
        factLabels_[static_cast<std::size_t>(kind)].label = label;
    }
    changed_->setObjectName("settings-changed");
    factLabel(Fact::Settings).label->installEventFilter(this);
    noPose_->setObjectName("no-pose");
    noPose_->setAutoRaise(true);
    noPose_->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard focus in the view
    noPose_->setText(tr("▲ no pose"));
    noPose_->setToolTip(
        tr("Without a pose, coordinates count from the scanner, not from the mine grid. Scan > Pose and Mounting… takes one."));
    noPose_->hide();
    connect(noPose_, &QToolButton::clicked, this, &StatusLine::poseRequested);
    addPinned(noPose_);
    QLabel* place = factLabel(Fact::Place).label;
    place->setCursor(Qt::PointingHandCursor);
    place->installEventFilter(this);
    QLabel* incomplete = factLabel(Fact::Incomplete).label;
    followColours(*incomplete, [incomplete](const Theme& theme) {
        incomplete->setStyleSheet(QString("color: %1; font-weight: bold;").arg(theme.bad.name()));
    });
}

void StatusLine::addPinned(QWidget* widget) {
    pinnedWidgets_.push_back(widget);
    facts_->insertWidget(0, widget);
    widget->installEventFilter(this);
}

void StatusLine::showFact(Fact fact, QStringList texts, bool always) {
    FactLabel& entry = this->factLabel(fact);
    texts.removeAll(QString());
    if (entry.texts == texts && entry.always == always) return;
    entry.texts = texts;
    entry.always = always;
    fit();
}

/// From left to right in the order of importance. Facts that do not fit get a shorter text and are then dropped, starting at the right end.
/// The place of the cell, its verdict, the mine grid, changed settings and warnings move to a second line before they are dropped.
void StatusLine::fit() {
    if (!isVisible()) return; // in a cab it has neither its letters nor its width
    const int withoutWork = strip_->width() - kBetween;
    const int whole = withoutWork - (work_->isHidden() ? 0 : work_->sizeHint().width() + kBetween);
    const QFontMetrics letters(probe_->font());
    const int left = letters.horizontalAdvance(longestMain_) + kBetween;
    const int withCell = letters.horizontalAdvance(longestWhole_) + kBetween;
    std::array<int, kFacts> forms{}; // which of its texts; the number of its texts: none
    const auto textOf = [&](std::size_t n) { return factLabels_[n].texts.value(forms[n]); };
    const auto textsOf = [&](std::size_t n) { return static_cast<int>(factLabels_[n].texts.size()); };
    const auto width = [&] {
        int sum = 0;
        for (const QWidget* widget : pinnedWidgets_) sum += widget->isHidden() ? 0 : widget->sizeHint().width() + kBetween;
        for (std::size_t n = 0; n < kFacts; ++n) {
            const QString text = textOf(n);
            QFont font = factLabels_[n].label->font();
            if (!text.isEmpty()) sum += QFontMetrics(font).horizontalAdvance(text) + 2 + kBetween;
        }
        return sum;
    };
    const auto shorten = [&](int room, bool counts) {
        for (int form = 1; form <= (counts ? 2 : 1); ++form) {
            for (std::size_t n = kFacts; n-- > 0 && width() > room;) forms[n] = std::max(forms[n], std::min(form, textsOf(n) - 1));
        }
        for (std::size_t n = kFacts; n-- > 0 && width() > room;) {
            const bool stays = factLabels_[n].always || (!counts && n == static_cast<std::size_t>(Fact::Counts));
            if (!stays) forms[n] = textsOf(n);
        }
    };
    // For line and beam of the cell all other facts may be dropped except the counts. The counts are dropped only for warnings.
    shorten(whole - withCell, false);
    shorten(whole - left, true);
    // Work that begins or ends moves nothing: its row is there. A narrow window makes room for its words.
    const bool two = width() > (strip_->width() < kNarrow ? whole : withoutWork) - left;
    if (two) {
        forms = {};
        shorten(whole, true);
    }
    way_->setDirection(two ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    for (std::size_t n = 0; n < kFacts; ++n) {
        const QString text = textOf(n);
        factLabels_[n].label->setText(text);
        factLabels_[n].label->setVisible(!text.isEmpty());
    }
    probe_->setText(probeIn(std::max(0, two ? whole : whole - width())));
}

/// Parts that do not fit are left out from the end: gray, angles, line and beam. No number is cut.
QString StatusLine::probeIn(int room) const {
    const QFontMetrics letters(probe_->font());
    QStringList more = probeMore_.split("  ", Qt::SkipEmptyParts);
    const auto text = [&] { return (QStringList(probeMain_) + more).join("  "); };
    while (!more.isEmpty() && letters.horizontalAdvance(text()) > room) {
        more.removeLast();
        if (more.size() == 1) more.clear(); // line and beam go together
    }
    return letters.elidedText(text(), Qt::ElideRight, room);
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    fit();
}

bool StatusLine::event(QEvent* event) {
    const bool done = QStatusBar::event(event);
    if (event->type() == QEvent::LayoutRequest) fit();
    if (event->type() == QEvent::Show || event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &StatusLine::fit, Qt::QueuedConnection); // when its labels have the letters of the theme
    return done;
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    QLabel* settings = factLabel(Fact::Settings).label;
    if (watched == settings && event->type() == QEvent::MouseButtonRelease && !changed_->isEmpty()) {
        changed_->popup(settings->mapToGlobal(QPoint(0, -changed_->sizeHint().height())));
        return true;
    }
    if (watched == factLabel(Fact::Place).label && event->type() == QEvent::MouseButtonRelease) {
        emit poseRequested();
        return true;
    }
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide || event->type() == QEvent::Resize)
        QMetaObject::invokeMethod(this, &StatusLine::fit, Qt::QueuedConnection);
    return QStatusBar::eventFilter(watched, event);
}

QString StatusLine::mainOf(const ProbeTexts& words, Cell cell) {
    const QString whose = cell == Cell::Pointer    ? QString()
                          : cell == Cell::Pin      ? tr("Pinned:") + " "
                          : cell == Cell::MovedPin ? tr("Pinned nearby:") + " "
                                                   : QString("A: ");
    return whose + words.place + (words.place.isEmpty() ? "" : "  ") + words.verdict;
}

void StatusLine::showProbe(const std::optional<edges::Probe>& probe, Cell cell) {
    const ProbeTexts words = probe ? probeWords(*probe) : ProbeTexts{};
    probeMain_ = probe ? mainOf(words, cell) : QString();
    probeMore_ = words.cell;
    reserve(probeMain_, probeMore_);
    fit();
    probe_->setToolTip(probeShown()); // whole, where a narrow window leaves parts out
}

/// Widgets at the right must not move, appear and disappear with the mouse.
void StatusLine::reserve(const QString& main, const QString& more) {
    const QFontMetrics letters(probe_->font());
    const auto keep = [&letters](QString& longest, const QString& text) {
        if (letters.horizontalAdvance(text) > letters.horizontalAdvance(longest)) longest = text;
    };
    keep(longestMain_, main);
    keep(longestWhole_, main + "  " + more);
}

void StatusLine::showPlace(const Scan& scan, bool growing) {
    longestMain_ = longestWhole_ = QString();
    const ProbeTexts longest = probeWords(longestProbe(scan));
    reserve(mainOf(longest, Cell::MovedPin), longest.cell);
    reserve(probeMain_, probeMore_);
    const auto incomplete = std::ranges::find_if(scan.warnings, [](const std::string& w) { return w.starts_with("INCOMPLETE"); });
    const bool part = !growing && incomplete != scan.warnings.end();
    const QString howMuch = part ? "✕ " + coreSentence(*incomplete).section(QRegularExpression("[:;,.]"), 0, 0) : QString();
    showFact(Fact::Incomplete, {howMuch, part ? tr("✕ INCOMPLETE") : QString()}, part);
    QLabel& label = *factLabel(Fact::Place).label;
    noPose_->setHidden(scan.placement != nullptr);
    if (!scan.placement) return showFact(Fact::Place, {}, false);
    const Placement& place = *scan.placement;
    QString grid = tr("mine grid");
    if (!place.grid.empty()) grid += " " + shownName(exactText(place.grid), 40);
    const QString spec = place.outOfSpec ? tr("OUT OF SPEC") : QString();
    const QString text = grid + tr(" · origin E %1 N %2 RL %3")
                                    .arg(number(place.originEnhM.x(), 0), number(place.originEnhM.y(), 0), number(place.originEnhM.z(), 0));
    showFact(Fact::Place, {spec.isEmpty() ? text : text + " · " + spec, spec.isEmpty() ? grid : "▲ " + spec}, true);
    QStringList about{tr("A click opens the pose, to change or remove it."), tr("Placed by %1").arg(shownText(place.source)), text};
    for (const std::string& warning : place.warnings) about << coreSentence(warning);
    label.setToolTip(about.join("\n"));
}

void StatusLine::showTimeOf(const Scan& scan, bool live) {
    const std::string start = scan.acquisition ? scan.acquisition->startUtc : std::string();
    if (live || start.empty()) return showFact(Fact::Recorded, {}, false); // the badge of the source says "no time"
    showFact(Fact::Recorded, {tr("first line %1").arg(shownText(start)), tr("first line %1").arg(shownText(start).left(10))}, false);
    factLabel(Fact::Recorded).label->setToolTip(tr("First line, by %1").arg(shownText(scan.acquisition->clockSource)));
}

void StatusLine::showCounts(const edges::Detection& detection) {
    const auto cells = countCells(*detection.scan);
    const auto of = [&](CellState state) { return cells[static_cast<std::size_t>(state)]; };
    const QString edges = tr("%1 edge cells").arg(countText(detection.edges->size()));
    const QString none = tr("%1 no return").arg(countText(of(CellState::NoReturn)));
    QString text = tr("%1 points").arg(countText(of(CellState::Valid))) + " · " + edges + " · " + none;
    if (of(CellState::DeviceStatus) > 0) text += tr(" · %1 status").arg(countText(of(CellState::DeviceStatus)));
    for (const CellState state : {CellState::OutOfWindow, CellState::Masked, CellState::Lost}) {
        if (of(state) > 0) text += QString(" · %1 %2").arg(countText(of(state)), cellStateText(state));
    }
    if (detection.filled) text += tr(" · %1 filled").arg(countText(detection.filled->cells.size()));
    showFact(Fact::Counts, {text, edges + " · " + none, edges}, false);
    factLabel(Fact::Counts).label->setToolTip(text + "\n" + tr("Edges found in %1 ms").arg(number(detection.totalMs, 1)));
}

void StatusLine::showCountsToCome(std::optional<std::size_t> cells) {
    const QString text = cells ? tr("%1 cells · edges pending").arg(countText(*cells)) : QString();
    showFact(Fact::Counts, {text, cells ? tr("edges pending") : QString()}, false);
    factLabel(Fact::Counts).label->setToolTip(text);
}

void StatusLine::showBox(const QString& words) { showFact(Fact::Box, {words}, false); }

void StatusLine::showSettings(const edges::Settings& settings, const rocks::RockSettings& ofRocks, bool own) {
    std::vector<std::pair<std::string, QString>> changes; // key, and "Crease angle: 37 instead of 30"
    const auto add = [&](const auto& p, const std::string& now, const std::string& usual) {
        if (now != usual)
            changes.emplace_back(p.key, tr("%1: %2 instead of %3").arg(QObject::tr(p.label), shownText(now), shownText(usual)));
    };
    for (const std::string& key : edges::changedFromDefault(settings)) {
        const edges::Parameter& p = *edges::findParameter(key);
        add(p, edges::formatValue(p, p.get(settings)), edges::formatValue(p, p.get(edges::Settings{})));
    }
    for (const rocks::RockParameter& p : rocks::rockParameters())
        add(p, fixedText(p.get(ofRocks), p.decimals), fixedText(p.get(rocks::RockSettings{}), p.decimals));
    const QString set = QString("%1 %2").arg(QString(edges::kDefaultSet.name)).arg(edges::kDefaultSet.version);
    QLabel& label = *factLabel(Fact::Settings).label;
    const bool menu = own && !changes.empty();
    const QString more = menu ? QString(" ▾") : QString();
    showFact(Fact::Settings,
             {changes.empty() ? tr("default settings") : tr("settings: %1 changed").arg(changes.size()) + more,
              changes.empty() ? QString() : tr("%1 changed").arg(changes.size()) + more},
             !changes.empty());
    label.setCursor(menu ? Qt::PointingHandCursor : Qt::ArrowCursor);
    changed_->clear();
    QStringList about{tr("Set of default settings: %1").arg(set)};
    for (const auto& [key, change] : changes) {
        about << change;
        if (menu) changed_->addAction(tr("Reset %1").arg(change), this, [this, key = shownText(key)] { emit resetRequested(key); });
    }
    if (menu) {
        changed_->addSeparator();
        changed_->addAction(tr("Reset all") + "\tCtrl+D", this, [this] { emit resetRequested({}); });
    }
    about << (changes.empty() ? tr("All settings are those of the default set.") : tr("Ctrl+D restores the default settings."));
    label.setToolTip(about.join("\n"));
}

void StatusLine::showWork(const QString& title, const QString& stage, double fraction) {
    workTitle_ = title;
    workStage_ = stage;
    workFraction_ = fraction;
    if (!work_->isHidden())
        paintWork();
    else if (!untilWorkIsShown_.isActive())
        untilWorkIsShown_.start();
}

void StatusLine::paintWork() {
    constexpr int kLongestTitle = 40, kLongestStage = 30; // characters
    const QString title = shownName(workTitle_, kLongestTitle);
    stage_->setText(workStage_.isEmpty() ? title : title + ": " + shownName(workStage_, kLongestStage));
    bar_->setValue(static_cast<int>(std::lround(workFraction_ * 1000)));
    work_->show();
    fit();
}

void StatusLine::endWork() {
    untilWorkIsShown_.stop();
    work_->hide();
    fit();
}

QString StatusLine::probeShown() const { return probeMore_.isEmpty() ? QString() : probeMain_ + "  " + probeMore_; }
QString StatusLine::placeShown() const { return noPose_->isHidden() ? factLabel(Fact::Place).texts.value(0) : noPose_->text(); }
QString StatusLine::recordedShown() const { return factLabel(Fact::Recorded).texts.value(0); }
QString StatusLine::settingsShown() const { return factLabel(Fact::Settings).texts.value(0); }
QString StatusLine::countsShown() const { return factLabel(Fact::Counts).texts.value(0); }

} // namespace edgescan::ui

#include "moc_status_line.cpp"
