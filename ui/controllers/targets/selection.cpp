// Selecting, hiding, isolating.
#include "ui/controllers/targets/selection.h"

#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/selected_colour.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/range_gate_dialog.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/sight.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QMenu>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace edgescan::ui {
namespace {

// Over the images: the selection with a rim and a tint as in the cloud, hidden cells under a dark layer.
std::shared_ptr<const QImage> selectionPicture(const inspect::CellSet& selected, const inspect::CellSet& hidden, int beams, int rows) {
    if (selected.empty() && hidden.empty()) return nullptr;
    auto image = std::make_shared<QImage>(beams, rows, QImage::Format_ARGB32_Premultiplied);
    image->fill(Qt::transparent);
    const auto width = static_cast<std::uint32_t>(beams);
    const auto pixel = [&](std::uint32_t k) -> QRgb& {
        return reinterpret_cast<QRgb*>(image->scanLine(static_cast<int>(k / width)))[k % width];
    };
    const std::size_t cells = static_cast<std::size_t>(beams) * static_cast<std::size_t>(rows);
    for (const std::uint32_t k : hidden) {
        if (k < cells) pixel(k) = qPremultiply(qRgba(30, 30, 30, 225));
    }
    const auto paint = [&](const std::vector<std::uint32_t>& some, unsigned opacity) {
        for (const std::uint32_t k : some) {
            if (k < cells) pixel(k) = qPremultiply((kSelectedColour & RGB_MASK) | opacity << 24U);
        }
    };
    paint(selected, static_cast<unsigned>(kSelectedTint * 255));
    paint(rimOf(selected, width), 255U);
    return image;
}

/// The cells of the selected rocks.
inspect::CellSet cellsOfRocks(const Rocks& rocks) {
    inspect::CellSet cells;
    if (!rocks.picture() || rocks.selected().empty()) return cells;
    std::set<std::uint32_t> wanted;
    for (const std::size_t cell : rocks.selected()) wanted.insert(rocks.picture()->labelAt(cell));
    wanted.erase(0);
    const auto& labels = rocks.picture()->labels.cells;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (wanted.contains(labels[k])) cells.push_back(static_cast<std::uint32_t>(k));
    }
    return cells;
}

} // namespace

Selection::Selection(Engine& engine, LinkedViews& views, Rocks& rocks, NoticeBar& notice, QUndoStack& undo)
    : engine_(engine), views_(views), rocks_(rocks), notice_(notice), undo_(undo),
      inside_(
          Urgency::Now, [](const Question& question) { return pointsInside(*question.cloud, question.view, question.corners); },
          [this](const Question& question, const std::shared_ptr<const inspect::CellSet>& cells) {
              if (question.cloud == views_.cloud().geometryOfCloud()) combine(*cells, question.modifiers);
          },
          [this](const QString& what) { notice_.showNotice(NoticeBar::Kind::Warning, tr("Nothing was selected (%1).").arg(what)); },
          Older::Delivered) { // each of them was drawn
    connect(&views_, &LinkedViews::imageOutlined, this, [this](const QPolygonF& corners, Qt::KeyboardModifiers modifiers) {
        const Scan& scan = *views_.shown()->detection->scan;
        std::vector<Eigen::Vector2d> way;
        for (const QPointF& corner : corners) way.emplace_back(corner.x(), corner.y());
        combine(inspect::without(inspect::cellsInside(scan.lines(), scan.beams(), way), state_.hidden), modifiers);
    });
    connect(&views_, &LinkedViews::cloudOutlined, this, [this](const QPolygonF& corners, Qt::KeyboardModifiers modifiers) {
        CloudView& cloud = views_.cloud();
        if (!cloud.geometryOfCloud()) return;
        QPolygonF pixels;
        for (const QPointF& corner : corners) pixels << corner * cloud.devicePixelRatioF();
        inside_.ask({cloud.geometryOfCloud(), cloud.screenView(), pixels, modifiers});
    });
    connect(&views_, &LinkedViews::clicked, this, [this](const inspect::ClickedCell& click) {
        if (views_.tool() != Tool::Box && views_.tool() != Tool::Lasso) return;
        const std::size_t cell = click.clicked; // an edge may be on the far side
        const bool edge = (*views_.shown()->detection->mask)[cell] != 0;
        edge ? selectChainAt(cell) : selectRockAt(cell);
    });
    connect(&views_, &LinkedViews::cellMenuOpens, this, &Selection::addToMenu);
}

void Selection::followPicture() {
    const Picture& picture = *engine_.picture();
    if (std::exchange(stream_, picture.source.stream) != picture.source.stream) {
        state_ = {};
        emit changed();
    }
    if (std::exchange(shownOn_, picture.detection->scan) != picture.detection->scan) show();
}

