// Transforms the points of two scans to one frame.
#include "core/inspect/registration/placed_scan.h"

#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/base/physical_limits.h"
#include "core/base/whole_file.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace edgescan::inspect {
namespace {

constexpr double kMetresPerCentimetre = 0.01;
constexpr std::size_t kMostStepsLooked = 20000;

/// Median angle between neighbours, as seen from the sensor.
double usualStep(const PlacedScan& placed, bool alongBeams) {
    const auto beams = static_cast<std::size_t>(placed.scan->beams());
    const std::size_t next = alongBeams ? 1 : beams;
    std::vector<double> steps;
    const std::size_t stride = std::max<std::size_t>(1, placed.pointsM.size() / kMostStepsLooked);
    for (std::size_t k = 0; k + next < placed.pointsM.size(); k += stride) {
        if (alongBeams && k % beams + 1 == beams) continue;
        const Eigen::Vector3d a = placed.pointsM[k] - placed.sensorM;
        const Eigen::Vector3d b = placed.pointsM[k + next] - placed.sensorM;
        const double step = std::atan2(a.cross(b).norm(), a.dot(b));
        if (std::isfinite(step)) steps.push_back(step);
    }
    return steps.empty() ? 0.0 : median(std::move(steps));
}

void measureStep(PlacedScan& placed) { placed.stepRad = std::max(usualStep(placed, true), usualStep(placed, false)); }

/// The rotation matrix of Euler angles, as 3DTK computes it.
Eigen::Matrix3d turnOf(const Eigen::Vector3d& deg) {
    const Eigen::Vector3d rad = deg * (std::numbers::pi / 180);
    return (Eigen::AngleAxisd(rad.x(), Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(rad.y(), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(rad.z(), Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

} // namespace

PlacedScan placedBy(std::shared_ptr<const Scan> scan, const RigidTransform& toCommon) {
    PlacedScan placed{std::move(scan), {}, {}, 0.0};
    const CartesianTables tables(*placed.scan);
    placed.pointsM.reserve(placed.scan->cells());
    for (std::size_t k = 0; k < placed.scan->cells(); ++k) placed.pointsM.push_back(toCommon * tables.point(k));
    placed.sensorM = toCommon * tables.sensor();
    measureStep(placed);
    return placed;
}

PlacedScan placedInMine(std::shared_ptr<const Scan> scan, const Eigen::Vector3d& originEnhM) {
    PlacedScan placed{std::move(scan), {}, {}, 0.0};
    const CartesianTables tables(*placed.scan);
    const PlacedPoints mine(*placed.scan);
    const Eigen::Vector3d shift = mine.originEnhM() - originEnhM;
    const auto beams = static_cast<std::size_t>(placed.scan->beams());
    placed.pointsM.reserve(placed.scan->cells());
    for (std::size_t k = 0; k < placed.scan->cells(); ++k)
        placed.pointsM.push_back(mine.local(static_cast<int>(k / beams), static_cast<int>(k % beams), tables.point(k)) + shift);
    placed.sensorM = mine.local(placed.scan->lines() / 2, placed.scan->beams() / 2, tables.sensor()) + shift;
    measureStep(placed);
    return placed;
}

Result<RigidTransform> open3dtkPose(const std::filesystem::path& path) {
    const auto bytes = readInput(path);
    if (!bytes) return bytes.error();
    Eigen::Matrix<double, 6, 1> numbers;
    Eigen::Index count = 0;
    for (std::string_view rest = textOf(*bytes); true;) {
        const std::size_t from = rest.find_first_not_of(" \t\r\n");
        if (from == rest.npos) break;
        rest.remove_prefix(from);
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
        const auto value = numberOf(std::string(word));
        if (!value || count == 6 || !physical::kPlaceM.hold(*value))
            return Error{"this is not a pose of 3DTK, which has three centimetres and three degrees", path.string(), "choose a .pose file"};
        numbers[count++] = *value;
        rest.remove_prefix(word.size());
    }
    if (count != 6)
        return Error{"the file holds " + counted(count, "number") + " and a pose of 3DTK has six", path.string(), "choose a .pose file"};
    const Eigen::DiagonalMatrix<double, 3> mirror(1, -1, 1);
    return RigidTransform{mirror * turnOf(numbers.tail<3>()) * mirror, mirror * (numbers.head<3>() * kMetresPerCentimetre)};
}

} // namespace edgescan::inspect
