// The mirror's centre in the fan: first by the step that all neighbours have in common, then by the rays of all beams.
#include "core/base/angles.h"
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/free_axis_parts.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unordered_map>

namespace edgescan::files::turning {
namespace {

constexpr std::size_t kNeighbourPairs = 200'000;
constexpr std::size_t kPhases = 4'000; // returns by which the even step is found
constexpr double kNeighbours = 0.3;    // of the step: neighbours without a gap between them
constexpr double kOnBeam = 0.3;        // of the step
constexpr double kEven = 0.7;          // of the phases: the beams are even
constexpr double kMostStep = 0.2;      // radians
constexpr int kStepRounds = 25;
constexpr double kSettled = 1e-14; // share that a round changes: rounding alone

struct Neighbours {
    Eigen::Vector2d a, b; ///< across and along the axis
};

double between(const Neighbours& pair, const Eigen::Vector2d& mirror) {
    const Eigen::Vector2d a = pair.a - mirror, b = pair.b - mirror;
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// Change of the direction to a point per change of the mirror's place.
Eigen::Vector2d changeOf(const Eigen::Vector2d& point) { return Eigen::Vector2d(point.y(), -point.x()) / point.squaredNorm(); }

std::vector<Neighbours> neighboursOf(std::span<const Eigen::Vector3d> inFans, const std::vector<ScanLine>& lines) {
    std::vector<Neighbours> pairs;
    const std::size_t stride = std::max<std::size_t>(1, inFans.size() / kNeighbourPairs);
    for (const ScanLine& line : lines) {
        for (std::size_t m = line.from; m + 1 < line.to; m += stride)
            pairs.push_back({{inFans[m].x(), inFans[m].z()}, {inFans[m + 1].x(), inFans[m + 1].z()}});
    }
    return pairs;
}

/// The step that most pairs have.
double commonStep(const std::vector<Neighbours>& pairs, const Eigen::Vector2d& mirror) {
    std::vector<double> steps;
    for (const Neighbours& pair : pairs) {
        const double step = between(pair, mirror);
        if (std::abs(step) < kMostStep) steps.push_back(step);
    }
    if (steps.size() < 12) return 0.0;
    const double middle = valueInOrder(steps, steps.size() / 2);
    const double low = std::abs(middle) * 0.5, high = std::abs(middle) * 1.2; // with gaps the middle may be two steps
    std::erase_if(steps, [&](double step) { return std::signbit(step) != std::signbit(middle) || std::abs(step) > high; });
    std::sort(steps.begin(), steps.end());
    double best = middle;
    std::size_t most = 0;
    for (std::size_t from = 0, to = 0; to < steps.size(); ++to) {
        while (steps[to] - steps[from] > 0.05 * std::abs(middle)) ++from;
        if (to - from + 1 <= most || std::abs(steps[to]) < low * 0.5) continue;
        most = to - from + 1;
        best = (steps[from] + steps[to]) / 2;
    }
    return best;
}

/// Mirror and step, so that neighbours are one step apart.
bool fitStep(Eigen::Vector2d& mirror, double& step, const std::vector<Neighbours>& pairs) {
    double tolerance = kNeighbours;
    for (int round = 0; round < kStepRounds; ++round) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        std::vector<double> off;
        for (const Neighbours& pair : pairs) {
            const double far = between(pair, mirror) - step;
            if (!(std::abs(far) < tolerance * std::abs(step))) continue;
            const Eigen::Vector2d a = pair.a - mirror, b = pair.b - mirror;
            const Eigen::Vector2d change = changeOf(b) - changeOf(a);
            const Eigen::Vector3d row(change.x(), change.y(), -1.0);
            const double weight = std::min(a.squaredNorm(), b.squaredNorm()); // angles of far points are the more precise ones
            normal += weight * row * row.transpose();
            right -= weight * far * row;
            off.push_back(std::abs(far));
        }
        if (off.size() < 12) return false;
        const Eigen::Vector3d change = normal.ldlt().solve(right);
        if (!change.allFinite()) return false;
        mirror += change.head<2>();
        step += change.z();
        const double before = tolerance;
        tolerance = std::clamp(8 * valueInOrder(off, off.size() / 2) / std::abs(step), 1e-4, kNeighbours);
        const double moved = std::max(change.head<2>().norm() / (1 + mirror.norm()), std::abs(change.z() / step));
        if (std::max(moved, std::abs(tolerance / before - 1)) < kSettled) break;
    }
    return true;
}

/// The even step near `step`, and by how much the returns agree on it.
std::pair<double, std::complex<double>> evenStep(const std::vector<double>& angles, double step) {
    std::pair<double, std::complex<double>> best{step, 0.0};
    for (const double finest : {5e-5, 5e-6}) {
        const double from = best.first;
        for (int n = -100; n <= 100; ++n) {
            const double tried = from * (1 + n * finest);
            std::complex<double> sum = 0.0;
            for (const double angle : angles) sum += std::polar(1.0, 2 * std::numbers::pi * angle / tried);
            sum /= static_cast<double>(angles.size());
            if (std::abs(sum) > std::abs(best.second)) best = {tried, sum};
        }
    }
    return best;
}

/// Sums of (x, z, 1) (x, z, 1)^T of the returns of each beam.
using BeamSums = std::unordered_map<long, Eigen::Matrix3d>;

class RayFit {
public:
    RayFit(std::span<const Eigen::Vector3d> inFans, double middle, double step, double first)
        : inFans_(inFans), middle_(middle), step_(step), first_(first) {}

