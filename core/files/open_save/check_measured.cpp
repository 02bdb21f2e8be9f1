// Whether the numbers of a scan can have been measured.
#include "core/files/open_save/check_measured.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/simd.h"
#include "core/files/open_save/table_numbers.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace edgescan::files {
namespace {

constexpr double kFinestStepDeg = 1e-6; // a thousandth of what any scanner distinguishes

bool isOutside(float rangeMm, CellState state) {
    constexpr auto kLeast = static_cast<float>(physical::kRangeMm.limits.least);
    constexpr auto kMost = static_cast<float>(physical::kRangeMm.limits.most);
    static_assert(kLeast == physical::kRangeMm.limits.least && kMost == physical::kRangeMm.limits.most);
    return (state == CellState::Valid) & !((rangeMm >= kLeast) & (rangeMm <= kMost));
}

EDGESCAN_INLINE bool isAnyOutside(const float* rangeMm, const CellState* states, int beams) {
    int any = 0;
    for (int j = 0; j < beams; ++j) any |= isOutside(rangeMm[j], states[j]) ? 1 : 0;
    return any != 0;
}

Error outside(const PhysicalLimit& limit, double value, const std::string& place, const std::string& where) {
    const std::string unit = *limit.unit == '\0' ? "" : std::string(" ") + limit.unit;
    const std::string text =
        withValues(place.empty() ? "%1 cannot be a measured %2: %3 to %4" : "%1 at %5 cannot be a measured %2: %3 to %4",
                   {significantText(value, 6) + unit, limit.what, significantText(limit.limits.least, 6),
                    significantText(limit.limits.most, 6) + unit, place});
    return {text, where, "check the unit and the numbers of the file"};
}

Result<Done> checkAngles(const std::vector<double>& degrees, const PhysicalLimit& limit, const char* of, const std::string& where) {
    const auto off = std::ranges::find_if(degrees, [&](double angle) { return !limit.hold(angle); });
    if (off == degrees.end()) return Done{};
    return outside(limit, *off, withValues(of, {off - degrees.begin()}), where);
}

Result<Done> checkPolar(const PolarGeometry& polar, const std::string& where) {
    if (auto known = checkAngles(polar.beamDeg, physical::kBeamDeg, "beam %1", where); !known) return known;
    if (auto known = checkAngles(polar.lineDeg, physical::kLineDeg, "line %1", where); !known) return known;
    if (auto known = checkAngles(polar.lineSkewDeg, physical::kLineDeg, "the skew of beam %1", where); !known) return known;
    if (polar.beamDeg.size() < 2) return Done{}; // all lines at one angle: a stepper at rest
    const auto [least, most] = std::ranges::minmax(polar.beamDeg);
    if (most - least >= kFinestStepDeg * static_cast<double>(polar.beamDeg.size() - 1)) return Done{};
    return Error{withValues("all %1 beams look the same way", {polar.beamDeg.size()}), where, "give the step from beam to beam"};
}

/// Points of no size, seen from far beyond the reach of a scanner, were measured from elsewhere.
Result<Done> checkDistance(const Scan& scan, const std::string& where) {
    constexpr float kFarMm = 1e6F; // the nearest point
    constexpr std::size_t kFewest = 12;
    const RangeLimits limits = rangeLimits(scan);
    if (limits.minMm < kFarMm) return Done{};
    const CartesianTables tables(scan);
    Eigen::AlignedBox3d box;
    std::size_t points = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        box.extend(tables.point(k));
        ++points;
    }
    if (points < kFewest) return Done{};
    const double size = box.diagonal().norm(), away = static_cast<double>(limits.minMm) / 1000.0;
    if (away < kMostTimesTheirSize * size) return Done{};
    return Error{withValues("all points are within %1 m of each other and at least %2 m away from the scanner, which no scanner measures",
                            {significantText(size, 3), significantText(away, 6)}),
                 where, "give --sensor X,Y,Z, the place in metres that the scan was taken from, or check --unit"};
}

Result<Done> checkPlace(const Placement& placement, const std::string& where) {
    for (int axis = 0; axis < 3; ++axis) {
        const PhysicalLimit& limit = axis < 2 ? physical::kPlaceM : physical::kElevationM;
        if (!limit.hold(placement.originEnhM[axis])) return outside(limit, placement.originEnhM[axis], "", where);
        for (const RigidTransform& pose : placement.poses) {
            if (!limit.hold(pose.translationM[axis])) return outside(limit, pose.translationM[axis], "", where);
        }
    }
    return Done{};
}

} // namespace

Result<Done> checkMeasured(const Scan& scan, const std::string& where) {
    if (!physical::kUnitMm.hold(scan.unitMm)) return outside(physical::kUnitMm, scan.unitMm, "", where);
    for (int i = 0; i < scan.lines(); ++i) {
        if (!vectorised<isAnyOutside>(scan.rangeMm.line(i), scan.state.line(i), scan.beams())) continue;
        for (int j = 0; j < scan.beams(); ++j) {
            if (isOutside(scan.rangeMm.at(i, j), scan.state.at(i, j)))
                return outside(physical::kRangeMm, scan.rangeMm.at(i, j), withValues("line %1, beam %2", {i, j}), where);
        }
    }
    if (const auto* polar = std::get_if<PolarGeometry>(&scan.geometry)) {
        if (auto sound = checkPolar(*polar, where); !sound) return sound;
    }
    if (auto near = checkDistance(scan, where); !near) return near;
    return scan.placement ? checkPlace(*scan.placement, where) : Done{};
}

} // namespace edgescan::files
