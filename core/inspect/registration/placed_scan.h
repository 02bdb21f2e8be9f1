// A scan's points in a frame that it shares with another scan.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace edgescan::inspect {

struct PlacedScan {
    std::shared_ptr<const Scan> scan;
    std::vector<Eigen::Vector3d> pointsM; ///< lines x beams in the common frame; NaN where a cell is not valid
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero();
    double stepRad = 0.0; ///< the larger of the median angles from beam to beam and from line to line
};

[[nodiscard]] PlacedScan placedBy(std::shared_ptr<const Scan> scan, const RigidTransform& toCommon);

/// In the mine grid: metres from `originEnhM` (Easting, Northing, Elevation). The scan must have a placement.
[[nodiscard]] PlacedScan placedInMine(std::shared_ptr<const Scan> scan, const Eigen::Vector3d& originEnhM);

/// Reads a pose file of 3DTK: position in centimetres and Euler angles in degrees about x, y and z, all left-handed (x right, y up, z
/// forward). Returns the transform from the scanner's frame, with y mirrored as when .3d files are opened, to that of the file. Error: not
/// six numbers.
Result<RigidTransform> open3dtkPose(const std::filesystem::path& path);

} // namespace edgescan::inspect
