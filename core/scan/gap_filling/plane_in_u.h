// Fits a plane in inverse range to the measured cells around a gap.
#pragma once

#include <array>
#include <optional>
#include <span>

namespace edgescan {

/// A measured cell, with its distance from the middle of the gap in cells.
struct RingCell {
    double beams = 0;
    double lines = 0;
    double u = 0; ///< 1/m
};

/// u = u0 + alongBeams * beams + alongLines * lines.
struct PlaneInU {
    double u0 = 0, alongBeams = 0, alongLines = 0;
    double sdU = 0;                  ///< standard deviation of the weighted cells from the plane, 1/m
    double weighed = 0;              ///< share of the cells that have weight
    std::array<double, 6> inverse{}; ///< of the sum of weight * position * position^T: elements 00, 01, 02, 11, 12, 22

    [[nodiscard]] double at(double beams, double lines) const { return u0 + alongBeams * beams + alongLines * lines; }
    /// Variance of at(), divided by the variance of one cell.
    [[nodiscard]] double leverage(double beams, double lines) const;
};

/// Tukey's biweight in three rounds, starting from least squares. A cell farther from the plane than 3 max(1.48 median, `noiseU`) has no
/// weight. Empty for fewer than 7 cells, and for cells on one straight line.
[[nodiscard]] std::optional<PlaneInU> fitPlaneInU(std::span<const RingCell> ring, double noiseU);

} // namespace edgescan
