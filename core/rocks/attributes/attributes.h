// The attributes of a rock seen from one viewpoint, and their uncertainty (docs/method/rocks.md, "What is said of a rock").
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::rocks {

/// This caveat must accompany every result.
inline constexpr const char* kRockCaveat = "candidate - geometry only, one viewpoint";

/// Below this confidence an outline is marked as doubtful.
inline constexpr double kSureConfidence = 0.85;

/// Uncertainty of an arch angle, degrees.
inline constexpr double kArchToleranceDeg = 25.0;

/// Two parts of a rock that do not touch, at their nearest cells.
struct PartDistance {
    std::uint32_t a = 0, b = 0; ///< one cell of each part
    double distanceM = 0.0;

    bool operator==(const PartDistance&) const = default;
};

/// One row of the table per rock. Lengths in metres; spans and areas are those of the visible part, never of the whole rock.
struct Rock {
    std::uint32_t label = 0;                           ///< as in rockLabels()
    std::uint32_t cells = 0;                           ///< number of measured cells
    std::uint32_t cell = 0;                            ///< its measured cell closest to its centre
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< mean of the visible points, frame of the scan
    double distanceM = 0.0;                            ///< distance from the sensor: median of the ranges
    /// a: largest caliper (distance of two parallel lines around the visible points) in the plane across the line of sight
    double longestCaliperM = 0.0;
    double shortestCaliperM = 0.0;              ///< b: smallest caliper of the visible points in the same plane
    double toleranceM = 0.0;                    ///< uncertainty of a and b: 2 (point spacing + width of the beam)
    double areaM2 = 0.0;                        ///< visible area, across the beams
    double unoccluded = 0.0;                    ///< 0..1: share of its outline at which it is the nearer side
    std::vector<std::uint32_t> rocksBehind;     ///< rocks behind it, ascending
    std::vector<std::uint32_t> rocksInFront;    ///< rocks in front of it, ascending
    std::vector<std::uint32_t> maybeOneWith;    ///< rocks that may be the same rock (addLikelyJoins()), ascending
    std::vector<std::uint32_t> contacts;        ///< rocks that it visibly touches; there may be more
    bool touchesOther = false;                  ///< it visibly touches something that is not a rock
    double freeHeightM = 0.0;                   ///< free height under its lowest visible point; the true height may be larger
    std::optional<double> archDeg;              ///< degrees: largest angle at it between the centres of two rocks that it touches
    std::array<std::uint32_t, 2> archBetween{}; ///< these two rocks; 0 without an arch
    bool isBelowContacts = false;               ///< it is below the line between these two centres
    double confidence = 0.0;                    ///< p, 0..1 (Region::confidence)
    double score = 0.0;                         ///< R, log odds (Region::score)
    bool byHand = false;
    std::vector<PartDistance> apart; ///< between parts that were merged by hand and do not touch: one fewer than such parts

    /// The largest of these distances; 0 without one.
    [[nodiscard]] double apartM() const;
    bool operator==(const Rock&) const = default;
};

/// As files and texts have it: an outline with p = 0.8497 has 0.850 in a table and is not marked.
[[nodiscard]] bool isDoubtful(const Rock& rock);
/// Two decimals that never round a marked one up to 0.85.
[[nodiscard]] std::string confidenceText(const Rock& rock);

/// The vertical in the frame of the scan.
struct UpDirection {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    bool assumed = true; ///< true: the scan has no placement, so the scanner's z axis is used
};
[[nodiscard]] UpDirection upOf(const Scan& scan);

/// An earlier map of the same segments, and its rows.
struct EarlierRows {
    const RegionMap& map;
    const std::vector<Rock>& rocks;
};

/// The row with this label, of rows in the order of their labels; null: there is none.
[[nodiscard]] const Rock* rockOf(std::span<const Rock> rocks, std::uint32_t label);

/// One row per rock of the map, in the order of the labels. `before` may be null. Rocks with the same segments as in `before` are not
/// measured again; the rows are the same without it.
[[nodiscard]] std::vector<Rock> rockRows(const Segmentation& segments, const RegionMap& map, const EarlierRows* before = nullptr);

/// Fills Rock::maybeOneWith: rocks that the tree merges within kLikelyJoin above the level of the map.
void addLikelyJoins(const MergeTree& tree, const RegionMap& map, std::vector<Rock>& rocks);
inline constexpr double kLikelyJoin = 1.0; ///< log odds: one rock is nearly as likely as two

/// Totals of the regions of one kind.
struct RegionCounts {
    std::uint32_t regions = 0;
    std::uint64_t cells = 0;
    double areaM2 = 0.0;
};
[[nodiscard]] RegionCounts regionCounts(const RegionMap& map, RegionKind kind);

} // namespace edgescan::rocks
