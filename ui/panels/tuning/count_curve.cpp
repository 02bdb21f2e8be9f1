// Draws the edge count over the threshold.
#include "ui/panels/tuning/count_curve.h"

#include "core/edges/settings/parameters.h"
#include "core/edges/settings/slider_scale.h"
#include "ui/base/count_text.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kTextHeight = 14;
const QColor kPlateau(86, 180, 233, 70);

} // namespace

CountCurve::CountCurve(const edges::Parameter& parameter, QWidget* parent) : QWidget(parent), parameter_(parameter) {
    setObjectName(QString("curve-") + parameter.key);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Number of edge cells at every threshold, from the least to the most on a logarithmic scale. Hatched: the widest range "
                  "over which at most a fifth of "
                  "them disappears. The vertical line is the threshold in use."));
}

void CountCurve::showCurve(std::optional<edges::EdgeCountCurve> curve) {
    curve_ = std::move(curve);
    setAccessibleDescription(words());
    update();
}

void CountCurve::showValue(double value) {
    if (value == value_) return;
    value_ = value;
    update();
}

void CountCurve::showFound(double threshold, std::size_t edges) {
    found_ = {threshold, edges};
    setAccessibleDescription(words());
    update();
}

double CountCurve::xOf(double threshold) const {
    const int margin = style()->pixelMetric(QStyle::PM_SliderLength) / 2; // limits of the centre of the slider's handle
    const double share = static_cast<double>(edges::sliderPosition(parameter_, threshold)) / edges::kSliderSteps;
    return margin + share * (width() - 2 * margin - 1);
}

double CountCurve::yOf(std::size_t edges) const {
    const auto [least, most] = std::ranges::minmax(curve_->edges);
    const double low = std::log1p(static_cast<double>(least)), high = std::log1p(static_cast<double>(most));
    const double share = high > low ? (std::log1p(static_cast<double>(edges)) - low) / (high - low) : 0.5;
    return height() - 2 - share * (height() - kTextHeight - 4);
}

QString CountCurve::words(bool brief) const {
    if (!curve_ || curve_->edges.empty()) return found_ ? tr("counting the edge cells …") : QString(); // without a scan nothing is counted
    const auto next = std::ranges::lower_bound(curve_->thresholds, value_);
    const auto place = std::min(static_cast<std::size_t>(next - curve_->thresholds.begin()), curve_->edges.size() - 1);
    const std::size_t edges = found_ && found_->first == value_ ? found_->second : curve_->edges[place];
    QString text = tr("%1 edge cells").arg(countText(edges));
    if (!brief && curve_->stableTo > curve_->stableFrom)
        text += tr(" · steady from %1 to %2").arg(curve_->stableFrom, 0, 'g', 3).arg(curve_->stableTo, 0, 'g', 3);
    return text;
}

void CountCurve::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    QFont font = painter.font();
    font.setPixelSize(kTextHeight - 3);
    painter.setFont(font);
    QString text = words();
    if (painter.fontMetrics().horizontalAdvance(text) > width()) text = words(true);
    painter.drawText(QRect(0, 0, width(), kTextHeight), Qt::AlignLeft | Qt::AlignVCenter, text);
    if (!curve_ || curve_->edges.empty()) return;

    const QRectF below(0, kTextHeight, width(), height() - kTextHeight);
    if (curve_->stableTo > curve_->stableFrom) {
        const QRectF plateau(QPointF(xOf(curve_->stableFrom), below.top()), QPointF(xOf(curve_->stableTo), below.bottom()));
        painter.fillRect(plateau, kPlateau);
        painter.fillRect(plateau, QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern)); // hatched, so that colour is not the only sign
    }
    QPainterPath path;
    for (std::size_t n = 0; n < curve_->edges.size(); ++n) {
        const QPointF at(xOf(curve_->thresholds[n]), yOf(curve_->edges[n]));
        if (n == 0)
            path.moveTo(at);
        else
            path.lineTo(at);
    }
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.4));
    painter.drawPath(path);
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    const double x = xOf(std::clamp(value_, curve_->thresholds.front(), curve_->thresholds.back()));
    painter.drawLine(QPointF(x, below.top()), QPointF(x, below.bottom()));
    painter.setPen(palette().color(QPalette::WindowText));
    // The ends of the curve, where it leaves room as it falls.
    const auto label = [&](Qt::Alignment side, const QString& arrows, std::size_t n) {
        const QString words = arrows.arg(QString::number(curve_->thresholds[n], 'g', 3) + ": " + countText(curve_->edges[n]));
        const QRectF place = painter.boundingRect(below, side, words);
        painter.fillRect(place, palette().window());
        painter.drawText(place, side, words);
    };
    label(Qt::AlignRight | Qt::AlignTop, "← %1", 0);
    label(Qt::AlignLeft | Qt::AlignBottom, "%1 →", curve_->edges.size() - 1);
}

} // namespace edgescan::ui

#include "moc_count_curve.cpp"
