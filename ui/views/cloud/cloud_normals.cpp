// Surface normals of the cells.
#include "ui/views/cloud/cloud_normals.h"

#include "core/base/bands.h"

#include <Eigen/Geometry>

#include <cmath>

namespace edgescan::ui {
namespace {

using Eigen::Vector3f;

constexpr int kReach = 3;              // cells to each side: averages out the noise of single ranges, which would look like grain
constexpr float kSameSurface = 0.04F;  // maximum difference of neighbours on one surface, as share of the range per cell of distance ...
constexpr float kSameSurfaceM = 0.05F; // ... plus metres

struct Neighbourhood {
    const CloudGeometry& cloud;
    std::vector<float> range; // metres from the sensor, per cell

    explicit Neighbourhood(const CloudGeometry& of) : cloud(of), range(of.cells()) {
        for (std::size_t k = 0; k < range.size(); ++k) range[k] = (cloud.point(k) - cloud.sensor).norm();
    }

    // Slope of the points along one direction of the grid; zero if neither side has a neighbour on the same surface.
    [[nodiscard]] Vector3f tangent(std::size_t k, std::ptrdiff_t step, int before, int after) const {
        Vector3f sum = Vector3f::Zero();
        const float here = range[k];
        const Vector3f p = cloud.point(k);
        for (const int sign : {-1, 1}) {
            const int reach = std::min(kReach, sign < 0 ? before : after);
            for (int n = 1; n <= reach; ++n) {
                const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) + sign * n * step);
                const float allowed = static_cast<float>(n) * kSameSurface * here + kSameSurfaceM;
                if (cloud.valid[other] == 0 || std::abs(range[other] - here) > allowed) break;
                sum += static_cast<float>(sign * n) * (cloud.point(other) - p);
            }
        }
        return sum;
    }

    // Normal towards the sensor.
    [[nodiscard]] Vector3f normalAt(std::size_t k, int line, int beam) const {
        const Vector3f toSensor = (cloud.sensor - cloud.point(k)).normalized();
        const Vector3f alongBeams = tangent(k, 1, beam, cloud.beams - 1 - beam);
        const Vector3f alongLines = tangent(k, cloud.beams, line, cloud.lines - 1 - line);
        Vector3f normal = alongBeams.cross(alongLines);
        const float length = normal.norm();
        normal = length > 0.0F && std::isfinite(length) ? Vector3f(normal / length) : toSensor;
        return normal.dot(toSensor) < 0.0F ? Vector3f(-normal) : normal;
    }
};

} // namespace

std::vector<float> surfaceNormals(const CloudGeometry& cloud) {
    const Neighbourhood around(cloud);
    std::vector<float> normals(3 * cloud.cells());
    runInBands(cloud.lines, bandsFor(cloud.cells(), 0), [&](int first, int last) {
        std::size_t k = static_cast<std::size_t>(first) * static_cast<std::size_t>(cloud.beams);
        for (int line = first; line < last; ++line) {
            for (int beam = 0; beam < cloud.beams; ++beam, ++k) {
                if (cloud.valid[k] == 0) continue;
                const Vector3f normal = around.normalAt(k, line, beam);
                for (int axis = 0; axis < 3; ++axis) normals[3 * k + static_cast<std::size_t>(axis)] = normal[axis];
            }
        }
    });
    return normals;
}

} // namespace edgescan::ui
