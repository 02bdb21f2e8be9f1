// Draws targets and measurements over a picture.
#include "ui/base/cell_marks.h"

#include "ui/base/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr double kMarkRing = 8.0;              // radius, px
constexpr double kEndDot = 3.5;                // of each measured cell
constexpr double kRingReach = kMarkRing + 2.0; // with its outline
constexpr int kTagOffset = 6;                  // px from the ring
constexpr double kMouseReach = 2.0;            // px around what is drawn
constexpr double kFingerReach = 10.0;
constexpr double kOnePlace = 48.0;         // px: labels of measurements that are nearer would be a heap
constexpr std::size_t kMostFreeRings = 40; // no tag covers a ring; among more of them it would be far from its own
const QColor kCut(255, 220, 110);          // along a section
const QColor kMeasured(120, 190, 255);     // the line being measured; its dark halo separates it from the cloud

QFont boldFont(const QPainter& painter) {
    QFont bold = painter.font();
    bold.setBold(true);
    return bold;
}

QPointF nearestOn(const QRectF& box, const QPointF& at) {
    return {std::clamp(at.x(), box.left(), box.right()), std::clamp(at.y(), box.top(), box.bottom())};
}

/// Px from a box to a line; 0 where it crosses the box.
double awayFrom(const QRectF& box, const QLineF& line) {
    const auto fromLine = [&line](const QPointF& at) {
        const QPointF way = line.p2() - line.p1();
        const double length = QPointF::dotProduct(way, way);
        const double along = length > 0.0 ? std::clamp(QPointF::dotProduct(at - line.p1(), way) / length, 0.0, 1.0) : 0.0;
        return QLineF(at, line.pointAt(along)).length();
    };
    const std::array corners{box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()};
    double least = std::min(QLineF(line.p1(), nearestOn(box, line.p1())).length(), QLineF(line.p2(), nearestOn(box, line.p2())).length());
    for (std::size_t n = 0; n < corners.size(); ++n) {
        QPointF at;
        if (line.intersects(QLineF(corners[n], corners[(n + 1) % corners.size()]), &at) == QLineF::BoundedIntersection) return 0.0;
        least = std::min(least, fromLine(corners[n]));
    }
    return least;
}

/// Places tags so that they cover neither each other nor a plate: as near to their mark as can be. A line joins a tag that is away from it.
class Tags {
public:
    /// `taken` has the boxes of the `rings`, too, unless these are too many. `lines`: of the measurements, one of each.
    Tags(QPainter& painter, const QRect& place, const std::vector<QRectF>& taken, const std::vector<QPointF>& rings,
         const std::vector<QLineF>& lines)
        : painter_(painter), place_(place), taken_(taken), rings_(rings), lines_(lines) {
        painter_.save();
        painter_.setFont(boldFont(painter_));
    }
    Tags(const Tags&) = delete;
    Tags& operator=(const Tags&) = delete;
    ~Tags() { painter_.restore(); }

