// Keeps a picture, compares with it, flips between both.
#include "ui/controllers/comparing.h"

#include "core/base/tolerance_text.h"
#include "core/base/utc_time.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/grid/acquisition.h"
#include "ui/base/core_words.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/files/source.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/engine/worker_bridge/works.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/rocks/rock_picture.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kLongestName = 30; // characters

QString nameOf(const Picture& picture) { return scanName(picture.detection->scan->name); }

/// Name and time of one of two scans.
QString headOf(const Picture& picture, const Picture& other) {
    const auto& measured = picture.detection->scan->acquisition;
    const QString time = measured ? timeWords(measured->startUtc) : QString();
    return shownApart(nameOf(picture), nameOf(other), kLongestName) + (time.isEmpty() ? QString() : " · " + time);
}

/// One of two settings of a scan: its preset, or the values that the other has not.
QString headOf(const edges::Settings& settings, const edges::Settings& other) {
    for (const edges::Preset& preset : edges::builtInPresets()) {
        if (preset.settings == settings) return presetName(preset.name);
    }
    QStringList values;
    for (const edges::Parameter& parameter : edges::parameters()) {
        const std::string value = edges::choiceLabel(parameter, settings);
        if (value != edges::choiceLabel(parameter, other)) values << QObject::tr(parameter.label) + ' ' + QObject::tr(value.c_str());
    }
    return shownName(values.join(", "), kLongestName);
}

NamesOfTwo namesOf(const Picture& a, const Picture* b) {
    if (b == nullptr || b->detection == a.detection) return {shownName(nameOf(a), kLongestName), {}};
    if (a.detection->scan == b->detection->scan)
        return {headOf(a.detection->settings, b->detection->settings), headOf(b->detection->settings, a.detection->settings)};
    const auto startOf = [](const Picture& picture) {
        const auto& measured = picture.detection->scan->acquisition;
        return measured ? parseUtc(measured->startUtc) : std::nullopt;
    };
    const auto first = startOf(a), second = startOf(*b);
    return {headOf(a, *b), headOf(*b, a), first && second && *second < *first};
}

bool isTyping(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) != nullptr || qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
}

} // namespace

Result<std::shared_ptr<const Picture>> Comparing::pictureOf(const Reading& reading, const Asker& asker) {
    const auto& [scan, settings] = reading.from;
    if (reading.scan) return ui::pictureOf(reading.scan, settings);
    if (!inspect::hasPath(scan.kind)) return earlierDemo(scan.kind == inspect::SessionScan::Kind::DemoAfterBlast, settings);
    ReadingOptions options = scan.reading;
    options.progress = [&](const char* stage, double fraction) { return reading.show(asker, stage, fraction); };
    return earlierPicture(exactText(scan.path.string()), options, settings);
}

