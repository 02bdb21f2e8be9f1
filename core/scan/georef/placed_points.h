// Transforms a scan's own points to the mine grid: one rigid transform per line, computed once.
#pragma once

#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace edgescan {

/// The scan must have a placement and must outlive this object.
class PlacedPoints {
public:
    explicit PlacedPoints(const Scan& scan);

    /// Scanner frame -> metres east, north, up from the placement's origin. NaN stays NaN.
    [[nodiscard]] Eigen::Vector3d local(int line, int beam, const Eigen::Vector3d& scannerPointM) const;
    /// Scanner frame -> Easting, Northing, Elevation.
    [[nodiscard]] Eigen::Vector3d mine(int line, int beam, const Eigen::Vector3d& scannerPointM) const;
    [[nodiscard]] Eigen::Vector3d inFrame(CoordinateFrame frame, int line, int beam, const Eigen::Vector3d& scannerPointM) const;
    /// Metres from the origin -> scanner frame.
    [[nodiscard]] Eigen::Vector3d scanner(int line, int beam, const Eigen::Vector3d& localPointM) const;

    [[nodiscard]] const Eigen::Vector3d& originEnhM() const { return origin_; }

private:
    [[nodiscard]] const RigidTransform& mountOf(int beam) const {
        return mounts_[mounts_.size() == 1 ? 0 : static_cast<std::size_t>(beam)];
    }

    std::vector<Eigen::Matrix3d> withoutStepper_; // per line: scanner frame -> fan, with the ideal stepper's rotation removed
    std::vector<RigidTransform> mounts_;          // fan -> mover; one, or one per beam if the stepper moves during the line
    std::vector<RigidTransform> lines_;           // per line: mover -> axis base -> pose axes, translation in grid metres
    Eigen::Vector3d scale_;
    Eigen::Vector3d origin_;
};

/// Directions of east, north and up in the frame of the scan, at the middle of its sweep. The scan must have a placement.
[[nodiscard]] Eigen::Matrix3d mineAxes(const Scan& scan);

/// The position of a cell in the mine grid, metres.
struct MinePoint {
    Eigen::Vector3d enhM;   ///< Easting, Northing, Elevation
    Eigen::Vector3d localM; ///< the same minus the origin
};

/// One point without tables: for a single cell, not for a loop. NaN where the cell is not valid. The scan must have a placement.
[[nodiscard]] MinePoint minePoint(const Scan& scan, std::size_t k);

/// Scanner frame -> metres east, north, up from the placement's origin, without tables. The scan must have a placement.
[[nodiscard]] Eigen::Vector3d localMinePoint(const Scan& scan, int line, int beam, const Eigen::Vector3d& scannerPointM);

/// Scanner frame -> axis base A, metres. The scan must have a placement.
[[nodiscard]] Eigen::Vector3d axisBasePoint(const Scan& scan, int line, int beam, const Eigen::Vector3d& scannerPointM);

/// The warnings about a scan's place; empty without a placement.
[[nodiscard]] inline std::vector<std::string> placeWarnings(const Scan& scan) {
    return scan.placement ? scan.placement->warnings : std::vector<std::string>{};
}

/// The tail of a name that states the frame of its numbers: "" mine grid, "_LOCAL" scanner frame, "_OFFSET" local metres from an origin
/// (docs/reference/rules.md, "S6").
[[nodiscard]] const char* frameTail(CoordinateFrame frame);

/// The frame's name in records: "scanner", "mine grid", "local metres from the mine grid origin".
[[nodiscard]] const char* frameName(CoordinateFrame frame);
[[nodiscard]] std::optional<CoordinateFrame> frameNamed(std::string_view name);

/// The names of coordinates in tables: they alone name the frame where a file has no other place for it. "easting_m", "east_m", "x_m" ...
[[nodiscard]] std::array<const char*, 3> coordinateNames(CoordinateFrame frame);

} // namespace edgescan
