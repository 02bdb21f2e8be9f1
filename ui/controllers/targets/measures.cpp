// The measuring tool.
#include "ui/controllers/targets/measures.h"

#include "ui/base/notice_bar.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"

#include <QStringList>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr double kMostSpread = 2.0; // of the throats that clicks next to each other find, the longest by the shortest

QString wordsFor(inspect::MeasureKind kind, std::size_t picked) {
    const QStringList two{Measures::tr("click one end"), Measures::tr("click the other end")};
    const QStringList height{Measures::tr("click the lower cell"), Measures::tr("click the higher cell")};
    const QStringList angle{Measures::tr("click the end of one side"), Measures::tr("click where the sides meet"),
                            Measures::tr("click the end of the other side")};
    const QStringList spans{Measures::tr("click one end of a"), Measures::tr("click the other end of a"),
                            Measures::tr("click one end of b"), Measures::tr("click the other end of b")};
    const QStringList throat{Measures::tr("click into the opening, or the near rock at one side"),
                             Measures::tr("click the rock at the other side")};
    const QStringList& all = kind == inspect::MeasureKind::Throat     ? throat
                             : kind == inspect::MeasureKind::Angle    ? angle
                             : kind == inspect::MeasureKind::Spans    ? spans
                             : kind == inspect::MeasureKind::Vertical ? height
                                                                      : two;
    return Measures::tr(inspect::traitsOf(kind).label) + ": " + all.value(static_cast<int>(picked));
}

} // namespace

Measures::Measures(LinkedViews& views, Targets& targets, NoticeBar& notice)
    : views_(views), targets_(targets), notice_(notice),
      throats_(
          Urgency::Now,
          [](const ThroatAsked& asked) {
              const Scan& scan = *asked.of->detection->scan;
              return inspect::throatAt(scan, CartesianTables(scan), asked.clicked[0], asked.clicked[1]);
          },
          [this](const ThroatAsked& asked, const auto& found) { finishThroat(asked, *found); },
          [this](const QString& what) {
              notice_.showNotice(NoticeBar::Kind::Error, tr("the throat could not be measured (%1); close other programs.").arg(what));
          }) {
    connect(&views_, &LinkedViews::clicked, this, [this](const inspect::ClickedCell& click) {
        if (kind_ && views_.tool() == Tool::Measure) pick(click);
    });
    connect(&views_, &LinkedViews::toolChanged, this, [this] {
        if (views_.tool() != Tool::Measure) stop();
    });
    connect(&views_, &LinkedViews::flippedChanged, this, &Measures::show);
    connect(&targets_, &Targets::cardChanged, this, &Measures::warnOfClick);
    connect(&views_, &LinkedViews::newScanShown, this, [this] {
        picked_.clear(); // cells of the old scan have no meaning in the new one
        show();
    });
}

void Measures::start(inspect::MeasureKind kind) {
    kind_ = kind;
    picked_.clear();
    views_.setTool(Tool::Measure);
    show();
    emit kindChanged();
}

void Measures::startAt(std::size_t cell) {
    if (views_.flipped()) return notice_.showHint(LinkedViews::onlyOfB());
    start(inspect::MeasureKind::Distance);
    pick(inspect::exactly(cell)); // the target on the card, wherever it is
}

void Measures::stop() {
    if (!kind_) return;
    kind_.reset();
    picked_.clear();
    if (views_.tool() == Tool::Measure) views_.setTool(Tool::Pin);
    targets_.showDraft({});
    emit asked(QString());
    emit kindChanged();
}

bool Measures::removeLastPick() {
    if (picked_.empty()) return false;
    picked_.pop_back();
    show();
    return true;
}

void Measures::pick(const inspect::ClickedCell& click) {
    if (throats_.behind()) return; // the prompt says so
    if (kind_ == inspect::MeasureKind::Throat && askThrough(click)) return show();
    if (!views_.shown() || views_.shown()->detection->scan->state[click.cell] != CellState::Valid) {
        notice_.showHint(tr("Nothing was measured within %1 cells of this click, so no length ends there: click nearer to a surface.")
                             .arg(inspect::kSnapReach));
        return;
    }
    picked_.push_back(click);
    if (picked_.size() == inspect::traitsOf(*kind_).cells) keepPicked();
    show();
}

/// One click into an opening measures it. False: it is not into one.
bool Measures::askThrough(const inspect::ClickedCell& click) {
    if (!views_.shown()) return false;
    const Scan& scan = *views_.shown()->detection->scan;
    const auto cell = inspect::openingOfClick(scan, CartesianTables(scan), click);
    if (!cell) return false;
    throats_.ask({views_.shown(), {*cell, *cell}, !picked_.empty()});
    picked_.clear();
    return true;
}