Comparing::Comparing(Engine& engine, LinkedViews& views, ChangeLegend& legend, Files& files, NoticeBar& notice, Preferences& preferences,
                     QUndoStack& undo)
    : engine_(engine), views_(views), legend_(legend), files_(files), notice_(notice), preferences_(preferences), undo_(undo),
      reader_(
          Urgency::Soon, [](const Reading& reading, const Asker& asker) { return pictureOf(reading, asker); },
          [this](const Reading& asked, const std::shared_ptr<const Read>& read) { finishReading(asked, *read); },
          [this](const QString& what) {
              finishReading({}, Error{what.toStdString(), "", "choose another scan"});
          }),
      comparer_(
          Urgency::Soon, [this](const ComparisonAsked& asked) { return compare(asked); },
          [this](const ComparisonAsked& asked, const std::shared_ptr<const Compared>& made) { finishComparison(asked, *made); },
          [this](const QString& what) {
              comparingWork_.reset();
              comparison_ = nullptr;
              show();
              showLegend();
              refuse(NoticeBar::Kind::Error, tr("The two pictures could not be compared (%1); keep a smaller scan.").arg(what));
          }) {
    connect(&legend_, &ChangeLegend::rowsRequested, this, [this](const ChangeRows& rows) {
        rows_ = rows;
        ask();
        emit rowsChanged();
    });
    connect(&views_, &LinkedViews::flippedChanged, this, [this](bool on) {
        legend_.showFlipped(on);
        if (!on) { // what was refused over A is possible again
            notice_.withdraw({LinkedViews::onlyOfB()});
            if (QToolTip::text() == LinkedViews::onlyOfB()) QToolTip::hideText();
        }
        emit flipped(on);
    });
    connect(&legend_, &ChangeLegend::shownRequested, this, [this](ShownOfTwo shown) {
        flip(shown == ShownOfTwo::A);
        if (shown != ShownOfTwo::A) setDifferenceShown(shown == ShownOfTwo::Difference);
    });
    connect(&legend_, &ChangeLegend::distancesRequested, this, [this](bool on) {
        byDistance_ = on;
        ask();
        emit byDistanceChanged(on);
    });
    connect(&legend_, &ChangeLegend::nextRegionRequested, this, &Comparing::nextRegion);
    connect(&legend_, &ChangeLegend::endRequested, this, &Comparing::end);
    connect(&legend_, &ChangeLegend::previousRegionRequested, this, &Comparing::previousRegion);
    connect(&engine_, &Engine::streamChanged, this, [this] {
        forgetDemo();
        if (!std::exchange(pairWanted_, false) || files_.demo() != true) return;
        inspect::EarlierScan before{{}, engine_.settings()};
        before.scan.kind = inspect::SessionScan::Kind::Demo;
        read(before, true);
    });
    QApplication::instance()->installEventFilter(this);
}

void Comparing::setRows(const ChangeRows& rows) { legend_.setRows(rows); }
void Comparing::setByDistance(bool on) { legend_.setByDistance(on); }

void Comparing::keep() {
    if (engine_.picture() == nullptr) {
        notice_.showHint(tr("There is no picture to keep yet: open a scan first."));
        return;
    }
    // On another scan the step is undone while A is there.
    push(stepName("Keep as A"), engine_.picture(), fromShown(), [this, here = engine_.hereNow()] { return pictureA_ || here(); });
}

void Comparing::forget(const std::function<bool()>& here) {
    if (!pictureA_) return;
    ViewPort& images = *views_.gray().viewPort();
    if (region_ && images.part() == regionPart_) images.fit(); // the operator did not move them since
    push(stepName("Forget A"), nullptr, std::nullopt, here);
}

/// Of two scans the other one can be opened: with a pair it may have been on the screen. What the operator ended does not begin again on
/// a later scan.
void Comparing::end() {
    const auto earlier = comparison_ && comparison_->isOfTwoScans() ? earlier_ : std::nullopt;
    forget(engine_.hereNow());
    if (earlier) {
        note(NoticeBar::Kind::Done,
             tr("The comparison ended: B, %1, is on the screen.").arg(scanName(engine_.picture()->detection->scan->name)));
        return notice_.offer(tr("Open A"), [this, scan = earlier->scan] { files_.openAgain(scan); });
    }
    notice_.showNotice(NoticeBar::Kind::Done, tr("The comparison ended: A was forgotten."));
    notice_.offerUndo(undo_);
}

/// The demo as A has nothing to do with a scan of the operator, and the demo before the blast, which the operator did not choose as A,
/// with any other scan than the one after it.
void Comparing::forgetDemo() {
    const bool ofPair = std::exchange(pairShown_, pairWanted_);
    if (!pictureA_ || !earlier_ || inspect::hasPath(earlier_->scan.kind)) return;
    if (files_.demo() && !(ofPair && earlier_->scan.kind == inspect::SessionScan::Kind::Demo)) return;
    const QString shown = scanName(engine_.picture()->detection->scan->name);
    const bool otherPlace = !files_.demo();
    forget();
    notice_.showNotice(NoticeBar::Kind::Warning, otherPlace ? tr("A was forgotten: the demo and %1 are not of one place.").arg(shown)
                                                            : tr("The comparison ended, because another scan was opened."));
    notice_.offerUndo(undo_);
}

