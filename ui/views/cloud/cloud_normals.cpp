// Surface normals of the cells, several cells of a line at a time.
#include "ui/views/cloud/cloud_normals.h"

#include "core/base/bands.h"
#include "core/base/simd.h"

#include <array>
#include <cmath>
#include <limits>

namespace edgescan::ui {
namespace {

constexpr int kReach = 3;              // cells to each side: averages out the noise of single ranges, which would look like grain
constexpr float kSameSurface = 0.04F;  // maximum difference of neighbours on one surface, as share of the range per cell of distance ...
constexpr float kSameSurfaceM = 0.05F; // ... plus metres

/// A line of the cloud with kReach cells of room at both ends.
struct PointLine {
    std::vector<float> x, y, z;
    std::vector<float> range; // metres from the sensor; NaN without a point

    explicit PointLine(int beams) {
        const auto room = static_cast<std::size_t>(beams) + 2 * kReach;
        for (std::vector<float>* values : {&x, &y, &z}) values->resize(room);
        range.resize(room, std::numeric_limits<float>::quiet_NaN());
    }
    /// A line outside of the cloud has no points.
    void read(const CloudGeometry& cloud, int line) {
        if (line < 0 || line >= cloud.lines) {
            range.assign(range.size(), std::numeric_limits<float>::quiet_NaN());
            return;
        }
        std::size_t k = static_cast<std::size_t>(line) * static_cast<std::size_t>(cloud.beams);
        for (std::size_t j = kReach; j < range.size() - kReach; ++j, ++k) {
            const Eigen::Vector3f p = cloud.point(k);
            x[j] = p.x();
            y[j] = p.y();
            z[j] = p.z();
            range[j] = cloud.valid[k] != 0 ? (p - cloud.sensor).norm() : std::numeric_limits<float>::quiet_NaN();
        }
    }
};

/// Pointers to the first cell of a line.
struct Cells {
    const float *x, *y, *z, *range;
};
using Window = std::array<Cells, 2 * kReach + 1>; // the lines around one, which is in the middle

struct Normals {
    std::vector<float> x, y, z;
    explicit Normals(int beams) {
        for (std::vector<float>* values : {&x, &y, &z}) values->resize(static_cast<std::size_t>(beams));
    }
};

struct Sum {
    float x = 0, y = 0, z = 0;
};

/// Adds a neighbour `n` cells away to the slope of the points; `same`: it and all before it are on one surface with the cell.
EDGESCAN_INLINE void add(Sum& sum, const Cells& line, int at, const Cells& own, int j, int n, bool& same) {
    const float here = own.range[j];
    const float allowed = static_cast<float>(n < 0 ? -n : n) * kSameSurface * here + kSameSurfaceM;
    same = same & (std::abs(line.range[at] - here) <= allowed); // never with NaN
    const float times = same ? static_cast<float>(n) : 0.0F;    // no branch: the compiler takes several cells at a time
    sum.x += times * (line.x[at] - own.x[j]);
    sum.y += times * (line.y[at] - own.y[j]);
    sum.z += times * (line.z[at] - own.z[j]);
}

/// Unit normals towards the sensor; zero without a point.
EDGESCAN_INLINE void normalsOfLine(const Window& window, float sensorX, float sensorY, float sensorZ, int beams, float* __restrict x,
                                   float* __restrict y, float* __restrict z) {
    const Window lines = window;
    const Cells own = lines[kReach];
    for (int j = 0; j < beams; ++j) {
        Sum a, b; // along beams, along lines
        bool same = true;
        add(a, own, j - 1, own, j, -1, same);
        add(a, own, j - 2, own, j, -2, same);
        add(a, own, j - 3, own, j, -3, same);
        same = true;
        add(a, own, j + 1, own, j, 1, same);
        add(a, own, j + 2, own, j, 2, same);
        add(a, own, j + 3, own, j, 3, same);
        same = true;
        add(b, lines[kReach - 1], j, own, j, -1, same);
        add(b, lines[kReach - 2], j, own, j, -2, same);
        add(b, lines[kReach - 3], j, own, j, -3, same);
        same = true;
        add(b, lines[kReach + 1], j, own, j, 1, same);
        add(b, lines[kReach + 2], j, own, j, 2, same);
        add(b, lines[kReach + 3], j, own, j, 3, same);
        const float toX = sensorX - own.x[j], toY = sensorY - own.y[j], toZ = sensorZ - own.z[j];
        const float far = std::sqrt(toX * toX + (toY * toY + toZ * toZ));
        const float toSensor = far > 0.0F ? 1.0F / far : 0.0F;
        const float crossX = a.y * b.z - a.z * b.y, crossY = a.z * b.x - a.x * b.z, crossZ = a.x * b.y - a.y * b.x;
        const float length = std::sqrt(crossX * crossX + (crossY * crossY + crossZ * crossZ));
        const bool flat = (length > 0.0F) & (length <= std::numeric_limits<float>::max());
        const float share = flat ? 1.0F / length : toSensor;
        const float nx = flat ? crossX : toX, ny = flat ? crossY : toY, nz = flat ? crossZ : toZ;
        const float towards = nx * toX + (ny * toY + nz * toZ) < 0.0F ? -share : share;
        const float scale = own.range[j] == own.range[j] ? towards : 0.0F;
        x[j] = nx * scale;
        y[j] = ny * scale;
        z[j] = nz * scale;
    }
}

} // namespace

std::vector<float> surfaceNormals(const CloudGeometry& cloud) {
    std::vector<float> normals(3 * cloud.cells());
    runInBands(cloud.lines, bandsFor(cloud.cells(), 0), [&](int first, int last) {
        std::vector<PointLine> lines(2 * kReach + 1, PointLine(cloud.beams)); // line i is at i modulo their number
        const auto lineAt = [&](int line) -> PointLine& {
            return lines[static_cast<std::size_t>(line + static_cast<int>(lines.size())) % lines.size()];
        };
        for (int line = first - kReach; line < first + kReach; ++line) lineAt(line).read(cloud, line);
        Normals of(cloud.beams);
        float* to = normals.data() + 3 * static_cast<std::size_t>(first) * static_cast<std::size_t>(cloud.beams);
        for (int line = first; line < last; ++line) {
            lineAt(line + kReach).read(cloud, line + kReach);
            Window window;
            for (int n = -kReach; n <= kReach; ++n) {
                const PointLine& at = lineAt(line + n);
                window[static_cast<std::size_t>(n + kReach)] = {at.x.data() + kReach, at.y.data() + kReach, at.z.data() + kReach,
                                                                at.range.data() + kReach};
            }
            vectorised<normalsOfLine>(window, cloud.sensor.x(), cloud.sensor.y(), cloud.sensor.z(), cloud.beams, of.x.data(), of.y.data(),
                                      of.z.data());
            for (std::size_t j = 0; j < of.x.size(); ++j, to += 3) {
                to[0] = of.x[j];
                to[1] = of.y[j];
                to[2] = of.z[j];
            }
        }
    });
    return normals;
}

} // namespace edgescan::ui
