// Angles with errors.
#include "core/files/grid_recovery/return_angles.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::files::recognition {
namespace {

constexpr double kBound = 1.75; // of a point's distance from what was measured, to the rounding of one coordinate: sqrt(3) at most
constexpr std::size_t kFewestAngles = 12;
constexpr double kPreciseShare = 1.0 / 6.0; // of the step: voids of two thirds remain
constexpr std::size_t kEnough = 200'000;    // angles show their groups; more only cost time

/// The values of angles with errors up to `limit`, evenly thinned to about kEnough.
std::vector<double> upTo(std::span<const Angle> angles, double limit) {
    std::vector<double> values;
    for (const Angle& a : angles) {
        if (a.error <= limit) values.push_back(a.value);
    }
    if (values.size() <= 2 * kEnough) return values;
    const double stride = static_cast<double>(values.size()) / static_cast<double>(kEnough);
    for (std::size_t n = 0; n < kEnough; ++n) values[n] = values[static_cast<std::size_t>(static_cast<double>(n) * stride)];
    values.resize(kEnough);
    return values;
}

bool known(const std::vector<Ring>& rings, const Ring& ring) {
    return std::any_of(rings.begin(), rings.end(), [&](const Ring& other) { return other.centres.size() == ring.centres.size(); });
}

double usualVoid(const Ring& ring) { return median(ring.voids()); }

} // namespace

std::vector<ReturnAngles> returnsOf(std::span<const AxisPoint> points, const Precision& precision) {
    std::vector<ReturnAngles> returns;
    returns.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const AxisPoint& p = points[k];
        if (p.missing()) continue;
        const double range = p.range();
        const double radius = std::sqrt(p.squaredRadius());
        const double bound = kBound * (precision.absolute + precision.relative * range);
        const double planeError = radius > bound ? bound / radius * 1.05 : kPi; // asin is hardly more
        returns.push_back(
            {static_cast<std::uint32_t>(k), p.plane(), std::atan2(radius, p.u), planeError > 1 ? kPi : planeError, bound / range});
    }
    return returns;
}

std::vector<Ring> ringsOfStep(std::span<const Angle> angles, double period, double step) {
    return ringsIn(upTo(angles, kPreciseShare * step), period);
}

std::vector<Ring> ringsAmong(std::span<const Angle> angles, double period) {
    std::vector<Ring> rings;
    if (angles.size() < kFewestAngles) return rings;
    std::vector<double> errors;
    errors.reserve(angles.size());
    for (const Angle& a : angles) errors.push_back(a.error);
    const double usual = valueInOrder(errors, errors.size() / 2);
    std::vector<double> limits{4 * usual, 1.0000001 * usual};
    for (const double share : {0.2, 0.05, 0.01}) limits.push_back(1.0000001 * quantile(errors, share));
    for (const double limit : limits) {
        bool clearest = true;
        for (Ring& ring : ringsIn(upTo(angles, limit), period)) {
            if (ring.centres.size() < 2 || known(rings, ring)) continue;
            // A coarse look may merge neighbours that lie close, or miss groups without a precise angle.
            if (clearest) {
                std::vector<Ring> fine = ringsOfStep(angles, period, usualVoid(ring));
                if (!fine.empty() && fine.front().centres.size() >= ring.centres.size() && !known(rings, fine.front()))
                    rings.push_back(std::move(fine.front()));
            }
            clearest = false;
            if (!known(rings, ring)) rings.push_back(std::move(ring));
        }
    }
    return rings;
}

std::vector<std::size_t> spreadInOrder(std::span<const double> wanted, std::span<const double> weights, std::size_t places) {
    struct Block {
        double sum = 0, weight = 0;
        std::size_t values = 0;
        [[nodiscard]] double mean() const { return sum / weight; }
    };
    std::vector<Block> blocks; // of wanted - place in the order, which must not descend
    for (std::size_t n = 0; n < wanted.size(); ++n) {
        blocks.push_back({(wanted[n] - static_cast<double>(n)) * weights[n], weights[n], 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() >= blocks.back().mean()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().weight += last.weight;
            blocks.back().values += last.values;
        }
    }
    std::vector<std::size_t> taken;
    taken.reserve(wanted.size());
    const auto most = static_cast<double>(places - wanted.size());
    for (const Block& block : blocks) {
        const auto shift = static_cast<std::size_t>(std::llround(std::clamp(block.mean(), 0.0, most)));
        for (std::size_t n = 0; n < block.values; ++n) taken.push_back(taken.size() + shift);
    }
    return taken;
}

double placeAmong(const std::vector<double>& centres, double angle) {
    if (centres.size() < 2) return 0.0;
    auto right = std::upper_bound(centres.begin(), centres.end(), angle);
    if (right == centres.begin()) ++right;
    if (right == centres.end()) --right;
    const auto at = static_cast<double>(right - centres.begin());
    return at - (*right - angle) / (*right - *(right - 1));
}

} // namespace edgescan::files::recognition