void Comparing::push(const QString& what, const std::shared_ptr<const Picture>& after, const std::optional<inspect::EarlierScan>& from,
                     std::function<bool()> here) {
    // The picture may be freed when the step is undone: it is then made again.
    struct State {
        std::weak_ptr<const Picture> picture;
        bool some;
        std::optional<inspect::EarlierScan> from;
    };
    if (after) {
        setDifferenceShown(true); // a comparison begins with it
        emit begun();
    }
    const auto useState = [this](const State& state) {
        const auto picture = state.picture.lock();
        if (picture || !state.some)
            use(picture, state.from);
        else if (state.from)
            read(*state.from, false);
        return picture || !state.some || state.from; // else of a sweep that was not recorded to a file
    };
    undo_.push(
        new UndoStep<State>(what, {pictureA_, pictureA_ != nullptr, earlier_}, {after, after != nullptr, from}, useState, std::move(here)));
}

std::optional<inspect::EarlierScan> Comparing::fromShown() const {
    const edges::Detection& detection = *engine_.picture()->detection;
    const auto scan = files_.scanShown(*detection.scan);
    return scan ? std::optional(inspect::EarlierScan{*scan, detection.settings}) : std::nullopt;
}

void Comparing::use(std::shared_ptr<const Picture> kept, std::optional<inspect::EarlierScan> from) {
    flip(false);
    pictureA_ = std::move(kept);
    earlier_ = std::move(from);
    bySurfaces_ = false;
    comparison_ = nullptr;
    endNotes();
    show();
    emit pictureAChanged(pictureA_ != nullptr);
    ask();
    showLegend();
}

void Comparing::compareWith(const QString& path) {
    if (engine_.picture() == nullptr) {
        notice_.showHint(tr("There is nothing to compare with it yet: open the later scan first."));
        return;
    }
    notice_.showNotice(NoticeBar::Kind::Done, tr("Reading %1 as A").arg(shownName(path)));
    readingNote_ = notice_.text();
    ReadingOptions reading = files_.options();
    reading.scanIndex.reset(); // the index belongs to the file on the screen
    read({inspect::fileScan(exactBytes(path), reading), engine_.settings()}, true);
}

void Comparing::setPart(const std::optional<inspect::EarlierScan>& part) {
    if (part)
        read(*part, false);
    else if (pictureA_)
        forget();
}

void Comparing::read(const inspect::EarlierScan& from, bool asStep) {
    const std::optional<inspect::EarlierScan> shown = engine_.picture() ? fromShown() : std::nullopt;
    const bool same = shown && !from.scan.identity.sha256.empty() && shown->scan.identity.sha256 == from.scan.identity.sha256 &&
                      shown->scan.identity.name == from.scan.identity.name && shown->scan.path == from.scan.path &&
                      readingFlags(shown->scan.reading) == readingFlags(from.scan.reading);
    const QString name = inspect::hasPath(from.scan.kind) ? exactText(from.scan.path.filename().string()) : tr("the demo");
    readingWork_ = engine_.works().start(tr("Reading %1 as A").arg(name), [this] {
        reader_.giveUp();
        readingWork_.reset();
        notice_.showHint(tr("Cancelled; what was on the screen stays."));
    });
    const auto show = [this](const Asker& asker, const char* stage, double fraction) {
        return asker.show([this, stage, fraction] {
            if (readingWork_) readingWork_->progress(stageWords(stage), fraction);
        });
    };
    reader_.ask({from, same ? engine_.picture()->detection->scan : nullptr, asStep, show});
}

void Comparing::askScan() {
    const QString path =
        Files::askScan(notice_.window(), tr("Choose the earlier scan, A; the scan on the screen is the later one, B"), preferences_);
    if (!path.isEmpty()) compareWith(path);
}

void Comparing::swap() {
    if (!earlier_ || !engine_.picture() || !fromShown())
        return notice_.showHint(tr("A and B are exchanged when both are files: keep a scan as A and open another one."));
    const inspect::SessionScan next = earlier_->scan;
    const bool bySurfaces = bySurfaces_;
    use(engine_.picture(), fromShown()); // not a step: undone, it would compare B with itself
    bySurfaces_ = bySurfaces;
    files_.openAgain(next);
}

void Comparing::openDemoPair() {
    files_.openDemo(true);
    pairWanted_ = true;
}

