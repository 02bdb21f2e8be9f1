// The grid below the rocks.
#include "ui/views/cloud/ground_grid.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {

double roundedDown(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0}) {
        if (times * power <= most * (1.0 + 1e-9)) return times * power;
    }
    return power;
}

GroundGrid groundOf(const CloudGeometry& cloud) {
    GroundGrid grid;
    if (cloud.validCount == 0) return grid;
    const Eigen::Vector3d up = cloud.axes.up, right = cloud.axes.right, forward = up.cross(right).normalized();
    // The first parts of the drawing order are spread over all points.
    std::vector<double> heights;
    for (const auto& part : cloud.drawOrder) {
        for (const std::uint32_t k : part) heights.push_back(up.dot(cloud.point(k).cast<double>()));
        if (heights.size() >= 2000) break;
    }
    const double lowest = valueInOrder(heights, heights.size() / 100);
    double from[2] = {1e300, 1e300}, to[2] = {-1e300, -1e300};
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d at = cloud.mainBounds.corner(static_cast<Box3f::CornerType>(corner)).cast<double>();
        const double along[2] = {right.dot(at), forward.dot(at)};
        for (int n = 0; n < 2; ++n) {
            from[n] = std::min(from[n], along[n]);
            to[n] = std::max(to[n], along[n]);
        }
    }
    const double widest = std::max({to[0] - from[0], to[1] - from[1], 1e-3});
    grid.stepM = roundedDown(widest / 8.0);
    for (int n = 0; n < 2; ++n) {
        from[n] = std::floor(from[n] / grid.stepM) * grid.stepM;
        to[n] = std::ceil(to[n] / grid.stepM) * grid.stepM;
    }
    const auto place = [&](double x, double y) { return Eigen::Vector3f((right * x + forward * y + up * lowest).cast<float>()); };
    for (double x = from[0]; x <= to[0] + 1e-9; x += grid.stepM) grid.lines.push_back({place(x, from[1]), place(x, to[1])});
    for (double y = from[1]; y <= to[1] + 1e-9; y += grid.stepM) grid.lines.push_back({place(from[0], y), place(to[0], y)});
    return grid;
}

} // namespace edgescan::ui
