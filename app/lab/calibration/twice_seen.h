// Finds the cells that a rotating fan sees twice, and their place in the other view (docs/reference/calibration.md, "Seen twice").
#pragma once

#include "core/scan/georef/assembly.h"
#include "core/scan/grid/inverse_range.h"

#include <optional>
#include <vector>

namespace edgescan::inspect {

/// A cell of one view of a surface, as measured.
struct SeenCell {
    int line = 0, beam = 0;
    double lineDeg = 0;                                  ///< nominal, for this beam (including its skew)
    Eigen::Vector3d inSensorM = Eigen::Vector3d::Zero(); ///< frame S of docs/reference/coordinates.md, from the nominal beam angle
};

/// The same place as the other view would have measured it.
struct OtherView {
    double lineDeg = 0, beamDeg = 0; ///< nominal, for that beam
    double rangeM = 0;
};

/// The stepper's angle when a beam of a line is measured, degrees. The stepper may move while the mirror sweeps the fan.
[[nodiscard]] double lineDegAt(const PolarGeometry& polar, int line, int beam);

/// The cell of that line and beam for a range in metres.
[[nodiscard]] SeenCell seenCell(const PolarGeometry& polar, int line, int beam, double rangeM);

/// Index of the line whose angle at this beam is nearest to `atDeg`.
[[nodiscard]] int nearestLine(const PolarGeometry& polar, int beam, double atDeg);

/// Index of the angle nearest to `at`; `deg` ascends or descends and is not empty.
[[nodiscard]] int nearestAngle(const std::vector<double>& deg, double at);

/// The rotation of the stepper from the first line to the last, degrees.
[[nodiscard]] double turnOf(const PolarGeometry& polar);

/// The lines of the late view: from half a turn after the first line, up to a full turn.
struct LineSpan {
    int first = 0, count = 0;
};
[[nodiscard]] LineSpan lateLines(const PolarGeometry& polar);

enum class View : std::uint8_t { Early, Late };

/// Up to `most` cells of one view in smooth surroundings, drawn evenly from all cells whose other view is within the turn. The same scan
/// gives the same cells each time. For spin mountings; for sweep mountings see app/lab/calibration/axis_ends.h.
[[nodiscard]] std::vector<SeenCell> cellsSeenTwice(const PolarGeometry& polar, const InverseRange& inverse, View view, std::size_t most);

/// Assembly errors prepared for many cells.
struct MountingWithErrors {
    Axis axis = Axis::Spin;
    RigidTransform sensorInMover;
    double turnedDeg = 1; ///< rotation by the stepper, right-handed, per nominal degree
};
[[nodiscard]] MountingWithErrors mountingWithErrors(const PolarGeometry& polar, const AssemblyErrors& errors);

/// The place where the other view, half a turn earlier (for View::Late) or later, sees the point of a cell. Empty if it never sees the
/// point.
[[nodiscard]] std::optional<OtherView> otherViewOf(const SeenCell& cell, View view, const MountingWithErrors& mounting);

} // namespace edgescan::inspect