/// Of the comparison that is shown, was refused or ended: the next one withdraws it.
void Comparing::note(NoticeBar::Kind kind, const QString& sentence) {
    notice_.showNotice(kind, sentence);
    notes_ << notice_.text();
    notice_.offer(tr("Forget A"), [this] { forget(); });
}

void Comparing::endNotes() {
    refused_ = false;
    notice_.withdraw(notes_);
    notes_.clear();
}

void Comparing::refuse(NoticeBar::Kind kind, const QString& sentence) {
    notice_.showNotice(kind, sentence);
    emit refused(sentence);
}

void Comparing::finishReading(const Reading& asked, const Read& read) {
    readingWork_.reset();
    if (!read) return refuse(NoticeBar::Kind::Error, exactText(read.error().sentence()));
    const std::shared_ptr<const Picture>& picture = *read;
    inspect::EarlierScan from = asked.from;
    const Scan& scan = *picture->detection->scan;
    const std::string& sha256 = from.scan.identity.sha256;
    if (!sha256.empty() && sha256 != scan.sha256) {
        return refuse(NoticeBar::Kind::Warning,
                      tr("A was not restored: %1 has changed since.").arg(shownName(exactText(from.scan.path.string()))));
    }
    from.scan.identity = inspect::notebookScan(scan);
    if (!asked.asStep) return use(picture, from);
    notice_.withdraw({readingNote_}); // others stay
    push(stepName("Compare with Earlier Scan"), picture, from);
}

bool Comparing::comparable() const {
    const std::shared_ptr<const Picture>& now = engine_.picture();
    return pictureA_ && now && pictureA_->detection != now->detection && !now->source.growth.growing;
}

void Comparing::followPicture() {
    if (!pictureA_) return;
    const auto& now = engine_.picture();
    if (comparison_ && comparison_->asked.now->detection->scan != now->detection->scan) comparison_ = nullptr;
    refused_ = false;
    if (!comparable()) comparison_ = nullptr;
    show();
    ask();
    showLegend();
}

void Comparing::ask() {
    if (pictureA_ && !comparable()) {
        comparingWork_.reset();
        return comparer_.giveUp();
    }
    if (!pictureA_) {
        comparingWork_.reset(); // what runs is of an A that was forgotten
    } else if (!comparingWork_) {
        comparingWork_ = engine_.works().start(tr("Comparing with A"), [this] {
            comparer_.giveUp();
            comparingWork_.reset();
            showLegend();
        });
    }
    const bool ofDemo = files_.demo() && earlier_ && !inspect::hasPath(earlier_->scan.kind); // simulated from one place
    comparer_.ask({pictureA_, engine_.picture(), rows_, ofDemo, bySurfaces_, byDistance_});
}

std::shared_ptr<const Comparing::Compared> Comparing::compare(const ComparisonAsked& asked) {
    std::shared_ptr<const Compared> made;
    if (asked.before) made = std::make_shared<const Compared>(compared(asked, last_.get()));
    last_ = made && *made ? **made : nullptr; // without A the cached results are dropped
    return made;
}

void Comparing::finishComparison(const ComparisonAsked& asked, const Compared& made) {
    comparingWork_.reset();
    if (!made) {
        const QString sentence = exactText(made.error().sentence());
        endNotes();
        note(NoticeBar::Kind::Error, sentence);
        refused_ = true;
        emit refused(sentence);
        comparison_ = nullptr; // A stays: the next scan may match it
        if (!asked.bySurfaces && onlyOneIsPlaced(asked)) {
            notice_.offer(tr("Line Up by Surfaces"), [this] {
                bySurfaces_ = true;
                ask();
            });
        }
    } else {
        const bool otherScans = !comparison_ || comparison_->asked.before != (*made)->asked.before;
        comparison_ = *made;
        refused_ = false;
        if (otherScans) {
            region_.reset();
            outlineRegion({});
            legend_.showRegion({});
            endNotes();
            QStringList warnings;
            for (const std::string& warning : comparison_->change.earlier.how.warnings) warnings << coreSentence(warning);
            if (!warnings.isEmpty()) note(NoticeBar::Kind::Warning, warnings.join('\n'));
        }
    }
    show();
    showLegend();
}

