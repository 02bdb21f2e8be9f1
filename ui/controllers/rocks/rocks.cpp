// Shows rocks in all views.
#include "ui/controllers/rocks/rocks.h"

#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/sight.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QGuiApplication>
#include <QMenu>
#include <QPushButton>
#include <QStringList>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kBetweenSweepsMs = 800; // in a sweep, rocks are at most this old plus the time to find them

bool severalWanted() { return QGuiApplication::keyboardModifiers().testFlag(Qt::ControlModifier); }

} // namespace

Rocks::Rocks(Engine& engine, LinkedViews& views, RocksPanel& panel, RockTable& table, NoticeBar& notice, Preferences& preferences,
             QUndoStack& undo)
    : engine_(engine), views_(views), panel_(panel), table_(table), notice_(notice), preferences_(preferences), undo_(undo),
      drag_(views, this), tip_(views), sidecar_(this),
      cutter_(
          Urgency::Now,
          [](const CutAsked& asked) {
              return rocks::cutAlong(*asked.of->study.segmentation, asked.of->study.map, asked.line, asked.chosen);
          },
          [this](const CutAsked& asked, const auto& cut) { applyCut(asked, *cut); },
          [this](const QString& what) {
              notice_.showNotice(NoticeBar::Kind::Error, tr("the rock could not be cut (%1); close other programs.").arg(what));
              writeWaiting();
          }) {
    nextOfSweep_.setSingleShot(true);
    nextOfSweep_.setInterval(kBetweenSweepsMs);
    connect(&nextOfSweep_, &QTimer::timeout, this, &Rocks::followPicture);
    connect(&engine_, &Engine::placePendingChanged, this, &Rocks::showCard);
    connect(&finder_, &RockFinder::found, this, &Rocks::storePicture);
    connect(&finder_, &RockFinder::failed, this, [this](const QString& what) {
        notice_.showNotice(NoticeBar::Kind::Error,
                           tr("the rocks could not be computed (%1); close other programs or open a smaller scan.").arg(what));
        refuseWaiting();
    });
    connect(&panel_, &RocksPanel::edited, this, &Rocks::change);
    const auto choose = [this](const std::vector<std::uint32_t>& labels) {
        std::vector<std::size_t> cells;
        for (const std::uint32_t label : labels) {
            if (const rocks::Rock* rock = picture_ ? picture_->rock(label) : nullptr) cells.push_back(rock->cell);
        }
        select(std::move(cells));
        if (views_.cloud().outline()) bringIntoSight(views_.cloud(), *views_.cloud().outline());
    };
    connect(&table_, &RockTable::chosen, this, choose);
    connect(&table_, &RockTable::filterChanged, this, &Rocks::ask);
    connect(&table_, &RockTable::jumpRequested, this, &Rocks::lookAt);
    connect(&table_, &RockTable::exportRequested, this, &Rocks::askExport);
    connect(&table_, &RockTable::menuRequested, this, [this](std::uint32_t label, const QPoint& position) {
        views_.openMenu(position, inspect::exactly(picture_->rock(label)->cell));
    });
    RockCard& card = panel_.card();
    connect(&card, &RockCard::closeRequested, this, [this] { select({}); });
    connect(&card, &RockCard::rockRequested, this, [choose](std::uint32_t label) { choose({label}); });
    connect(&card, &RockCard::splitRequested, this, [this](bool on) { useTool(on ? RockTool::Split : RockTool::None); });
    connect(&card, &RockCard::cutRequested, this, [this](bool on) { useTool(on ? RockTool::Cut : RockTool::None); });
    connect(&card, &RockCard::mergeRequested, this, &Rocks::mergeOffered);
    connect(&card, &RockCard::nameRequested, this, &Rocks::nameRequested);
    connect(&card, &RockCard::sectionRequested, this, &Rocks::sectionRequested);
    connect(&card, &RockCard::markRequested, this, &Rocks::callChosen);
    connect(this, &Rocks::toolChanged, &card, [&card](RockTool tool) {
        card.split()->setChecked(tool == RockTool::Split);
        card.cut()->setChecked(tool == RockTool::Cut);
    });
    connect(&sidecar_, &RockSidecar::found, this, &Rocks::applyPreset);
    connect(&sidecar_, &RockSidecar::readEnded, this, [this] {
        followPicture();
        setPart(std::exchange(restored_, std::nullopt));
    });
    connect(&sidecar_, &RockSidecar::merged, this, &Rocks::adopt);
    connect(&sidecar_, &RockSidecar::failed, this,
            [this](const QString& sentence) { notice_.showNotice(NoticeBar::Kind::Warning, sentence); });
    connect(&drag_, &CellDrag::drawn, this, [this](const std::vector<QPoint>& cells) { views_.setTrail({cells, cells}); });
    connect(&drag_, &CellDrag::finished, this, &Rocks::applyStroke);
    connect(&drag_, &CellDrag::stepped, this, &Rocks::stepPiece);
    connectViews();
}

