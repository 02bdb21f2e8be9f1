// A list that holds every cell in order: the row length is the divisor at which rows are planes and columns are cones.
#include "core/files/grid_recovery/parts.h"

#include <algorithm>
#include <complex>
#include <numeric>

namespace edgescan::files::recognition {
namespace {

constexpr double kRoughlyPlane = 0.02; // radians: rows of the right length are far flatter, others are not
constexpr std::size_t kSampleLines = 16;
// Steps, of the median point from its beam. Two beams taken for one lie a quarter of their step off, all of them, and coarse numbers let
// that pass; points of one beam lie closer.
constexpr double kMostResidual = 0.2;

/// Sums up to each point: any run of points is judged in constant time.
struct RunningSums {
    std::vector<std::complex<double>> doubledPlane; ///< radius^2 exp(2 i plane)
    std::vector<double> squaredRadius;
    std::vector<double> cosTilt, squaredCosTilt, returns;

    explicit RunningSums(std::span<const AxisPoint> points) {
        const std::size_t size = points.size() + 1;
        doubledPlane.resize(size);
        for (auto* sums : {&squaredRadius, &cosTilt, &squaredCosTilt, &returns}) sums->resize(size);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const AxisPoint& p = points[k];
            const bool missing = p.missing();
            const double c = missing ? 0.0 : p.u / p.range();
            doubledPlane[k + 1] = doubledPlane[k] + std::complex(p.v * p.v - p.w * p.w, 2 * p.v * p.w);
            squaredRadius[k + 1] = squaredRadius[k] + p.squaredRadius();
            cosTilt[k + 1] = cosTilt[k] + c;
            squaredCosTilt[k + 1] = squaredCosTilt[k] + c * c;
            returns[k + 1] = returns[k] + (missing ? 0.0 : 1.0);
        }
    }
    /// Root mean square angle from the best plane through the axis; empty when no point gives one.
    [[nodiscard]] std::optional<double> flatness(std::size_t from, std::size_t to) const {
        const double weight = squaredRadius[to] - squaredRadius[from];
        if (returns[to] - returns[from] < 2 || weight <= 0) return std::nullopt;
        return std::sqrt(std::max(0.0, 1 - std::abs(doubledPlane[to] - doubledPlane[from]) / weight) / 2);
    }
    /// Standard deviation of cos(tilt).
    [[nodiscard]] std::optional<double> coneness(std::size_t from, std::size_t to) const {
        const double count = returns[to] - returns[from];
        if (count < 2) return std::nullopt;
        const double mean = (cosTilt[to] - cosTilt[from]) / count;
        return std::sqrt(std::max(0.0, (squaredCosTilt[to] - squaredCosTilt[from]) / count - mean * mean));
    }
};

template <class Measure>
bool mostRunsAreBelow(std::size_t points, std::size_t length, double limit, Measure measure) {
    std::size_t judged = 0;
    std::size_t below = 0;
    for (std::size_t from = 0; from + length <= points; from += length) {
        const std::optional<double> value = measure(from, from + length);
        if (!value) continue;
        ++judged;
        if (*value < limit) ++below;
        if (judged == 64 && below < 32) return false;
    }
    return judged > 0 && below * 10 >= judged * 9;
}

/// Plane angle of one line modulo 180 degrees; empty when no point gives it.
std::optional<double> planeOf(std::span<const AxisPoint> line, double eps) {
    std::complex<double> sum;
    double weight = 0;
    for (const AxisPoint& p : line) {
        sum += std::complex(p.v * p.v - p.w * p.w, 2 * p.v * p.w);
        weight += p.squaredRadius();
    }
    if (!(weight > 0) || eps / std::sqrt(weight) > 0.1) return std::nullopt;
    return 0.5 * std::arg(sum);
}

/// Angles that are not known lie on the straight line between their neighbours.
void fillGaps(std::vector<double>& angles, const std::vector<bool>& known) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i]) at.push_back(i);
    }
    if (at.size() < 2) return;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i]) continue;
        auto right = std::lower_bound(at.begin(), at.end(), i);
        if (right == at.end()) --right;
        if (right == at.begin()) ++right;
        const std::size_t a = *(right - 1);
        const std::size_t b = *right;
        angles[i] = angles[a] + (angles[b] - angles[a]) * (static_cast<double>(i) - static_cast<double>(a)) / static_cast<double>(b - a);
    }
}

