// A measured sweep: raw ranges, a state per cell, and the geometry that converts a cell into a 3D point.
#pragma once

#include "core/base/grid.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace edgescan {

/// The state of a cell. Every cell has exactly one state; the counts add up to lines x beams (docs/reference/rules.md, "S1").
enum class CellState : std::uint8_t {
    Valid,        ///< rangeMm holds a measured range
    NoReturn,     ///< the beam had no return
    DeviceStatus, ///< the scanner put a status code in place of a range (LMS2xx: dazzled, overflow ...)
    OutOfWindow,  ///< a return outside the range window of the gate
    Masked,       ///< removed by the operator
    Lost,         ///< its telegram never arrived
};
inline constexpr int kCellStates = 6;

/// "valid", "no_return", "status", "out_of_window", "masked", "lost": the keys in the JSON of `info` and `detect`.
[[nodiscard]] const char* cellStateName(CellState state);

/// How the stepper turns the fan (docs/reference/coordinates.md, "Step 1").
enum class Axis : std::uint8_t {
    Spin,  ///< about the viewing direction z: x = r cos a cos p, y = r cos a sin p, z = r sin a
    Sweep, ///< about the 0/180 degree line x: Rx(p) (r cos a, 0, r sin a) = (r cos a, -r sin a sin p, r sin a cos p)
};

/// A scanner's geometry: beam angle a and line angle p per row and column; uneven steps are normal.
struct PolarGeometry {
    std::vector<double> beamDeg; ///< beams angles in the fan, degrees
    std::vector<double> lineDeg; ///< lines stepper angles, degrees
    Axis axis = Axis::Spin;
    double lineDirection = 1.0; ///< +1: line angles turn right-handed about the axis; -1: the other way (3DTK files)

    /// `beams` values in degrees, added to the line angle, because the stepper moves while the mirror sweeps the fan. Empty = zero.
    std::vector<double> lineSkewDeg = {};

    bool operator==(const PolarGeometry&) const = default;
};

/// An organised cloud without known ray angles (a depth camera): the points themselves, metres, NaN where missing. The scan's rangeMm is
/// the distance from `sensorM`.
struct PointGeometry {
    Grid<Eigen::Vector3d> pointsM;                     ///< lines x beams
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero(); ///< position of the sensor in the frame of pointsM
    /// If the rays nevertheless follow beams and lines about an axis of any direction: the angles between them.
    std::optional<PolarGeometry> angles = {};
};

/// A point of a cloud that was put onto a grid. It is behind the nearer point that represents its cell.
struct AttachedPoint {
    std::uint32_t cell = 0;
    Eigen::Vector3d pointM = Eigen::Vector3d::Zero(); ///< in the frame of PointGeometry::pointsM
};

using Geometry = std::variant<PolarGeometry, PointGeometry>;

struct Placement;   // core/scan/grid/placement.h
struct Acquisition; // core/scan/grid/acquisition.h

struct Scan {
    std::string name;       ///< short name for titles and file names ("scan000")
    std::string path;       ///< file it was opened from, empty when made in memory
    std::string format;     ///< "raw grid", "range CSV", "PCD", "point list", ...
    std::string sha256;     ///< of the bytes of the file with the ranges, lower-case hex
    std::string openedWith; ///< JSON of the options given when it was opened, by flag name; empty = defaults

    /// lines x beams, millimetres, exact up to 2^24. A range only where state is Valid. A DeviceStatus cell stores its code times unitMm,
    /// so that no value of the file is lost.
    Grid<float> rangeMm;
    Grid<CellState> state; ///< lines x beams
    /// lines x beams: strength of the return, as the file or the telegram gives it (RSSI), without a unit; NaN where a cell has no value.
    /// Empty: the scan has no intensities.
    Grid<float> intensity;
    Geometry geometry;
    std::vector<AttachedPoint> attached; ///< ordered by cell; empty unless the cloud had to be put onto a grid

    double unitMm = 1.0;                            ///< millimetres per raw count
    std::vector<std::uint32_t> noReturnCodes{0};    ///< raw counts that mean "no return"
    std::vector<std::uint32_t> statusCodes;         ///< raw counts that are device status codes
    std::vector<std::string> warnings;              ///< sentences about values that EdgeScan assumed, repaired or lost while reading
    std::size_t pointsRead = 0;                     ///< returns in the list of points that was put onto this grid; 0: the file holds a grid
    std::size_t pointsLeftOut = 0;                  ///< how many of these did not get a cell of their own; `attached` holds some of them
    std::string note;                               ///< free text from the file
    std::shared_ptr<const Placement> placement;     ///< its place in the mine; null = scanner frame only
    std::shared_ptr<const Acquisition> acquisition; ///< device and time of the scan; null = the file does not say

    [[nodiscard]] int lines() const { return rangeMm.lines; }
    [[nodiscard]] int beams() const { return rangeMm.beams; }
    [[nodiscard]] std::size_t cells() const { return rangeMm.size(); }
};

/// Number of cells by state, indexed by CellState. They add up to lines x beams.
[[nodiscard]] std::array<std::size_t, kCellStates> countCells(const Scan& scan);

/// Smallest and largest range over the valid cells, mm; {0, 0} if no cell is valid.
struct RangeLimits {
    float minMm = 0.0F;
    float maxMm = 0.0F;
};
[[nodiscard]] RangeLimits rangeLimits(const Scan& scan);

} // namespace edgescan
