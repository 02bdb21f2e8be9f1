// The data that the cloud view draws, made once per scan on any thread: float coordinates, drawing order, tiles, frame of the view.
#pragma once

#include "core/scan/grid/scan.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

using Box3f = Eigen::AlignedBox3f;

/// The parts of the drawing order: part 0 has 1/64 of the points, parts 0 and 1 have 1/32 ...
inline constexpr int kCloudParts = 12;
inline constexpr std::array<double, kCloudParts> kPartEnds = {1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 3.0 / 16, 1.0 / 4,
                                                              3.0 / 8,  1.0 / 2,  5.0 / 8,  3.0 / 4, 7.0 / 8,  1.0};

/// Right, forward and up from the scanner's view: unit vectors in the frame of the scan, image row 0 towards `up`.
struct ViewFrame {
    Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    Eigen::Vector3d forward = Eigen::Vector3d::UnitY();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
};

/// Cells of a rectangle of the grid with the bounding box of their valid points; used to find points on the screen.
struct CloudTile {
    int line0 = 0, line1 = 0, beam0 = 0, beam1 = 0; ///< [line0, line1) x [beam0, beam1)
    Box3f box;                                      ///< local metres, never empty
};

/// Immutable after construction. Local coordinates = scan coordinates - origin, metres.
struct CloudGeometry {
    int lines = 0;
    int beams = 0;
    std::vector<float> xyz;                                        ///< 3 per cell k, local; the sensor's position for invalid cells
    std::vector<float> normals;                                    ///< per cell k, for shading: a byte an axis, as an integer
    std::vector<std::uint8_t> valid;                               ///< 1 per valid cell
    std::array<std::vector<std::uint32_t>, kCloudParts> drawOrder; ///< valid cells, spread evenly; ascending in each part
    std::size_t validCount = 0;
    std::vector<CloudTile> tiles;
    Eigen::Vector3d originM = Eigen::Vector3d::Zero();
    Eigen::Vector3f sensor = Eigen::Vector3f::Zero(); ///< local
    Box3f bounds;                                     ///< of all valid points, local; empty if no cell is valid
    Box3f mainBounds;                                 ///< of the 1-99 % of the points per axis
    Box3f wideBounds;                                 ///< of the 0.1-99.9 %: with the end of a drift, without single far points
    double stepRad = 0.0;                             ///< median angle between neighbouring points, seen from the sensor; 0: unknown
    ViewFrame scannerView;                            ///< looking from the sensor along the mean direction of the points
    ViewFrame axes; ///< for the views front, right, top ...: those of the mine grid; without a pose up is the scanner's z, as in sections

    [[nodiscard]] std::size_t cells() const { return valid.size(); }
    [[nodiscard]] bool drawable(std::size_t k) const { return k < valid.size() && valid[k] != 0; }
    [[nodiscard]] Eigen::Vector3f point(std::size_t k) const { return {xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]}; }
    /// Of the surface, towards the sensor; its length is 1 within 1 %, or 0 without a point.
    [[nodiscard]] Eigen::Vector3f normal(std::size_t k) const {
        const auto axes = static_cast<int>(normals[k]);
        return (Eigen::Vector3i(axes / 65536, axes / 256 % 256, axes % 256).array() - 128).cast<float>() / 127.0F;
    }
};

/// The larger of the two angles to the neighbours in line and beam, seen from the sensor, rad: points of this size close the surface in
/// both directions. Empty: both neighbours have no point.
[[nodiscard]] std::optional<double> stepAt(const CloudGeometry& cloud, std::size_t k);

/// True if each cell of the one has its point where the other has it, within 1 % of the cloud's size; on a sample.
[[nodiscard]] bool areAtSamePlaces(const CloudGeometry& a, const CloudGeometry& b);

/// The same cloud without the cells whose byte is not 0: they become invalid and leave the drawing order.
[[nodiscard]] std::shared_ptr<const CloudGeometry> withoutHidden(const CloudGeometry& cloud, const std::vector<std::uint8_t>& hidden);

/// For the worker thread: uses no VTK or Qt object. About 30 ms for 1.14 M points.
[[nodiscard]] std::shared_ptr<const CloudGeometry> makeCloudGeometry(const Scan& scan);

} // namespace edgescan::ui