    /// `aside`: x from `at` to the nearer end of the tag; `above`: y from its lower end to `at`. The tag does not cover the `line`. It says
    /// `brief` where `text` has no free place near the mark, or only one that misleads.
    void place(const MarkName& of, const QPointF& at, double aside, double above, QString text, bool active, const QString& brief = {},
               const QLineF& line = {}) {
        const auto isWhole = [this](const QString& words) { return sizeOf(words).width() <= place_.width() - 2.0 * kFromRim; };
        if (!isWhole(text)) text = isWhole(brief) ? brief : QString();
        if (text.isEmpty()) return;
        line_ = line;
        const std::size_t others = taken_.size();
        reserveLine(at, line, painter_.fontMetrics().horizontalAdvance(text));
        const QPointF way(aside, above);
        constexpr double kAnywhere = std::numeric_limits<double>::infinity();
        const bool mayBeBrief = !brief.isEmpty() && !(active && of.isMeasure); // the value of the chosen one is read
        auto box = freePlace(at, way, sizeOf(text), mayBeBrief ? kNear : kAnywhere);
        QString words = text;
        if (mayBeBrief && (!box || (!active && misleads(*box, at)))) {
            const auto small = freePlace(at, way, sizeOf(brief), kAnywhere);
            const bool better = small && (!box || !misleads(*small, at));
            if (better) box = small;
            if (better || !box) words = brief;
        }
        if (!box) box = clearOfTags(at, usualPlace(at, way, sizeOf(words)));
        taken_.resize(others);
        taken_.push_back(*box);
        const bool led = QLineF(at, nearestOn(*box, at)).length() > std::hypot(aside, above) + kStillNext;
        placed_.push_back({{*box, of}, words, active, at, led || misleads(*box, at)});
    }
    /// The tag that was placed first is over the others, where they have no room next to each other. Returns their places, as placed.
    std::vector<MarkTag> draw() {
        QVector<QLineF> ways;
        for (const Placed& tag : placed_) {
            const QPointF end = nearestOn(tag.box, tag.at);
            const double away = QLineF(tag.at, end).length(), ring = tag.box.of.isMeasure ? 0.0 : kMarkRing;
            if (tag.led && away > ring) ways << QLineF(tag.at + (end - tag.at) * (ring / away), end);
        }
        strokeTwice(painter_, QPen(QColor(0, 0, 0, 200), 3.0), QPen(QColor(232, 232, 232), 1.0), [&] { painter_.drawLines(ways); });
        painter_.setPen(QPen(Qt::black, 1.0));
        for (auto tag = placed_.rbegin(); tag != placed_.rend(); ++tag) {
            painter_.setPen(tag->active ? Qt::black : QColor(232, 232, 232));
            painter_.setBrush(tag->active ? QColor(255, 255, 255, 240) : QColor(27, 29, 31, 225));
            painter_.drawRoundedRect(tag->box, 3, 3);
            painter_.drawText(tag->box, Qt::AlignCenter, tag->text);
        }
        std::vector<MarkTag> boxes;
        for (const Placed& tag : placed_) boxes.push_back(tag.box);
        return boxes;
    }

private:
    struct Placed {
        MarkTag box;
        QString text;
        bool active;
        QPointF at;
        bool led; // a line joins it with its mark: it is away from it, or nearer to another one
    };
    /// Takes the part of a line that a tag of this width at `at` could cover, as small squares.
    void reserveLine(const QPointF& at, const QLineF& line, double width) {
        constexpr double kStep = 10.0; // px
        const double length = line.length();
        for (double along = 0.0; length > 0.0 && along <= length + kStep; along += kStep) {
            const QPointF here = line.pointAt(std::min(1.0, along / length));
            if (QLineF(here, at).length() <= width + 2.0 * kStep) taken_.emplace_back(here - QPointF(5.0, 5.0), QSizeF(10.0, 10.0));
        }
    }
    [[nodiscard]] QSizeF sizeOf(const QString& text) const {
        return QRectF(painter_.fontMetrics().boundingRect(text)).adjusted(-5, -2, 5, 2).size();
    }
    [[nodiscard]] static QRectF usualPlace(const QPointF& at, const QPointF& way, const QSizeF& size) {
        return {QPointF(at.x() + way.x(), at.y() - way.y() - size.height()), size};
    }
    /// True if a reader would take another mark for that of the tag: it is nearer, or on the way to the tag.
    [[nodiscard]] bool misleads(const QRectF& box, const QPointF& at) const {
        if (!line_.isNull()) {
            const double own = awayFrom(box, line_) + 1.0;
            const auto isNearer = [&](const QLineF& other) { return other != line_ && awayFrom(box, other) <= own; };
            const auto isRingNearer = [&](const QPointF& ring) {
                const bool isEnd = QLineF(ring, line_.p1()).length() < kMarkRing || QLineF(ring, line_.p2()).length() < kMarkRing;
                return !isEnd && QLineF(nearestOn(box, ring), ring).length() - kMarkRing <= own;
            };
            return std::ranges::any_of(lines_, isNearer) || std::ranges::any_of(rings_, isRingNearer);
        }
        const QPointF end = nearestOn(box, at), way = end - at;
        const double away = QPointF::dotProduct(way, way);
        return std::ranges::any_of(rings_, [&](const QPointF& other) {
            if (other == at) return false;
            if (QLineF(nearestOn(box, other), other).length() <= std::sqrt(away) + 1.0) return true;
            const double along = away > 0.0 ? std::clamp(QPointF::dotProduct(other - at, way) / away, 0.0, 1.0) : 0.0;
            return QLineF(at + along * way, other).length() < kMarkRing;
        });
    }
    /// The free place nearest to the mark, at most `most` px from it, of equal ones that nearest to the usual place: at either side of the
    /// mark, above or below, or next to what is taken. A place that misleads is taken only where the others are much farther.
    [[nodiscard]] std::optional<QRectF> freePlace(const QPointF& at, const QPointF& way, const QSizeF& size, double most) const {
        const QPointF usual = usualPlace(at, way, size).topLeft();
        std::vector<double> lefts{usual.x(), at.x() - way.x() - size.width()},
            tops{usual.y(), at.y() + way.y(), at.y() - size.height() / 2.0};
        for (const QRectF& other : taken_) {
            tops.insert(tops.end(), {other.bottom() + kBetweenTags, other.top() - size.height() - kBetweenTags});
            lefts.insert(lefts.end(), {other.right() + kBetweenTags, other.left() - size.width() - kBetweenTags});
        }
        std::optional<QRectF> nearest;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t n = 0; n < lefts.size() && (n < 2 || least > kNextTo); ++n) { // next to the mark, if it can be
            for (const double top : tops) {
                QRectF box({lefts[n], top}, size);
                keepWithin(box);
                const double away = QLineF(nearestOn(box, at), at).length();
                const double cost = away + QLineF(box.topLeft(), usual).length() / 8.0;
                if (away > most || cost >= least) continue;
                if (std::ranges::any_of(taken_, [&](const QRectF& other) { return other.intersects(box); })) continue;
                const double all = cost + (rings_.size() + lines_.size() <= kMostFreeRings && misleads(box, at) ? kMisleading : 0.0);
                if (all >= least) continue;
                least = all;
                nearest = box;
            }
        }
        return nearest;
    }
    /// The place nearest to the mark that covers no other tag, whatever else is below it.
    [[nodiscard]] QRectF clearOfTags(const QPointF& at, QRectF nearest) const {
        const QSizeF size = nearest.size();
        keepWithin(nearest);
        double least = std::numeric_limits<double>::infinity();
        const auto isFree = [&](const QRectF& box) {
            return std::ranges::none_of(placed_, [&](const Placed& other) { return other.box.intersects(box); });
        };
        if (isFree(nearest)) return nearest;
        for (double top = place_.top(); top < place_.bottom(); top += size.height() / 2.0) {
            for (double left = place_.left(); left < place_.right(); left += size.width() / 4.0) {
                QRectF box({left, top}, size);
                keepWithin(box);
                const double away = QLineF(nearestOn(box, at), at).length();
                if (away >= least || !isFree(box)) continue;
                least = away;
                nearest = box;
            }
        }
        return nearest;
    }
    void keepWithin(QRectF& box) const {
        const QRectF room = place_.adjusted(kFromRim, kFromRim, -kFromRim, -kFromRim);
        box.moveLeft(std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
        box.moveTop(std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
    }

    static constexpr double kBetweenTags = 2.0, kFromRim = 2.0; // px
    static constexpr double kNextTo = 24.0;                     // px from the mark: near enough not to look further
    static constexpr double kStillNext = 4.0;                   // px beyond the usual place
    static constexpr double kNear = 100.0;                      // px from the mark: farther away a short text is better
    static constexpr double kMisleading = 30.0;                 // px that a tag is rather farther away than nearer to another mark
    QPainter& painter_;
    QRectF place_;
    std::vector<QRectF> taken_;
    std::vector<QPointF> rings_;
    std::vector<QLineF> lines_;
    QLineF line_; // of the measurement whose tag is placed
    std::vector<Placed> placed_;
};

/// Of the measurements at one place only one has its value: the chosen one, else the newest.
void shortenHeaps(std::vector<ScreenMarks::Measure>& shown) {
    std::vector<std::size_t> order(shown.size());
    std::iota(order.rbegin(), order.rend(), std::size_t{0});
    std::ranges::stable_partition(order, [&](std::size_t n) { return shown[n].active; });
    std::vector<QPointF> whole; // labels with a value
    for (const std::size_t n : order) {
        if (shown[n].label.isEmpty()) continue;
        const auto isNear = [&](const QPointF& at) { return QLineF(at, shown[n].labelAt).length() < kOnePlace; };
        if (!shown[n].brief.isEmpty() && std::ranges::any_of(whole, isNear))
            shown[n].label = shown[n].brief;
        else
            whole.push_back(shown[n].labelAt);
    }
}

void drawTarget(QPainter& painter, const ScreenMarks::Target& target) {
    const Qt::PenStyle style = target.hidden ? Qt::DotLine : Qt::SolidLine;
    painter.setBrush(Qt::NoBrush);
    strokeTwice(painter, QPen(QColor(0, 0, 0, 220), 4.0), QPen(Qt::white, 2.0, style),
                [&] { painter.drawEllipse(target.at, kMarkRing, kMarkRing); });
    painter.setPen(QPen(Qt::black, 1.0));
    painter.setBrush(Qt::white);
    painter.drawEllipse(target.at, 2.0, 2.0);
}

void drawMeasure(QPainter& painter, const ScreenMarks::Measure& measure) {
    painter.setBrush(Qt::NoBrush);
    const auto drawLines = [&] {
        for (const QLineF& line : measure.lines) painter.drawLine(line);
    };
    if (measure.active) {
        strokeTwice(painter, QPen(QColor(0, 0, 0, 220), 11.0), QPen(Qt::white, 8.0), drawLines);
        strokeTwice(painter, QPen(QColor(0, 0, 0, 220), 4.0), QPen(Qt::white, 2.0), [&] {
            for (const QPointF& end : measure.ends) painter.drawEllipse(end, kMarkRing, kMarkRing);
        });
    }
    const double wide = measure.active ? 4.0 : 2.0;
    strokeTwice(painter, QPen(QColor(0, 0, 0, 200), wide + 2.0), QPen(kMeasured, wide), drawLines);
    painter.setPen(QPen(Qt::black, 1.5));
    painter.setBrush(kMeasured);
    for (const QPointF& end : measure.ends) painter.drawEllipse(end, kEndDot, kEndDot);
}

/// No tag covers the chosen measurement: its lines and ends as small squares.
void reserveChosen(const ScreenMarks& marks, std::vector<QRectF>& taken) {
    constexpr double kStep = 10.0; // px
    for (const ScreenMarks::Measure& measure : marks.measures) {
        if (!measure.active) continue;
        for (const QPointF& end : measure.ends)
            taken.emplace_back(end - QPointF(kRingReach, kRingReach), end + QPointF(kRingReach, kRingReach));
        for (const QLineF& line : measure.lines) {
            for (double along = 0.0; along <= line.length(); along += kStep) {
                const QPointF here = line.pointAt(along / std::max(1.0, line.length()));
                taken.emplace_back(here - QPointF(kStep, kStep) / 2.0, here + QPointF(kStep, kStep) / 2.0);
            }
        }
    }
}

/// A dotted line from the click, which has a small cross.
void drawMove(QPainter& painter, const QLineF& move) {
    constexpr double kCross = 4.0; // px
    const QPointF at = move.p1();
    strokeTwice(painter, QPen(QColor(0, 0, 0, 200), 3.0), QPen(Qt::white, 1.0), [&] {
        painter.drawLine(at - QPointF(kCross, kCross), at + QPointF(kCross, kCross));
        painter.drawLine(at - QPointF(kCross, -kCross), at + QPointF(kCross, -kCross));
    });
    strokeTwice(painter, QPen(QColor(0, 0, 0, 200), 3.0), QPen(Qt::white, 1.0, Qt::DotLine), [&] { painter.drawLine(move); });
}

/// A new part begins after a cell out of view.
void addCut(std::vector<QPolygonF>& parts, const std::vector<std::size_t>& line, const PlaceOfCell& placeOf) {
    QPolygonF part;
    const auto end = [&] {
        if (part.size() > 1) parts.push_back(std::exchange(part, {}));
        part.clear();
    };
    for (const std::size_t cell : line) {
        if (const auto place = placeOf(cell))
            part << *place;
        else
            end();
    }
    end();
}

} // namespace