    void run(Eigen::Vector2d& mirror) {
        for (int again = 0; again < 3; ++again) {
            assign(mirror);
            for (int round = 0; round < 4; ++round) mirror += stepFrom(mirror);
        }
    }
    /// First and last of the even beams, by least squares over the angles that were found.
    [[nodiscard]] FanBeams beams() const {
        if (sums_.size() < 2) return {};
        double w = 0, wi = 0, wii = 0, wy = 0, wiy = 0;
        long least = sums_.begin()->first, most = least;
        for (const long beam : inOrder()) {
            const auto at = static_cast<double>(beam);
            const double weight = sums_.at(beam)(2, 2), off = angles_.at(beam) - first_ - at * step_;
            w += weight;
            wi += weight * at;
            wii += weight * at * at;
            wy += weight * off;
            wiy += weight * at * off;
            least = std::min(least, beam);
            most = std::max(most, beam);
        }
        const double slope = (w * wiy - wi * wy) / (w * wii - wi * wi), start = (wy - slope * wi) / w;
        const auto angle = [&](long beam) { return first_ + start + static_cast<double>(beam) * (step_ + slope); };
        FanBeams beams;
        beams.first = angle(least);
        beams.last = angle(most);
        return beams;
    }

    /// Root mean square distance of the returns from their rays.
    [[nodiscard]] double misfit(const Eigen::Vector2d& mirror) const {
        double squares = 0, count = 0;
        for (const long beam : inOrder()) {
            const double c = std::cos(angles_.at(beam)), s = std::sin(angles_.at(beam));
            const Eigen::Vector3d off(-s, c, s * mirror.x() - c * mirror.y());
            squares += std::max(0.0, off.dot(sums_.at(beam) * off));
            count += sums_.at(beam)(2, 2);
        }
        return count > 0 ? std::sqrt(squares / count) : 0.0;
    }

private:
    /// The same order on every machine.
    [[nodiscard]] std::vector<long> inOrder() const {
        std::vector<long> order;
        for (const auto& [beam, sum] : sums_) order.push_back(beam);
        std::sort(order.begin(), order.end());
        return order;
    }
    void assign(const Eigen::Vector2d& mirror) {
        sums_.clear();
        angles_.clear();
        for (const Eigen::Vector3d& f : inFans_) {
            const double angle = std::atan2(f.z() - mirror.y(), f.x() - mirror.x());
            const double beam = (middle_ + std::remainder(angle - middle_, 2 * std::numbers::pi) - first_) / step_;
            const double whole = std::round(beam);
            if (!(std::abs(beam - whole) < kOnBeam)) continue;
            const Eigen::Vector3d row(f.x(), f.z(), 1.0);
            auto [sum, isNew] = sums_.try_emplace(static_cast<long>(whole), Eigen::Matrix3d::Zero());
            sum->second += row * row.transpose();
        }
        for (const auto& [beam, sum] : sums_) angles_[beam] = first_ + static_cast<double>(beam) * step_;
    }
    /// Distance of a return from the ray at angle a: cos a (z - mz) - sin a (x - mx). The angles are eliminated.
    Eigen::Vector2d stepFrom(const Eigen::Vector2d& mirror) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        struct Turn {
            long beam;
            double own;
            Eigen::Vector2d shared;
        };
        std::vector<Turn> turns;
        for (const long beam : inOrder()) {
            const Eigen::Matrix3d& sum = sums_.at(beam);
            const double c = std::cos(angles_.at(beam)), s = std::sin(angles_.at(beam));
            const Eigen::Vector3d off(-s, c, s * mirror.x() - c * mirror.y());
            const Eigen::Vector3d turn(-c, -s, c * mirror.x() + s * mirror.y());
            const Eigen::Vector2d move(s, -c);
            const double square = turn.dot(sum * turn);
            if (!(square > 0) || sum(2, 2) < 3) continue;
            const Eigen::Vector3d ones = sum.col(2);
            const Eigen::Vector2d mixed = turn.dot(ones) * move;
            const double pull = turn.dot(sum * off);
            const Eigen::Vector2d pullMove = off.dot(ones) * move;
            turns.push_back({beam, -pull / square, -mixed / square});
            normal += sum(2, 2) * move * move.transpose() - mixed * mixed.transpose() / square;
            right -= pullMove - mixed * pull / square;
        }
        const Eigen::Vector2d change = normal.ldlt().solve(right);
        if (!change.allFinite()) return Eigen::Vector2d::Zero();
        for (const Turn& turn : turns) angles_[turn.beam] += turn.own + turn.shared.dot(change);
        return change;
    }

