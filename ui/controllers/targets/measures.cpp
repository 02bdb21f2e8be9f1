// The measuring tool.
#include "ui/controllers/targets/measures.h"

#include "core/inspect/measure/throat.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"

#include <QStringList>

namespace edgescan::ui {
namespace {

QString wordsFor(inspect::MeasureKind kind, std::size_t picked) {
    static const QStringList two{Measures::tr("click the one end"), Measures::tr("click the other end")};
    static const QStringList height{Measures::tr("click the lower cell"), Measures::tr("click the higher cell")};
    static const QStringList angle{Measures::tr("click the end of one side"), Measures::tr("click where the sides meet"),
                                   Measures::tr("click the end of the other side")};
    static const QStringList spans{Measures::tr("click one end of a"), Measures::tr("click the other end of a"),
                                   Measures::tr("click one end of b"), Measures::tr("click the other end of b")};
    static const QStringList throat{Measures::tr("click the rim on one side"), Measures::tr("click the rim on the other side")};
    const QStringList& all = kind == inspect::MeasureKind::Throat     ? throat
                             : kind == inspect::MeasureKind::Angle    ? angle
                             : kind == inspect::MeasureKind::Spans    ? spans
                             : kind == inspect::MeasureKind::Vertical ? height
                                                                      : two;
    return Measures::tr(inspect::traitsOf(kind).label) + ": " + all.value(static_cast<int>(picked));
}

} // namespace

Measures::Measures(LinkedViews& views, Targets& targets, NoticeBar& notice) : views_(views), targets_(targets), notice_(notice) {
    connect(&views_, &LinkedViews::picked, this, [this](std::size_t cell) {
        if (kind_ && views_.tool() == Tool::Measure) pick(cell);
    });
    connect(&views_, &LinkedViews::toolChanged, this, [this] {
        if (views_.tool() != Tool::Measure) stop();
    });
    connect(&views_, &LinkedViews::newScanShown, this, [this] {
        picked_.clear(); // cells of the old scan have no meaning in the new one
        if (kind_) show();
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
    start(inspect::MeasureKind::Distance);
    pick(cell);
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

void Measures::pick(std::size_t cell) {
    if (!views_.shown() || views_.shown()->detection->scan->state[cell] != CellState::Valid) {
        notice_.showNotice(NoticeBar::Kind::Warning,
                           tr("Nothing was measured at this cell, so it is the end of no length: click one that has a range."));
        return;
    }
    picked_.push_back(static_cast<std::uint32_t>(cell));
    if (picked_.size() == inspect::traitsOf(*kind_).cells) keepPicked();
    show();
}

void Measures::keepPicked() {
    std::vector<std::uint32_t> cells = std::exchange(picked_, {});
    if (kind_ == inspect::MeasureKind::Throat) {
        const Scan& scan = *views_.shown()->detection->scan;
        const auto ends = inspect::narrowestBetween(scan, CartesianTables(scan), cells[0], cells[1]);
        if (!ends) {
            notice_.showNotice(NoticeBar::Kind::Warning,
                               tr("No free way was seen between these two rims: click cells on the two borders of an opening."));
            return;
        }
        cells.assign(ends->begin(), ends->end());
    }
    targets_.keepMeasure({*kind_, std::move(cells)});
}

void Measures::show() {
    MeasureMark draft;
    draft.cells.assign(picked_.begin(), picked_.end());
    for (const auto& link : Targets::linksOf(*kind_)) {
        if (link.first < picked_.size() && link.second < picked_.size()) draft.links.push_back(link);
    }
    targets_.showDraft(draft);
    emit asked(wordsFor(*kind_, picked_.size()));
}

} // namespace edgescan::ui

#include "moc_measures.cpp"
