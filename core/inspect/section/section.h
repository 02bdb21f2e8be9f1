// A section: the line in which a plane cuts the measured surfaces, in true scale.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/edges/pipeline/detection.h"
#include "core/inspect/measure/lengths.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace edgescan::inspect {

/// Frame of the scan, metres. `across` and `up` are unit vectors at right angles to each other: the axes of the plot.
struct SectionPlane {
    Eigen::Vector3d originM = Eigen::Vector3d::Zero(); ///< (0, 0) of the plot
    Eigen::Vector3d across = Eigen::Vector3d::UnitX();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    bool upAssumed = false; ///< the scan has no placement: up is the scanner's z axis
};

/// The plane through the points of two cells and the vertical; the first is at (0, 0), the second to its right. If one is above the other,
/// the plane goes through the scanner too. Error: a cell does not exist or has no range, or both are one point.
[[nodiscard]] Result<SectionPlane> planeThrough(const Scan& scan, std::uint32_t from, std::uint32_t to);
/// The vertical plane through a rock, along its longest visible width; what is at the left in the range image is at the left of the plot.
/// `rockCells`: its cells. Error: fewer than two points.
[[nodiscard]] Result<SectionPlane> planeThroughRock(const Scan& scan, const std::vector<std::uint32_t>& rockCells);

struct SectionVertex {
    Eigen::Vector2d atM = Eigen::Vector2d::Zero();    ///< across and up
    Eigen::Vector3d pointM = Eigen::Vector3d::Zero(); ///< frame of the scan
    std::uint32_t cell = 0;                           ///< the nearer of the two cells between which it is
    std::uint32_t other = 0;                          ///< the other one
    double share = 0.0;                               ///< of the way from `cell` to `other`, up to 0.5
    bool edge = false;                                ///< one of these two cells is an edge
    edges::DepthEdge kind = edges::DepthEdge::None;   ///< class of that edge, if the method distinguishes classes
    std::uint32_t rock = 0;                           ///< label of the rock at `cell`; 0: none
};

/// A line along one surface: from one jump or border to the next.
using SectionLine = std::vector<SectionVertex>;

struct Section {
    SectionPlane plane;
    std::vector<SectionLine> lines;
};

/// Cuts the triangles between neighbouring cells. Cells on both sides of a jump or of a gap are not connected. `rockOf`: labels, lines x
/// beams, 0 = no rock; null: no rocks are marked.
[[nodiscard]] Section sectionOf(const edges::Detection& detection, const SectionPlane& plane, const Grid<std::uint32_t>* rockOf = nullptr);

/// The distance of two vertices: lengthBetween().
[[nodiscard]] MeasuredLength sectionLength(const Scan& scan, const RangeNoise& noise, const SectionVertex& a, const SectionVertex& b);

} // namespace edgescan::inspect
