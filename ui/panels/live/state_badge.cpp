// A word with a shape and a colour.
#include "ui/panels/live/state_badge.h"

#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

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

constexpr int kLeastLetters = 8, kLeastName = 12;
constexpr int kThreeLinesPx = 15; // letters: as large as the facts next to it

struct BadgeParts {
    QString name, between, time, ago; ///< "FILE north 3", " · ", "2026-11-19 08:12:05 UTC", ", 5 days ago"
};

/// With one ellipsis, also if the name has one already.
QString shortened(const QString& name, const QFontMetrics& letters, int room, Qt::TextElideMode where) {
    QString shown = letters.elidedText(name, where, room);
    const QChar ellipsis(0x2026);
    const int first = shown.indexOf(ellipsis), last = shown.lastIndexOf(ellipsis);
    return first == last ? shown : shown.left(first) + shown.mid(last);
}

/// Without a time in the text, what is after the last separator.
BadgeParts partsOf(const QString& text) {
    static const QRegularExpression time("(\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d UTC)(.*)$");
    static const QRegularExpression separator("( · | )$");
    const QRegularExpressionMatch found = time.match(text);
    const int part = text.lastIndexOf(QStringLiteral(" · "));
    if (!found.hasMatch()) return part < 0 ? BadgeParts{text, {}, {}, {}} : BadgeParts{text.left(part), " · ", text.mid(part + 3), {}};
    QString name = text.left(found.capturedStart());
    const QString between = separator.match(name).captured();
    name.chop(between.size());
    return {name, between, found.captured(1), found.captured(2)};
}

} // namespace

StateBadge::StateBadge(QWidget* parent) : QWidget(parent) {
    QFont bold = font();
    bold.setBold(true);
    setFont(bold);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
}

void StateBadge::setShrinks() { setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred); }

void StateBadge::setRoom(int pixels) {
    setShrinks();
    if (std::exchange(room_, pixels) != pixels) updateGeometry();
}

void StateBadge::setTwoLines() { twoLines_ = true; }

/// The time is always whole, in two lines if it has to be. The name of a file is shortened in its middle, a state at its end.
QStringList StateBadge::linesIn(int width) const {
    const QFontMetrics metrics(font());
    const auto fits = [&](const QString& words) { return metrics.horizontalAdvance(words) <= width; };
    if (fits(text_)) return {text_};
    const BadgeParts parts = partsOf(text_);
    const bool isFile = sign_ == Sign::File || sign_ == Sign::Recorded;
    const Qt::TextElideMode where = isFile ? Qt::ElideMiddle : Qt::ElideRight;
    if (parts.time.isEmpty()) return twoLines_ ? brokenIn(width) : QStringList{metrics.elidedText(text_, Qt::ElideRight, width)};
    if (!twoLines_) {
        const int room = width - metrics.horizontalAdvance(parts.between + parts.time);
        const bool some = room >= kLeastLetters * metrics.averageCharWidth();
        return {some ? shortened(parts.name, metrics, room, where) + parts.between + parts.time
                     : metrics.elidedText(text_, Qt::ElideRight, width)};
    }
    // Of a state that has no room, what comes after its comma or dot is left out: the strip has it, or the tool tip.
    const QString name = isFile || fits(parts.name) ? parts.name : parts.name.section(',', 0, 0).section(QStringLiteral(" · "), 0, 0);
    const QString state = isFile ? name.left(name.indexOf(' ') + 1) : QString(); // whole
    const int left = width - metrics.horizontalAdvance(state);
    // Too little of a name is not recognised; it is the title next to it.
    const bool some = state.isEmpty() || fits(name) || left >= kLeastName * metrics.averageCharWidth();
    QStringList lines{some ? state + shortened(name.mid(state.size()), metrics, left, where) : state.trimmed()};
    if (fits(parts.time + parts.ago)) return lines << parts.time + parts.ago;
    if (fits(parts.time)) return lines << parts.time;
    if (room_ > 0) return lines << metrics.elidedText(parts.time, Qt::ElideLeft, width); // the seconds stay
    return lines << parts.time.section(' ', 0, 0) << parts.time.section(' ', 1);
}

/// Two lines, the first with as many words as it has room for.
QStringList StateBadge::brokenIn(int width) const {
    const QFontMetrics metrics(font());
    QString first;
    for (int at = text_.indexOf(' '); at >= 0 && metrics.horizontalAdvance(text_.left(at)) <= width; at = text_.indexOf(' ', at + 1))
        first = text_.left(at);
    if (first.isEmpty()) return {metrics.elidedText(text_, Qt::ElideRight, width)};
    return {first, metrics.elidedText(text_.mid(first.size()).trimmed(), Qt::ElideRight, width)};
}

void StateBadge::mousePressEvent(QMouseEvent* event) { event->setAccepted(twoLines_); }

void StateBadge::mouseReleaseEvent(QMouseEvent* event) {
    if (rect().contains(event->pos())) emit clicked();
}

void StateBadge::showState(Sign sign, const QString& text) {
    if (sign == sign_ && text == text_) return;
    sign_ = sign;
    text_ = text;
    setAccessibleName(text);
    updateGeometry();
    update();
}

int StateBadge::widthFor(const QString& text) const {
    const QFontMetrics metrics(font());
    const int margin = grown(kMargin, metrics), shape = grown(kShape, metrics);
    return margin + shape + margin + metrics.horizontalAdvance(text) + margin / 2 + 1;
}

QSize StateBadge::sizeHint() const {
    const QFontMetrics metrics(font());
    const int high = room_ > 0 && twoLines_ ? 2 * metrics.height() : metrics.height() + grown(kMargin, metrics);
    return {room_ > 0 ? room_ : widthFor(text_), std::max(high, grown(kShape, metrics) + grown(kMargin, metrics))};
}

QSize StateBadge::minimumSizeHint() const {
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
    const QStringList lines = this->lines();
    if (lines.size() > 2) {
        QFont letters = font();
        letters.setPixelSize(kThreeLinesPx);
        painter.setFont(letters);
    }
    painter.drawText(textPlace(), Qt::AlignLeft | Qt::AlignVCenter, lines.join('\n'));
}

QRect StateBadge::textPlace() const {
    const int margin = grown(kMargin, fontMetrics()), shape = grown(kShape, fontMetrics());
    return rect().adjusted(margin + shape + margin, 0, -margin / 2, 0);
}

QStringList StateBadge::lines() const { return linesIn(textPlace().width()); }

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
