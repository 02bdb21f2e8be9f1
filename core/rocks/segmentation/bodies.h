// Bodies: groups of segments that merge to rocks, and their shape (docs/method/rocks.md, "Step 5").
#pragma once

#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/inverse_range.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan::rocks {

/// A corner of a convex hull in the picture of lines x beams.
struct HullCorner {
    std::int32_t beam = 0, line = 0;
};

/// Sums over the cells of a body; they add up when bodies merge.
struct BodySums {
    SegmentSums points;               ///< over the measured cells
    std::uint32_t cells = 0;          ///< all cells, also those whose gap was filled
    std::array<double, 15> angles{};  ///< x^a y^b of the cells, a + b up to 4, by a + b and then by b; x, y: angles in the picture, rad
    std::array<double, 6> inverses{}; ///< the same times u, a + b up to 2
    double sumU2 = 0.0;               ///< u^2, 1/m^2
    std::int64_t outerLength = 0;     ///< outline without a segment behind it, in units of kLengthStep
    std::vector<HullCorner> hull;     ///< of its cells, counterclockwise

    void add(const BodySums& other);
    void addNumbers(const BodySums& other); ///< all but the hull
};

/// What the sums say about the shape of a body.
struct BodyShape {
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< mean of the points
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the plane through the points, towards the sensor
    double longM = 0.0;                                ///< 4 standard deviations of the points along the longest axis
    double depthRatio = 0.0, middleRatio = 0.0;        ///< the standard deviations along the other two axes, divided by it
    double roughness = 0.0;                            ///< distance from a quadric, as a multiple of the noise
    double fill = 0.0;                                 ///< 0..1.2: cells divided by those of the hull
    double bulge = 0.0;                                ///< curvature of the quadric times the length; positive: towards the scanner
};

/// By segment, with an empty one for kNoSegment.
[[nodiscard]] std::vector<BodySums> segmentBodies(const Segmentation& segments);

[[nodiscard]] BodyShape shapeOf(const BodySums& sums, const RangeNoise& noise);
/// The shape of two bodies together.
[[nodiscard]] BodyShape shapeOfBoth(const BodySums& a, const BodySums& b, const RangeNoise& noise);

} // namespace edgescan::rocks