void Measures::keepPicked() {
    const std::vector<inspect::ClickedCell> clicks = std::exchange(picked_, {});
    std::vector<std::uint32_t> cells, clicked;
    for (const inspect::ClickedCell& click : clicks) {
        cells.push_back(click.cell);
        clicked.push_back(click.clicked);
    }
    if (kind_ != inspect::MeasureKind::Throat) return keep(*kind_, std::move(cells), std::move(clicked));
    throats_.ask({views_.shown(), std::move(clicked), false});
}

void Measures::finishThroat(const ThroatAsked& asked, const Throat& found) {
    show();
    if (!isOnScreen(*asked.of)) return;
    if (found && found->mostM > kMostSpread * found->leastM)
        return notice_.showHint(
            (asked.clicked[0] == asked.clicked[1]
                 ? tr("Clicks next to this one find a throat of %1 to %2 m: zoom in, or click on the rock at both sides.")
                 : tr("Clicks next to these find a throat of %1 to %2 m: zoom in and click on the rock at both sides, or once into "
                      "the middle of the opening."))
                .arg(found->leastM, 0, 'f', 2)
                .arg(found->mostM, 0, 'f', 2));
    if (found) {
        keep(inspect::MeasureKind::Throat, {found->ends.begin(), found->ends.end()}, asked.clicked);
        if (asked.afterAClick)
            notice_.showHint(tr("The last click is in an opening and measures all of it: the click before does not count."));
        return;
    }
    notice_.showHint(tr("No opening between these two clicks: click the rock at both sides of one. Distance measures over a rock."));
}

/// Of another scan the cells have no meaning; a sweep may have grown.
bool Measures::isOnScreen(const Picture& of) const {
    const Picture* now = views_.picture().get();
    return now != nullptr && now->source.stream == of.source.stream && now->source.growth.sweep == of.source.growth.sweep;
}

/// Once for a throat, when its card is known.
void Measures::warnOfClick() {
    if (!newThroat_) return;
    const KnownTargets& known = targets_.known();
    const auto* measured = known.of(*newThroat_);
    if (measured == nullptr) return;
    newThroat_.reset();
    if (*measured && isOnScreen(*known.picture) && (*measured)->clickBehindM > 0.0) // the ends may be others
        notice_.showHint(tr("A click went through the opening, so the rim in front of it was taken: check both ends of the line."));
}

void Measures::keep(inspect::MeasureKind kind, std::vector<std::uint32_t> cells, std::vector<std::uint32_t> clicked) {
    if (clicked == cells) clicked.clear();
    const auto measured = inspect::measureCells(*views_.picture()->detection->scan, {}, kind, cells);
    targets_.keepMeasure({kind, cells, std::move(clicked)});
    const auto& all = targets_.notebook().measures;
    if (kind == inspect::MeasureKind::Throat && !all.empty() && all.back().cells == cells) newThroat_ = all.back();
    if (measured && measured->behindM > 0.0)
        notice_.showHint(tr("An end of this measurement is %1 m behind the surface under its line: check where its "
                            "ends are, and click again on the near side if that was meant.")
                             .arg(measured->behindM, 0, 'f', 2));
}

/// A side that is far behind the throat that was meant shows by its range.
QString Measures::lastClickWords() const {
    const std::uint32_t cell = picked_.back().cell;
    const QString away = QString::number(views_.shown()->detection->scan->rangeMm[cell] / 1000.0, 'f', 2), target = targets_.nameAt(cell);
    if (!target.isEmpty()) return tr(" · the last click took target %1, at %2 m").arg(target, away);
    return (picked_.back().moved() ? tr(" · the last click took the near side, at %1 m") : tr(" · the last click is at %1 m")).arg(away);
}

void Measures::show() {
    if (!kind_) return;
    MeasureMark draft;
    draft.active = true; // its ends have rings: a click near a target takes the cell of that
    for (const inspect::ClickedCell& click : picked_) {
        draft.cells.push_back(click.cell);
        draft.clicked.push_back(click.clicked);
    }
    for (const auto& link : inspect::linksOf(*kind_)) {
        if (link.first < picked_.size() && link.second < picked_.size()) draft.links.push_back(link);
    }
    targets_.showDraft(draft);
    QString words = throats_.behind() ? tr("Throat width: the narrowest way is being searched …") : wordsFor(*kind_, picked_.size());
    if (views_.flipped())
        words = LinkedViews::onlyOfB(); // no number of B over A
    else if (!picked_.empty() && views_.shown())
        words += lastClickWords();
    emit asked(words);
}

} // namespace edgescan::ui

#include "moc_measures.cpp"
