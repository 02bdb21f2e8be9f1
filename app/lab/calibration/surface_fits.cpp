// Least squares over a square of cells.
#include "app/lab/calibration/surface_fits.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr double kMisfitMm = 30.0;
constexpr double kMisfitShare = 0.02; // share of the range
constexpr double kLeastShare = 0.6;   // share of the square that must be measured
constexpr double kNearestM = 0.5;

SurfaceFit fitAt(const InverseRange& inverse, int line, int beam, int half) {
    SurfaceFit fit;
    if (!inverse.isMeasured(line, beam)) return fit;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double squares = 0;
    int count = 0;
    const int fromLine = std::max(0, line - half), toLine = std::min(inverse.u.lines - 1, line + half);
    const int fromBeam = std::max(0, beam - half), toBeam = std::min(inverse.u.beams - 1, beam + half);
    const double middle = static_cast<double>(inverse.u.at(line, beam));
    for (int i = fromLine; i <= toLine; ++i) {
        for (int j = fromBeam; j <= toBeam; ++j) {
            if (!inverse.isMeasured(i, j)) continue;
            const Eigen::Vector3d x(1.0, j - beam, i - line);
            const double u = static_cast<double>(inverse.u.at(i, j)) - middle; // small numbers keep more digits
            normal += x * x.transpose();
            right += u * x;
            squares += u * u;
            ++count;
        }
    }
    const int side = 2 * half + 1;
    if (count < std::max(6, static_cast<int>(kLeastShare * side * side))) return fit;
    bool invertible = false;
    normal.computeInverseWithCheck(fit.inverseNormal, invertible);
    if (!invertible) return fit;
    const Eigen::Vector3d c = fit.inverseNormal * right;
    const double left = std::max(0.0, squares - c.dot(right)) / (count - 3);
    fit.c = c + Eigen::Vector3d(middle, 0, 0);
    const double rangeM = 1.0 / middle;
    fit.misfitMm = 1000.0 * std::sqrt(left) * rangeM * rangeM;
    fit.usable = fit.c[0] > 0 && rangeM > kNearestM && fit.misfitMm < kMisfitMm + 1000.0 * kMisfitShare * rangeM;
    return fit;
}

} // namespace

SurfaceFits::SurfaceFits(const InverseRange& inverse, int halfWidth)
    : inverse_(inverse), halfWidth_(halfWidth), place_(inverse.u.size(), -1) {}

const SurfaceFit& SurfaceFits::at(int line, int beam) {
    std::int32_t& place = place_[inverse_.u.index(line, beam)];
    if (place < 0) {
        place = static_cast<std::int32_t>(fits_.size());
        fits_.push_back(fitAt(inverse_, line, beam, halfWidth_));
    }
    return fits_[static_cast<std::size_t>(place)];
}

} // namespace edgescan::inspect
