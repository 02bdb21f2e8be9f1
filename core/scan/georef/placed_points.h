// From a scan's own points to the mine: one rigid transform per line, worked out once.
#pragma once

#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <optional>
#include <string_view>
#include <vector>

namespace edgescan {

/// The scan must have a placement and outlive this.
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

    std::vector<Eigen::Matrix3d> unturned_; // per line: scanner frame -> fan, the ideal stepper turned back
    std::vector<RigidTransform> mounts_;    // fan -> mover; one, or one per beam where the stepper moves on during the line
    std::vector<RigidTransform> lines_;     // per line: mover -> axis base -> pose axes, the translation in grid metres
    Eigen::Vector3d scale_;
    Eigen::Vector3d origin_;
};

/// A cell's place in the mine.
struct MinePoint {
    Eigen::Vector3d enhM;   ///< Easting, Northing, Elevation
    Eigen::Vector3d localM; ///< the same less the origin
};

/// One point without tables: for a probe, not for a loop. NaN where the cell is not valid. The scan must have a placement.
[[nodiscard]] MinePoint minePoint(const Scan& scan, std::size_t k);

/// Scanner frame -> metres east, north, up from the placement's origin, without tables. The scan must have a placement.
[[nodiscard]] Eigen::Vector3d inMineLocal(const Scan& scan, int line, int beam, const Eigen::Vector3d& scannerPointM);

/// Scanner frame -> axis base A, metres. The scan must have a placement.
[[nodiscard]] Eigen::Vector3d inAxisBase(const Scan& scan, int line, int beam, const Eigen::Vector3d& scannerPointM);

/// What is doubtful about a scan's place: empty without one.
[[nodiscard]] inline std::vector<std::string> placeWarnings(const Scan& scan) {
    return scan.placement ? scan.placement->warnings : std::vector<std::string>{};
}

/// What a name says of its numbers: "" mine grid, "_LOCAL" scanner frame, "_OFFSET" local metres from an origin (docs/operator.md, "S6").
[[nodiscard]] const char* frameTail(CoordinateFrame frame);

/// What records call it: "scanner", "mine grid", "local metres from the mine grid origin".
[[nodiscard]] const char* frameName(CoordinateFrame frame);
[[nodiscard]] std::optional<CoordinateFrame> frameNamed(std::string_view name);

/// Mine where the scan has a place, else Scanner: what an export should carry unless somebody says otherwise.
[[nodiscard]] inline CoordinateFrame usualFrame(const Scan& scan) {
    return scan.placement ? CoordinateFrame::Mine : CoordinateFrame::Scanner;
}

} // namespace edgescan
