// Weighted least squares with three unknowns.
#include "core/scan/gap_filling/plane_in_u.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr std::size_t kFewestCells = 7;
constexpr int kRounds = 3;
constexpr double kReach = 3;          // in median deviations converted to standard deviations
constexpr double kSdPerMedian = 1.48; // for a normal distribution
constexpr double kLeastSpread = 1e-9; // determinant divided by the product of the diagonal

struct Sums {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, u = 0, ux = 0, uy = 0;
};

Sums summed(std::span<const RingCell> ring, const std::vector<double>& weights) {
    Sums s;
    for (std::size_t n = 0; n < ring.size(); ++n) {
        const auto& [x, y, u] = ring[n];
        const double w = weights[n];
        s.w += w;
        s.x += w * x;
        s.y += w * y;
        s.xx += w * x * x;
        s.xy += w * x * y;
        s.yy += w * y * y;
        s.u += w * u;
        s.ux += w * u * x;
        s.uy += w * u * y;
    }
    return s;
}

// False if the cells are on one straight line.
bool solve(const Sums& s, PlaneInU& plane) {
    const double c00 = s.xx * s.yy - s.xy * s.xy;
    const double c01 = s.xy * s.y - s.x * s.yy;
    const double c02 = s.x * s.xy - s.xx * s.y;
    const double determinant = s.w * c00 + s.x * c01 + s.y * c02;
    if (!(determinant > kLeastSpread * s.w * s.xx * s.yy)) return false;
    const double c11 = s.w * s.yy - s.y * s.y;
    const double c12 = s.x * s.y - s.w * s.xy;
    const double c22 = s.w * s.xx - s.x * s.x;
    for (std::size_t n = 0; const double c : {c00, c01, c02, c11, c12, c22}) plane.inverse[n++] = c / determinant;
    const auto& i = plane.inverse;
    plane.u0 = i[0] * s.u + i[1] * s.ux + i[2] * s.uy;
    plane.alongBeams = i[1] * s.u + i[3] * s.ux + i[4] * s.uy;
    plane.alongLines = i[2] * s.u + i[4] * s.ux + i[5] * s.uy;
    return true;
}

} // namespace

double PlaneInU::leverage(double x, double y) const {
    const auto& i = inverse;
    return i[0] + 2 * (i[1] * x + i[2] * y) + i[3] * x * x + 2 * i[4] * x * y + i[5] * y * y;
}

std::optional<PlaneInU> fitPlaneInU(std::span<const RingCell> ring, double noiseU) {
    if (ring.size() < kFewestCells) return std::nullopt;
    std::vector<double> weights(ring.size(), 1.0);
    std::vector<double> off(ring.size());
    PlaneInU plane;
    for (int round = 0; round <= kRounds; ++round) {
        if (!solve(summed(ring, weights), plane)) return std::nullopt;
        for (std::size_t n = 0; n < ring.size(); ++n) off[n] = std::abs(ring[n].u - plane.at(ring[n].beams, ring[n].lines));
        if (round == kRounds) break;
        const double reach = kReach * std::max(kSdPerMedian * median(off), noiseU);
        for (std::size_t n = 0; n < ring.size(); ++n) {
            const double share = reach > 0 ? off[n] / reach : 1.0;
            const double rest = 1 - share * share;
            weights[n] = off[n] == 0 ? 1.0 : share < 1 ? rest * rest : 0.0;
        }
    }
    double cells = 0, sum = 0, weight = 0;
    for (std::size_t n = 0; n < ring.size(); ++n) {
        cells += weights[n] > 0 ? 1 : 0;
        weight += weights[n];
        sum += weights[n] * off[n] * off[n];
    }
    plane.weighed = cells / static_cast<double>(ring.size());
    plane.sdU = std::sqrt(sum / weight * cells / std::max(cells - 3, 1.0));
    return plane;
}

} // namespace edgescan
