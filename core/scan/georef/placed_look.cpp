// The span of a placed scan, and the direction of its scanner.
#include "core/scan/georef/placed_look.h"

#include "core/base/angles.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

constexpr double kLooksUpDeg = 45.0; // a z axis that is lower does not look up
constexpr double kMost = 0.5;

} // namespace

PlacedLook placedLook(const Scan& scan) {
    const PlacedPoints mine(scan);
    const CartesianTables tables(scan);
    const int line = scan.lines() / 2, beam = scan.beams() / 2;
    PlacedLook look;
    look.sensor = look.least = look.most = mine.mine(line, beam, tables.sensor());
    const Eigen::Vector3d ahead = mine.mine(line, beam, tables.sensor() + Eigen::Vector3d::UnitZ()) - look.sensor;
    look.elevationDeg = degrees(std::atan2(ahead.z(), std::hypot(ahead.x(), ahead.y())));
    std::size_t points = 0, below = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d point = tables.point(k);
        if (!point.allFinite()) continue;
        const auto beams = static_cast<std::size_t>(scan.beams());
        const Eigen::Vector3d p = mine.mine(static_cast<int>(k / beams), static_cast<int>(k % beams), point);
        look.least = look.least.cwiseMin(p);
        look.most = look.most.cwiseMax(p);
        ++points;
        below += p.z() < look.sensor.z() ? 1 : 0;
    }
    if (points > 0) look.belowShare = static_cast<double>(below) / static_cast<double>(points);
    return look;
}

LookDoubt lookDoubt(const PlacedLook& look, Viewing viewing) {
    const bool looksUp = look.elevationDeg >= kLooksUpDeg;
    if (viewing == Viewing::Forward) return looksUp ? LookDoubt::None : LookDoubt::TurnedForward;
    if (viewing != Viewing::Up) return LookDoubt::None;
    if (!looksUp) return LookDoubt::NotUp;
    return look.belowShare > kMost ? LookDoubt::MostlyBelow : LookDoubt::None;
}

} // namespace edgescan
