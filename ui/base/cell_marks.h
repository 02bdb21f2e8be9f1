// Targets and measurements are tied to cells. Both images and the cloud draw the same marks wherever they show these cells.
#pragma once

#include <QLineF>
#include <QPainter>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgescan::ui {

/// A cell that the operator marked as a target.
struct TargetMark {
    std::size_t cell = 0;                 ///< k = line * beams + beam
    QString tag;                          ///< "1 keystone · 4.91 m"
    QString brief;                        ///< "1": shown instead of `tag` where space is short, unless the target is active
    bool active = false;                  ///< its card is shown
    std::optional<std::size_t> clicked{}; ///< where the operator clicked, if the mark is at another cell
    bool isTarget = true;                 ///< false: a remark at a cell, as "✓ edge", which no click chooses

    bool operator==(const TargetMark&) const = default;
};

/// A measurement between cells.
struct MeasureMark {
    std::vector<std::size_t> cells;
    std::vector<std::pair<std::size_t, std::size_t>> links; ///< pairs of indices into `cells`; a line joins each pair
    QString label;                                          ///< empty until all cells are picked
    std::vector<std::size_t> clicked{};                     ///< where the operator clicked; empty: at `cells`
    bool active = false;                                    ///< it is the chosen one
    QString brief{};                                        ///< "M2": in place of `label` where several are at one place
    std::vector<std::size_t> way{}; ///< cells that the line follows, from its first end to its last one; empty: it is straight

    bool operator==(const MeasureMark&) const = default;
};

struct CellMarks {
    std::vector<TargetMark> targets;
    std::vector<MeasureMark> measures;
    std::vector<std::vector<std::size_t>> cut{}; ///< cells along the section that is open, one line for each surface

    bool operator==(const CellMarks&) const = default;
    [[nodiscard]] bool empty() const { return targets.empty() && measures.empty() && cut.empty(); }
};

/// One of the marks.
struct MarkName {
    bool isMeasure = false;
    std::size_t which = 0; ///< the cell of a target, or the index of a measurement
    bool byLabel = false;  ///< its label was meant, which may be far from its cell

    bool operator==(const MarkName&) const = default;
};

/// Where a cell is, in pixels of a view; empty: out of view.
using PlaceOfCell = std::function<std::optional<QPointF>(std::size_t cell)>;

/// The part of the marks that a view shows, in pixels of the view.
struct ScreenMarks {
    struct Target {
        QPointF at;
        bool hidden = false; ///< another surface hides it
        QString tag;
        bool active = false;
        std::size_t cell = 0;
        bool isTarget = true;
        QString brief{}; ///< in place of `tag` where that has no free place near the ring
        bool operator==(const Target&) const = default;
    };
    struct Measure {
        std::vector<QLineF> lines;
        std::vector<QPointF> ends;
        QString label;
        QPointF labelAt;
        bool active = false;
        std::size_t index = 0; ///< in CellMarks::measures
        QString brief{};       ///< in place of `label` where another label is at the same place, or the view is too narrow
        bool operator==(const Measure&) const = default;
    };
    std::vector<Target> targets;
    std::vector<Measure> measures;
    std::vector<QLineF> moves; ///< from a click to the cell that it meant
    std::vector<QPolygonF> cut;

    bool operator==(const ScreenMarks&) const = default;
    [[nodiscard]] bool empty() const { return targets.empty() && measures.empty() && cut.empty(); }
};

/// The place of a tag in a view.
struct MarkTag : QRectF {
    MarkName of;
};

/// A line is drawn only if both its ends are in view. `small`: the view has little space for text, so lengths are without their labels.
/// `isHidden`: another surface hides the cell of a target; null: the view hides none.
[[nodiscard]] ScreenMarks screenMarks(const CellMarks& marks, const PlaceOfCell& placeOf, bool small = false,
                                      const std::function<bool(std::size_t cell)>& isHidden = {});

/// White rings with black outline, centre dot and tag; lines with their labels, the chosen one thicker, with a white rim and with rings at
/// its ends; dash-dotted lines along a section; a thin line from a tag that is away from its mark, or nearer to another one. Tags stay
/// inside `place`, do not overlap, and keep off the rings, the `plates` over the view and its `texts`; a mark outside `place` or under a
/// plate has none, and no tag is cut. Returns the tags, the upper ones first.
std::vector<MarkTag> drawScreenMarks(QPainter& painter, const QRect& place, const ScreenMarks& marks,
                                     const std::vector<QRectF>& plates = {}, const std::vector<QRectF>& texts = {});

/// The mark whose tag, ring or end is at this place or, for a finger, near it; `tags` as they were drawn.
[[nodiscard]] std::optional<MarkName> markAt(const ScreenMarks& marks, const std::vector<MarkTag>& tags, QPointF at, bool byFinger);

} // namespace edgescan::ui
