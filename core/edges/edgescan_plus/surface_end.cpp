// Where a surface ends before missing data.
#include "core/edges/edgescan_plus/surface_end.h"

#include <cmath>

namespace edgescan::edges {
namespace {

constexpr int kSide = 5;   // cells of a surface used for its slope
constexpr int kFewest = 3; // least number of these

} // namespace

bool SurfaceEnd::slants(float angle, float tangent) const { return std::abs(slope) > tangent * u * angle; }

SurfaceEnd surfaceEnd(const Way& way, int n, int awayFromVoid, const DepthLimits& limits) {
    SurfaceEnd end{way.u(n)};
    float sum = 0, weighted = 0;
    int cells = 0;
    for (; cells < kSide; ++cells) {
        const int m = n + cells * awayFromVoid;
        if (m < 0 || m >= way.count || way.isVoid(m)) break;
        const float there = way.u(m);
        const float before = cells == 0 ? there : way.u(m - awayFromVoid);
        if (std::abs(1000 / there - 1000 / before) > limits.jumpAt(1000 / before)) break;
        sum += there - end.u;
        weighted += static_cast<float>(cells) * (there - end.u);
    }
    const auto count = static_cast<float>(cells);
    const float middle = 0.5F * (count - 1);
    end.known = cells >= kFewest;
    if (end.known) end.slope = -(weighted - middle * sum) / (count * (count * count - 1) / 12);
    return end;
}

} // namespace edgescan::edges