ScreenMarks screenMarks(const CellMarks& marks, const PlaceOfCell& placeOf, bool small, const std::function<bool(std::size_t)>& isHidden) {
    ScreenMarks shown;
    for (const MeasureMark& measure : marks.measures) {
        ScreenMarks::Measure drawn;
        drawn.index = static_cast<std::size_t>(&measure - marks.measures.data());
        std::vector<std::optional<QPointF>> places;
        for (const std::size_t cell : measure.cells) {
            places.push_back(placeOf(cell));
            if (places.back()) drawn.ends.push_back(*places.back());
        }
        for (const auto& [a, b] : measure.links) {
            if (a >= places.size() || b >= places.size() || !places[a] || !places[b]) continue;
            drawn.lines.emplace_back(*places[a], *places[b]);
        }
        if (!measure.way.empty()) drawn.lines.clear();
        for (std::size_t n = 1; n < measure.way.size(); ++n) {
            const auto from = placeOf(measure.way[n - 1]), to = placeOf(measure.way[n]);
            if (from && to) drawn.lines.emplace_back(*from, *to);
        }
        if (!drawn.lines.empty()) drawn.labelAt = drawn.lines[measure.way.empty() ? 0 : drawn.lines.size() / 2].center();
        for (std::size_t n = 0; n < measure.clicked.size() && n < places.size(); ++n) {
            const auto click = measure.clicked[n] == measure.cells[n] ? std::nullopt : placeOf(measure.clicked[n]);
            if (click && places[n]) shown.moves.emplace_back(*click, *places[n]);
        }
        drawn.active = measure.active;
        if (!small || measure.active) drawn.label = measure.label;
        if (drawn.ends.empty()) continue;
        if (drawn.lines.empty()) drawn.label.clear(); // it would be nowhere
        drawn.brief = measure.brief;
        shown.measures.push_back(std::move(drawn));
    }
    shortenHeaps(shown.measures);
    for (const TargetMark& target : marks.targets) {
        const QString& words = small && !target.active ? target.brief : target.tag;
        const auto place = placeOf(target.cell);
        if (!place) continue;
        shown.targets.push_back(
            {*place, isHidden && isHidden(target.cell), words, target.active, target.cell, target.isTarget, target.brief});
        const auto click = target.clicked ? placeOf(*target.clicked) : std::nullopt;
        if (click) shown.moves.emplace_back(*click, *place);
    }
    for (const std::vector<std::size_t>& line : marks.cut) addCut(shown.cut, line, placeOf);
    // The chosen one is drawn over the others.
    std::ranges::stable_partition(shown.measures, [](const ScreenMarks::Measure& measure) { return !measure.active; });
    std::stable_partition(shown.targets.begin(), shown.targets.end(), [](const ScreenMarks::Target& target) { return !target.active; });
    return shown;
}

