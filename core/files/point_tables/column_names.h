// What a column of points is by its name, in every format that names its columns.
#pragma once

#include "core/files/point_tables/angle_columns.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

enum class ColumnRole : std::uint8_t {
    X,
    Y,
    Z,
    Line,
    Beam,
    RangeMm,
    State,
    ScannerX,
    ScannerY,
    ScannerZ,
    Intensity,
    FilledSdMm,
    ReturnNumber
};
inline constexpr std::size_t kColumnRoles = 13;

/// Which column has which role; empty where no column has it.
struct NamedColumns {
    std::optional<std::size_t> of[kColumnRoles];
    bool rowsAndColumns = false;        ///< line and beam are called row and column, which programs mean either way
    std::optional<double> unitMm;       ///< millimetres per number of x y z, where their names say so: "x_mm", "X [m]"
    std::optional<AngleColumns> angles; ///< azimuth and elevation, where no columns count lines and beams
    bool anglesForPoint = false;        ///< x, y and z are the columns of azimuth, elevation and range: setPointsFromAngles()

    [[nodiscard]] std::optional<std::size_t> operator[](ColumnRole role) const { return of[static_cast<std::size_t>(role)]; }
    [[nodiscard]] bool hasPoint() const { return of[0] && of[1] && of[2]; }
    [[nodiscard]] bool hasCell() const { return (*this)[ColumnRole::Line] && (*this)[ColumnRole::Beam]; }
    [[nodiscard]] bool hasScannerPoint() const {
        return (*this)[ColumnRole::ScannerX] && (*this)[ColumnRole::ScannerY] && (*this)[ColumnRole::ScannerZ];
    }
};

/// By the usual names, in any case: x y z, Easting Northing Elevation, E N Z, East North Height, RL ..., line or row or ring, beam or
/// column or col, intensity or reflectance or RSSI. A column that is the first of its name counts; a role's usual name goes before its
/// others. Words that all three columns share are not part of a name: "Point X", "pos.x", "Points:0", "cartesianX".
[[nodiscard]] NamedColumns columnsNamed(std::span<const std::string> names);

/// What the names say the columns hold in place of x, y and z: "angles and ranges", "degrees of latitude and longitude"; empty where the
/// names do not say it, or where they name x, y and z.
[[nodiscard]] std::optional<std::string> contentsNamed(std::span<const std::string> names);

/// How many names speak of an axis. Where x, y and z are not all found among such names their order is unknown.
[[nodiscard]] std::size_t namesOfAxes(std::span<const std::string> names);

/// True where names only count the columns, as "col1" and "a" do: they say nothing about their order.
[[nodiscard]] bool onlyCount(std::span<const std::string> names);

} // namespace edgescan::files