void Rocks::connectViews() {
    for (ImageView* view : {&views_.gray(), &views_.edges()}) {
        connect(view, &ImageView::hovered, this, [this, view](int line, int beam) { point(views_.cellAt(line, beam), view); });
        connect(view, &ImageView::hoverLeft, this, [this, view] { point(std::nullopt, view); });
    }
    connect(&views_, &LinkedViews::cellMenuOpens, this, &Rocks::addToMenu);
    connect(&views_, &LinkedViews::pinChanged, this, &Rocks::followPin);
    CloudView& cloud = views_.cloud();
    connect(&cloud, &CloudView::hovered, this, [this, &cloud](qint64 cell) { point(static_cast<std::size_t>(cell), &cloud); });
    connect(&cloud, &CloudView::hoverLeft, this, [this, &cloud] { point(std::nullopt, &cloud); });
    connect(&views_, &LinkedViews::clicked, this, &Rocks::click);
    connect(&views_, &LinkedViews::toolChanged, this, [this] {
        if (views_.tool() != Tool::Pin && tool_ != RockTool::None) useTool(RockTool::None);
    });
}

void Rocks::setShown(bool on) {
    if (on == on_) return;
    on_ = on;
    if (on)
        followPicture();
    else
        forget();
    views_.setChoosesOnly(on); // a click means a rock, until Pin is chosen
    emit shownChanged(on);
}

void Rocks::forget() {
    useTool(RockTool::None);
    nextOfSweep_.stop();
    picture_ = nullptr;
    asked_ = nullptr;
    familyPicture_ = nullptr;
    judgedFrom_ = nullptr;
    selected_.clear();
    largestWanted_ = false;
    point(std::nullopt, nullptr);
    show();
    refuseWaiting();
}

bool Rocks::ofAnotherPicture() const { return !picture_ || !engine_.picture() || picture_->detection != engine_.picture()->detection; }

bool Rocks::working() const { return sidecar_.reading() || finder_.behind() || cutter_.behind(); }

bool Rocks::behind() const { return on_ && engine_.picture() != nullptr && (working() || ofAnotherPicture()); }

void Rocks::followPicture() {
    const std::shared_ptr<const Picture>& shown = engine_.picture();
    if (!shown) return;
    stream_ = shown->source.stream;
    const std::string key = scanKey(shown.get());
    if (std::exchange(key_, key) != key) { // read again, a scan keeps its edits
        edits_.clear();
        restored_.reset();
        settings_.region.clear();
        sidecar_.follow(nullptr);
        sidecarAsked_ = false;
        finder_.forget();
        if (on_) forget();
    }
    if (!on_) return;
    if (!std::exchange(sidecarAsked_, true)) {
        const bool isFile = shown->source.growth.sweep < 0;
        sidecar_.follow(isFile ? shown->detection->scan : nullptr);
    }
    if (sidecar_.reading()) return show();
    if (asked_ != shown->detection) {
        if (shown->source.growth.growing && nextOfSweep_.isActive()) {
            show(); // the former rocks stay, marked as older
            return;
        }
        ask();
        if (shown->source.growth.growing) nextOfSweep_.start();
    }
    show();
}

