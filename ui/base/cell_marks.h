// Targets and measurements as they hang on cells: the same in both images and in the cloud, wherever the cells are drawn.
#pragma once

#include <QLineF>
#include <QPainter>
#include <QPointF>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgescan::ui {

/// A cell that somebody pinned.
struct TargetMark {
    std::size_t cell = 0; ///< k = line * beams + beam
    QString tag;          ///< "1 keystone · 4.91 m"
    QString brief;        ///< "1": where there is little room, unless it is active
    bool active = false;  ///< its card is shown

    bool operator==(const TargetMark&) const = default;
};

/// Something that is measured between cells.
struct MeasureMark {
    std::vector<std::size_t> cells;
    std::vector<std::pair<std::size_t, std::size_t>> links; ///< places in `cells` that a line joins
    QString label;                                          ///< empty: not all cells were picked yet

    bool operator==(const MeasureMark&) const = default;
};

struct CellMarks {
    std::vector<TargetMark> targets;
    std::vector<MeasureMark> measures;

    bool operator==(const CellMarks&) const = default;
};

/// Where a cell is on the screen of a view.
struct MarkPlace {
    QPointF at;
    bool hidden = false; ///< behind something else

    bool operator==(const MarkPlace&) const = default;
};

/// What of it a view shows, in its own pixels.
struct ScreenMarks {
    struct Target {
        MarkPlace place;
        QString tag;
        bool active = false;
        bool operator==(const Target&) const = default;
    };
    struct Measure {
        std::vector<QLineF> lines;
        std::vector<QPointF> ends;
        QString label;
        QPointF labelAt;
        bool operator==(const Measure&) const = default;
    };
    std::vector<Target> targets;
    std::vector<Measure> measures;

    bool operator==(const ScreenMarks&) const = default;
    [[nodiscard]] bool empty() const { return targets.empty() && measures.empty(); }
};

/// `placeOf`: empty where the cell is not in view. A line needs both its ends. `small`: the view has little room for words.
[[nodiscard]] ScreenMarks screenMarks(const CellMarks& marks, const std::function<std::optional<MarkPlace>(std::size_t cell)>& placeOf,
                                      bool small = false);

/// White rings with black outline, centre dot and tag; lines with their labels. Tags stay within `place` and off each other.
void drawScreenMarks(QPainter& painter, const QRect& place, const ScreenMarks& marks);

} // namespace edgescan::ui
