// A plane in inverse range through measured cells round a gap.
#pragma once

#include <array>
#include <optional>
#include <span>

namespace edgescan {

/// A measured cell, by its steps from the middle of the gap.
struct RingCell {
    double beams = 0;
    double lines = 0;
    double u = 0; ///< 1/m
};

/// u = u0 + alongBeams * beams + alongLines * lines.
struct PlaneInU {
    double u0 = 0, alongBeams = 0, alongLines = 0;
    double sdU = 0;                  ///< of the cells with weight from the plane, 1/m
    double weighed = 0;              ///< share of the cells that have weight
    std::array<double, 6> inverse{}; ///< of the sum of weights times place times place: 00, 01, 02, 11, 12, 22

    [[nodiscard]] double at(double beams, double lines) const { return u0 + alongBeams * beams + alongLines * lines; }
    /// Variance of at() in units of that of a cell.
    [[nodiscard]] double leverage(double beams, double lines) const;
};

/// Tukey's weights in three rounds from least squares; a cell farther than 3 max(1.48 median, `noiseU`) has none. Empty for fewer than 7
/// cells, or for cells that lie on one line.
[[nodiscard]] std::optional<PlaneInU> fitPlaneInU(std::span<const RingCell> ring, double noiseU);

} // namespace edgescan
