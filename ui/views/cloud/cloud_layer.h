// The cloud of another scan, drawn together with the one whose cells are shown.
#pragma once

#include "core/scan/grid/placement.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <QColor>

namespace edgescan::ui {

struct CloudLayer {
    std::shared_ptr<const CloudGeometry> cloud;
    RigidTransform toShown; ///< from the scanner's frame of its scan to that of the shown cloud's scan
    QColor colour;

    bool operator==(const CloudLayer&) const = default;
    /// From its local coordinates to those of the shown cloud: both are near their origins, so that floats are exact enough.
    [[nodiscard]] RigidTransform local(const Eigen::Vector3d& shownOriginM) const {
        return {toShown.rotation, toShown * cloud->originM - shownOriginM};
    }
};

} // namespace edgescan::ui
