// From cell to 3D point: tables of sines and cosines per beam and per line, in double (docs/reference/coordinates.md, "Step 1").
#pragma once

#include "core/scan/grid/scan.h"

namespace edgescan {

/// Converts any cell of one scan into a point, in metres, scanner frame. The constructor computes one sine per line and beam, not per cell.
/// The scan must outlive this object.
class CartesianTables {
public:
    explicit CartesianTables(const Scan& scan);

    /// Point of cell (line, beam); NaN where the cell is not valid.
    [[nodiscard]] Eigen::Vector3d point(int line, int beam) const;
    [[nodiscard]] Eigen::Vector3d point(std::size_t k) const;

    /// The points of all cells of a line, the same numbers as point(). x, y and z are separate arrays of `beams` values. For loops over
    /// many cells.
    void pointsOfLine(int line, double* x, double* y, double* z) const;
    void pointsOfLine(int line, float* x, float* y, float* z) const; ///< rounded to the nearest float

    /// Unit direction of the beam, also where there is no return; NaN where an organised cloud has no point.
    [[nodiscard]] Eigen::Vector3d direction(int line, int beam) const;

    /// The origin of the beams, metres.
    [[nodiscard]] Eigen::Vector3d sensor() const;

private:
    template <class Number>
    void fillLine(int line, Number* x, Number* y, Number* z) const;

    const Scan* scan_;
    const PolarGeometry* polar_; // null for an organised cloud
    std::vector<double> cosBeam_, sinBeam_, cosLine_, sinLine_;
    std::vector<double> cosSkew_, sinSkew_; // per beam; empty = the line angle holds for all beams
};

/// One point without tables: for a single cell, not for a loop.
[[nodiscard]] Eigen::Vector3d pointOfCell(const Scan& scan, std::size_t k);

} // namespace edgescan
