// Puts points without a grid onto one, as seen from the sensor: the nearest return wins a cell, the others stay attached.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/files/grid_recovery/recover_grid.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::files {

inline constexpr const char* kListsOnlyPoints = "The file lists only points: "; ///< begins the warning about a grid found from them
/// What to do about a cloud whose sensor's place is not known.
inline constexpr const char* kGiveSensor = "give --sensor X,Y,Z, the place in metres that the scan was taken from";

/// A cloud without a grid and where it is looked at from.
struct LooseCloud {
    std::span<const Eigen::Vector3d> points;                          ///< any unit; not finite or (0, 0, 0) = no return
    Eigen::Vector3d sensor = Eigen::Vector3d::Zero();                 ///< in the same numbers
    std::optional<double> stepDeg;                                    ///< angle from cell to cell; empty = from the spacing of the points
    std::function<bool(const char* stage, double fraction)> progress; ///< false cancels
};

struct Regridded {
    static constexpr std::uint32_t kNoPoint = RecoveredGrid::kNoPoint;
    struct Hidden {
        std::uint32_t cell = 0;
        std::uint32_t point = 0;
    };

    Grid<std::uint32_t> pointOf; ///< lines x beams: the nearest point of each cell; line 0 on top, beam 0 at left
    std::vector<Hidden> hidden;  ///< the other points, by cell
    double beamStepDeg = 0.0;    ///< angle from beam to beam
    double lineStepDeg = 0.0;    ///< angle from line to line; of a fan its median
    bool fan = false;            ///< the lines are those of a scanner, each a line of its own angle
    std::size_t returns = 0;     ///< points in the list that are returns
    std::size_t filled = 0;      ///< cells with a point
    std::size_t outside = 0;     ///< points left out, far from all others in angle
    double closed = 0.0;         ///< share of the neighbours of filled cells that are filled; 0.6 and less looks like dust
    double nearest = 0.0;        ///< distance of the nearest point from the sensor, in the list's numbers
    double farthest = 0.0;
    [[nodiscard]] double fillRatio() const {
        return pointOf.size() > 0 ? static_cast<double>(filled) / static_cast<double>(pointOf.size()) : 0.0;
    }
};

/// Error, in numbers: too few points, a sensor so far away that the points lie in one direction, or cells that stay empty.
/// `where` is left empty for the caller.
Result<Regridded> regrid(const LooseCloud& cloud);

/// "100769 points in, 61234 of 412 x 380 cells filled (39.1 %) ...": what became of the points.
[[nodiscard]] std::string accountOf(const Regridded& grid);

} // namespace edgescan::files