void Rocks::ask() {
    if (!on_ || !engine_.picture()) return;
    asked_ = engine_.picture()->detection;
    finder_.ask({asked_, settings_, edits_, table_.filter()});
}

void Rocks::useSettings(const rocks::RockSettings& settings) {
    if (settings == settings_) return;
    settings_ = settings;
    panel_.showSettings(settings);
    sidecar_.keep(settings_, edits_);
    ask();
    emit changed();
}

void Rocks::applyPreset(const rocks::Preset& preset) {
    if (preset.settings) settings_ = *preset.settings;
    edits_ = preset.edits;
    panel_.showSettings(settings_);
    emit changed();
}

void Rocks::adopt(const rocks::Preset& mine, const rocks::Preset& theirs) {
    const rocks::Preset now = rocks::mergedPreset(mine, {settings_, edits_, mine.sha256}, theirs);
    settings_ = *now.settings;
    edits_ = now.edits;
    panel_.showSettings(settings_);
    ask();
    emit changed();
    notice_.showHint(tr("Another window changed the rocks of this scan. The changes of both windows are kept."));
}

void Rocks::storePicture(const std::shared_ptr<const RockPicture>& picture) {
    // An answer about another scan, or after rocks were switched off, is dropped.
    if (!on_ || !engine_.picture() || (finder_.behind() && picture->detection->scan != engine_.picture()->detection->scan)) return;
    const bool wasOnRock = pinnedOnRock();
    picture_ = picture;
    show();
    if (!wasOnRock && selected_.empty()) selectPinned();
    judgeEdit();
    emit rocksShown();
    if (std::exchange(largestWanted_, false)) lookAtLargest();
    writeWaiting();
}

QString Rocks::remark() const {
    QStringList words;
    if (engine_.picture() && picture_) {
        const Growth& growth = engine_.picture()->source.growth;
        const int lines = picture_->labels.lines;
        if (growth.growing || growth.expectedLines > lines) words << tr("▲ of the first %1 lines").arg(lines);
        if (!growth.growing && ofAnotherPicture()) // of a sweep that grows the number of lines says it
            words << tr("▲ of the picture before; being computed again");
    }
    if (on_ && engine_.picture() && !picture_) words << tr("being computed …");
    if (on_ && !engine_.picture()) words << tr("open a scan first");
    if (const QString assumed = picture_ ? assumedText(*picture_->detection->scan) : QString(); !assumed.isEmpty()) words << assumed;
    return words.join(" · ");
}

void Rocks::show() {
    table_.show(picture_, remark());
    panel_.showResult(picture_.get(), remark());
    showFaces();
    showSelection();
}

void Rocks::showFaces() {
    if (!on_) return views_.remove(OverlayName::Rocks);
    Overlay overlay;
    overlay.name = OverlayName::Rocks;
    overlay.points = OverlayPoints{nullptr, 0, kOutsideRocks, false};
    if (picture_) {
        overlay.faces = picture_->faces;
        overlay.facesFaded = ofAnotherPicture();
        overlay.points->colours = picture_->points;
        overlay.points->beams = picture_->labels.beams;
    }
    views_.put(std::move(overlay));
}

/// The rock of the chosen target is selected with it, until another target or another rock is chosen.
void Rocks::followPin(std::optional<std::size_t> cell) {
    const auto was = std::exchange(pinned_, cell);
    if (cell || (was && selected_ == std::vector{*was})) selectPinned();
}

bool Rocks::pinnedOnRock() const { return picture_ && pinned_ && picture_->labelAt(*pinned_) != 0; }

