// Finds the beam x line grid that a list of points was measured on, about the origin.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::files {

/// Largest rounding error of a written coordinate v: absolute + relative * |v|.
struct Precision {
    double absolute = 0.0;
    double relative = 1e-15;
};

struct PointList {
    std::span<const Eigen::Vector3d> points; ///< any unit; not finite or (0, 0, 0) = no return
    Precision precision;
    std::size_t rowLength = 0;                                        ///< points per row of an organised cloud; 0 = not known
    std::optional<Axis> axis;                                         ///< only this mounting is tried
    std::function<bool(const char* stage, double fraction)> progress; ///< false cancels
};

struct RecoveredGrid {
    static constexpr std::uint32_t kNoPoint = 0xFFFFFFFF;

    PolarGeometry geometry;                             ///< of the points after `turn`
    Grid<std::uint32_t> pointOf;                        ///< lines x beams: index into the list, kNoPoint where the list has none
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< applied first, where Axis cannot express the rotation axis
    bool complete = false;                              ///< the list held every cell in order, also those without a return
    std::size_t unplaced = 0;                           ///< points with a return that lie on no cell
    std::size_t doubled = 0;                            ///< other points in cells that hold a nearer one
    std::size_t copied = 0;                             ///< points that were in the list before
    std::size_t copiedLines = 0;                        ///< lines that repeated the line before and were left out
    std::vector<std::string> remarks;                   ///< sentences about what was assumed or repaired
};

/// True for a measured point: finite, neither (0, 0, 0) nor so near to it or so far that nothing measures it.
[[nodiscard]] bool isReturn(const Eigen::Vector3d& point);

/// Error: the points lie on no such grid; says in numbers what was found instead. `where` is left empty for the caller.
Result<RecoveredGrid> recoverGrid(const PointList& list);

} // namespace edgescan::files
