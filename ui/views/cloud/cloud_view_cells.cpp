// Looks at a region of cells in the cloud view.
#include "core/base/order_statistic.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/views/cloud/cloud_scene.h"
#include "ui/views/cloud/cloud_view.h"

#include <algorithm>
#include <array>
#include <vector>

namespace edgescan::ui {

void CloudView::keepReady(const std::shared_ptr<const CloudGeometry>& cloud) {
    scene_->keepReady(cloud);
    requestFrame();
}

void CloudView::lookAtCells(const CellIndices& cells) {
    if (!cloud_) return;
    constexpr double kRim = 0.04, kAround = 0.35;
    constexpr float kLeastShare = 0.06F; // of the cloud: a small rock is recognised by what is around it
    std::array<std::vector<float>, 3> places;
    for (const std::uint32_t k : cells) {
        if (!cloud_->drawable(k)) continue;
        for (int axis = 0; axis < 3; ++axis) places[static_cast<std::size_t>(axis)].push_back(cloud_->point(k)[axis]);
    }
    if (places[0].empty()) return;
    Eigen::Vector3f least, most;
    for (int axis = 0; axis < 3; ++axis) {
        auto& values = places[static_cast<std::size_t>(axis)];
        least[axis] = quantile(values, kRim);
        most[axis] = quantile(values, 1.0 - kRim);
    }
    const float sizeM = (most - least).maxCoeff(), leastM = kLeastShare * cloud_->mainBounds.diagonal().norm();
    const Eigen::Vector3f around = Eigen::Vector3f::Constant(std::max(static_cast<float>(kAround) * sizeM, 0.5F * (leastM - sizeM)));
    const Box3f box(least - around, most + around);
    const FreeBox fits = intoFreeArea(box);
    pose_ = lookingAtFrom(cloud_->sensor.cast<double>(), fits.box, cloud_->scannerView.up, pose_, fits.aspect);
    centre_ = pose_.focus;
    if (pose_.parallel) {
        pose_ = besidePlates(pose_);
    } else { // the camera turns where it is: from a place aside, other rocks would hide the cells
        const double perPixel = 2.0 * pose_.halfHeight() / std::max(1, height());
        const QPoint by = freeArea().center() - rect().center();
        pose_.focus += perPixel * (by.y() * pose_.up - by.x() * pose_.right());
        pose_.up = (pose_.up - pose_.forward() * pose_.forward().dot(pose_.up)).normalized();
    }
    applyCamera();
}

CloudView::FreeBox CloudView::intoFreeArea(const Box3f& box) const {
    const QRect free = freeArea();
    const Eigen::Vector3f half = 0.5F * static_cast<float>(height()) / static_cast<float>(free.height()) * box.sizes();
    return {Box3f(box.center() - half, box.center() + half), static_cast<double>(free.width()) / free.height()};
}

CameraPose CloudView::besidePlates(const CameraPose& pose) const {
    const QPoint by = freeArea().center() - rect().center();
    return panned(pose, pose.focus, by.x(), by.y(), height());
}

void CloudView::centreOn(const Eigen::Vector3d& point) {
    pose_ = besidePlates(centredOn(pose_, point));
    centre_ = point;
    applyCamera();
}

std::function<bool(QPointF)> CloudView::freePixels() const {
    return [plates = overlay_->platesOver(), view = QRectF(rect()).adjusted(0, topTaken_, 0, 0)](QPointF pixel) {
        return view.contains(pixel) && std::ranges::none_of(plates, [&](const QRectF& plate) { return plate.contains(pixel); });
    };
}

/// The largest rectangle without plates and texts; all of the view if little is left.
QRect CloudView::freeArea() const {
    constexpr double kGap = 8.0; // px
    constexpr int kLeast = 120;  // px
    const QRectF all = QRectF(rect()).adjusted(0, topTaken_, 0, 0);
    std::vector<QRectF> taken = overlay_->platesOver();
    for (const QRect& label : overlay_->labels()) {
        if (!label.isEmpty()) taken.emplace_back(label);
    }
    std::vector<double> lefts{all.left()}, rights{all.right()}, tops{all.top()}, bottoms{all.bottom()};
    for (const QRectF& each : taken) {
        lefts.push_back(each.right() + kGap);
        rights.push_back(each.left() - kGap);
        tops.push_back(each.bottom() + kGap);
        bottoms.push_back(each.top() - kGap);
    }
    QRectF best;
    const auto consider = [&](const QRectF& place) {
        if (place.width() * place.height() <= best.width() * best.height() || !all.contains(place)) return;
        if (std::ranges::none_of(taken, [&](const QRectF& each) { return each.intersects(place); })) best = place;
    };
    for (const double left : lefts) {
        for (const double right : rights) {
            for (const double top : tops) {
                for (const double bottom : bottoms) {
                    if (right - left >= kLeast && bottom - top >= kLeast) consider(QRectF(QPointF(left, top), QPointF(right, bottom)));
                }
            }
        }
    }
    return best.isEmpty() ? QRect(QPoint(0, 0), size().expandedTo({1, 1})) : best.toRect();
}

} // namespace edgescan::ui
