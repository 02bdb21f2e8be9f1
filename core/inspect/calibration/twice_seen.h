// Which cells a turning fan sees twice, and where the other view of them lies (docs/calibration.md, "Seen twice").
#pragma once

#include "core/scan/georef/assembly.h"
#include "core/scan/grid/inverse_range.h"

#include <optional>
#include <vector>

namespace edgescan {

/// A cell of one view of a surface, as measured.
struct SeenCell {
    int line = 0, beam = 0;
    double lineDeg = 0;                                  ///< nominal, of this beam (its skew added)
    Eigen::Vector3d inSensorM = Eigen::Vector3d::Zero(); ///< S of docs/coordinates.md, by the nominal beam angle
};

/// The same place as the other view would have measured it.
struct OtherView {
    double lineDeg = 0, beamDeg = 0; ///< nominal, of that beam
    double rangeM = 0;
};

/// Where the stepper stands when a beam of a line is measured, degrees: it may move on while the mirror sweeps the fan.
[[nodiscard]] double lineDegAt(const PolarGeometry& polar, int line, int beam);

/// The cell of that line and beam with a range of so many metres.
[[nodiscard]] SeenCell seenCell(const PolarGeometry& polar, int line, int beam, double rangeM);

/// Index of the line whose angle at this beam is nearest to `atDeg`.
[[nodiscard]] int nearestLine(const PolarGeometry& polar, int beam, double atDeg);

/// Index of the angle nearest to `at`; `deg` ascends or descends and is not empty.
[[nodiscard]] int nearestAngle(const std::vector<double>& deg, double at);

/// How far the stepper turned from the first line to the last, degrees.
[[nodiscard]] double turnOf(const PolarGeometry& polar);

/// The lines of the late view: from half a turn after the first line on, to a full turn at most.
struct LineSpan {
    int first = 0, count = 0;
};
[[nodiscard]] LineSpan lateLines(const PolarGeometry& polar);

enum class View : std::uint8_t { Early, Late };

/// Up to `most` cells of one view whose surroundings are smooth, evenly drawn from all whose other view lies within the turn. A scan draws
/// the same cells each time. Of a spin mounting; those of a sweep: core/inspect/calibration/axis_ends.h.
[[nodiscard]] std::vector<SeenCell> cellsSeenTwice(const PolarGeometry& polar, const InverseRange& inverse, View view, std::size_t most);

/// Errors of an assembly made ready for many cells.
struct TurningMounting {
    Axis axis = Axis::Spin;
    RigidTransform sensorInMover;
    double turnedDeg = 1; ///< by the stepper, right-handed, for one nominal degree
};
[[nodiscard]] TurningMounting turningMounting(const PolarGeometry& polar, const AssemblyErrors& errors);

/// Where the other view, half a turn earlier (for View::Late) or later, sees the point of a cell. Nothing: it never does.
[[nodiscard]] std::optional<OtherView> otherViewOf(const SeenCell& cell, View view, const TurningMounting& mounting);

} // namespace edgescan
