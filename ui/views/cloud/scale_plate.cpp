// Draws the scale bar, the axes and the colour scale of the cloud.
#include "ui/views/cloud/scale_plate.h"

#include "core/base/order_statistic.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/views/cloud/cloud_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr double kMostBar = 84.0; // px
constexpr int kColours = 50;
constexpr QSize kPlain(168, 64), kBrief(134, 46); // px; brief: without axes and grid
constexpr double kAxis = 15.0;                    // px
constexpr int kLetters = 12;                      // px, for the usual font height of the window ...
constexpr double kUsualLetters = 17.0;            // ... which is this many px

/// X, Y, Z in red, green and blue, each with contrast to the ground of the theme.
std::array<QColor, 3> axisInks() {
    const Theme& theme = themeInUse();
    const bool isDark = theme.window.lightness() < theme.text.lightness();
    return {theme.bad, isDark ? QColor(0x7f, 0xd9, 0x62) : QColor(0x1d, 0x5e, 0x0c), theme.accent};
}

} // namespace

ScalePlate::ScalePlate(CloudView* cloud) : cloud_(cloud) {
    setObjectName("scale-plate");
    setToolTip(tr("The bar has this length at the median distance of the points in view. The distance counts from the scanner."));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(cloud, &CloudView::frameDrawn, this, &ScalePlate::follow);
    cloud->installEventFilter(this);
    hide();
}

bool ScalePlate::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::HideToParent) hide(); // a frame shows it
    return QWidget::eventFilter(watched, event);
}

void ScalePlate::setBrief(bool on) {
    brief_ = on;
    updateGeometry();
}

bool ScalePlate::coloured() const { return colours_.points && cloud_->pointColours() == colours_.points; }

void ScalePlate::follow() {
    if (std::exchange(coloured_, coloured()) != coloured_) updateGeometry();
    setVisible(cloud_->geometryOfCloud() && cloud_->geometryOfCloud()->validCount > 0 && cloud_->isVisible());
    if (!cloud_->geometryOfCloud()) return;
    const double step = cloud_->groundStepM();
    const QString ground = step > 0.0 ? tr("grid %1").arg(shortLength(step)) : QString();
    if (ground != groundText_) update();
    groundText_ = ground;
    if (scan_ != cloud_->frameOf()) {
        scan_ = cloud_->frameOf();
        const bool mine = scan_ && scan_->placement;
        frame_ = mine ? mineAxes(*scan_) : Eigen::Matrix3d::Identity();
        names_ = mine ? std::array<QString, 3>{"E", "N", "RL"} : std::array<QString, 3>{"X", "Y", "Z"};
    }
    const CameraPose pose = cloud_->camera();
    const ViewInputs inputs{cloud_->geometryOfCloud(), pose, cloud_->clip(), cloud_->size()};
    if (inputs != viewInputs_) depth_ = medianDepth();
    viewInputs_ = inputs;
    const double depth = depth_;
    const double perMetre = cloud_->height() / (2.0 * pose.halfHeight()) * (pose.parallel ? 1.0 : pose.distance() / depth);
    const double metres = roundedDown(kMostBar * unit() / perMetre);
    const QString text = barWords(shortLength(metres), depth);
    std::array<Eigen::Vector2d, 3> axes;
    for (int n = 0; n < 3; ++n) axes[static_cast<std::size_t>(n)] = {pose.right().dot(frame_.col(n)), pose.up.dot(frame_.col(n))};
    if (text == barText_ && metres * perMetre == barPixels_ && axes == axes_) return;
    barText_ = text;
    barPixels_ = metres * perMetre;
    axes_ = axes;
    update();
}

/// The distance counts from the scanner, as ranges do, where the view looks from there.
QString ScalePlate::barWords(const QString& length, double depth) const {
    constexpr double kMostAside = 0.1, kMostBack = 0.25; // of the depth
    const CameraPose pose = cloud_->camera();
    if (pose.parallel) return length;
    const Eigen::Vector3d sensor = cloud_->geometryOfCloud()->sensor.cast<double>() - pose.position;
    const double along = pose.forward().dot(sensor), aside = (sensor - along * pose.forward()).norm();
    if (aside > kMostAside * depth || std::abs(along) > kMostBack * depth) return QString::fromUtf8("≈ ") + length;
    return tr("%1 at %2 m").arg(length).arg(depth - along, 0, 'f', 1);
}

/// Of some of the points in view: the middle of the view may look through a gap. Without a point in view: of the cloud's centre.
double ScalePlate::medianDepth() const {
    const CameraPose pose = cloud_->camera();
    const auto depthOf = [&pose](const Eigen::Vector3f& at) { return pose.forward().dot(at.cast<double>() - pose.position); };
    std::vector<double> depths;
    for (const CloudView::Sample& each : cloud_->samples()) {
        if (each.pixel && QRectF(cloud_->rect()).contains(*each.pixel)) depths.push_back(depthOf(each.point));
    }
    const double depth = median(std::move(depths), depthOf(cloud_->geometryOfCloud()->mainBounds.center()));
    return depth > 1e-3 ? depth : pose.distance();
}