std::vector<MarkTag> drawScreenMarks(QPainter& painter, const QRect& place, const ScreenMarks& marks, const std::vector<QRectF>& plates,
                                     const std::vector<QRectF>& texts) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const QPolygonF& part : marks.cut)
        strokeTwice(painter, QPen(QColor(0, 0, 0, 200), 4.0), QPen(kCut, 2.0, Qt::DashDotLine), [&] { painter.drawPolyline(part); });
    for (const QLineF& move : marks.moves) drawMove(painter, move);
    for (const ScreenMarks::Measure& measure : marks.measures) drawMeasure(painter, measure);
    for (const ScreenMarks::Target& target : marks.targets) drawTarget(painter, target);
    std::vector<MarkTag> drawn;
    const QRectF inView = QRectF(place).adjusted(-kMarkRing, -kMarkRing, kMarkRing, kMarkRing);
    const auto isVisible = [&](const QPointF& at) {
        return inView.contains(at) && std::ranges::none_of(plates, [&](const QRectF& plate) { return plate.contains(at); });
    };
    std::vector<QRectF> taken = plates;
    taken.insert(taken.end(), texts.begin(), texts.end());
    std::vector<QPointF> rings;
    for (const ScreenMarks::Target& target : marks.targets) {
        if (isVisible(target.at)) rings.push_back(target.at);
    }
    if (rings.size() <= kMostFreeRings) {
        const QPointF corner(kRingReach, kRingReach);
        for (const QPointF& ring : rings) taken.emplace_back(ring - corner, ring + corner);
    }
    reserveChosen(marks, taken);
    std::vector<QLineF> lines;
    for (const ScreenMarks::Measure& measure : marks.measures) {
        if (!measure.lines.empty()) lines.push_back(measure.lines.front());
    }
    {
        Tags tags(painter, place, taken, rings, lines);
        for (auto target = marks.targets.rbegin(); target != marks.targets.rend(); ++target) { // the active one first
            if (isVisible(target->at)) // a tag without its mark would name another place
                tags.place({false, target->cell}, target->at, kMarkRing + kTagOffset, kMarkRing, target->tag, target->active,
                           target->brief);
        }
        for (auto measure = marks.measures.rbegin(); measure != marks.measures.rend(); ++measure) { // the chosen one first
            if (!measure->lines.empty() && isVisible(measure->labelAt))
                tags.place({true, measure->index}, measure->labelAt, kTagOffset, kTagOffset, measure->label, measure->active,
                           measure->brief, measure->lines.front());
        }
        drawn = tags.draw();
    }
    painter.restore();
    return drawn;
}