bool strictlyMonotone(const std::vector<double>& angles) {
    if (angles.size() < 2) return false;
    const bool rises = angles[1] > angles[0];
    for (std::size_t j = 1; j < angles.size(); ++j) {
        if (angles[j] == angles[j - 1] || (angles[j] > angles[j - 1]) != rises) return false;
    }
    return std::abs(angles.back() - angles.front()) < 2.02 * kPi;
}

/// Planes and tilts of the lines in `chosen`, each `beams` points long; empty when the beams are not monotone.
class LineFitter {
public:
    LineFitter(std::span<const AxisPoint> points, std::size_t beams, double eps) : points_(points), beams_(beams), eps_(eps) {}

    std::optional<Fit> fit(const std::vector<std::size_t>& chosen) {
        std::vector<std::complex<double>> beamSums(beams_);
        Fit fit;
        std::vector<bool> lineKnown;
        double previous = 0;
        bool first = true;
        for (const std::size_t i : chosen) {
            const auto line = points_.subspan(i * beams_, beams_);
            const auto measured = planeOf(line, eps_);
            lineKnown.push_back(measured.has_value());
            fit.plane.push_back(previous);
            if (!measured) continue;
            double plane = first ? *measured : previous + std::remainder(*measured - previous, kPi);
            if (!first && turnedAgrees(line, plane, beamSums)) plane += plane > previous ? -kPi : kPi;
            addLine(line, plane, beamSums);
            fit.plane.back() = previous = plane;
            first = false;
        }
        fillGaps(fit.plane, lineKnown);
        if (!beamsFrom(beamSums, fit.tilt)) return std::nullopt;
        return fit;
    }

private:
    void addLine(std::span<const AxisPoint> line, double plane, std::vector<std::complex<double>>& sums) const {
        const double c = std::cos(plane);
        const double s = std::sin(plane);
        for (std::size_t j = 0; j < beams_; ++j) sums[j] += std::complex(line[j].u, line[j].radiusIn(c, s));
    }
    /// True when the line fits the beams found so far better with its plane turned by 180 degrees, which negates its tilts.
    [[nodiscard]] bool turnedAgrees(std::span<const AxisPoint> line, double plane, const std::vector<std::complex<double>>& sums) const {
        const double c = std::cos(plane);
        const double s = std::sin(plane);
        double agreement = 0;
        for (std::size_t j = 0; j < beams_; ++j) {
            const double size = std::abs(sums[j]) * line[j].range();
            if (size > 0) agreement += sums[j].imag() * line[j].radiusIn(c, s) / size;
        }
        return agreement < 0;
    }
    static bool beamsFrom(const std::vector<std::complex<double>>& sums, std::vector<double>& tilt) {
        std::vector<bool> known;
        double previous = 0;
        bool first = true;
        for (const auto& sum : sums) {
            known.push_back(std::abs(sum) > 0);
            tilt.push_back(previous);
            if (!known.back()) continue;
            const double angle = std::arg(sum);
            tilt.back() = previous = first ? angle : previous + std::remainder(angle - previous, 2 * kPi);
            first = false;
        }
        fillGaps(tilt, known);
        return strictlyMonotone(tilt);
    }

    std::span<const AxisPoint> points_;
    std::size_t beams_;
    double eps_;
};

Grid<std::uint32_t> inOrder(const std::vector<std::size_t>& lines, std::size_t beams) {
    Grid<std::uint32_t> pointOf(static_cast<int>(lines.size()), static_cast<int>(beams));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t j = 0; j < beams; ++j) pointOf[i * beams + j] = static_cast<std::uint32_t>(lines[i] * beams + j);
    }
    return pointOf;
}

