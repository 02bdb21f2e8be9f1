// Draws the size curve.
#include "ui/panels/rocks/size_curve_view.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kText = 12; // px
constexpr double kDot = 4.0;

QString metresText(double metres) { return QString::number(metres, 'f', 2); }

QString oversizeText(const rocks::SizeCurve& curve) {
    if (curve.oversizeM <= 0) return {};
    return SizeCurveView::tr("▲ %1 % over %2 m").arg(100.0 * curve.oversizeShare, 0, 'f', 0).arg(metresText(curve.oversizeM));
}

// Step of the axis: 0.1, 0.2, 0.5, 1 ... metres, so that it has at most five numbers.
double tickM(double rightM) {
    double tick = 0.05;
    for (int n = 0; rightM / tick > 5.0; ++n) tick *= n % 3 == 1 ? 2.5 : 2.0;
    return tick;
}

} // namespace

QString sizeCurveText(const rocks::SizeCurve& curve) {
    if (curve.rocks() == 0) return {};
    const QString over = oversizeText(curve);
    return SizeCurveView::tr("Visible width b by count: P20 %1, P50 %2, P80 %3 (20, 50, 80 % of the rocks are not wider), largest %4 m%5. "
                             "Hidden parts make this finer than the pile is, by 40 % and more.")
        .arg(metresText(curve.p20M), metresText(curve.p50M), metresText(curve.p80M), metresText(curve.topM),
             over.isEmpty() ? over : "; " + over);
}

SizeCurveView::SizeCurveView(QWidget* parent) : QWidget(parent) {
    setObjectName("size-curve");
    setFocusPolicy(Qt::NoFocus);
    show(rocks::SizeCurve{});
}

void SizeCurveView::show(const rocks::SizeCurve& curve) {
    curve_ = curve;
    const double largest = std::max({curve.topM, curve.oversizeM, 0.1});
    rightM_ = std::ceil(1.02 * largest / tickM(largest)) * tickM(largest);
    setAccessibleName(tr("Size curve"));
    setAccessibleDescription(sizeCurveText(curve));
    update();
}

void SizeCurveView::mark(std::vector<double> widthsM) {
    marked_ = std::move(widthsM);
    update();
}

QFont SizeCurveView::letters() const {
    QFont letters = font();
    letters.setPixelSize(kText);
    return letters;
}

int SizeCurveView::heightOf(const QString& text) const {
    return QFontMetrics(letters()).boundingRect(0, 0, width() - 8, 1000, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text).height();
}

QString SizeCurveView::caption() const {
    const QString whole = tr("Visible width b by count: 50 % of the rocks are not wider than P50. Hidden parts make this finer than the "
                             "pile is, by 40 % and more.");
    for (const QString& text : {whole, whole.section(". ", 0, 0) + "."}) {
        if (2 * heightOf(text) <= height()) return text; // the tool tip has all of it
    }
    return {};
}

QRectF SizeCurveView::plot() const {
    const double left = fontMetrics().horizontalAdvance("100 %") + 10.0;
    const QString above = caption();
    // Above 100 % is the number of the largest rock, where nothing else is drawn.
    return QRectF(QPointF(left, (above.isEmpty() ? 0 : heightOf(above)) + kText + 6.0),
                  QPointF(width() - 10.0, height() - 2.0 * kText - 8.0));
}

QPointF SizeCurveView::placeOf(double wideM, double share) const {
    const QRectF area = plot();
    return {area.left() + wideM / rightM_ * area.width(), area.bottom() - share * area.height()};
}

QString SizeCurveView::textAt(QPointF place) const {
    const QRectF area = plot();
    if (curve_.rocks() == 0 || !area.contains(place)) return sizeCurveText(curve_);
    const double wideM = (place.x() - area.left()) / area.width() * rightM_;
    return tr("%1 % of the rocks have a visible width of %2 m at most")
        .arg(100.0 * curve_.shareUpTo(wideM), 0, 'f', 0)
        .arg(metresText(wideM));
}

bool SizeCurveView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), textAt(help->pos()), this);
    return true;
}

void SizeCurveView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(letters());
    painter.setPen(palette().color(QPalette::WindowText));
    if (curve_.rocks() == 0) {
        painter.drawText(rect(), Qt::AlignCenter, tr("no rocks to count"));
        return;
    }
    painter.drawText(QRect(4, 0, width() - 8, height()), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, caption());
    drawAxes(painter);
    drawOversize(painter);
    drawCurve(painter);
}

