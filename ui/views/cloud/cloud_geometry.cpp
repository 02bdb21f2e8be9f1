// Makes float coordinates, drawing order, tiles and the frame of the view from a scan.
#include "ui/views/cloud/cloud_geometry.h"

#include "core/base/bands.h"
#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace edgescan::ui {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Surface normals of the cells, only for shading: without shading a gray cloud shows no shape.

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

/// -1 to 1 as 1 to 255
EDGESCAN_INLINE int byteOf(float share) { return static_cast<int>(share * 127.0F + 128.5F); }

/// Unit normals towards the sensor; zero without a point.
EDGESCAN_INLINE void normalsOfLine(const Window& window, float sensorX, float sensorY, float sensorZ, int beams, float* __restrict to) {
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
        to[j] = static_cast<float>((byteOf(nx * scale) * 256 + byteOf(ny * scale)) * 256 + byteOf(nz * scale));
    }
}

/// CloudGeometry::normals, fitted to the neighbours on the same surface along the line and along the beam.
/// With too few neighbours: the direction to the sensor. Uses lines, beams, xyz, valid and sensor of `cloud`.
std::vector<float> surfaceNormals(const CloudGeometry& cloud) {
    std::vector<float> normals(cloud.cells());
    runInBands(cloud.lines, bandsFor(cloud.cells(), 0), [&](int first, int last) {
        std::vector<PointLine> lines(2 * kReach + 1, PointLine(cloud.beams)); // line i is at i modulo their number
        const auto lineAt = [&](int line) -> PointLine& {
            return lines[static_cast<std::size_t>(line + static_cast<int>(lines.size())) % lines.size()];
        };
        for (int line = first - kReach; line < first + kReach; ++line) lineAt(line).read(cloud, line);
        for (int line = first; line < last; ++line) {
            lineAt(line + kReach).read(cloud, line + kReach);
            Window window;
            for (int n = -kReach; n <= kReach; ++n) {
                const PointLine& at = lineAt(line + n);
                window[static_cast<std::size_t>(n + kReach)] = {at.x.data() + kReach, at.y.data() + kReach, at.z.data() + kReach,
                                                                at.range.data() + kReach};
            }
            vectorised<normalsOfLine>(window, cloud.sensor.x(), cloud.sensor.y(), cloud.sensor.z(), cloud.beams,
                                      normals.data() + static_cast<std::size_t>(line) * static_cast<std::size_t>(cloud.beams));
        }
    });
    return normals;
}

constexpr int kTile = 16;               // lines and beams
constexpr double kKeepOriginM = 1000.0; // below this coordinate a float resolves 0.1 mm without a shift of the origin
constexpr std::size_t kEnoughSamples = 20000;

// Value of a cell in the R2 low-discrepancy sequence (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018): the
// cells below any threshold are spread evenly over lines and beams.
std::uint32_t spread(int line, int beam) {
    return static_cast<std::uint32_t>(beam) * 3242174889U + static_cast<std::uint32_t>(line) * 2447445414U;
}

int partOf(std::uint32_t place) {
    const double share = static_cast<double>(place) / 4294967296.0;
    int part = 0;
    while (part + 1 < kCloudParts && share >= kPartEnds[static_cast<std::size_t>(part)]) ++part;
    return part;
}

Vector3d pickOrigin(const Scan& scan) {
    const auto* points = std::get_if<PointGeometry>(&scan.geometry);
    if (points == nullptr) return Vector3d::Zero(); // the sensor is the origin
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Vector3d& p = points->pointsM[k];
        if (scan.state[k] != CellState::Valid || !p.allFinite()) continue;
        if (p.cwiseAbs().maxCoeff() < kKeepOriginM) return Vector3d::Zero();
        return (p / kKeepOriginM).array().round().matrix() * kKeepOriginM;
    }
    return Vector3d::Zero();
}

void fillPoints(const CartesianTables& tables, CloudGeometry& out) {
    const auto beams = static_cast<std::size_t>(out.beams);
    const std::size_t cells = static_cast<std::size_t>(out.lines) * beams;
    out.xyz.resize(3 * cells);
    out.valid.assign(cells, 0);
    runInBands(out.lines, bandsFor(cells, 0), [&](int first, int last) {
        std::vector<double> x(beams), y(beams), z(beams);
        for (int line = first; line < last; ++line) {
            tables.pointsOfLine(line, x.data(), y.data(), z.data());
            std::size_t k = static_cast<std::size_t>(line) * beams;
            for (std::size_t beam = 0; beam < beams; ++beam, ++k) {
                const Vector3d p(x[beam], y[beam], z[beam]);
                const bool drawn = p.allFinite();
                const Vector3f local = drawn ? Vector3f((p - out.originM).cast<float>()) : out.sensor;
                out.xyz[3 * k] = local.x();
                out.xyz[3 * k + 1] = local.y();
                out.xyz[3 * k + 2] = local.z();
                out.valid[k] = drawn ? 1 : 0;
            }
        }
    });
}

