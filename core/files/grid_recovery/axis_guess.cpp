// A first guess of a free axis: planes through neighbours of the list contain its direction, and meet in it.
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/free_axis_parts.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace edgescan::files::turning {
namespace {

constexpr std::array<std::size_t, 6> kSpans{4, 8, 16, 32, 64, 128}; // points from one corner of a plane to the next
constexpr double kNormalError = 0.004; // radians, from rounding: the corners are far enough from a straight line
constexpr std::size_t kPlanes = 20000; // looked at
constexpr std::size_t kFewestPlanes = 60;
constexpr std::size_t kScored = 1500; // planes by which a guess is judged
constexpr std::size_t kGuesses = 400;
constexpr double kLeastBetween = 0.02; // sine of the angle between two planes that give a guess
constexpr double kMostOff = 0.03;      // radians: half of the planes contain the axis within this
constexpr int kRefined = 12;
constexpr std::size_t kPairs = 2000;
constexpr double kClearOfAxis = 10.0; // misfits: nearer to the axis a point does not show its line

/// normal . p = distance
struct Plane {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double distance = 0.0;
};

/// The same sequence on every machine.
class Picks {
public:
    explicit Picks(std::size_t count) : count_(count) {}
    std::size_t next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<std::size_t>(state_ >> 33U) % count_;
    }

private:
    std::size_t count_;
    std::uint64_t state_ = 29;
};

std::optional<Plane> planeThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double rounding) {
    const Eigen::Vector3d ab = b - a, ac = c - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    const double area = normal.norm();
    const double side = std::max({ab.norm(), ac.norm(), (c - b).norm()});
    if (!(area > 0) || 2 * rounding * side > kNormalError * area) return std::nullopt;
    const Eigen::Vector3d unit = normal / area;
    return Plane{unit, unit.dot(b)};
}

/// Through each of some points and two that follow it, as near as rounding allows.
std::vector<Plane> planesAmong(std::span<const Eigen::Vector3d> points, double rounding) {
    std::vector<Plane> planes;
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kPlanes);
    for (std::size_t m = 0; m < points.size(); m += stride) {
        for (const std::size_t span : kSpans) {
            if (m + 2 * span >= points.size()) break;
            const auto plane = planeThrough(points[m], points[m + span], points[m + 2 * span], rounding);
            if (!plane) continue;
            planes.push_back(*plane);
            break;
        }
    }
    return planes;
}

/// The guess of which half of the planes are nearest. `guess(a, b)` from two planes, `off(guess, plane)` its distance.
template <class Guess, class Off>
std::optional<std::pair<Guess, double>> bestOf(const std::vector<Plane>& planes,
                                               const std::function<std::optional<Guess>(const Plane&, const Plane&)>& guessOf, Off off) {
    Picks picks(planes.size());
    const std::size_t stride = std::max<std::size_t>(1, planes.size() / kScored);
    std::optional<std::pair<Guess, double>> best;
    std::vector<double> far;
    for (std::size_t n = 0; n < kGuesses; ++n) {
        const Plane& a = planes[picks.next()];
        const auto guess = guessOf(a, planes[picks.next()]);
        if (!guess) continue;
        far.clear();
        for (std::size_t k = 0; k < planes.size(); k += stride) far.push_back(off(*guess, planes[k]));
        const double middle = valueInOrder(far, far.size() / 2);
        if (!best || middle < best->second) best = {*guess, middle};
    }
    return best;
}

double pull(double off, double scale) { return 1 / (1 + off * off / (scale * scale)); }

/// The direction that the planes contain, and by how much half of them do not.
std::optional<std::pair<Eigen::Vector3d, double>> directionOf(const std::vector<Plane>& planes) {
    using Direction = Eigen::Vector3d;
    const auto off = [](const Direction& along, const Plane& plane) { return std::abs(along.dot(plane.normal)); };
    const auto both = [](const Plane& a, const Plane& b) -> std::optional<Direction> {
        const Direction along = a.normal.cross(b.normal);
        if (along.norm() < kLeastBetween) return std::nullopt;
        return along.normalized();
    };
    auto best = bestOf<Direction>(planes, both, off);
    if (!best || best->second > kMostOff) return std::nullopt;
    for (int round = 0; round < kRefined; ++round) {
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        std::vector<double> far;
        for (const Plane& plane : planes) {
            far.push_back(off(best->first, plane));
            spread += pull(far.back(), best->second + 1e-9) * plane.normal * plane.normal.transpose();
        }
        best->first = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
        best->second = valueInOrder(far, far.size() / 2);
    }
    return best;
}

