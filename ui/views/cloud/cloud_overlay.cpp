// Marker, laser ray and texts over the 3D picture.
#include "ui/views/cloud/cloud_overlay.h"

#include "ui/base/marks.h"

#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr double kRing = 9.0; // radius, px: the same on the screen at every distance
constexpr int kLabelMargin = 8;
constexpr double kArrow = 22.0, kArrowInset = 10.0, kArrowStep = 4.0; // px

} // namespace

CloudOverlay::CloudOverlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void CloudOverlay::setMarks(const OverlayMarks& marks) {
    if (marks == marks_) return;
    const QRect before = covered(marks_);
    marks_ = marks;
    if (marks_.marks.empty()) tags_.clear();
    setVisible(!marks_.empty());
    update(before.united(covered(marks_)));
}

QRect CloudOverlay::covered(const OverlayMarks& marks) const {
    const bool words = !marks.centreText.isEmpty() || !marks.note.isEmpty() || marks.frame.colour.isValid();
    if (words || !marks.marks.empty() || !marks.dragged.isEmpty() || marks.way) return rect();
    const double reach = kRing + 4.0;
    QRectF area;
    if (marks.ring) area = QRectF(*marks.ring, *marks.ring).adjusted(-reach, -reach, reach, reach);
    if (marks.ray) area = area.united(QRectF(marks.ray->p1(), marks.ray->p2()).normalized().adjusted(-reach, -reach, reach, reach));
    if (marks.tipAt && !marks.tip.isEmpty())
        area = area.united(tipBox(fontMetrics(), rect(), marks.tipAt->toPoint(), marks.tip).adjusted(-2, -2, 2, 2));
    return area.toAlignedRect().intersected(rect());
}

std::vector<QRectF> CloudOverlay::platesOver() const {
    std::vector<QRectF> plates;
    for (const QWidget* other : parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (other != this && other->isVisible()) plates.emplace_back(other->geometry());
    }
    return plates;
}

std::optional<QLineF> CloudOverlay::arrow() const {
    const QRectF room = QRectF(rect()).adjusted(kArrowInset, kArrowInset, -kArrowInset, -kArrowInset);
    if (!marks_.way || room.isEmpty()) return std::nullopt;
    const double across = std::abs(marks_.way->x()) / (room.width() / 2.0), down = std::abs(marks_.way->y()) / (room.height() / 2.0);
    const QLineF whole(room.center(), room.center() + *marks_.way / std::max({across, down, 1e-9}));
    for (double end = whole.length(); end > 2.0 * kArrow; end -= kArrowStep) {
        const QPointF tip = whole.pointAt(end / whole.length());
        const QRectF box = QRectF(tip - QPointF(kArrow, kArrow), QSizeF(2.0 * kArrow, 2.0 * kArrow));
        if (std::ranges::any_of(plates_, [&](const QRectF& plate) { return plate.intersects(box); })) continue;
        return QLineF(whole.pointAt((end - kArrow) / whole.length()), tip);
    }
    return QLineF(whole.pointAt(std::max(0.0, 1.0 - kArrow / std::max(kArrow, whole.length()))), whole.p2());
}

void CloudOverlay::paintEvent(QPaintEvent* /*event*/) {
    // A plate that moved uncovers only its old place: the tags that avoid it are somewhere else.
    auto plates = platesOver();
    if (std::exchange(plates_, std::move(plates)) != plates_ && !marks_.marks.empty()) update();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (marks_.ray) {
        const QPen light(QColor(255, 90, 80), 1.4, marks_.hidden ? Qt::DashLine : Qt::SolidLine);
        strokeTwice(painter, QPen(QColor(0, 0, 0, 120), 3.0), light, [&] { painter.drawLine(*marks_.ray); });
    }
    if (marks_.ring) { // below the digits of the marks
        const QPen light(Qt::white, 2.0, marks_.hidden ? Qt::DotLine : Qt::SolidLine);
        strokeTwice(painter, QPen(QColor(0, 0, 0, 220), 4.0), light, [&] { painter.drawEllipse(*marks_.ring, kRing, kRing); });
        painter.setPen(QPen(Qt::black, 1.0));
        painter.setBrush(Qt::white);
        painter.drawEllipse(*marks_.ring, 2.0, 2.0);
    }
    tags_ = drawScreenMarks(painter, rect(), marks_.marks, plates_, {QRectF(label_)});
    painter.setBrush(Qt::NoBrush);
    if (!marks_.dragged.isEmpty())
        strokeTwice(painter, QPen(QColor(0, 0, 0, 170), 3.0), QPen(Qt::white, 1.0, Qt::DashLine),
                    [&] { painter.drawPolygon(marks_.dragged); });
    if (const auto to = arrow()) {
        const QLineF across = to->normalVector();
        const QPointF side = QPointF(across.dx(), across.dy()) * 0.45;
        painter.setPen(QPen(Qt::black, 2.0));
        painter.setBrush(Qt::white);
        painter.drawPolygon(QPolygonF(QVector<QPointF>{to->p2(), to->p1() + side, to->p1() - side}));
        painter.setBrush(Qt::NoBrush);
    }
    const QRect corner = plates_.empty() ? QRect() : plates_.front().toAlignedRect(); // the picture in it
    warning_ = drawPictureFrame(painter, rect(), marks_.frame, corner);
    const QRect inner = rect().adjusted(kLabelMargin + 6, kLabelMargin + 3, -kLabelMargin - 6, -kLabelMargin - 3);
    const int taken = corner.isNull() ? 0 : width() - corner.left();
    const QRect label = drawLabel(painter, inner.adjusted(0, 0, -taken, 0), Qt::AlignLeft | Qt::AlignTop, marks_.note);
    if (std::exchange(label_, label) != label && !marks_.marks.empty()) update(); // the tags avoid it
    if (marks_.tipAt && !marks_.tip.isEmpty()) drawTipAt(painter, rect(), marks_.tipAt->toPoint(), marks_.tip);
    if (!marks_.centreText.isEmpty()) drawLabel(painter, inner, Qt::AlignCenter, marks_.centreText);
}

} // namespace edgescan::ui

#include "moc_cloud_overlay.cpp"