void fillOrder(CloudGeometry& out) {
    for (std::size_t part = 0; part < out.drawOrder.size(); ++part) {
        const double share = kPartEnds[part] - (part == 0 ? 0.0 : kPartEnds[part - 1]);
        out.drawOrder[part].reserve(static_cast<std::size_t>(share * 1.05 * static_cast<double>(out.cells())) + 16);
    }
    std::size_t k = 0;
    for (int line = 0; line < out.lines; ++line) {
        for (int beam = 0; beam < out.beams; ++beam, ++k) {
            if (out.valid[k] == 0) continue;
            out.drawOrder[static_cast<std::size_t>(partOf(spread(line, beam)))].push_back(static_cast<std::uint32_t>(k));
            ++out.validCount;
        }
    }
}

void fillTiles(CloudGeometry& out) {
    for (int line = 0; line < out.lines; line += kTile) {
        for (int beam = 0; beam < out.beams; beam += kTile) {
            CloudTile tile{line, std::min(line + kTile, out.lines), beam, std::min(beam + kTile, out.beams), Box3f()};
            for (int i = tile.line0; i < tile.line1; ++i) {
                for (int j = tile.beam0; j < tile.beam1; ++j) {
                    const std::size_t k = static_cast<std::size_t>(i) * static_cast<std::size_t>(out.beams) + static_cast<std::size_t>(j);
                    if (out.valid[k] != 0) tile.box.extend(out.point(k));
                }
            }
            if (tile.box.isEmpty()) continue;
            out.bounds.extend(tile.box);
            out.tiles.push_back(tile);
        }
    }
}

std::vector<std::uint32_t> sampleCells(const CloudGeometry& cloud) {
    std::vector<std::uint32_t> cells;
    for (const auto& part : cloud.drawOrder) {
        cells.insert(cells.end(), part.begin(), part.end());
        if (cells.size() >= kEnoughSamples) break;
    }
    return cells;
}

/// The boxes without 1 % and without 0.1 % of the points at each end of each axis.
void fillBoxes(const std::vector<std::uint32_t>& sample, CloudGeometry& out) {
    if (sample.empty()) return;
    std::vector<float> values(sample.size());
    const auto last = static_cast<double>(values.size() - 1);
    for (int axis = 0; axis < 3; ++axis) {
        std::transform(sample.begin(), sample.end(), values.begin(), [&](std::uint32_t k) { return out.point(k)[axis]; });
        for (const auto& [box, leftOut] : {std::pair(&out.mainBounds, 0.01), std::pair(&out.wideBounds, 0.001)}) {
            box->min()[axis] = quantile(values, leftOut);
            box->max()[axis] = valueInOrder(values, static_cast<std::size_t>(std::ceil((1.0 - leftOut) * last)));
        }
    }
}

double middleStep(const CloudGeometry& cloud, const std::vector<std::uint32_t>& sample) {
    constexpr std::size_t kEnough = 2000;
    std::vector<double> steps;
    const std::size_t every = std::max<std::size_t>(1, sample.size() / kEnough);
    for (std::size_t n = 0; n < sample.size(); n += every) {
        if (const auto step = stepAt(cloud, sample[n])) steps.push_back(*step);
    }
    return median(std::move(steps));
}

Vector3d meanDirection(const CloudGeometry& cloud, const std::vector<std::uint32_t>& sample) {
    Vector3d sum = Vector3d::Zero();
    for (const std::uint32_t k : sample) {
        const Vector3d d = (cloud.point(k) - cloud.sensor).cast<double>();
        if (d.squaredNorm() > 0.0) sum += d.normalized();
    }
    const double strength = sum.norm() / std::max(1.0, static_cast<double>(sample.size()));
    // A full dome has no mean direction.
    return strength > 0.05 ? Vector3d(sum.normalized()) : Vector3d(Vector3d::UnitY());
}

// Direction towards row 0: mean step from a line to the line before, seen from the sensor.
std::optional<Vector3d> towardsRowZero(const CartesianTables& tables, const CloudGeometry& cloud, const Vector3d& forward) {
    Vector3d sum = Vector3d::Zero();
    double length = 0.0;
    const int step = std::max(1, cloud.lines / 32);
    for (int line = 0; line + step < cloud.lines; line += step) {
        for (int beam = 0; beam < cloud.beams; beam += std::max(1, cloud.beams / 64)) {
            const Vector3d a = tables.direction(line, beam);
            const Vector3d b = tables.direction(line + step, beam);
            if (!a.allFinite() || !b.allFinite()) continue;
            const Vector3d d = a - b;
            sum += d;
            length += d.norm();
        }
    }
    sum -= forward * forward.dot(sum);
    if (length <= 0.0 || sum.norm() < 0.2 * length) return std::nullopt; // the lines rotate about the view direction
    return sum.normalized();
}

