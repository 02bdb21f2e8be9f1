// Ranges by their largest value, points by counting equal ones.
#include "core/files/point_tables/repeated_values.h"

#include "core/files/grid_recovery/recover_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace edgescan::files {
namespace {

constexpr std::size_t kFewestRanges = 5, kFewestStated = 3, kFewestOthers = 12; ///< and as few points as stated ranges, far outside
constexpr double kFarApart = 2.0;                                               // times the largest of the others
constexpr double kNearStated = 0.9;                                             // of the limit: others from there on are compared with it
constexpr double kOftenerThanNear = 3;                                          // times
constexpr const char* kRepeated = ", which repeats exactly and is far apart from the rest, as nothing measured is: taken as no return";
constexpr double kPlainly = 4; // times the step of the numbers: so much the ranges of a surface would differ

/// The largest range, how many have it, and the largest below it.
struct Largest {
    double range = 0, least = 0, next = 0;
    std::size_t count = 0, others = 0;
};
Largest largestOf(const RangesToJudge& given) {
    Largest found;
    for (const double range : given.ranges) {
        if (std::isfinite(range)) found.range = std::max(found.range, range);
    }
    found.least = found.range - 2 * (given.absolute + given.relative * found.range);
    for (const double range : given.ranges) {
        if (!(range > 0) || !std::isfinite(range)) continue;
        const bool has = range >= found.least;
        ++(has ? found.count : found.others);
        if (!has) found.next = std::max(found.next, range);
    }
    return found;
}

/// How finely the other ranges are written: the smallest difference between two of them. Empty: they are too few, or too few differ.
std::optional<double> stepOfOthers(const RangesToJudge& given, double least) {
    constexpr std::size_t kSample = 4096;
    std::vector<double> sample;
    const std::size_t stride = std::max<std::size_t>(1, given.ranges.size() / kSample);
    for (std::size_t n = 0; n < given.ranges.size(); n += stride) {
        if (given.ranges[n] > 0 && given.ranges[n] < least) sample.push_back(given.ranges[n]);
    }
    std::ranges::sort(sample);
    const auto end = std::unique(sample.begin(), sample.end());
    const auto distinct = static_cast<std::size_t>(end - sample.begin());
    if (distinct < kFewestOthers) return std::nullopt;
    double step = sample[1] - sample[0];
    for (std::size_t n = 2; n < distinct; ++n) step = std::min(step, sample[n] - sample[n - 1]);
    return step;
}

/// Radians from the first of the largest ranges to the one farthest from it in direction.
double spreadOf(const RangesToJudge& given, double least, std::size_t count) {
    constexpr std::size_t kLooked = 4096;
    std::optional<Eigen::Vector3d> first;
    double cosine = 1;
    std::size_t passed = 0;
    const std::size_t stride = std::max<std::size_t>(1, count / kLooked);
    for (std::size_t n = 0; n < given.ranges.size(); ++n) {
        if (!(given.ranges[n] >= least) || !std::isfinite(given.ranges[n]) || passed++ % stride != 0) continue;
        const Eigen::Vector3d direction = given.direction(n);
        if (!first) first = direction;
        cosine = std::min(cosine, first->dot(direction));
    }
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// How often the most frequent range near below the limit is there.
std::size_t mostFrequentNear(const RangesToJudge& given, double least) {
    std::vector<double> near;
    for (const double range : given.ranges) {
        if (range < least && range >= kNearStated * least) near.push_back(range);
    }
    std::ranges::sort(near);
    std::size_t most = 0, run = 0;
    for (std::size_t n = 0; n < near.size(); ++n) {
        run = n > 0 && near[n] == near[n - 1] ? run + 1 : 1;
        most = std::max(most, run);
    }
    return most;
}

std::uint64_t hashOf(const Eigen::Vector3d& p) {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) { // 0 and -0 are one number
        hash = (hash ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0)) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

/// Equal points and how many they are, most first: all that repeat more often than `uncounted` times.
struct EqualPoints {
    std::vector<RepeatedPoint> groups;
    std::size_t uncounted = 1;
};
EqualPoints equalPoints(std::span<const Eigen::Vector3d> points, const std::vector<RepeatedPoint>& without) {
    constexpr std::size_t kMostBuckets = std::size_t{1} << 20U;
    const auto counts = [&](const Eigen::Vector3d& p) {
        return isReturn(p) && std::ranges::none_of(without, [&](const RepeatedPoint& one) { return one.point == p; });
    };
    std::vector<std::uint32_t> buckets(std::bit_ceil(std::min(points.size() + 1, kMostBuckets)));
    const std::uint64_t mask = buckets.size() - 1;
    std::uint32_t most = 0;
    for (const Eigen::Vector3d& p : points) {
        if (counts(p)) most = std::max(most, ++buckets[hashOf(p) & mask]);
    }
    EqualPoints found;
    if (most < kFewestStated) return found;
    const std::uint32_t least = std::max<std::uint32_t>(2, most / 16);
    found.uncounted = least - 1;
    std::vector<std::size_t> full; // points in buckets that are as full
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (counts(points[n]) && buckets[hashOf(points[n]) & mask] >= least) full.push_back(n);
    }
    const auto before = [&](std::size_t a, std::size_t b) {
        const Eigen::Vector3d &p = points[a], &q = points[b];
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    std::ranges::sort(full, before);
    for (const std::size_t n : full) {
        if (found.groups.empty() || found.groups.back().point != points[n]) found.groups.push_back({points[n], 0});
        ++found.groups.back().count;
    }
    std::ranges::stable_sort(found.groups, std::ranges::greater{}, &RepeatedPoint::count);
    return found;
}

/// A point so far outside of all points but `groups` that it is in no scan.
class FarOutside {
public:
    FarOutside(std::span<const Eigen::Vector3d> points, std::span<const RepeatedPoint> groups) {
        const auto isOther = [&](const Eigen::Vector3d& p) {
            return isReturn(p) && std::ranges::none_of(groups, [&](const RepeatedPoint& one) { return one.point == p; });
        };
        for (const Eigen::Vector3d& p : points) {
            if (!isOther(p)) continue;
            middle_ += p;
            ++others_;
        }
        if (others_ == 0) return;
        middle_ /= static_cast<double>(others_);
        for (const Eigen::Vector3d& p : points) {
            if (isOther(p)) size_ = std::max(size_, (p - middle_).norm());
        }
    }
    [[nodiscard]] std::size_t others() const { return others_; }
    [[nodiscard]] bool operator()(const Eigen::Vector3d& p) const {
        constexpr double kTimesTheirSize = 20;
        return (p - middle_).norm() > kTimesTheirSize * size_;
    }

private:
    Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
    double size_ = 0;
    std::size_t others_ = 0;
};

/// No other point is near a point, as seen from the origin. Each line of a scan measures the same point on the axis that it turns about:
/// this one has neighbours of its surface.
bool isAlone(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& one) {
    constexpr double kNear = 0.1; // of its distance
    const double near = kNear * one.norm();
    return std::ranges::none_of(points, [&](const Eigen::Vector3d& p) { return isReturn(p) && p != one && (p - one).norm() < near; });
}

} // namespace

std::optional<RepeatedRange> repeatedRange(const RangesToJudge& given) {
    const Largest largest = largestOf(given);
    const bool isStated = given.stated && *given.stated >= largest.least && *given.stated <= 2 * largest.range - largest.least;
    if (largest.count < kFewestStated || (largest.others < kFewestOthers && !(isStated && largest.others == 0))) return std::nullopt;
    const RepeatedRange found{largest.least, largest.count};
    const bool outnumbers =
        isStated && static_cast<double>(largest.count) >= kOftenerThanNear * static_cast<double>(mostFrequentNear(given, largest.least));
    if (outnumbers) return found;
    if (largest.count < kFewestRanges || largest.range < kFarApart * largest.next) return std::nullopt;
    const auto step = stepOfOthers(given, largest.least);
    if (!step || !given.direction) return std::nullopt;
    const double differ = largest.range * (1 - std::cos(spreadOf(given, largest.least, largest.count) / 2));
    return differ > kPlainly * (*step + largest.range - largest.least) ? std::optional(found) : std::nullopt;
}

std::vector<RepeatedPoint> repeatedPoints(std::span<const Eigen::Vector3d> points) {
    constexpr std::size_t kAtOnce = 3, kRounds = 3, kFewestSame = 8, kOftener = 8;
    std::vector<RepeatedPoint> found;
    for (std::size_t round = 0; round < kRounds; ++round) {
        const EqualPoints equal = equalPoints(points, found);
        if (equal.groups.empty() || equal.groups.front().count < kFewestStated) break;
        const auto candidates = std::span(equal.groups).first(std::min(kAtOnce, equal.groups.size()));
        const std::size_t natural = std::max(equal.groups.size() > kAtOnce ? equal.groups[kAtOnce].count : 1, equal.uncounted);
        const FarOutside isFar(points, candidates);
        if (isFar.others() < kFewestOthers) break;
        const std::size_t before = found.size();
        for (const RepeatedPoint& one : candidates) {
            const bool often = one.count >= kFewestSame && one.count >= kOftener * natural;
            const bool far = one.count >= kFewestStated && isFar(one.point);
            if (far || (often && isAlone(points, one.point))) found.push_back(one);
        }
        if (found.size() == before) break;
    }
    return found;
}

std::string repeatedSentence(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + kRepeated + " (--keep-repeated takes it as measured).";
}

bool isRepeatedWarning(const std::string& warning) { return warning.find(kRepeated) != std::string::npos; }

} // namespace edgescan::files
