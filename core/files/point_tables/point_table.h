// Points as any format delivers them.
#pragma once

#include "core/files/grid_recovery/recover_grid.h"
#include "core/files/point_tables/source.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

/// Twice the relative rounding error of a 4-byte float. Whatever a file's numbers look like, most programs computed them in float.
inline constexpr double kFloatError = 1.2e-7;

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFF;
/// A number as a line's or a beam's index.
[[nodiscard]] constexpr std::uint32_t indexOf(double value) {
    if (!(value >= 0 && value < 2147483648.0)) return kNoIndex;
    const auto whole = static_cast<std::uint32_t>(value);
    return static_cast<double>(whole) == value ? whole : kNoIndex;
}

struct PointTable {
    std::string format;                               ///< "PCD", "PLY", "point list"
    std::size_t width = 0;                            ///< points per row of an organised cloud; all points otherwise
    std::size_t height = 1;                           ///< 1 = not organised
    bool mayBeTurned = false;                         ///< what the file calls its lines may be its beams: the one that makes a fan counts
    bool gridIsGiven = false;                         ///< organised by the file's own line and beam of each point: no other shape is right
    std::vector<Eigen::Vector3d> points;              ///< the numbers of the file; not finite where missing
    Precision precision{0.0, kFloatError};            ///< how exactly they are written
    Eigen::Vector3d sensor = Eigen::Vector3d::Zero(); ///< position of the sensor, in the same numbers
    std::optional<double> unitMm;                     ///< millimetres per number where the format or a header says so
    bool leftHanded = false;                          ///< 3DTK: x right, y up, z forward
    std::string description;                          ///< our own comment lines, JSON
    std::vector<std::string> remarks;                 ///< sentences of the reader, for Scan::warnings

    // Our own columns; empty when the file has them not, else one per point.
    std::vector<float> rangeMm;
    std::vector<std::uint8_t> state;
    std::vector<float> intensity;               ///< one per point, in any file; NaN where a point has none; empty where no point has one
    std::vector<float> filledSdMm;              ///< one per point: more than 0 was filled by this program and not measured
    std::vector<std::uint8_t> returnNumber;     ///< one per point where pulses have several: 1 is the first; empty where no point has one
    std::vector<std::uint32_t> line, beam;      ///< of columns of that name, in any file; kNoIndex where there is no whole number
    std::vector<Eigen::Vector3d> scannerPoints; ///< of a cloud in mine coordinates: the points as they were read
};

/// Adds one line of a comment to the description when it is ours ("edgescan {..."): true when it was.
bool addToDescription(std::string_view comment, std::string& description);

} // namespace edgescan::files