void Rocks::selectPinned() {
    if (pinnedOnRock() || !selected_.empty()) select(pinnedOnRock() ? std::vector{*pinned_} : std::vector<std::size_t>());
}

void Rocks::setTargets(const RockNames& targets, const std::vector<inspect::PinnedTarget>& pinned) {
    pinnedTargets_ = pinned;
    table_.setNames(names());
    if (std::exchange(targets_, targets) != targets) showCard();
}

/// Of the targets that have one.
RockNames Rocks::names() const {
    RockNames names;
    for (const inspect::PinnedTarget& target : pinnedTargets_) {
        if (!target.name.empty()) names.emplace_back(target.cell, shownName(exactText(target.name)));
    }
    return names;
}

void Rocks::showCard() {
    if (picture_)
        panel_.card().show(*picture_, selected_, behind() || engine_.placePending(), targets_, names());
    else
        panel_.card().hide();
}

/// One thing is chosen: a target that is not on the only selected rock is not the chosen one any more.
void Rocks::select(std::vector<std::size_t> cells) {
    if (cells.empty()) useTool(RockTool::None);
    if (cells.size() == 1 && picture_ && pinned_ && picture_->regionAt(*pinned_) != picture_->regionAt(cells.front()))
        views_.pin(std::nullopt);
    selected_ = std::move(cells);
    showSelection();
}

void Rocks::showSelection() {
    std::vector<std::uint32_t> labels;
    RockOutline outline;
    if (picture_) {
        for (const std::size_t cell : selected_) {
            const std::uint32_t label = picture_->labelAt(cell);
            if (label == 0 || std::find(labels.begin(), labels.end(), label) != labels.end()) continue;
            labels.push_back(label);
            const RockOutline one = outlineOf(picture_->labels, label);
            outline.sides.insert(outline.sides.end(), one.sides.begin(), one.sides.end());
            outline.cells.insert(outline.cells.end(), one.cells.begin(), one.cells.end());
        }
    }
    showCard();
    table_.select(labels);
    std::sort(outline.cells.begin(), outline.cells.end());
    views_.setOutline(outline.sides, std::move(outline.cells));
    emit selectionChanged();
}

void Rocks::point(std::optional<std::size_t> cell, const QObject* from) {
    if (tool_ == RockTool::Split && cell && picture_ && picture_->regionAt(*cell) != nullptr) {
        choosePieceAt(*cell);
        return showPiece(from);
    }
    const rocks::Rock* rock = picture_ && cell ? picture_->rockAt(*cell) : nullptr;
    if (rock == nullptr) return tip_.hide();
    tip_.show(*cell, rockTip(*rock), from);
}

void Rocks::click(const inspect::ClickedCell& click) {
    if (!picture_ || views_.tool() != Tool::Pin) return;
    if (tool_ == RockTool::Split) return splitAt(click.clicked);
    if (!severalWanted() && !views_.clickPins() && tool_ == RockTool::None) {
        if (const auto rock = rockCellAt(click)) return select({*rock});
        return notice_.showHint(tr("No rock was found here: choose Pin to set a target."));
    }
    if (!severalWanted()) return tool_ == RockTool::None ? selectPinned() : void(); // also if this target was the chosen one
    const std::size_t cell = rockCellAt(click).value_or(click.clicked);
    std::vector<std::size_t> cells = selected_;
    const auto sameRock = [&](std::size_t other) {
        return picture_->regionAt(cell) != nullptr && picture_->regionAt(other) == picture_->regionAt(cell);
    };
    const auto was = std::find_if(cells.begin(), cells.end(), sameRock);
    if (was != cells.end())
        cells.erase(was);
    else
        cells.push_back(cell);
    select(std::move(cells));
}

std::optional<std::size_t> Rocks::rockCellAt(const inspect::ClickedCell& click) const {
    if (!picture_) return std::nullopt;
    for (const std::size_t cell : {click.cell, click.clicked}) {
        if (cell < picture_->labels.size() && picture_->labelAt(cell) != 0) return cell;
    }
    return std::nullopt;
}

