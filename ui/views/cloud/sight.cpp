// Brings cells into the 3D view.
#include "ui/views/cloud/sight.h"

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr std::size_t kAsked = 500;  // cells
constexpr double kMostOutside = 0.1; // of them

bool isInSight(const CloudView& cloud, const CloudView::CellIndices& cells) {
    std::size_t asked = 0, outside = 0;
    for (std::size_t n = 0; n < cells.size(); n += std::max<std::size_t>(1, cells.size() / kAsked)) {
        if (!cloud.geometryOfCloud()->drawable(cells[n])) continue;
        const auto at = cloud.pixelOf(cells[n]);
        ++asked;
        outside += at && cloud.isFree(*at) ? 0 : 1;
    }
    return static_cast<double>(outside) <= kMostOutside * static_cast<double>(asked);
}

} // namespace

void bringIntoSight(CloudView& cloud, const CloudView::CellIndices& cells) {
    if (!cloud.geometryOfCloud() || isInSight(cloud, cells)) return;
    Box3f box;
    for (const std::uint32_t k : cells) {
        if (cloud.geometryOfCloud()->drawable(k)) box.extend(cloud.geometryOfCloud()->point(k));
    }
    cloud.centreOn(box.center().cast<double>());
    if (!isInSight(cloud, cells)) cloud.zoomToCells(cells);
}

} // namespace edgescan::ui