void Comparing::setDifferenceShown(bool on) {
    if (std::exchange(shown_, on) == on) return;
    show();
    showLegend();
    emit differenceShownChanged(on);
}

void Comparing::show() {
    views_.cloud().keepReady(comparison_ && comparison_->isOfTwoScans() ? comparison_->before->cloud : nullptr);
    if (!comparison_) outlineRegion({});
    if (!comparison_ || !shown_) return views_.remove(OverlayName::Comparison);
    Overlay overlay;
    overlay.name = OverlayName::Comparison;
    overlay.scan = comparison_->asked.now->detection->scan;
    overlay.edges = std::make_shared<const OverlayEdges>(
        OverlayEdges{comparison_->edges, changeColours(), comparison_->map, comparison_->overlay, false, tr("gained, lost and kept")});
    overlay.points = OverlayPoints{comparison_->points, overlay.scan->beams(), 0, true, comparison_->changed};
    views_.put(std::move(overlay));
}

void Comparing::showLegend() {
    legend_.setVisible(pictureA_ != nullptr);
    legend_.setRowsShown(shown_);
    if (!pictureA_) return;
    legend_.showKept(namesOf(*pictureA_, engine_.picture().get()), comparison_.get(), comparer_.behind(), refused_);
}

void Comparing::flip(bool on) {
    if (on == views_.flipped()) return;
    if (on && !comparison_) {
        emit flipped(false); // the menu entry checks itself when it is triggered
        notice_.showNotice(NoticeBar::Kind::Warning, pictureA_
                                                         ? tr("A and what is on the screen are the same, or are still being compared.")
                                                         : tr("Nothing is kept as A yet: Edges > Compare A/B > Keep This as A."));
        return;
    }
    views_.flipTo(on ? comparison_->before : nullptr);
}

const Picture* Comparing::drawnA() const { return views_.flipped() ? pictureA_.get() : nullptr; }

bool Comparing::eventFilter(QObject* watched, QEvent* event) {
    const bool leaves = event->type() == QEvent::WindowDeactivate && watched == notice_.window();
    if ((event->type() == QEvent::ApplicationDeactivate || (leaves && heldCode_ != 0)) && views_.flipped()) {
        heldCode_ = 0;
        flip(false);
    }
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    // On keyboards where the key needs AltGr, its release may be reported under another name.
    const bool isHeld = event->type() == QEvent::KeyRelease && heldCode_ != 0 && key->nativeScanCode() == heldCode_;
    if ((key->key() != Qt::Key_Backslash && !isHeld) || !watched->isWidgetType() || isTyping(QApplication::focusWidget())) return false;
    if (static_cast<QWidget*>(watched)->window() != notice_.window()) return false;
    if (!key->isAutoRepeat()) heldCode_ = event->type() == QEvent::KeyPress ? key->nativeScanCode() : 0;
    if (!key->isAutoRepeat() && (event->type() == QEvent::KeyPress) != views_.flipped()) flip(event->type() == QEvent::KeyPress);
    return true;
}

namespace {

constexpr int kLeastAround = 10; // cells around a region, as visible context

/// Only the cells of the region: other regions of its kind may be in the same box.
std::vector<std::uint32_t> cellsOf(const Grid<inspect::RangeChange>& kinds, const inspect::ChangedRegion& region) {
    std::vector<std::uint32_t> cells{region.cell};
    std::vector<bool> seen(kinds.size(), false);
    seen[region.cell] = true;
    for (std::size_t n = 0; n < cells.size(); ++n) {
        const int line = static_cast<int>(cells[n]) / kinds.beams, beam = static_cast<int>(cells[n]) % kinds.beams;
        for (int i = std::max(region.firstLine, line - 1); i <= std::min(region.lastLine, line + 1); ++i) {
            for (int j = std::max(region.firstBeam, beam - 1); j <= std::min(region.lastBeam, beam + 1); ++j) {
                const std::size_t k = kinds.index(i, j);
                if (seen[k] || kinds[k] != kinds[region.cell]) continue;
                seen[k] = true;
                cells.push_back(static_cast<std::uint32_t>(k));
            }
        }
    }
    return cells;
}

} // namespace

