// What the numbers of a table of points mean: their unit, how they were rounded, where the sensor is among them.
#include "core/files/open_save/table_numbers.h"
#include "core/base/translated_text.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/regrid.h"
#include "core/files/open_save/cells_of_points.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::files {
namespace {

/// Distance in metres that few points exceed.
double farDistanceM(std::vector<double> ranges, double mmPerUnit) {
    std::erase_if(ranges, [](double r) { return !(r > 0); });
    if (ranges.empty()) return 0;
    return valueInOrder(ranges, (ranges.size() - 1) * 95 / 100) * mmPerUnit * kMetresPerMm;
}

} // namespace

std::string coarseStep(const PointTable& table, const char* sentence) {
    double largest = 0;
    for (const Eigen::Vector3d& p : table.points) {
        if (!p.allFinite()) continue;
        if (p.cast<float>().cast<double>() != p) return {}; // written with more digits than a float has
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    if (largest < 1e5) return {};
    const auto step = static_cast<double>(std::nextafter(static_cast<float>(largest), std::numeric_limits<float>::infinity())) -
                      static_cast<double>(static_cast<float>(largest));
    return withValues(sentence, {significantText(largest, 7), significantText(step, 3)});
}

Precision withDecimals(Precision precision, const std::vector<Eigen::Vector3d>& points) {
    const std::size_t stride = std::max<std::size_t>(1, points.size() / 20000);
    bool floats = true; // 8-byte numbers show their decimals to the last digit
    for (std::size_t k = 0; k < points.size() && floats; k += stride)
        floats = !isReturn(points[k]) || points[k].cast<float>().cast<double>() == points[k];
    const double relative = floats ? precision.relative : std::min(precision.relative, 1e-14);
    for (const double scale : {1.0, 10.0, 100.0, 1000.0, 1e4, 1e5, 1e6}) {
        std::size_t telling = 0;
        std::size_t whole = 0;
        for (std::size_t k = 0; k < points.size(); k += stride) {
            if (!isReturn(points[k])) continue;
            for (int axis = 0; axis < 3; ++axis) {
                const double value = points[k][axis] * scale;
                const double error = std::abs(value) * relative + 1e-9;
                if (error > 0.15) continue;
                ++telling;
                whole += std::abs(value - std::round(value)) <= error ? 1 : 0;
            }
        }
        if (telling > 30 && whole * 1000 >= telling * 999) {
            precision.absolute = std::max(precision.absolute, 0.5 / scale);
            return precision;
        }
    }
    return precision;
}

std::vector<double> rangesOf(const PointTable& table) {
    std::vector<double> ranges;
    ranges.reserve(table.points.size());
    for (const Eigen::Vector3d& p : table.points) ranges.push_back(isReturn(p) ? (p - table.sensor).norm() : 0.0);
    return ranges;
}

RangeUnit unitOf(const PointTable& table, const std::vector<double>& ranges, const Source& source) {
    std::vector<double> returns;
    std::copy_if(ranges.begin(), ranges.end(), std::back_inserter(returns), [](double r) { return r > 0; });
    const std::optional<double> known = source.options->unitMm ? source.options->unitMm : table.unitMm;
    return findUnit(returns, table.precision, known);
}

std::string withCoarseStep(std::string what, const PointTable& table) {
    const std::string coarse = coarseStep(table);
    if (!coarse.empty()) what += "; " + coarse;
    return what;
}

Precision precisionAboutSensor(const PointTable& table) {
    Precision precision = table.precision;
    double largest = 0;
    for (const Eigen::Vector3d& p : table.points) {
        if (!isReturn(p)) continue;
        if (p.cast<float>().cast<double>() != p) return precision;
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    if (!table.sensor.isZero(0.0)) precision.absolute = std::max(precision.absolute, kFloatError / 2 * largest);
    return precision;
}

Precision precisionAnywhere(const PointTable& table) {
    Precision precision = precisionAboutSensor(table);
    Eigen::AlignedBox3d box;
    bool floats = true;
    for (const Eigen::Vector3d& p : table.points) {
        if (!isReturn(p)) continue;
        box.extend(p);
        floats = floats && p.cast<float>().cast<double>() == p;
    }
    if (floats || box.isEmpty()) return precision;
    return {precision.absolute + precision.relative * box.diagonal().norm() / 2, 1e-15};
}

bool dropImpossibleSensor(PointTable& table, const Source& source) {
    if (source.options->sensorM || table.sensor.isZero(0.0)) return false;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : table.points) {
        if (isReturn(p)) box.extend(p);
    }
    const double size = box.diagonal().norm(), away = box.exteriorDistance(table.sensor);
    if (!(size > 0) || away < kMostTimesTheirSize * size) return false;
    table.remarks.push_back(withValues("The file puts the sensor %1 away from its points, which are all within %2 of each other (in its "
                                       "own numbers): no scanner measures so, and the place was not used.",
                                       {significantText(away, 4), significantText(size, 3)}));
    table.sensor = Eigen::Vector3d::Zero();
    return true;
}

std::optional<Error> wrongOrigin(const PointTable& table, const Source& source) {
    constexpr double kNarrowRad = 0.0175, kNarrowCellRad = 3.5e-5; // a degree, and two thousandths of one
    if (source.options->sensorM || !table.sensor.isZero(0.0)) return std::nullopt;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    std::size_t returns = 0;
    for (const Eigen::Vector3d& p : table.points) {
        if (!isReturn(p)) continue;
        middle += p.normalized();
        ++returns;
    }
    constexpr std::size_t kFewest = 12;
    if (returns < kFewest || middle.norm() < 0.5 * static_cast<double>(returns)) return std::nullopt;
    middle.normalize();
    double widest = 0;
    double farthest = 0;
    for (const Eigen::Vector3d& p : table.points) {
        if (!isReturn(p)) continue;
        widest = std::max(widest, 2 * middle.cross(p).norm() / p.norm());
        farthest = std::max(farthest, p.norm());
    }
    if (widest > kNarrowRad || widest > kNarrowCellRad * static_cast<double>(std::max(table.width, table.height))) return std::nullopt;
    return source.refused(withValues("the %1 points of its grid lie in one direction from the origin, within %2 degrees and up to %3 away: "
                                     "the scanner stood elsewhere",
                                     {returns, significantText(degrees(widest), 3), significantText(farthest, 6)}),
                          kGiveSensor);
}

void applyGivenSensor(PointTable& table, const Source& source) {
    if (!source.options->sensorM) return;
    Eigen::Vector3d given = *source.options->sensorM;
    if (table.leftHanded) given.y() *= -1;
    const std::optional<double> known = source.options->unitMm ? source.options->unitMm : table.unitMm;
    if (known) {
        table.sensor = given * (1000.0 / *known);
        return;
    }
    constexpr double kReachM = 1000.0;
    double best = 0, bestFarM = 0;
    bool agrees = false;
    for (const double unit : {1000.0, 1.0, 10.0}) {
        table.sensor = given * (1000.0 / unit);
        const std::vector<double> ranges = rangesOf(table);
        const RangeUnit found = unitOf(table, ranges, source);
        const double farM = farDistanceM(ranges, unit);
        const bool whole = found.wholeMm && found.mmPerUnit == unit;
        const bool nearer = farM < bestFarM && bestFarM > kReachM && unit != 10.0; // centimetres only when they are whole
        if (best != 0 && !whole && !nearer) continue;
        best = unit;
        bestFarM = farM;
        agrees = found.mmPerUnit == unit;
        if (whole) break;
    }
    table.sensor = given * (1000.0 / best);
    if (agrees) return;
    table.unitMm = best;
    table.remarks.push_back(best == 1000.0 ? "Unit taken as metres, in which the numbers fit the sensor position given."
                                           : "Unit taken as millimetres, in which the numbers fit the sensor position given.");
}

} // namespace edgescan::files
