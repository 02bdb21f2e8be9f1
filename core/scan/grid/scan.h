// A sweep as measured: raw ranges, a state per cell, and the geometry that turns a cell into a 3D point.
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

/// What is known about a cell. Every cell has exactly one state; the counts add up to lines x beams (docs/operator.md, "S1").
enum class CellState : std::uint8_t {
    Valid,        ///< rangeMm holds a measured range
    NoReturn,     ///< the beam came back empty
    DeviceStatus, ///< the device put a status code where a range should be (LMS2xx: dazzled, overflow ...)
    OutOfWindow,  ///< a return outside the range window that the scan was gated with
    Masked,       ///< taken out by the operator
    Lost,         ///< the telegram that carried it never arrived
};
inline constexpr int kCellStates = 6;

/// "valid", "no_return", "status", "out_of_window", "masked", "lost": the keys of `info` and `detect` JSON.
[[nodiscard]] const char* cellStateName(CellState state);

/// How the stepper turns the fan (docs/coordinates.md, "Step 1").
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

    /// Beams degrees to add to the line angle: the stepper moves on while the mirror sweeps the fan. Empty = none.
    std::vector<double> lineSkewDeg = {};

    bool operator==(const PolarGeometry&) const = default;
};

/// An organised cloud whose ray angles are not known (a depth camera): the points themselves, metres, NaN where missing.
/// Its rangeMm is the distance from `sensorM`.
struct PointGeometry {
    Grid<Eigen::Vector3d> pointsM;                     ///< lines x beams
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero(); ///< position of the sensor in the frame of pointsM
    /// Where the rays lie on beams and lines all the same, about an axis of any direction: the angles between them.
    std::optional<PolarGeometry> angles = {};
};

/// A point of a cloud that was put onto a grid, behind the nearer one that its cell shows.
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
    std::string sha256;     ///< of the bytes of the file that holds the ranges, lower-case hex
    std::string openedWith; ///< JSON of what the user said on opening it, by flag name; empty = nothing

    /// lines x beams, millimetres, exact up to 2^24. Only meaningful as a range where state is Valid; a DeviceStatus
    /// cell keeps its code times unitMm, so that nothing that was read is lost.
    Grid<float> rangeMm;
    Grid<CellState> state; ///< lines x beams
    /// lines x beams: how bright the return was, as the file or the telegram (RSSI) gives it, without a unit; NaN where a cell has none.
    /// Empty: the scan has none.
    Grid<float> intensity;
    Geometry geometry;
    std::vector<AttachedPoint> attached; ///< by cell; empty unless the cloud had to be put onto a grid

    double unitMm = 1.0;                            ///< millimetres per raw count
    std::vector<std::uint32_t> noReturnCodes{0};    ///< raw counts that mean "no return"
    std::vector<std::uint32_t> statusCodes;         ///< raw counts that are device status codes
    std::vector<std::string> warnings;              ///< sentences about what was assumed, repaired or lost on reading
    std::size_t pointsRead = 0;                     ///< returns of the list of points that was put onto this grid; 0: the file holds a grid
    std::size_t pointsLeftOut = 0;                  ///< of these, how many stand in no cell of their own; `attached` holds some of them
    std::string note;                               ///< free text that the file carried
    std::shared_ptr<const Placement> placement;     ///< where it stands in the mine; null = scanner frame only
    std::shared_ptr<const Acquisition> acquisition; ///< who measured it and when; null = the file does not say

    [[nodiscard]] int lines() const { return rangeMm.lines; }
    [[nodiscard]] int beams() const { return rangeMm.beams; }
    [[nodiscard]] std::size_t cells() const { return rangeMm.size(); }
};

/// Number of cells by state, indexed by CellState. They add up to lines x beams.
[[nodiscard]] std::array<std::size_t, kCellStates> countCells(const Scan& scan);

/// Smallest and largest range over valid cells, mm; {0, 0} when there is none.
struct RangeLimits {
    float minMm = 0.0F;
    float maxMm = 0.0F;
};
[[nodiscard]] RangeLimits rangeLimits(const Scan& scan);

} // namespace edgescan
