// Brings cells into the 3D view.
#include "ui/views/cloud/sight.h"

#include <QPolygonF>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr std::size_t kAsked = 500;  // cells
constexpr double kMostOutside = 0.1; // of them

/// From behind the surfaces that the scanner measured, their backs would be seen.
bool seesItsFace(const CloudView& cloud, std::uint32_t cell) {
    const Eigen::Vector3d at = cloud.geometryOfCloud()->point(cell).cast<double>();
    return (at - cloud.camera().position).dot(at - cloud.geometryOfCloud()->sensor.cast<double>()) > 0.0;
}

std::size_t stepOver(const CloudView::CellIndices& cells) { return std::max<std::size_t>(1, cells.size() / kAsked); }

bool isInSight(const CloudView& cloud, const CloudView::CellIndices& cells) {
    std::size_t asked = 0, outside = 0;
    const auto isFree = cloud.freePixels();
    for (std::size_t n = 0; n < cells.size(); n += stepOver(cells)) {
        if (!cloud.geometryOfCloud()->drawable(cells[n])) continue;
        const auto at = cloud.pixelOf(cells[n]);
        ++asked;
        outside += at && isFree(*at) && seesItsFace(cloud, cells[n]) ? 0 : 1;
    }
    return static_cast<double>(outside) <= kMostOutside * static_cast<double>(asked);
}

/// Of the view's height.
double shareOf(const CloudView& cloud, const CloudView::CellIndices& cells) {
    QPolygonF places;
    for (const std::uint32_t k : cells) {
        if (const auto at = cloud.pixelOf(k)) places << *at;
    }
    const QRectF box = places.boundingRect();
    return std::max(box.width(), box.height()) / std::max(1, cloud.height());
}

} // namespace

QRect placeIn(const CloudView& cloud, const CloudView::CellIndices& cells) {
    QRect place;
    for (std::size_t n = 0; n < cells.size(); n += stepOver(cells)) {
        if (const auto at = cloud.pixelOf(cells[n])) place |= QRect(at->toPoint(), QSize(1, 1));
    }
    return place;
}

void bringIntoSight(CloudView& cloud, const CloudView::CellIndices& cells, double leastShare) {
    if (!cloud.geometryOfCloud() || (isInSight(cloud, cells) && shareOf(cloud, cells) >= leastShare)) return;
    cloud.lookAtCells(cells);
}

} // namespace edgescan::ui