Vector3d nearestAxis(const Vector3d& v, const Vector3d& not_along) {
    Vector3d best = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        Vector3d unit = Vector3d::Unit(axis);
        if (std::abs(unit.dot(not_along)) > 0.5) continue;
        if (v[axis] < 0.0) unit = -unit;
        if (best.isZero() || unit.dot(v) > best.dot(v)) best = unit;
    }
    return best;
}

ViewFrame frameOf(const Vector3d& forward, const Vector3d& up) {
    const Vector3d right = forward.cross(up).normalized();
    return {right, forward, right.cross(forward)};
}

void fillFrames(const Scan& scan, const CartesianTables& tables, const std::vector<std::uint32_t>& sample, CloudGeometry& out) {
    const Vector3d forward = meanDirection(out, sample);
    const Vector3d up = Vector3d::UnitZ();
    const bool alongUp = std::abs(forward.z()) >= 0.9; // as in a draw-bell: only the rows define a top of the picture
    out.scannerView = frameOf(forward, towardsRowZero(tables, out, forward).value_or(alongUp ? Vector3d::UnitY() : up));
    // Front is then a side of the picture, so that left and right are those of the picture.
    const Vector3d side = forward.z() > 0.0 ? Vector3d(-out.scannerView.up) : out.scannerView.up;
    out.axes = frameOf(nearestAxis(alongUp ? side : forward, up), up);
    if (scan.placement) { // the plan has north on top, the elevations have RL up
        const Eigen::Matrix3d mine = mineAxes(scan);
        out.axes = frameOf(mine.col(1), mine.col(2));
    }
}

} // namespace

std::optional<double> stepAt(const CloudGeometry& cloud, std::size_t k) {
    const auto angle = [&](std::size_t a, std::size_t b) {
        const Vector3d from = (cloud.point(a) - cloud.sensor).cast<double>();
        const Vector3d to = (cloud.point(b) - cloud.sensor).cast<double>();
        return std::atan2(from.cross(to).norm(), from.dot(to));
    };
    const auto beams = static_cast<std::size_t>(cloud.beams);
    const bool right = (k + 1) % beams != 0 && cloud.drawable(k + 1);
    const bool below = cloud.drawable(k + beams);
    if (!right && !below) return std::nullopt;
    return std::max(right ? angle(k, k + 1) : 0.0, below ? angle(k, k + beams) : 0.0);
}

std::shared_ptr<const CloudGeometry> withoutHidden(const CloudGeometry& cloud, const std::vector<std::uint8_t>& hidden) {
    auto rest = std::make_shared<CloudGeometry>(cloud);
    if (hidden.size() != cloud.cells()) return rest;
    for (std::size_t k = 0; k < hidden.size(); ++k) {
        if (hidden[k] != 0) rest->valid[k] = 0;
    }
    rest->validCount = 0;
    for (auto& part : rest->drawOrder) {
        std::erase_if(part, [&](std::uint32_t k) { return hidden[k] != 0; });
        rest->validCount += part.size();
    }
    return rest;
}

bool areAtSamePlaces(const CloudGeometry& a, const CloudGeometry& b) {
    if (a.lines != b.lines || a.beams != b.beams || a.validCount != b.validCount) return false;
    const Vector3d shift = a.originM - b.originM;
    const double most = 0.01 * static_cast<double>(a.wideBounds.diagonal().norm());
    const std::size_t step = std::max<std::size_t>(1, a.cells() / 1009);
    for (std::size_t k = 0; k < a.cells(); k += step) {
        if (a.drawable(k) != b.drawable(k)) return false;
        if (a.drawable(k) && ((a.point(k) - b.point(k)).cast<double>() + shift).norm() > most) return false;
    }
    return true;
}

std::shared_ptr<const CloudGeometry> makeCloudGeometry(const Scan& scan) {
    auto out = std::make_shared<CloudGeometry>();
    out->lines = scan.lines();
    out->beams = scan.beams();
    const CartesianTables tables(scan);
    out->originM = pickOrigin(scan);
    const Vector3d sensor = tables.sensor();
    out->sensor = (sensor - out->originM).cast<float>();
    fillPoints(tables, *out);
    out->normals = surfaceNormals(*out);
    fillOrder(*out);
    fillTiles(*out);
    const std::vector<std::uint32_t> sample = sampleCells(*out);
    fillBoxes(sample, *out);
    out->stepRad = middleStep(*out, sample);
    fillFrames(scan, tables, sample, *out);
    return out;
}

} // namespace edgescan::ui
