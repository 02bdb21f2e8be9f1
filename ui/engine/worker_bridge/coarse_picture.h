// The first picture of a large scan: some of its points, without edges, until the whole is computed.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <QImage>

#include <cstddef>
#include <memory>

namespace edgescan::ui {

/// Larger scans have a coarse picture first.
inline constexpr std::size_t kCoarseAbove = 2'000'000; // cells

/// Only for the eye: its cells are not those of the scan, and nothing is counted, stored or exported from it.
struct CoarsePicture {
    std::size_t cells = 0;                             ///< of the whole scan
    std::shared_ptr<const edges::Detection> detection; ///< every n-th line and beam, and its gray levels; without mask and edges
    std::shared_ptr<const CloudGeometry> cloud;
    std::shared_ptr<const QImage> gray;
};

/// Every third line and beam, fewer of scans with more than some 20 million cells. Pool's thread.
[[nodiscard]] std::shared_ptr<const CoarsePicture> makeCoarsePicture(const Scan& scan, const edges::Settings& settings);

} // namespace edgescan::ui
