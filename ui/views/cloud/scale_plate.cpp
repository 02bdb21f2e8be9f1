// Draws the scale bar, the axes and the colour scale of the cloud.
#include "ui/views/cloud/scale_plate.h"

#include "core/base/order_statistic.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/shown_text.h"
#include "ui/views/cloud/cloud_view.h"

#include <QAbstractButton>
#include <QEvent>
#include <QLayout>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr double kMostBar = 110.0; // px
constexpr int kBarLeft = 12, kColours = 50;
constexpr QSize kPlain(204, 64), kSmall(134, 46); // without axes and grid
constexpr double kAxis = 15.0;                    // px
constexpr int kLetters = 12;                      // px, for the usual font height of the window ...
constexpr double kUsualLetters = 17.0;            // ... which is this many px
constexpr int kFromRim = 8;                       // px
constexpr QSize kLeastView(300, 240);
constexpr int kSmallView = 460; // px of width
const QColor kInk(0xe8, 0xe8, 0xe8), kLessInk(0xb3, 0xb8, 0xbe);
const std::array<QColor, 3> kAxisInk{QColor(0xff, 0x82, 0x76), QColor(0x7f, 0xd9, 0x62), QColor(0x6c, 0xb2, 0xff)};

} // namespace

ScalePlate::ScalePlate(CloudView* cloud) : ViewPlate(cloud), cloud_(cloud) {
    setObjectName("scale-plate");
    setToolTip(tr("The bar has this length at the median distance of the points in view. The distance counts from the scanner."));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(cloud, &CloudView::frameDrawn, this, &ScalePlate::follow);
    cloud->installEventFilter(this);
    for (QObject* child : cloud->children()) watch(child);
    hide();
}

bool ScalePlate::eventFilter(QObject* watched, QEvent* event) {
    const auto type = event->type();
    if (watched == cloud_ && type == QEvent::Resize) place();
    // A plate that was made as a child has its type when it is polished, another one when it is added.
    if (watched == cloud_ && (type == QEvent::ChildAdded || type == QEvent::ChildPolished))
        watch(static_cast<QChildEvent*>(event)->child());
    // A legend that unfolds draws no frame. Queued: the layout moves several of them.
    const bool moves = type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show || type == QEvent::Hide;
    if (watched != cloud_ && moves) QMetaObject::invokeMethod(this, &ScalePlate::place, Qt::QueuedConnection);
    return ViewPlate::eventFilter(watched, event);
}

/// The plates and buttons that it keeps off.
void ScalePlate::watch(QObject* child) {
    const bool isPlate = qobject_cast<ViewPlate*>(child) != nullptr || qobject_cast<QAbstractButton*>(child) != nullptr;
    if (isPlate && child != this) child->installEventFilter(this); // a second installation changes nothing
}

bool ScalePlate::coloured() const { return colours_.points && cloud_->pointColours() == colours_.points; }

void ScalePlate::place() {
    const auto& cloud = cloud_->geometryOfCloud();
    isSmall_ = cloud_->width() < kSmallView;
    const bool crowded = isSmall_ && !(cloud_->caption().isEmpty() && keptFree_.isEmpty()); // most of a small view is for the rocks
    const bool some =
        cloud && cloud->validCount > 0 && cloud_->width() >= kLeastView.width() && cloud_->height() >= kLeastView.height() && !crowded;
    const auto covers = [this](const std::vector<QRect>& places) {
        return std::ranges::any_of(places, [this](const QRect& each) { return each.intersects(geometry()); });
    };
    const bool inCorner =
        geometry().bottom() >= cloud_->height() - kFromRim - 1 && (x() == kFromRim || geometry().right() >= cloud_->width() - kFromRim - 1);
    const bool away = !inCorner && keptFree_.isEmpty() && rings_.empty();         // of no target
    const bool sameView = std::exchange(view_, cloud_->size()) == cloud_->size(); // each time, or a view that grows and shrinks is the same
    const bool stays = some && sameView && !away && isVisible() && size() == sizeHint() && !covers(taken());
    resize(sizeHint());
    auto at = !some ? std::nullopt : stays ? std::optional(pos()) : freePlace(rings_);
    if (some && !at) at = freePlace({});
    if (at) move(*at);
    if (std::exchange(seeThrough_, at && covers(rings_)) != seeThrough_) update();
    setVisible(at.has_value());
}

std::vector<QRect> ScalePlate::taken() const {
    std::vector<QRect> places;
    for (const ViewPlate* other : cloud_->findChildren<ViewPlate*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (other != this && other->isVisible()) places.push_back(other->geometry());
    }
    for (const auto* button : cloud_->findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly)) { // the picture of a cab
        if (button->isVisible()) places.push_back(button->geometry());
    }
    if (!keptFree_.isEmpty() && cloud_->atRest()) places.push_back(keptFree_);
    return places;
}

void ScalePlate::keepOff(const QRect& pinned, std::vector<QRect> rings) {
    keptFree_ = pinned;
    rings_ = std::move(rings);
    this->place(); // also without another place to keep free: a legend may have moved
}