/// Other controllers add what they do with a rock: they find the menu by its name.
void Rocks::addToMenu(QMenu& menu, const inspect::ClickedCell& click) {
    if (!picture_ || behind()) return;
    const auto at = rockCellAt(click);
    const std::size_t cell = at.value_or(click.cell);
    const auto callIt = [this, cell](bool rock) {
        return [this, cell, rock] {
            select({cell});
            callChosen(rock);
        };
    };
    if (!at) {
        menu.addAction(tr("This Is a Roc&k"), this, callIt(true))->setEnabled(picture_->regionAt(cell) != nullptr);
        return;
    }
    const std::uint32_t label = picture_->labelAt(cell);
    QMenu* rock = menu.addMenu(tr("&Rock %1").arg(label));
    rock->setObjectName(kRockMenu);
    const auto isOther = [&](std::size_t other) { return picture_->labelAt(other) != label; };
    rock->addAction(tr("Se&lect"), this, [this, cell] { select({cell}); });
    rock->addAction(tr("&Merge with Selected Rocks"), this,
                    [this, cell] {
                        std::vector<std::size_t> cells = selected_;
                        cells.push_back(cell);
                        select(std::move(cells));
                        mergeSelected();
                    })
        ->setEnabled(std::ranges::any_of(selected_, isOther));
    rock->addAction(tr("&Split Here"), this, [this, cell] { splitAt(cell); });
    rock->addAction(tr("&Cut along a Line"), this, [this, cell] {
        select({cell});
        useTool(RockTool::Cut);
    });
    rock->addAction(tr("&Wall, Not a Rock"), this, callIt(false));
    rock->addAction(tr("&Export Rocks…"), this, [this] { askExport(); });
}

void Rocks::lookAt(std::uint32_t label) {
    const rocks::Rock* rock = picture_ ? picture_->rock(label) : nullptr;
    if (rock == nullptr) return;
    const std::size_t cell = rock->cell;
    views_.pin(std::nullopt); // the rock is chosen instead of a target, which may be on it
    select({cell});
    ViewPort& images = *views_.gray().viewPort();
    if (!images.fitted()) images.centreOn(QPointF(views_.placeOf(cell)) + QPointF(0.5, 0.5)); // else all of it is in sight
    constexpr double kRecognised = 0.12;                                                      // of the view's height
    if (views_.cloud().outline()) bringIntoSight(views_.cloud(), *views_.cloud().outline(), kRecognised);
}

void Rocks::lookAtLargest() {
    setShown(true);
    largestWanted_ = picture_ == nullptr;
    if (!picture_ || picture_->study.rocks.empty()) return;
    const rocks::Rock& largest = std::ranges::max(picture_->study.rocks, {}, &rocks::Rock::shortestCaliperM);
    lookAt(largest.label);
    if (largest.label == 1) return;
    notice_.showNotice(NoticeBar::Kind::Done, tr("Rock %1 has the largest visible width b, %2 m. Rock 1 has the largest visible area.")
                                                  .arg(QString::number(largest.label), QString::number(largest.shortestCaliperM, 'f', 2)));
}

void Rocks::lookAtNextSmaller() {
    const rocks::Rock* now = picture_ && !selected_.empty() ? picture_->rockAt(selected_.back()) : nullptr;
    if (now == nullptr) return lookAtLargest();
    const auto order = [](const rocks::Rock& rock) { return std::make_pair(-rock.shortestCaliperM, rock.label); };
    const rocks::Rock* next = nullptr;
    for (const rocks::Rock& each : picture_->study.rocks) {
        if (order(each) > order(*now) && (next == nullptr || order(each) < order(*next))) next = &each;
    }
    if (next == nullptr) return notice_.showHint(tr("No rock has a smaller visible width b."));
    lookAt(next->label);
}

} // namespace edgescan::ui

#include "moc_rocks.cpp"