/// Where planes that contain the third axis meet.
std::optional<std::pair<Eigen::Vector2d, double>> meetingOf(const std::vector<Plane>& planes) {
    using Place = Eigen::Vector2d;
    const auto off = [](const Place& at, const Plane& plane) { return std::abs(plane.normal.head<2>().dot(at) - plane.distance); };
    const auto both = [](const Plane& a, const Plane& b) -> std::optional<Place> {
        Eigen::Matrix2d rows;
        rows << a.normal.head<2>().transpose(), b.normal.head<2>().transpose();
        if (std::abs(rows.determinant()) < kLeastBetween) return std::nullopt;
        return rows.inverse() * Place(a.distance, b.distance);
    };
    auto best = bestOf<Place>(planes, both, off);
    for (int round = 0; best && round < kRefined; ++round) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Place right = Place::Zero();
        std::vector<double> far;
        for (const Plane& plane : planes) {
            far.push_back(off(best->first, plane));
            const double weight = pull(far.back(), best->second + 1e-9);
            normal += weight * plane.normal.head<2>() * plane.normal.head<2>().transpose();
            right += weight * plane.distance * plane.normal.head<2>();
        }
        best->first = normal.ldlt().solve(right);
        best->second = valueInOrder(far, far.size() / 2);
    }
    if (best && !best->first.allFinite()) return std::nullopt;
    return best;
}

/// Two neighbours of one line, in the half plane of the first one: along the axis and away from it.
struct Pair {
    double x1, y1, x2, y2;
    /// Tangent of the angle between them as seen from a place on the axis.
    [[nodiscard]] double tangent(double place) const {
        const double a = x1 - place, b = x2 - place;
        return std::abs((y1 * b - y2 * a) / (a * b + y1 * y2));
    }
};

std::vector<Pair> pairsOf(const AxisFrame& frame, std::span<const Eigen::Vector3d> points) {
    std::vector<Pair> pairs;
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kPairs);
    for (std::size_t m = 0; m + 1 < points.size(); m += stride) {
        const Eigen::Vector3d a = frame(points[m]), b = frame(points[m + 1]);
        const double far = a.head<2>().norm();
        if (std::min(far, b.head<2>().norm()) < kClearOfAxis * frame.misfit) continue;
        const Eigen::Vector2d away = a.head<2>() / far;
        const double across = away.x() * b.y() - away.y() * b.x();
        if (std::abs(across) > 0.05 * b.head<2>().norm()) continue; // of another line
        pairs.push_back({a.z(), far, b.z(), away.dot(b.head<2>())});
    }
    return pairs;
}

/// How many pairs have the step that most have, within `width` of it.
std::size_t agreeing(const std::vector<Pair>& pairs, double place, double width, std::vector<double>& logs) {
    logs.clear();
    for (const Pair& pair : pairs) {
        const double tangent = pair.tangent(place);
        if (tangent > 1e-7 && tangent < 0.5) logs.push_back(std::log(tangent));
    }
    std::sort(logs.begin(), logs.end());
    std::size_t most = 0;
    for (std::size_t from = 0, to = 0; to < logs.size(); ++to) {
        while (logs[to] - logs[from] > width) ++from;
        most = std::max(most, to - from + 1);
    }
    return most;
}

} // namespace

std::optional<AxisFrame> guessAxis(std::span<const Eigen::Vector3d> returns, double rounding) {
    std::vector<Plane> planes = planesAmong(returns, rounding);
    if (planes.size() < kFewestPlanes) return std::nullopt;
    const auto along = directionOf(planes);
    if (!along) return std::nullopt;
    AxisFrame frame;
    const Eigen::Vector3d across = along->first.unitOrthogonal();
    frame.turn << across.transpose(), along->first.cross(across).transpose(), along->first.transpose();
    for (Plane& plane : planes) {
        const Eigen::Vector3d normal = frame.turn * plane.normal;
        const double level = normal.head<2>().norm();
        plane = {normal / std::max(level, 0.1), plane.distance / std::max(level, 0.1)};
    }
    const auto meeting = meetingOf(planes);
    if (!meeting) return std::nullopt;
    frame.centre = frame.turn.transpose() * Eigen::Vector3d(meeting->first.x(), meeting->first.y(), 0.0);
    frame.misfit = std::max(meeting->second, rounding);
    return frame;
}

void guessPlaceOnAxis(AxisFrame& frame, std::span<const Eigen::Vector3d> returns) {
    const std::vector<Pair> pairs = pairsOf(frame, returns);
    if (pairs.empty()) return;
    std::vector<double> places;
    for (const Pair& pair : pairs) places.push_back(pair.x1);
    const auto [least, most] = std::minmax_element(places.begin(), places.end());
    const double span = *most - *least;
    double from = *least - span, to = *most + span, best = 0.0;
    std::vector<double> logs;
    constexpr int kTried = 300;
    for (double width = 0.05; width > 1e-3; width *= 0.3) {
        const double step = (to - from) / kTried;
        std::size_t count = 0;
        for (int n = 0; n <= kTried; ++n) {
            const double place = from + n * step;
            const std::size_t now = agreeing(pairs, place, width, logs);
            if (now <= count) continue;
            count = now;
            best = place;
        }
        from = best - 6 * step;
        to = best + 6 * step;
    }
    frame.centre += frame.turn.transpose() * Eigen::Vector3d(0, 0, best);
}

} // namespace edgescan::files::turning
