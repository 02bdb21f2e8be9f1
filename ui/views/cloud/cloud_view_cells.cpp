// Looks at a region of cells in the cloud view.
#include "core/base/order_statistic.h"
#include "ui/base/view_plate.h"
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
    const Eigen::Vector3f around = Eigen::Vector3f::Constant(static_cast<float>(kAround) * std::max(0.1F, (most - least).maxCoeff()));
    const Box3f box(least - around, most + around);
    const QRect free = freeArea();
    pose_ = lookingAtFrom(cloud_->sensor.cast<double>(), box, cloud_->axes.up, pose_, aspect() * free.width() / std::max(1, width()));
    centre_ = pose_.focus;
    // The camera turns where it is: from a place aside, other rocks would hide the cells.
    const double aside = free.center().x() - rect().center().x(), perPixel = 2.0 * pose_.halfHeight() / std::max(1, height());
    if (pose_.parallel)
        pose_ = panned(pose_, centre_, aside, 0.0, height());
    else
        pose_.focus -= aside * perPixel * pose_.right();
    applyCamera();
}

/// Next to the high plates at its sides, if that is most of it.
QRect CloudView::freeArea() const {
    constexpr int kGap = 8;         // px
    constexpr double kHigh = 0.25;  // of the view
    constexpr double kLeast = 0.45; // of its width
    QRect free = rect();
    for (const ViewPlate* plate : findChildren<ViewPlate*>(QString(), Qt::FindDirectChildrenOnly)) {
        const QRect place = plate->geometry();
        if (!plate->isVisible() || place.height() < kHigh * height()) continue;
        if (place.center().x() < width() / 2)
            free.setLeft(std::max(free.left(), place.right() + kGap));
        else
            free.setRight(std::min(free.right(), place.left() - kGap));
    }
    return free.width() >= kLeast * width() ? free : rect();
}

} // namespace edgescan::ui
