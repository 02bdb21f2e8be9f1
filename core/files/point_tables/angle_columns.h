// Columns of angles: which they are by their names, the points that angles and a range mean, and the grid that angles make.
#pragma once

#include "core/files/point_tables/point_table.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace edgescan::files {

/// Two columns of angles and, where it is there, one of ranges.
struct AngleColumns {
    std::size_t azimuth = 0, elevation = 0;
    std::optional<std::size_t> range;
    std::array<std::optional<double>, 2> unitDeg; ///< degrees per number of azimuth and elevation, where a name says so
    std::optional<double> rangeUnitMm;            ///< millimetres per number of the range, where its name says so
    bool fromZenith = false;                      ///< the elevation is counted from the zenith
    bool clockwise = false; ///< the azimuth counts clockwise from y, as surveyors do; else from x to y, as ROS and E57 do
};

/// By their names in the languages of axis_words.h: azimuth, Hz, rumbo; elevation, vertical angle, zenith; range, distance. Empty: azimuth
/// or elevation is missing.
[[nodiscard]] std::optional<AngleColumns> angleColumnsNamed(std::span<const std::string> names);

/// Replaces azimuth, elevation and range, which the points of the table hold in place of x, y and z, by x, y and z. Where the angles make
/// a regular grid the points get their line (azimuth) and beam (elevation). A remark says what was done.
void setPointsFromAngles(PointTable& table, const AngleColumns& columns);

/// Lines and beams of points by their angles (azimuth, elevation), one per point, where these make a regular grid; else nothing is done.
void setCellsFromAngles(PointTable& table, std::span<const Eigen::Vector2d> angles, const AngleColumns& columns);

} // namespace edgescan::files
