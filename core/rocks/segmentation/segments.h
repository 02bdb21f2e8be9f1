// The smallest pieces from which rocks are composed (segments), and the measurements on the borders between them (docs/method/rocks.md).
#pragma once

#include "core/rocks/segmentation/inputs.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::rocks {

/// A cell without a segment: the cell was not measured, or no segment fits it.
inline constexpr std::uint32_t kNoSegment = 0;

/// Log odds of "two rocks" are stored as whole multiples of this, so that sums are exact in any order.
inline constexpr double kEvidenceStep = 1.0 / 65536.0;

/// The border of two segments, or of two groups of segments. All numbers add up when groups are merged. A crack is the side between two
/// neighbouring cells.
struct SegmentBorder {
    std::uint32_t a = 0, b = 0; ///< the two segments, a < b
    std::int64_t sumZ = 0;      ///< sum of the log odds of its cracks, in units of kEvidenceStep
    std::uint32_t cracks = 0;   ///< number of cracks between cells of a and of b
    std::uint32_t jumpsA = 0;   ///< number of cracks with a jump at which `a` is the nearer side
    std::uint32_t jumpsB = 0;   ///< the same for `b`
    std::uint32_t valleys = 0;  ///< number of cracks without a jump in a clear valley: the two touch there
    std::int64_t sumE1 = 0;     ///< sums of the parts of the evidence (CrackEvidence), in units of kEvidenceStep: e1, 0..1 per crack
    std::int64_t sumE2 = 0;     ///< e2, 0..1 per crack
    std::int64_t sumValley = 0; ///< v, -2 to 2 per crack
    std::int64_t sumWide = 0;   ///< w, -2 to 2 per crack

    /// Mean log odds of "two rocks" per crack.
    [[nodiscard]] double meanZ() const { return mean(sumZ); }
    /// The mean per crack of one of the sums.
    [[nodiscard]] double mean(std::int64_t sum) const { return static_cast<double>(sum) * kEvidenceStep / static_cast<double>(cracks); }
    void add(const SegmentBorder& other) {
        sumZ += other.sumZ;
        cracks += other.cracks;
        jumpsA += other.jumpsA;
        jumpsB += other.jumpsB;
        valleys += other.valleys;
        sumE1 += other.sumE1;
        sumE2 += other.sumE2;
        sumValley += other.sumValley;
        sumWide += other.sumWide;
    }
    /// The same border with a and b exchanged.
    [[nodiscard]] SegmentBorder reversed() const { return {b, a, sumZ, cracks, jumpsB, jumpsA, valleys, sumE1, sumE2, sumValley, sumWide}; }
};

/// Lengths of outlines, seen from the scanner, are stored as whole multiples of this, in radians, so that sums are exact in any order.
inline constexpr double kLengthStep = 1.0 / 1073741824.0;

/// The border of two segments after its refinement. Sums over its cracks in units of kLengthStep: each crack counts with the angle that it
/// covers. They add up like those of SegmentBorder.
struct OutlineSums {
    std::int64_t length = 0;
    std::array<std::int64_t, 4> byEdge{}; ///< length of cracks with e2 below 0.25, below 0.75, below 1, and 1
    std::int64_t step = 0;                ///< difference in range over the distance of neighbouring points, 0..20
    std::array<std::int64_t, 3> turn{};   ///< u above its chord of 1, 2.7 and 5.3 degrees to each side, over the length, -2..2
    std::int64_t fold = 0;                ///< S_C, the lesser of both cells, -3..3

    void add(const OutlineSums& other);
    /// The mean over the length of one of the sums; 0 without a length.
    [[nodiscard]] double mean(std::int64_t sum) const { return length == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(length); }
};

/// Sums over the measured cells of a segment; they add up when segments are merged.
struct SegmentSums {
    std::uint32_t cells = 0;
    double areaM2 = 0.0;                             ///< across the beams: r^2 x solid angle
    Eigen::Vector3d sumM = Eigen::Vector3d::Zero();  ///< sum of the points, metres from the sensor
    Eigen::Matrix3d sumM2 = Eigen::Matrix3d::Zero(); ///< sum of p p^T, m^2

    void add(const SegmentSums& other) {
        cells += other.cells;
        areaM2 += other.areaM2;
        sumM += other.sumM;
        sumM2 += other.sumM2;
    }
};

/// Consecutive cells of one segment: along the beams of a line, or along the lines of a beam.
struct SegmentRun {
    std::uint32_t segment;
    std::uint32_t row;        ///< the line, or the beam
    std::uint32_t begin, end; ///< first cell of the row, and the cell behind the last
};

/// The segments and everything else that does not depend on the level. Immutable after construction.
struct Segmentation {
    Inputs inputs;
    Grid<std::uint32_t> segment; ///< lines x beams: kOpen, or the segment from 1 on; numbered by first cells, parts of cut ones behind
    std::vector<SegmentBorder> borders; ///< ascending by (a, b)
    std::vector<OutlineSums> outlines;  ///< by border
    std::vector<std::int64_t> outer;    ///< by segment: length of its outline without a segment behind it, in units of kLengthStep
    std::vector<SegmentSums> sums;      ///< by segment; that of kOpen is empty
    std::vector<std::uint32_t> cutFrom; ///< by segment: the one that it was before any cut
    std::vector<SegmentRun> beamRuns;   ///< by line, then beam
    std::vector<SegmentRun> lineRuns;   ///< by beam, then line

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(sums.size()) - 1; }
};

/// Adds up borders of the same two segments; ascending by (a, b).
[[nodiscard]] std::vector<SegmentBorder> summedBorders(std::vector<SegmentBorder> parts);

/// The segments before the network of borders decides (core/rocks/segmentation/border_choice.h).
struct FittedSegments {
    Grid<std::uint32_t> basins; ///< before their borders were refined: `borders` belong to them
    Grid<std::uint32_t> segment;
    std::vector<SegmentBorder> borders;
    std::uint32_t count = 0;
};
[[nodiscard]] FittedSegments fittedSegments(const Inputs& inputs);

/// Steps 2 to 4 and 6. `cuts`: strokes along which the finished segments are cut, one after the other, each a list of cells
/// (core/rocks/segmentation/cuts.h). What they do not cross is the same as without them.
[[nodiscard]] Segmentation segmentRocks(const Inputs& inputs, std::span<const std::vector<std::uint32_t>> cuts = {});

} // namespace edgescan::rocks
