// Clouds of other scans in the 3D view.
#include "ui/views/cloud/cloud_scene.h"
#include "ui/views/cloud/cloud_view.h"

#include <limits>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr double kLayerPickPx = 8.0;
constexpr double kInFrontM = 0.05; // of surfaces that both scans see, neither is in front

Box3f placed(const Box3f& box, const RigidTransform& place) {
    Box3f out;
    for (int n = 0; n < 8 && !box.isEmpty(); ++n) {
        const Eigen::Vector3d corner = box.corner(static_cast<Box3f::CornerType>(n)).cast<double>();
        out.extend((place * corner).cast<float>());
    }
    return out;
}

Eigen::Matrix4d matrixOf(const RigidTransform& place) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = place.rotation;
    matrix.topRightCorner<3, 1>() = place.translationM;
    return matrix;
}

} // namespace

void CloudView::setLayers(std::vector<CloudLayer> layers) {
    if (layers == layers_) return;
    const bool others = layers.size() != layers_.size();
    layers_ = std::move(layers);
    placeLayers();
    if (others) guessBudget();
    moved();
}

/// By the origin of the shown cloud.
void CloudView::placeLayers() {
    const Eigen::Vector3d origin = cloud_ ? cloud_->originM : Eigen::Vector3d::Zero();
    layersBounds_ = {};
    layersMain_ = {};
    for (const CloudLayer& layer : layers_) {
        layersBounds_.extend(placed(layer.cloud->bounds, layer.local(origin)));
        layersMain_.extend(placed(layer.cloud->mainBounds, layer.local(origin)));
    }
    scene_->setLayers(layers_, origin);
}

/// The layer whose point is drawn in front of the cell's point, or in front of nothing.
std::optional<int> CloudView::layerInFront(QPointF pixel, const std::optional<std::uint32_t>& of) const {
    const ScreenView view = screenView();
    const double dpr = devicePixelRatioF();
    std::optional<int> found;
    const auto depthOf = [this](const Eigen::Vector3d& p) { return pose_.forward().dot(p - pose_.position); };
    double depth = of ? depthOf(cloud_->point(*of).cast<double>()) - kInFrontM : std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < layers_.size(); ++n) {
        const CloudLayer& layer = layers_[n];
        const RigidTransform local = layer.local(cloud_->originM);
        ScreenView there = view;
        there.worldToClip = view.worldToClip * matrixOf(local);
        const auto cell = pickPoint(*layer.cloud, there, pixel.x() * dpr, pixel.y() * dpr, kLayerPickPx * dpr);
        if (!cell) continue;
        const double at = depthOf(local * layer.cloud->point(*cell).cast<double>());
        if (at >= depth) continue;
        depth = at;
        found = static_cast<int>(n);
    }
    return found;
}

} // namespace edgescan::ui