std::vector<std::uint32_t> Comparing::someOfRegion() const {
    if (!shown_ || !comparison_ || comparison_->change.regions.empty()) return {};
    constexpr int kSteps = 4;
    const inspect::ChangedRegion& region = comparison_->change.regions[region_.value_or(0)];
    const auto& kinds = comparison_->change.ranges.cells;
    std::vector<std::uint32_t> cells{region.cell};
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            const std::size_t k = kinds.index(region.firstLine + i * (region.lastLine - region.firstLine) / kSteps,
                                              region.firstBeam + j * (region.lastBeam - region.firstBeam) / kSteps);
            if (kinds[k] == kinds[region.cell]) cells.push_back(static_cast<std::uint32_t>(k));
        }
    }
    return cells;
}

void Comparing::goToRegion(int by) {
    if (comparison_ && !comparison_->change.earlier.how.measurable())
        return notice_.showHint(tr("The surfaces of the two scans do not fit, so no areas of change are given."));
    if (!comparison_ || comparison_->change.regions.empty()) {
        notice_.showHint(tr("No surface came nearer or went farther: keep a scan as A and open another one."));
        return;
    }
    const auto& regions = comparison_->change.regions;
    const std::size_t count = regions.size();
    const std::size_t n = region_ ? (*region_ + (by > 0 ? 1 : count - 1)) % count : (by > 0 ? 0 : count - 1);
    region_ = n;
    const inspect::ChangedRegion& region = regions[n];
    const auto& kinds = comparison_->change.ranges.cells;
    const QRect box(region.firstBeam, region.firstLine, region.lastBeam - region.firstBeam + 1, region.lastLine - region.firstLine + 1);
    const int around = std::max(kLeastAround, std::max(box.width(), box.height()) / 3);
    regionPart_ = QRectF(box.adjusted(-around, -around, around, around));
    // First the words: the cloud turns the region to where the legend with them leaves room, and the legend stays where it is.
    legend_.showRegion(
        (n == 0 ? tr("region %1 of %2, the largest by area: %3 by %4 m ± %5 m,\nnow at %7 m; %6 m² at the nearer surface, without its "
                     "border of one cell")
                : tr("region %1 of %2: %3 by %4 m ± %5 m,\nnow at %7 m; %6 m² at the nearer surface, without its border of one cell"))
            .arg(n + 1)
            .arg(count)
            .arg(region.farther ? tr("farther") : tr("nearer"))
            .arg(region.byM, 0, 'f', 2)
            .arg(shownTolerance(region.toleranceM, 2), 0, 'f', 2)
            .arg(region.areaM2, 0, 'f', 2)
            .arg(region.rangeM, 0, 'f', 2),
        QString("%1/%2 <span style='color:%3'>■</span> %4%5 m")
            .arg(n + 1)
            .arg(count)
            .arg(changeColour(region.farther ? ChangeRow::Farther : ChangeRow::Nearer).name(), region.farther ? "+" : "−")
            .arg(region.byM, 0, 'f', 2));
    views_.gray().viewPort()->fitTo(regionPart_);
    const std::vector<std::uint32_t> cells = cellsOf(kinds, region);
    views_.cloud().lookAtCells(cells);
    outlineRegion(cells);
}

/// Without cells it takes the outline away, unless that is of a rock by now.
void Comparing::outlineRegion(const std::vector<std::uint32_t>& cells) {
    if (cells.empty() && (!outlined_ || outlined_ != views_.cloud().outline())) return outlined_.reset();
    RockOutline outline;
    if (!cells.empty()) {
        const auto& kinds = comparison_->change.ranges.cells;
        Grid<std::uint32_t> mask(kinds.lines, kinds.beams);
        for (const std::uint32_t k : cells) mask[k] = 1;
        outline = outlineOf(mask, 1);
    }
    views_.setOutline(outline.sides, std::move(outline.cells));
    outlined_ = views_.cloud().outline();
}

} // namespace edgescan::ui

#include "moc_comparing.cpp"
