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
    pose_ = lookingAtFrom(cloud_->sensor.cast<double>(), box, cloud_->scannerView.up, pose_, aspect());
    centre_ = pose_.focus;
    applyCamera();
}

void CloudView::centreOn(const Eigen::Vector3d& point) {
    pose_ = centredOn(pose_, point);
    centre_ = point;
    applyCamera();
}

std::function<bool(QPointF)> CloudView::freePixels() const {
    return [plates = overlay_->platesOver(), view = QRectF(rect())](QPointF pixel) {
        return view.contains(pixel) && std::ranges::none_of(plates, [&](const QRectF& plate) { return plate.contains(pixel); });
    };
}

} // namespace edgescan::ui
