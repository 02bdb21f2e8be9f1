// A word with a shape and a colour.
#include "ui/panels/live/state_badge.h"

#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kShape = 12; // px
constexpr int kMargin = 6;

QColor groundOf(StateBadge::Sign sign) {
    switch (sign) {
    case StateBadge::Sign::Good:
        return {24, 92, 48};
    case StateBadge::Sign::Waiting:
        return {38, 72, 120};
    case StateBadge::Sign::Doubtful:
        return {122, 88, 0};
    case StateBadge::Sign::Failed:
        return {140, 28, 28};
    case StateBadge::Sign::Recorded:
        return {90, 63, 134};
    case StateBadge::Sign::File:
        return {77, 83, 90};
    case StateBadge::Sign::Off:
        break;
    }
    return {66, 66, 66};
}

void drawShape(QPainter& painter, StateBadge::Sign sign, const QRectF& place) {
    painter.setPen(QPen(Qt::white, 2.0));
    painter.setBrush(sign == StateBadge::Sign::Good ? QBrush(Qt::white) : QBrush(Qt::NoBrush));
    switch (sign) {
    case StateBadge::Sign::Good:
        painter.drawEllipse(place.adjusted(1, 1, -1, -1));
        return;
    case StateBadge::Sign::Waiting:
        for (const double x : {0.3, 0.7})
            painter.drawLine(QPointF(place.left() + x * place.width(), place.top() + 1),
                             QPointF(place.left() + x * place.width(), place.bottom() - 1));
        return;
    case StateBadge::Sign::Doubtful:
        painter.drawPolygon(QPolygonF(QVector<QPointF>{QPointF(place.center().x(), place.top()), place.bottomRight(), place.bottomLeft()}));
        return;
    case StateBadge::Sign::Failed:
        painter.drawLine(place.topLeft(), place.bottomRight());
        painter.drawLine(place.topRight(), place.bottomLeft());
        return;
    case StateBadge::Sign::Recorded:
        painter.drawPolygon(QPolygonF(QVector<QPointF>{place.topLeft(), QPointF(place.right(), place.center().y()), place.bottomLeft()}));
        return;
    case StateBadge::Sign::File:
        painter.drawRect(place.adjusted(2, 0.5, -2, -0.5));
        return;
    case StateBadge::Sign::Off:
        painter.drawLine(QPointF(place.left(), place.center().y()), QPointF(place.right(), place.center().y()));
    }
}

/// Margin and sign grow with the letters: in cab mode they are larger.
int grown(int pixels, const QFontMetrics& letters) {
    constexpr double kUsualLetters = 18.0;
    return static_cast<int>(std::lround(pixels * std::max(1.0, letters.height() / kUsualLetters)));
}

} // namespace

StateBadge::StateBadge(QWidget* parent) : QWidget(parent) {
    QFont bold = font();
    bold.setBold(true);
    setFont(bold);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
}

void StateBadge::setShrinks() { setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred); }

void StateBadge::setTwoLines() { twoLines_ = true; }

// The state is at one end, its time at the other: a narrow badge keeps both.
QStringList StateBadge::linesIn(int width) const {
    const QFontMetrics metrics(font());
    const auto fits = [&](const QString& words) { return metrics.horizontalAdvance(words) <= width; };
    if (fits(text_) || !twoLines_) return {metrics.elidedText(text_, Qt::ElideMiddle, width)};
    const QString separator = QStringLiteral(" · ");
    QString first;
    for (int at = text_.indexOf(' '); at >= 0 && fits(text_.left(at)); at = text_.indexOf(' ', at + 1)) first = text_.left(at);
    if (first.isEmpty()) return {metrics.elidedText(text_, Qt::ElideMiddle, width)};
    if (const int part = text_.lastIndexOf(separator); part > 0 && part < first.size()) first = text_.left(part); // LIVE above its time
    QString rest = text_.mid(first.size()).trimmed();
    if (rest.startsWith(separator.trimmed())) rest = rest.mid(1).trimmed();
    if (first.endsWith(separator.trimmed())) first = first.chopped(1).trimmed();
    return {first, metrics.elidedText(rest, Qt::ElideMiddle, width)};
}

void StateBadge::showState(Sign sign, const QString& text) {
    if (sign == sign_ && text == text_) return;
    sign_ = sign;
    text_ = text;
    setAccessibleName(text);
    updateGeometry();
    update();
}

QSize StateBadge::sizeHint() const {
    const QFontMetrics metrics(font());
    const int margin = grown(kMargin, metrics), shape = grown(kShape, metrics);
    return {margin + shape + margin + metrics.horizontalAdvance(text_) + margin / 2 + 1, std::max(metrics.height(), shape) + margin};
}

QSize StateBadge::minimumSizeHint() const {
    constexpr int kLeastLetters = 8;
    const QFontMetrics metrics(font());
    const int letters = metrics.averageCharWidth() * kLeastLetters, margin = grown(kMargin, metrics);
    return {std::min(sizeHint().width(), 3 * margin + grown(kShape, metrics) + letters), sizeHint().height()};
}

void StateBadge::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(groundOf(sign_));
    painter.drawRoundedRect(QRectF(rect()), 3, 3);
    const int margin = grown(kMargin, fontMetrics()), shape = grown(kShape, fontMetrics());
    drawShape(painter, sign_, QRectF(margin, (height() - shape) / 2.0, shape, shape));
    painter.setPen(Qt::white);
    const QRect place = rect().adjusted(margin + shape + margin, 0, -margin / 2, 0);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, linesIn(place.width()).join('\n'));
}

StateBadge::Sign signOf(files::Liveness liveness) {
    switch (liveness) {
    case files::Liveness::Connecting:
        return StateBadge::Sign::Waiting;
    case files::Liveness::Live:
        return StateBadge::Sign::Good;
    case files::Liveness::Stale:
        return StateBadge::Sign::Doubtful;
    case files::Liveness::Lost:
        return StateBadge::Sign::Failed;
    case files::Liveness::Stopped:
        break;
    }
    return StateBadge::Sign::Off;
}

StateBadge::Sign signOf(files::Condition condition) {
    switch (condition) {
    case files::Condition::Good:
        return StateBadge::Sign::Good;
    case files::Condition::OutOfSpec:
        return StateBadge::Sign::Doubtful;
    case files::Condition::Failure:
        break;
    }
    return StateBadge::Sign::Failed;
}

} // namespace edgescan::ui

#include "moc_state_badge.cpp"
