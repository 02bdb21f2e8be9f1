// The smallest pieces that rocks are put together from, and what was measured on the borders between them (docs/rocks-method.md).
#pragma once

#include "core/rocks/segmentation/inputs.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

/// A cell that belongs to no leaf: nothing was measured there, or no piece fits it.
inline constexpr std::uint32_t kOpen = 0;

/// Log odds of "two rocks" are kept as whole numbers of this share, so that sums are exact in any order.
inline constexpr double kEvidenceStep = 1.0 / 65536.0;

/// The border of two leaves, or of two groups of leaves: all numbers add up when groups merge.
struct LeafBorder {
    std::uint32_t a = 0, b = 0; ///< leaves, a < b
    std::int64_t sumZ = 0;      ///< of its cracks, in units of kEvidenceStep
    std::uint32_t cracks = 0;   ///< cracks between cells of a and of b
    std::uint32_t jumpsA = 0;   ///< cracks where the surface breaks and `a` is the nearer side
    std::uint32_t jumpsB = 0;   ///< likewise `b`
    std::uint32_t valleys = 0;  ///< cracks without a jump in a clear valley: the two touch there
    std::int64_t sumE1 = 0;     ///< of the parts of the evidence, like sumZ: 0..1 each
    std::int64_t sumE2 = 0;
    std::int64_t sumValley = 0; ///< v, from -2 to 2
    std::int64_t sumWide = 0;   ///< w, from -2 to 2

    /// Mean log odds of "two rocks" per crack.
    [[nodiscard]] double meanZ() const { return mean(sumZ); }
    /// Of one of the sums.
    [[nodiscard]] double mean(std::int64_t sum) const { return static_cast<double>(sum) * kEvidenceStep / static_cast<double>(cracks); }
    void add(const LeafBorder& other) {
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
    [[nodiscard]] LeafBorder turned() const { return {b, a, sumZ, cracks, jumpsB, jumpsA, valleys, sumE1, sumE2, sumValley, sumWide}; }
};

/// Sums over the measured cells of a leaf; they add up when leaves merge.
struct LeafSums {
    std::uint32_t cells = 0;
    double areaM2 = 0.0;                             ///< across the beams: r^2 x solid angle
    Eigen::Vector3d sumM = Eigen::Vector3d::Zero();  ///< of the points, metres from the sensor
    Eigen::Matrix3d sumM2 = Eigen::Matrix3d::Zero(); ///< of p p^T

    void add(const LeafSums& other) {
        cells += other.cells;
        areaM2 += other.areaM2;
        sumM += other.sumM;
        sumM2 += other.sumM2;
    }
};

/// Cells of one leaf one after the other: along the beams of a line, or along the lines of a beam.
struct LeafRun {
    std::uint32_t leaf;
    std::uint32_t row;        ///< the line, or the beam
    std::uint32_t begin, end; ///< cells of the row, `end` not included
};

/// Everything that does not depend on the level. Made once, never changed.
struct RockLeaves {
    RockInputs inputs;
    Grid<std::uint32_t> leaf;        ///< lines x beams: kOpen, or 1 ..., numbered by their first cells
    std::vector<LeafBorder> borders; ///< ascending by (a, b)
    std::vector<LeafSums> sums;      ///< by leaf; that of kOpen stays empty
    std::vector<LeafRun> beamRuns;   ///< by line, then beam
    std::vector<LeafRun> lineRuns;   ///< by beam, then line

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(sums.size()) - 1; }
};

/// Borders of the same two sides become one; ascending by (a, b).
[[nodiscard]] std::vector<LeafBorder> addedUp(std::vector<LeafBorder> parts);

/// Steps 2 to 4 and 6. `cuts`: strokes along which leaves are cut, each a list of cells (core/rocks/segmentation/cuts.h).
[[nodiscard]] RockLeaves rockLeaves(const RockInputs& inputs, std::span<const std::vector<std::uint32_t>> cuts = {});

} // namespace edgescan