/// Shift adds to the selection, Ctrl removes from it.
void Selection::combine(inspect::CellSet cells, Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ShiftModifier)) cells = inspect::united(state_.selected, cells);
    if (modifiers.testFlag(Qt::ControlModifier)) cells = inspect::without(state_.selected, cells);
    select(std::move(cells));
}

void Selection::select(inspect::CellSet cells) {
    change(cells.empty() ? stepName("Select Nothing") : stepName("Select"), {std::move(cells), state_.hidden});
}

void Selection::selectChainAt(std::size_t cell) {
    if (!views_.shown()) return;
    inspect::CellSet chain = inspect::chainAt(*views_.shown()->detection->mask, static_cast<std::uint32_t>(cell));
    if (chain.empty())
        notice_.showHint(tr("This cell is not an edge, so it is on no chain of edges: choose one that is."));
    else
        select(std::move(chain));
}

void Selection::selectRockAt(std::size_t cell) {
    const std::uint32_t label = rocks_.picture() ? rocks_.picture()->labelAt(cell) : 0;
    if (label == 0) {
        notice_.showNotice(NoticeBar::Kind::Warning, rocks_.picture()
                                                         ? tr("This cell is not on a rock: choose a cell on a coloured face.")
                                                         : tr("Rocks are not shown, so none can be selected: show them first."));
        return;
    }
    inspect::CellSet rock;
    const auto& labels = rocks_.picture()->labels.cells;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (labels[k] == label) rock.push_back(static_cast<std::uint32_t>(k));
    }
    select(std::move(rock));
}

/// Where no cells are selected, the rocks that are selected count.
bool Selection::needSelection() {
    if (state_.selected.empty()) {
        if (inspect::CellSet rocks = cellsOfRocks(rocks_); !rocks.empty()) select(std::move(rocks));
    }
    if (!state_.selected.empty()) return true;
    notice_.showHint(tr("Nothing is selected yet: drag a box (B) or a lasso (L) over a view first."));
    return false;
}

void Selection::hideSelected() {
    if (needSelection()) change(stepName("Hide"), {{}, inspect::united(state_.hidden, state_.selected)});
}

void Selection::isolateSelected() {
    if (!needSelection()) return;
    change(stepName("Isolate"), {state_.selected, inspect::allBut(state_.selected, engine_.picture()->detection->scan->cells())});
    bringIntoSight(views_.cloud(), state_.selected);
}

void Selection::showAll() {
    if (!state_.hidden.empty()) change(stepName("Show All"), {state_.selected, {}});
}

void Selection::zoomTo() {
    if (!needSelection()) return;
    const int beams = engine_.picture()->detection->scan->beams();
    QRect around;
    for (const std::uint32_t k : state_.selected) {
        const QPoint at = views_.placeOf(k);
        around = around.united(QRect(at, QSize(1, 1)));
    }
    views_.gray().viewPort()->fitTo(QRectF(around.intersected(QRect(0, 0, beams, engine_.picture()->detection->scan->lines()))));
    views_.cloud().zoomToCells(state_.selected);
}

void Selection::change(const QString& what, State after) {
    if (after == state_) return;
    undo_.push(new UndoStep<State>(
        what, state_, std::move(after), [this](const State& value) { return use(value), true; },
        [this, stream = stream_] { return stream_ == stream; }));
}

void Selection::use(const State& state) {
    state_ = state;
    show();
    emit changed();
}

void Selection::show() {
    if (!engine_.picture()) return;
    const Picture& picture = *engine_.picture();
    // If only the selection is visible, it needs no colour.
    const bool isolated = state_.selected.size() + state_.hidden.size() >= picture.detection->scan->cells();
    const inspect::CellSet coloured = isolated ? inspect::CellSet() : state_.selected;
    const auto image = selectionPicture(coloured, state_.hidden, picture.gray->width(), picture.gray->height());
    for (ImageView* view : {&views_.gray(), &views_.edges()}) view->setSelection(image);
    CloudView& cloud = views_.cloud();
    std::shared_ptr<std::vector<std::uint8_t>> mask;
    if (!state_.hidden.empty()) {
        mask = std::make_shared<std::vector<std::uint8_t>>(picture.detection->scan->cells(), 0);
        for (const std::uint32_t k : state_.hidden) {
            if (k < mask->size()) (*mask)[k] = 1;
        }
    }
    cloud.setHidden(std::move(mask));
    cloud.setSelection(coloured.empty() ? nullptr : std::make_shared<const inspect::CellSet>(coloured));
}

QString Selection::words() const {
    QString words;
    if (!state_.selected.empty() && engine_.picture()) {
        const edges::Detection& detection = *engine_.picture()->detection;
        std::size_t points = 0, edges = 0;
        for (const std::uint32_t k : state_.selected) {
            if (k >= detection.scan->cells()) continue;
            points += detection.scan->state[k] == CellState::Valid ? 1 : 0;
            edges += (*detection.mask)[k] != 0 ? 1 : 0;
        }
        words =
            tr("%1 cells selected, %2 points, %3 edge cells").arg(countText(state_.selected.size()), countText(points), countText(edges));
    }
    if (!state_.hidden.empty()) words += (words.isEmpty() ? "" : " · ") + tr("▲ %1 cells hidden").arg(countText(state_.hidden.size()));
    return words;
}