/// The list read as lines of `beams` points. A few lines first: nearly every wrong length fails there.
/// `known`: the file says how long a line is; else the points must be precise enough to show it.
std::optional<Fit> fitLines(std::span<const AxisPoint> points, const Precision& precision, std::size_t beams, double eps, bool known) {
    const std::size_t lines = points.size() / beams;
    LineFitter fitter(points, beams, eps);
    const auto attempt = [&](const std::vector<std::size_t>& chosen) -> std::optional<Fit> {
        auto fit = fitter.fit(chosen);
        if (!fit) return std::nullopt;
        fit->pointOf = inOrder(chosen, beams);
        const OnGrid judged = judge(*fit, points, precision);
        const bool isOneBeamEach = judged.telling && judged.residual < kMostResidual;
        if (judged.share < kShareOnGrid || !(isOneBeamEach || known)) return std::nullopt;
        fit->residual = judged.residual;
        fit->complete = true;
        return fit;
    };
    std::vector<std::size_t> all(lines);
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (lines > 4 * kSampleLines) {
        std::vector<std::size_t> sample;
        const std::size_t from = lines / 2 - kSampleLines / 2; // neighbours, so that the step between lines is the true one
        for (std::size_t i = 0; i < kSampleLines; ++i) sample.push_back(from + i);
        auto fit = fitter.fit(sample);
        if (fit) {
            fit->pointOf = inOrder(sample, beams);
            if (judge(*fit, points, precision).share < 0.9) return std::nullopt;
        }
    }
    return attempt(all);
}

/// Lines `from` to `from + count` of a list that runs beam by beam.
std::vector<AxisPoint> linesOutOfBeams(std::span<const AxisPoint> points, std::size_t lines, std::size_t from, std::size_t count) {
    const std::size_t beams = points.size() / lines;
    std::vector<AxisPoint> turned(count * beams);
    for (std::size_t j = 0; j < beams; ++j) {
        for (std::size_t i = 0; i < count; ++i) turned[i * beams + j] = points[j * lines + from + i];
    }
    return turned;
}

std::optional<Fit> fitTransposed(std::span<const AxisPoint> points, const Precision& precision, std::size_t lines, double eps) {
    const std::size_t beams = points.size() / lines;
    if (lines > 4 * kSampleLines) {
        const auto sample = linesOutOfBeams(points, lines, lines / 2 - kSampleLines / 2, kSampleLines);
        std::vector<std::size_t> all(kSampleLines);
        std::iota(all.begin(), all.end(), std::size_t{0});
        auto fit = LineFitter(sample, beams, eps).fit(all);
        if (!fit) return std::nullopt;
        fit->pointOf = inOrder(all, beams);
        if (judge(*fit, sample, precision).share < 0.9) return std::nullopt;
    }
    const auto turned = linesOutOfBeams(points, lines, 0, lines);
    auto fit = fitLines(turned, precision, beams, eps, false);
    if (!fit) return std::nullopt;
    for (std::size_t i = 0; i < lines; ++i) {
        for (std::size_t j = 0; j < beams; ++j) fit->pointOf[i * beams + j] = static_cast<std::uint32_t>(j * lines + i);
    }
    return fit;
}

std::vector<std::size_t> rowLengths(std::size_t points, std::size_t given) {
    std::vector<std::size_t> lengths;
    if (given > 0) return points % given == 0 && given > 1 ? std::vector<std::size_t>{given} : lengths;
    for (std::size_t d = 1; d * d <= points; ++d) {
        if (points % d != 0) continue;
        lengths.push_back(d);
        if (d * d != points) lengths.push_back(points / d);
    }
    std::erase_if(lengths, [](std::size_t length) { return length < 3; });
    std::sort(lengths.rbegin(), lengths.rend());
    return lengths;
}

double typicalError(std::span<const AxisPoint> points, const Precision& precision) {
    double longest = 0;
    for (const AxisPoint& p : points) longest = std::max(longest, p.range());
    return precision.absolute + precision.relative * longest;
}

} // namespace

std::optional<Fit> fitFileOrder(std::span<const AxisPoint> points, const Precision& precision, std::size_t rowLength) {
    const RunningSums sums(points);
    const double eps = typicalError(points, precision);
    for (const std::size_t length : rowLengths(points.size(), rowLength)) {
        const auto flat = [&](std::size_t from, std::size_t to) { return sums.flatness(from, to); };
        if (mostRunsAreBelow(points.size(), length, kRoughlyPlane, flat)) {
            if (auto fit = fitLines(points, precision, length, eps, rowLength > 0)) return fit;
        }
        const auto cone = [&](std::size_t from, std::size_t to) { return sums.coneness(from, to); };
        if (length < points.size() / 2 && mostRunsAreBelow(points.size(), length, kRoughlyPlane, cone)) {
            if (auto fit = fitTransposed(points, precision, length, eps)) return fit;
        }
    }
    return std::nullopt;
}

} // namespace edgescan::files::recognition
