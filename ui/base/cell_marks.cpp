// Targets and measurements over a picture.
#include "ui/base/cell_marks.h"

#include "ui/base/marks.h"

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr double kMarkRing = 8.0;      // radius, px
constexpr double kEndDot = 3.5;        // of what is measured
constexpr int kTagBeside = 6;          // px from the ring
const QColor kMeasured(120, 190, 255); // the line being measured; its halo tells it from the cloud

QFont boldFont(const QPainter& painter) {
    QFont bold = painter.font();
    bold.setBold(true);
    return bold;
}

void drawTag(QPainter& painter, const QRect& place, const QPointF& beside, const QString& text, bool active) {
    if (text.isEmpty()) return;
    painter.save();
    painter.setFont(boldFont(painter));
    QRectF box = QRectF(painter.fontMetrics().boundingRect(text)).adjusted(-5, -2, 5, 2);
    box.moveBottomLeft(beside);
    box.moveLeft(std::clamp(box.left(), place.left() + 2.0, std::max(place.left() + 2.0, place.right() - 2.0 - box.width())));
    box.moveTop(std::clamp(box.top(), place.top() + 2.0, std::max(place.top() + 2.0, place.bottom() - 2.0 - box.height())));
    painter.setPen(active ? Qt::black : QColor(232, 232, 232));
    painter.setBrush(active ? QColor(255, 255, 255, 240) : QColor(27, 29, 31, 225));
    painter.drawRoundedRect(box, 3, 3);
    painter.drawText(box, Qt::AlignCenter, text);
    painter.restore();
}

void drawTarget(QPainter& painter, const QRect& place, const ScreenMarks::Target& target) {
    const Qt::PenStyle style = target.place.hidden ? Qt::DotLine : Qt::SolidLine;
    painter.setBrush(Qt::NoBrush);
    strokeTwice(painter, QPen(QColor(0, 0, 0, 220), 4.0), QPen(Qt::white, 2.0, style),
                [&] { painter.drawEllipse(target.place.at, kMarkRing, kMarkRing); });
    painter.setPen(QPen(Qt::black, 1.0));
    painter.setBrush(Qt::white);
    painter.drawEllipse(target.place.at, 2.0, 2.0);
    drawTag(painter, place, target.place.at + QPointF(kMarkRing + kTagBeside, -kMarkRing), target.tag, target.active);
}

void drawMeasure(QPainter& painter, const QRect& place, const ScreenMarks::Measure& measure) {
    painter.setBrush(Qt::NoBrush);
    strokeTwice(painter, QPen(QColor(0, 0, 0, 200), 4.0), QPen(kMeasured, 2.0), [&] {
        for (const QLineF& line : measure.lines) painter.drawLine(line);
    });
    painter.setPen(QPen(Qt::black, 1.5));
    painter.setBrush(kMeasured);
    for (const QPointF& end : measure.ends) painter.drawEllipse(end, kEndDot, kEndDot);
    if (!measure.lines.empty()) drawTag(painter, place, measure.labelAt + QPointF(kTagBeside, -kTagBeside), measure.label, false);
}

} // namespace

ScreenMarks screenMarks(const CellMarks& marks, const std::function<std::optional<MarkPlace>(std::size_t)>& placeOf, bool small) {
    ScreenMarks shown;
    for (const MeasureMark& measure : marks.measures) {
        ScreenMarks::Measure drawn;
        std::vector<std::optional<MarkPlace>> places;
        for (const std::size_t cell : measure.cells) {
            places.push_back(placeOf(cell));
            if (places.back()) drawn.ends.push_back(places.back()->at);
        }
        for (const auto& [a, b] : measure.links) {
            if (a >= places.size() || b >= places.size() || !places[a] || !places[b]) continue;
            drawn.lines.emplace_back(places[a]->at, places[b]->at);
        }
        if (!drawn.lines.empty()) drawn.labelAt = drawn.lines.front().center();
        drawn.label = measure.label;
        if (!drawn.ends.empty()) shown.measures.push_back(std::move(drawn));
    }
    for (const TargetMark& target : marks.targets) {
        const QString& words = small && !target.active ? target.brief : target.tag;
        if (const auto place = placeOf(target.cell)) shown.targets.push_back({*place, words, target.active});
    }
    // The one whose card is shown lies over the others.
    std::stable_partition(shown.targets.begin(), shown.targets.end(), [](const ScreenMarks::Target& target) { return !target.active; });
    return shown;
}

void drawScreenMarks(QPainter& painter, const QRect& place, const ScreenMarks& marks) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ScreenMarks::Measure& measure : marks.measures) drawMeasure(painter, place, measure);
    for (const ScreenMarks::Target& target : marks.targets) drawTarget(painter, place, target);
    painter.restore();
}

} // namespace edgescan::ui