    std::span<const Eigen::Vector3d> inFans_;
    double middle_, step_, first_;
    BeamSums sums_;
    std::unordered_map<long, double> angles_;
};

Eigen::Vector2d middleOf(std::span<const Eigen::Vector3d> inFans, const Eigen::Vector2d& mirror) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector3d& f : inFans) sum += (Eigen::Vector2d(f.x(), f.z()) - mirror).normalized();
    return sum / static_cast<double>(inFans.size());
}

std::vector<double> someAngles(std::span<const Eigen::Vector3d> inFans, const Eigen::Vector2d& mirror) {
    std::vector<double> angles;
    const std::size_t stride = std::max<std::size_t>(1, inFans.size() / kPhases) | 1U;
    for (std::size_t m = 0; m < inFans.size(); m += stride)
        angles.push_back(std::atan2(inFans[m].z() - mirror.y(), inFans[m].x() - mirror.x()));
    return angles;
}

} // namespace

std::optional<FanBeams> fitRays(FanModel& fan, std::span<const Eigen::Vector3d> inFans, const std::vector<ScanLine>& lines) {
    Eigen::Vector2d mirror(fan.mirror.x(), fan.mirror.z());
    const std::vector<Neighbours> pairs = neighboursOf(inFans, lines);
    double step = commonStep(pairs, mirror);
    if (step == 0.0 || !fitStep(mirror, step, pairs)) return std::nullopt;
    FanBeams beams;
    const auto [even, phase] = evenStep(someAngles(inFans, mirror), step);
    fan.step = step;
    if (std::abs(phase) >= kEven) {
        const Eigen::Vector2d middle = middleOf(inFans, mirror);
        RayFit rays(inFans, std::atan2(middle.y(), middle.x()), even, std::arg(phase) / (2 * std::numbers::pi) * even);
        rays.run(mirror);
        beams = rays.beams();
        fan.step = even;
        fan.misfit = std::max(fan.misfit, rays.misfit(mirror));
    }
    fan.mirror.x() = mirror.x();
    fan.mirror.z() = mirror.y();
    beams.middle = middleOf(inFans, mirror);
    return beams;
}

} // namespace edgescan::files::turning