void Selection::addToMenu(QMenu& menu, const inspect::ClickedCell& click) {
    if (!views_.shown()) return;
    const std::size_t cell = click.clicked;
    if (auto* rock = menu.findChild<QMenu*>(kRockMenu)) {
        rock->addAction(tr("&Isolate"), this, [this, click] {
            selectRockAt(rocks_.rockCellAt(click).value_or(click.clicked));
            isolateSelected();
        });
    }
    QMenu* more = menu.addMenu(tr("&Select"));
    more->setObjectName("select-menu");
    more->addAction(tr("Edge &Chain Here"), this, [this, cell] { selectChainAt(cell); })
        ->setEnabled((*views_.shown()->detection->mask)[cell] != 0);
    more->addAction(tr("&Rock Here"), this, [this, cell] { selectRockAt(cell); })
        ->setEnabled(rocks_.picture() && rocks_.picture()->labelAt(cell) != 0);
    more->addSeparator();
    const bool some = !state_.selected.empty(), somewhere = some || !rocks_.selected().empty();
    more->addAction(tr("&Hide Selected"), this, &Selection::hideSelected)->setEnabled(somewhere);
    more->addAction(tr("&Isolate Selected"), this, &Selection::isolateSelected)->setEnabled(somewhere);
    more->addAction(tr("Show &All"), this, &Selection::showAll)->setEnabled(!state_.hidden.empty());
    more->addAction(tr("&Export Selected…"), this, &Selection::exportRequested)->setEnabled(some);
}

void Selection::hideToo(const QString& what, const inspect::CellSet& cells) {
    if (cells.empty())
        notice_.showNotice(NoticeBar::Kind::Done, tr("There is no cell here: nothing more is hidden."));
    else
        change(what, {inspect::without(state_.selected, cells), inspect::united(state_.hidden, cells)});
    reportGrowth();
}

void Selection::reportGrowth() {
    if (!engine_.picture() || !engine_.picture()->source.growth.growing) return;
    notice_.showNotice(NoticeBar::Kind::Warning,
                       tr("▲ The sweep grows. The cells that are there now are hidden. New lines are shown at every range."));
}

void Selection::setPart(const inspect::SelectionPart& part) {
    const std::size_t cells = engine_.picture()->detection->scan->cells();
    change(stepName("Open Session"), {inspect::cellsOf(part.selected, cells), inspect::cellsOf(part.hidden, cells)});
}

void Selection::hideBeyond(double nearM, double farM) {
    if (engine_.picture()) hideToo(stepName("Range Gate"), inspect::cellsBeyond(*engine_.picture()->detection->scan, nearM, farM));
}

std::optional<double> Selection::rangeAt(std::optional<std::size_t> cell) {
    if (engine_.picture() && cell && *cell < engine_.picture()->detection->scan->cells()) {
        const Scan& scan = *engine_.picture()->detection->scan;
        if (scan.state[*cell] == CellState::Valid) return static_cast<double>(scan.rangeMm[*cell]) / 1000.0;
    }
    notice_.showHint(tr("No range is known there: click a cell, or point at one that has a range, first."));
    return std::nullopt;
}

void Selection::hideFartherThan(std::optional<std::size_t> cell) {
    if (const auto range = rangeAt(cell)) hideBeyond(0.0, *range);
}

void Selection::hideNearerThan(std::optional<std::size_t> cell) {
    if (const auto range = rangeAt(cell)) hideBeyond(*range, std::numeric_limits<double>::infinity());
}

void Selection::askRangeGate() {
    if (!engine_.picture()) return;
    const RangeLimits limits = rangeLimits(*engine_.picture()->detection->scan);
    const auto gate =
        askForRangeGate(notice_.window(), static_cast<double>(limits.minMm) / 1000.0, static_cast<double>(limits.maxMm) / 1000.0);
    if (gate) hideBeyond(gate->nearM, gate->farM);
}

void Selection::clipToSelected() {
    if (!needSelection()) return;
    const Scan& scan = *engine_.picture()->detection->scan;
    const inspect::CellSet outside = inspect::cellsOutsideBoxOf(scan, state_.selected);
    // The selection defined the corners of the box; now its content is of interest.
    if (outside.empty()) return hideToo(stepName("Clip to Box"), outside);
    change(stepName("Clip to Box"), {{}, inspect::united(state_.hidden, outside)});
    reportGrowth();
}

} // namespace edgescan::ui

#include "moc_selection.cpp"