/// In the corner opposite to the legends, else as near to it as it can be: at the foot of the view, or above targets or legends at its
/// sides; empty: each place would cover something.
std::optional<QPoint> ScalePlate::freePlace(const std::vector<QRect>& rings) const {
    std::vector<QRect> taken = this->taken();
    taken.insert(taken.end(), rings.begin(), rings.end());
    bool legendsAtRight = false;
    for (ViewPlate* other : cloud_->findChildren<ViewPlate*>(QString(), Qt::FindDirectChildrenOnly)) {
        const bool isLegend = other->isVisible() && cloud_->layout() != nullptr && cloud_->layout()->indexOf(other) >= 0;
        legendsAtRight = legendsAtRight || (isLegend && other->geometry().center().x() > cloud_->width() / 2);
    }
    const int left = kFromRim, right = cloud_->width() - kFromRim - width(), bottom = cloud_->height() - kFromRim - height();
    const QPoint corner(legendsAtRight ? left : right, bottom);
    std::vector<QPoint> places{corner, {left + right - corner.x(), bottom}};
    for (const QRect& other : taken) {
        for (const int x : {left, right}) places.emplace_back(x, other.top() - kFromRim - height());
        for (const int x : {other.left() - kFromRim - width(), other.right() + kFromRim}) places.emplace_back(x, bottom);
    }
    const QRect all(QPoint(left, kFromRim), QPoint(right, bottom)); // of its top left
    std::erase_if(places, [&](const QPoint& each) { return !all.contains(each); });
    std::ranges::stable_sort(places, {}, [&](const QPoint& each) { return (each - corner).manhattanLength(); });
    const auto isFree = [&](const QPoint& each) {
        return std::ranges::none_of(taken, [place = QRect(each, size())](const QRect& other) { return other.intersects(place); });
    };
    const auto free = std::ranges::find_if(places, isFree);
    return free == places.end() ? std::nullopt : std::optional(*free);
}

void ScalePlate::follow() {
    coloured_ = coloured();
    place();
    if (!cloud_->geometryOfCloud()) return;
    // Hidden too: place() may show it before the next frame.
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
    const Seen seen{cloud_->geometryOfCloud(), pose, cloud_->clip(), cloud_->size()};
    if (seen != seen_) depth_ = medianDepth();
    seen_ = seen;
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
    place();
    update();
}

double ScalePlate::unit() const { return std::max(1.0, fontMetrics().height() / kUsualLetters); }

QSize ScalePlate::plain() const { return isSmall_ ? kSmall : kPlain; }

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

void ScalePlate::paintEvent(QPaintEvent* event) {
    if (!seeThrough_) ViewPlate::paintEvent(event);
    QPainter painter(this);
    if (seeThrough_) painter.fillRect(rect(), QColor(0x1b, 0x1d, 0x1f, 120)); // the ring below it and its own text are both seen
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(unit(), unit()); // scales with the font of the window
    QFont letters = painter.font();
    letters.setPixelSize(kLetters);
    painter.setFont(letters);
    drawBar(painter);
    if (!isSmall_) drawAxes(painter);
    if (coloured_) drawColours(painter);
}

void ScalePlate::drawBar(QPainter& painter) const {
    painter.setPen(kInk);
    painter.drawText(QRectF(kBarLeft, 6, kMostBar + 10, 20), Qt::AlignLeft | Qt::AlignVCenter, barText_);
    painter.setPen(QPen(kInk, 2.0));
    const double y = 38, right = kBarLeft + barPixels_ / unit();
    painter.drawLine(QPointF(kBarLeft, y), QPointF(right, y));
    for (const double x : {static_cast<double>(kBarLeft), right}) painter.drawLine(QPointF(x, y - 6), QPointF(x, y));
    if (isSmall_) return;
    painter.setPen(kLessInk);
    painter.drawText(QRectF(kBarLeft, 44, kMostBar, 18), Qt::AlignLeft | Qt::AlignVCenter, groundText_);
}

void ScalePlate::drawAxes(QPainter& painter) const {
    const QPointF middle(kPlain.width() - 38, 34);
    for (std::size_t n = 0; n < axes_.size(); ++n) {
        const QPointF way(axes_[n].x(), -axes_[n].y());
        painter.setPen(QPen(kAxisInk[n], 2.0));
        painter.drawLine(middle, middle + kAxis * way);
        // The letter is drawn beyond the end of the axis. An axis that points at the eye has its letter next to the middle.
        const double length = std::hypot(way.x(), way.y());
        const QPointF beyond = length > 0.3 ? (kAxis + 8.0 / length) * way : QPointF(-7, 8);
        painter.setPen(kInk);
        painter.drawText(QRectF(middle + beyond - QPointF(14, 8), QSizeF(28, 16)), Qt::AlignCenter, names_[n]);
    }
}

void ScalePlate::drawColours(QPainter& painter) const {
    const QRectF bar(kBarLeft, plain().height() + 14, plain().width() - 2 * kBarLeft, 10);
    painter.setPen(kLessInk);
    painter.drawText(QRectF(kBarLeft, plain().height() - 6, bar.width(), 18), Qt::AlignLeft | Qt::AlignVCenter, scaleTitle());
    for (int x = 0; x < static_cast<int>(bar.width()); ++x)
        painter.fillRect(QRectF(bar.left() + x, bar.top(), 1.0, bar.height()), QColor(colourAt(x / (bar.width() - 1.0))));
    painter.setPen(kInk);
    const QFontMetrics letters(painter.font());
    double free = 0.0; // x from which the line is free of text
    for (const auto& [share, text] : scaleTicks()) {
        const double x = bar.left() + share * bar.width(), wide = letters.horizontalAdvance(text);
        const double left = std::clamp(x - wide / 2, static_cast<double>(kBarLeft), bar.right() - wide);
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        if (left < free) continue;
        painter.drawText(QRectF(left, bar.bottom() + 2, wide + 1, 16), Qt::AlignLeft | Qt::AlignVCenter, text);
        free = left + wide + 6;
    }
}

} // namespace edgescan::ui

#include "moc_scale_plate.cpp"
