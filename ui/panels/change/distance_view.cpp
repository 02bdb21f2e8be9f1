// Draws the bars.
#include "ui/panels/change/distance_view.h"

#include "ui/base/shown_text.h"
#include "ui/views/cloud/cloud_colours.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kBarsHigh = 44, kUnderBars = 18, kWide = 220; // px

} // namespace

DistanceView::DistanceView(QWidget* parent) : QWidget(parent) {
    setObjectName("change-histogram");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMinimumSize(sizeHint());
    hide();
}

QSize DistanceView::sizeHint() const { return {kWide, kBarsHigh + kUnderBars}; }

void DistanceView::showDistances(std::shared_ptr<const SurfaceDistances> distances) {
    distances_ = std::move(distances);
    setVisible(distances_ != nullptr);
    update();
}

void DistanceView::paintEvent(QPaintEvent*) {
    if (!distances_) return;
    QPainter painter(this);
    const inspect::DistanceHistogram& histogram = distances_->histogram;
    // Up to the end of the colour scale; the last bar has what is farther.
    const auto shown = static_cast<std::size_t>(
        std::clamp(std::ceil(distances_->scaleM / histogram.stepM), 1.0, static_cast<double>(histogram.counts.size())));
    std::vector<std::size_t> bars(histogram.counts.begin(), histogram.counts.begin() + static_cast<std::ptrdiff_t>(shown));
    std::size_t farther = histogram.beyond;
    for (std::size_t n = shown; n < histogram.counts.size(); ++n) farther += histogram.counts[n];
    bars.push_back(farther);
    const double most = std::sqrt(static_cast<double>(std::max<std::size_t>(1, *std::ranges::max_element(bars))));
    const double wide = static_cast<double>(width()) / static_cast<double>(bars.size());
    for (std::size_t n = 0; n < bars.size(); ++n) {
        const double high = kBarsHigh * std::sqrt(static_cast<double>(bars[n])) / most;
        const QRectF bar(static_cast<double>(n) * wide, kBarsHigh - high, std::max(1.0, wide - 1.0), high);
        painter.fillRect(bar, QColor(colourAt(static_cast<double>(n) / static_cast<double>(bars.size() - 1))));
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect under(0, kBarsHigh, width(), kUnderBars);
    painter.drawText(under, Qt::AlignLeft | Qt::AlignVCenter, "0");
    painter.drawText(under, Qt::AlignRight | Qt::AlignVCenter, "≥ " + shortLength(distances_->scaleM));
}

} // namespace edgescan::ui
