// What may be said of a rock that was seen from one point, and how well it is known (docs/rocks-method.md, "What is said of a rock").
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace edgescan {

/// To be said with every result.
inline constexpr const char* kRockCaveat = "candidate - geometry only, one viewpoint";

/// Below this confidence an outline is shown as doubtful.
inline constexpr double kSureConfidence = 0.85;

/// How far an arch angle may be off, degrees.
inline constexpr double kArchToleranceDeg = 25.0;

/// One row per rock. Lengths in metres; spans and areas are of the visible part, never of the whole rock.
struct Rock {
    std::uint32_t label = 0;                           ///< as in rockLabels()
    std::uint32_t cells = 0;                           ///< measured
    std::uint32_t cell = 0;                            ///< the measured cell of it that lies closest to its centre
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< of the visible points, frame of the scan
    double distanceM = 0.0;                            ///< from the sensor: median of the ranges
    double longM = 0.0;                                ///< a: largest caliper across the line of sight
    double wideM = 0.0;                                ///< b: smallest
    double toleranceM = 0.0;                           ///< of both: 2 (point spacing + width of the beam)
    double areaM2 = 0.0;                               ///< across the beams
    double unoccluded = 0.0;                           ///< 0..1: share of its outline where it is the nearer side
    std::vector<std::uint32_t> before;                 ///< rocks that it lies in front of, ascending
    std::vector<std::uint32_t> behind;                 ///< rocks that lie in front of it
    std::vector<std::uint32_t> contacts;               ///< rocks that it is seen to touch: at least these
    bool touchesOther = false;                         ///< it is seen to touch something that is no rock
    double freeBelowM = 0.0;                           ///< free height under its lowest visible point: at least this
    std::optional<double> archDeg;                     ///< largest angle at it between the centres of two rocks that it touches
    bool hangsBelow = false;                           ///< it lies below the line between these two centres
    double confidence = 0.0;                           ///< p
    double score = 0.0;                                ///< R
    bool byHand = false;

    bool operator==(const Rock&) const = default;
};

/// Which way is up in the frame of the scan.
struct UpDirection {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    bool assumed = true; ///< the scan has no place: taken for the scanner's z axis
};
[[nodiscard]] UpDirection upOf(const Scan& scan);

/// A map of the same leaves, and its rows.
struct RowsBefore {
    const RockMap& map;
    const std::vector<Rock>& rocks;
};

/// One row per rock of the map, in the order of the labels. `before` may be null: what it measured of a rock of the same leaves is not
/// measured again; the rows are the same without it.
[[nodiscard]] std::vector<Rock> rockRows(const RockLeaves& leaves, const RockMap& map, const RowsBefore* before = nullptr);

/// The regions of one kind together.
struct RegionCounts {
    std::uint32_t regions = 0;
    std::uint64_t cells = 0;
    double areaM2 = 0.0;
};
[[nodiscard]] RegionCounts regionCounts(const RockMap& map, RegionKind kind);

} // namespace edgescan