void ScalePlate::showColours(const CloudColours& colours) {
    colours_ = colours;
    coloured_ = coloured();
    updateGeometry();
    update();
}

double ScalePlate::unit() const { return std::max(1.0, fontMetrics().height() / kUsualLetters); }

QSize ScalePlate::plain() const { return brief_ ? kBrief : kPlain; }

double ScalePlate::across() const { return width() / unit(); }

QSize ScalePlate::sizeHint() const { return (plain() + QSize(0, coloured_ ? kColours : 0)) * unit(); }

QString ScalePlate::scaleTitle() const {
    if (!coloured_) return {};
    switch (colours_.by) {
    case ColourBy::Range:
        return tr("Range [m]");
    case ColourBy::Height:
        return colours_.mine ? tr("RL [m]") : tr("Height above the scanner [m]");
    case ColourBy::Line:
        return tr("Line");
    case ColourBy::Intensity:
        return tr("Intensity");
    case ColourBy::Nothing:
        break;
    }
    return {};
}

std::vector<std::pair<double, QString>> ScalePlate::scaleTicks() const {
    std::vector<std::pair<double, QString>> ticks;
    if (!coloured_) return ticks;
    const double span = colours_.high - colours_.low;
    double step = roundedDown(span / 2.5);
    if (colours_.by == ColourBy::Line) step = std::max(1.0, step);
    const int decimals = step >= 1.0 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    for (double value = std::ceil(colours_.low / step - 1e-9) * step; value <= colours_.high + 1e-9 * span; value += step)
        ticks.emplace_back((value - colours_.low) / span, QString::number(std::abs(value) < 1e-9 ? 0.0 : value, 'f', decimals));
    return ticks;
}

void ScalePlate::paintEvent(QPaintEvent* /*event*/) {
    if (across() < kMostBar + 20) return; // a strip without room for it
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(unit(), unit()); // scales with the font of the window
    QFont letters = painter.font();
    letters.setPixelSize(kLetters);
    painter.setFont(letters);
    drawBar(painter);
    if (!brief_) drawAxes(painter);
    if (coloured_) drawColours(painter);
}

void ScalePlate::drawBar(QPainter& painter) const {
    painter.setPen(themeInUse().text);
    painter.drawText(QRectF(0, 6, kMostBar + 20, 20), Qt::AlignLeft | Qt::AlignVCenter, barText_);
    painter.setPen(QPen(themeInUse().text, 2.0));
    const double y = 38, right = barPixels_ / unit() + 1;
    painter.drawLine(QPointF(1, y), QPointF(right, y));
    for (const double x : {1.0, right}) painter.drawLine(QPointF(x, y - 6), QPointF(x, y));
    if (brief_) return;
    painter.setPen(themeInUse().quietText);
    painter.drawText(QRectF(0, 44, kMostBar, 18), Qt::AlignLeft | Qt::AlignVCenter, groundText_);
}

void ScalePlate::drawAxes(QPainter& painter) const {
    const QPointF middle(across() - 34, 34);
    const std::array<QColor, 3> inks = axisInks();
    for (std::size_t n = 0; n < axes_.size(); ++n) {
        const QPointF way(axes_[n].x(), -axes_[n].y());
        painter.setPen(QPen(inks[n], 2.0));
        painter.drawLine(middle, middle + kAxis * way);
        // The letter is drawn beyond the end of the axis. An axis that points at the eye has its letter next to the middle.
        const double length = std::hypot(way.x(), way.y());
        const QPointF beyond = length > 0.3 ? (kAxis + 8.0 / length) * way : QPointF(-7, 8);
        painter.setPen(themeInUse().text);
        painter.drawText(QRectF(middle + beyond - QPointF(14, 8), QSizeF(28, 16)), Qt::AlignCenter, names_[n]);
    }
}

void ScalePlate::drawColours(QPainter& painter) const {
    const QRectF bar(0, plain().height() + 14, across(), 10);
    painter.setPen(themeInUse().quietText);
    painter.drawText(QRectF(0, plain().height() - 6, bar.width(), 18), Qt::AlignLeft | Qt::AlignVCenter, scaleTitle());
    for (int x = 0; x < static_cast<int>(bar.width()); ++x)
        painter.fillRect(QRectF(bar.left() + x, bar.top(), 1.0, bar.height()), QColor(colourAt(x / (bar.width() - 1.0))));
    painter.setPen(themeInUse().text);
    const QFontMetrics letters(painter.font());
    double free = 0.0; // x from which the line is free of text
    for (const auto& [share, text] : scaleTicks()) {
        const double x = bar.left() + share * bar.width(), wide = letters.horizontalAdvance(text);
        const double left = std::clamp(x - wide / 2, 0.0, bar.right() - wide);
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        if (left < free) continue;
        painter.drawText(QRectF(left, bar.bottom() + 2, wide + 1, 16), Qt::AlignLeft | Qt::AlignVCenter, text);
        free = left + wide + 6;
    }
}

} // namespace edgescan::ui

#include "moc_scale_plate.cpp"