std::optional<MarkName> markAt(const ScreenMarks& marks, const std::vector<MarkTag>& tags, QPointF at, bool byFinger) {
    std::optional<MarkName> nearest;
    double least = byFinger ? kFingerReach : kMouseReach;
    const auto chooseNearer = [&](const MarkName& mark, double away) {
        if (nearest ? away >= least : away > least) return; // of equal ones the upper one
        nearest = mark;
        least = away;
    };
    const auto fromRing = [&](const QPointF& middle, double radius) { return std::max(0.0, QLineF(middle, at).length() - radius); };
    const auto isRemark = [&](const MarkName& mark) {
        return !mark.isMeasure &&
               std::ranges::none_of(marks.targets, [&](const auto& each) { return each.isTarget && each.cell == mark.which; });
    };
    const auto isChosen = [&](const MarkName& mark) {
        return mark.isMeasure
                   ? std::ranges::any_of(marks.measures, [&](const auto& each) { return each.active && each.index == mark.which; })
                   : std::ranges::any_of(marks.targets, [&](const auto& each) { return each.active && each.cell == mark.which; });
    };
    for (const MarkTag& tag : tags) {
        const double away = QLineF(nearestOn(tag, at), at).length();
        if (isRemark(tag.of) || (away > 0.0 && isChosen(tag.of))) continue; // next to the label of the chosen one, a place is meant
        chooseNearer({tag.of.isMeasure, tag.of.which, true}, away);
    }
    for (auto target = marks.targets.rbegin(); target != marks.targets.rend(); ++target) {
        if (target->isTarget) chooseNearer({false, target->cell}, fromRing(target->at, kMarkRing));
    }
    for (auto measure = marks.measures.rbegin(); measure != marks.measures.rend(); ++measure) {
        for (const QPointF& end : measure->ends) chooseNearer({true, measure->index}, fromRing(end, measure->active ? kMarkRing : kEndDot));
    }
    return nearest;
}

} // namespace edgescan::ui