void SizeCurveView::drawAxes(QPainter& painter) const {
    const QColor ink = palette().color(QPalette::WindowText);
    const QColor line = palette().color(QPalette::Mid);
    const QRectF area = plot();
    for (const int percent : {0, 50, 100}) {
        const double y = placeOf(0, percent / 100.0).y();
        painter.setPen(line);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(0, y - kText / 2.0 - 1, area.left() - 5, kText + 2), Qt::AlignRight | Qt::AlignVCenter,
                         tr("%1 %").arg(percent));
    }
    painter.setPen(line);
    const double step = tickM(rightM_);
    for (int n = 0; n * step <= rightM_ + 1e-9; ++n) {
        const double x = placeOf(n * step, 0).x();
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 3));
    }
    painter.setPen(ink);
    for (const AxisLabel& label : axisLabels()) painter.drawText(label.place, Qt::AlignCenter, label.text);
}

std::vector<SizeCurveView::AxisLabel> SizeCurveView::axisLabels() const {
    constexpr double kBetween = 6.0; // px
    const QFontMetrics metrics(letters());
    const double step = tickM(rightM_);
    std::vector<AxisLabel> labels; // from the right
    for (int n = static_cast<int>(std::floor(rightM_ / step + 1e-9)); n >= 0; --n) {
        const QString text = QString::number(n * step, 'g', 3) + (labels.empty() ? tr(" m") : QString());
        const double wide = metrics.horizontalAdvance(text) + 1.0;
        const double left = std::min(placeOf(n * step, 0).x() - wide / 2, width() - 2 - wide);
        if (!labels.empty() && left + wide + kBetween > labels.back().place.left()) continue;
        labels.push_back({QRectF(left, plot().bottom() + 3, wide, kText + 3), text});
    }
    return labels;
}

// Hatched, with an icon and text, so that colour is not the only sign.
void SizeCurveView::drawOversize(QPainter& painter) const {
    if (curve_.oversizeM <= 0) return;
    const QRectF area = plot();
    const double x = placeOf(curve_.oversizeM, 0).x();
    painter.fillRect(QRectF(QPointF(x, area.top()), area.bottomRight()), QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.4, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(0, height() - kText - 3.0, width() - 6.0, kText + 2), Qt::AlignRight | Qt::AlignVCenter, oversizeText(curve_));
}

void SizeCurveView::drawCurve(QPainter& painter) const {
    QPainterPath path(placeOf(0, 0));
    const auto count = static_cast<double>(curve_.rocks());
    for (std::size_t n = 0; n < curve_.rocks(); ++n) {
        path.lineTo(placeOf(curve_.widthsM[n], static_cast<double>(n) / count));
        path.lineTo(placeOf(curve_.widthsM[n], static_cast<double>(n + 1) / count));
    }
    path.lineTo(placeOf(rightM_, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.6));
    painter.drawPath(path);

    struct Mark {
        const char* name;
        double wideM, share;
    };
    const std::array<Mark, 4> marks{
        {{"P20", curve_.p20M, 0.2}, {"P50", curve_.p50M, 0.5}, {"P80", curve_.p80M, 0.8}, {"largest", curve_.topM, 1.0}}};
    const QColor accent = palette().color(QPalette::Link);
    std::vector<QRectF> written;
    for (const Mark& mark : marks) {
        const QPointF at = placeOf(mark.wideM, mark.share);
        painter.setPen(QPen(accent, 1.0, Qt::DotLine));
        painter.drawLine(at, placeOf(mark.wideM, 0));
        painter.setPen(Qt::NoPen);
        painter.setBrush(accent);
        painter.drawEllipse(at, kDot / 1.4, kDot / 1.4);
        painter.setPen(palette().color(QPalette::WindowText));
        const QString text = tr(mark.name) + " " + metresText(mark.wideM);
        const bool atTop = mark.share >= 1.0;
        const double wide = painter.fontMetrics().horizontalAdvance(text);
        const double x = std::min(at.x() + 6, width() - wide - 4);
        const QRectF place(x, atTop ? at.y() - kText - 5 : at.y() + 1, wide + 2, kText + 3);
        const auto crosses = [&](const QRectF& other) { return other.intersects(place); };
        if (std::ranges::any_of(written, crosses)) continue; // the panel shows this number too
        written.push_back(place);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, text);
    }
    painter.setPen(QPen(palette().color(QPalette::Base), 1.0));
    painter.setBrush(palette().color(QPalette::BrightText));
    for (const double wideM : marked_) painter.drawEllipse(placeOf(wideM, curve_.shareUpTo(wideM)), kDot, kDot);
}

} // namespace edgescan::ui

#include "moc_size_curve_view.cpp"
