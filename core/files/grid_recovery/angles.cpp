// Measures the angles of lines and beams, judges a fit, and makes angles tidy.
#include "core/files/grid_recovery/parts.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <array>
#include <limits>

namespace edgescan::files::recognition {
namespace {

struct Steps {
    double beam = 0.0, line = 0.0;
};
Steps stepsOf(const Fit& fit) {
    Steps steps{medianStep(fit.tilt), medianStep(fit.plane)};
    if (!(steps.line > 1e-9)) steps.line = steps.beam; // one line, or a stepper at rest
    return steps;
}

/// A point against its cell: angles along the beams and across the line, radians, and the error it was written with.
struct Offset {
    double along = 0.0, across = 0.0, error = 0.0, range = 0.0, radius = 0.0, off = 0.0;
};
class Offsets {
public:
    Offsets(const Fit& fit, std::span<const AxisPoint> points, const Precision& precision)
        : fit_(&fit), points_(points), precision_(precision) {
        for (const double plane : fit.plane) {
            cos_.push_back(std::cos(plane));
            sin_.push_back(std::sin(plane));
        }
    }
    [[nodiscard]] std::optional<Offset> at(std::size_t line, std::size_t beam) const {
        const std::uint32_t point = fit_->pointOf[line * fit_->tilt.size() + beam];
        if (point == kNone || points_[point].missing()) return std::nullopt;
        const AxisPoint& p = points_[point];
        Offset o;
        o.range = p.range();
        o.radius = p.radiusIn(cos_[line], sin_[line]);
        o.off = p.offPlane(cos_[line], sin_[line]);
        const double along = std::atan2(o.radius, p.u) - fit_->tilt[beam];
        o.along = std::abs(along) < kPi ? along : std::remainder(along, 2 * kPi); // the same number: remainder() is slow
        o.across = o.off / o.range;
        o.error = (precision_.absolute + precision_.relative * o.range) / o.range;
        return o;
    }
    [[nodiscard]] static bool within(const Offset& o, const Steps& steps) {
        return std::abs(o.along) <= 0.25 * steps.beam + 3 * o.error && std::abs(o.across) <= 0.25 * steps.line + 3 * o.error;
    }

private:
    const Fit* fit_;
    std::span<const AxisPoint> points_;
    Precision precision_;
    std::vector<double> cos_, sin_;
};

/// Weighted mean. Its standard error is that of the scatter, but at least half of what rounding explains.
struct Mean {
    double weight = 0, sum = 0, weightedSquares = 0, weightedSquaredErrors = 0, cross = 0, squaredWeight = 0;
    void add(double value, double itsWeight, double error) {
        const double w2 = itsWeight * itsWeight;
        weight += itsWeight;
        sum += itsWeight * value;
        weightedSquares += w2 * value * value;
        cross += w2 * value;
        squaredWeight += w2;
        weightedSquaredErrors += w2 * error * error;
    }
    [[nodiscard]] double value() const { return weight > 0 ? sum / weight : 0.0; }
    [[nodiscard]] double error() const {
        if (!(weight > 0)) return std::numeric_limits<double>::infinity();
        const double m = value();
        const double scatter = std::max(0.0, weightedSquares - 2 * m * cross + m * m * squaredWeight);
        return std::max({std::sqrt(scatter), 0.5 * std::sqrt(weightedSquaredErrors), 1e-14 * weight}) / weight;
    }
};

struct Tidy {
    double value = 0.0;
    int digits = 12;
};
/// The number with the fewest digits within `reach` of `value`; for steps also a fraction such as 1/6.
Tidy simplest(double value, double reach, bool fractions) {
    reach = std::max(reach, 1e-10);
    for (int decimals = 0; decimals <= 10; ++decimals) {
        const double scale = std::pow(10.0, decimals);
        const double candidate = std::round(value * scale) / scale;
        if (std::abs(candidate - value) <= reach && !(fractions && candidate == 0.0)) return {candidate, decimals};
        if (decimals < 2 || !fractions) continue;
        for (const double parts : {3.0, 6.0, 7.0, 9.0, 12.0, 14.0, 15.0, 18.0, 24.0}) {
            const double fraction = std::round(value * parts) / parts;
            if (decimals == 2 && fraction != 0.0 && std::abs(fraction - value) <= reach) return {fraction, 2};
        }
    }
    return {value, 12};
}

/// start + i * step through the measured angles.
struct Line {
    double start = 0.0, step = 0.0;
    double startError = 0.0, stepError = 0.0, endError = 0.0;
    int digits = 24;
};

std::optional<Line> leastSquares(const std::vector<double>& degrees, const std::vector<double>& errors) {
    double w = 0, wi = 0, wii = 0, wy = 0, wiy = 0;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (!std::isfinite(errors[i])) continue;
        const double weight = 1 / std::pow(std::max(errors[i], 1e-12), 2);
        const auto x = static_cast<double>(i);
        w += weight;
        wi += weight * x;
        wii += weight * x * x;
        wy += weight * degrees[i];
        wiy += weight * x * degrees[i];
    }
    const double determinant = w * wii - wi * wi;
    if (!(determinant > 0)) return std::nullopt;
    Line line;
    line.step = (w * wiy - wi * wy) / determinant;
    line.start = (wy - line.step * wi) / w;
    line.stepError = std::sqrt(w / determinant);
    line.startError = std::sqrt(wii / determinant);
    const auto last = static_cast<double>(degrees.size() - 1);
    line.endError = std::sqrt(std::max(0.0, (wii - 2 * last * wi + last * last * w) / determinant));
    return line;
}

bool agrees(const Line& line, const std::vector<double>& degrees, const std::vector<double>& errors) {
    std::size_t known = 0;
    std::size_t good = 0;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (!std::isfinite(errors[i])) continue;
        ++known;
        if (std::abs(degrees[i] - line.start - static_cast<double>(i) * line.step) <= 5 * errors[i] + 1e-9) ++good;
    }
    return good * 100 >= known * 99;
}

/// Step and start with few digits; the start is fitted again once the step is fixed.
Line tidyByStep(const Line& fitted, std::size_t count) {
    const Tidy step = simplest(fitted.step, 3 * fitted.stepError, true);
    const double middle = static_cast<double>(count - 1) / 2;
    const double centre = fitted.start + middle * fitted.step;
    const double centreError = std::hypot(fitted.startError, fitted.endError) / 2;
    const Tidy start = simplest(centre - middle * step.value, 3 * centreError, false);
    Line line = fitted;
    line.step = step.value;
    line.start = start.value;
    line.digits = step.digits + start.digits;
    return line;
}

Line tidyByEnds(const Line& fitted, std::size_t count) {
    const auto last = static_cast<double>(count - 1);
    const Tidy start = simplest(fitted.start, 3 * fitted.startError, false);
    const Tidy end = simplest(fitted.start + last * fitted.step, 3 * fitted.endError, false);
    Line line = fitted;
    line.start = start.value;
    line.step = (end.value - start.value) / last;
    line.digits = start.digits + end.digits;
    return line;
}

std::vector<double> roundedBelowError(const std::vector<double>& degrees, const std::vector<double>& errors) {
    std::vector<double> rounded;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const double error = std::isfinite(errors[i]) ? std::max(errors[i], 1e-12) : 1e-4;
        const double scale = std::pow(10.0, std::ceil(-std::log10(error)) + 1);
        rounded.push_back(std::round(degrees[i] * scale) / scale);
    }
    return rounded;
}

} // namespace

double medianStep(const std::vector<double>& angles) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < angles.size(); ++i) steps.push_back(std::abs(angles[i] - angles[i - 1]));
    return median(std::move(steps));
}

std::vector<std::size_t> placesOnSteps(const std::vector<double>& angles) {
    constexpr double kMostMissing = 0.3;
    if (angles.size() < 8) return {};
    const double rough = medianStep(angles) * (angles.back() > angles.front() ? 1 : -1);
    const double step = (angles.back() - angles.front()) / std::round((angles.back() - angles.front()) / rough);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double place = (angles[i] - angles[0]) / step;
        if (std::abs(place - std::round(place)) > 0.1 || (i > 0 && std::round(place) <= static_cast<double>(places.back()))) return {};
        places.push_back(static_cast<std::size_t>(std::lround(place)));
    }
    const std::size_t all = places.back() + 1;
    if (all == angles.size() || static_cast<double>(all) > static_cast<double>(angles.size()) * (1 + kMostMissing)) return {};
    return places;
}

OnGrid judge(const Fit& fit, std::span<const AxisPoint> points, const Precision& precision) {
    const Offsets offsets(fit, points, precision);
    const Steps steps = stepsOf(fit);
    std::vector<double> residuals;
    std::size_t inside = 0;
    std::size_t precise = 0;
    for (std::size_t i = 0; i < fit.plane.size(); ++i) {
        for (std::size_t j = 0; j < fit.tilt.size(); ++j) {
            const auto offset = offsets.at(i, j);
            if (!offset) continue;
            residuals.push_back(std::max(std::abs(offset->along) / steps.beam, std::abs(offset->across) / steps.line));
            inside += Offsets::within(*offset, steps) ? 1 : 0;
            precise += 3 * offset->error < 0.25 * std::min(steps.beam, steps.line) ? 1 : 0;
        }
    }
    if (residuals.empty()) return {};
    OnGrid result;
    result.share = static_cast<double>(inside) / static_cast<double>(residuals.size());
    result.telling = precise * 2 > residuals.size();
    result.residual = median(std::move(residuals));
    return result;
}

MeasuredAngles measureAngles(const Fit& fit, std::span<const AxisPoint> points, const Precision& precision) {
    const Offsets offsets(fit, points, precision);
    const Steps steps = stepsOf(fit);
    std::vector<Mean> planes(fit.plane.size());
    std::vector<Mean> tilts(fit.tilt.size());
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = 0; j < tilts.size(); ++j) {
            const auto o = offsets.at(i, j);
            if (!o || !Offsets::within(*o, steps)) continue;
            if (o->radius != 0.0) planes[i].add(o->off / o->radius, o->radius * o->radius, o->error * o->range / o->radius);
            tilts[j].add(o->along, o->range * o->range, o->error);
        }
    }
    MeasuredAngles angles;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        angles.plane.push_back(fit.plane[i] + planes[i].value());
        angles.planeError.push_back(planes[i].error());
    }
    for (std::size_t j = 0; j < tilts.size(); ++j) {
        angles.tilt.push_back(fit.tilt[j] + tilts[j].value());
        angles.tiltError.push_back(tilts[j].error());
    }
    return angles;
}

std::vector<double> tidyAngles(const std::vector<double>& degrees, const std::vector<double>& errors) {
    if (degrees.size() == 1) return {simplest(degrees[0], std::isfinite(errors[0]) ? 3 * errors[0] : 1e-4, false).value};
    const auto fitted = leastSquares(degrees, errors);
    if (!fitted || !agrees(*fitted, degrees, errors)) return roundedBelowError(degrees, errors);
    std::array<Line, 2> tidy{tidyByStep(*fitted, degrees.size()), tidyByEnds(*fitted, degrees.size())};
    if (tidy[1].digits < tidy[0].digits) std::swap(tidy[0], tidy[1]);
    for (const Line& line : tidy) {
        if (!agrees(line, degrees, errors)) continue;
        std::vector<double> regular;
        for (std::size_t i = 0; i < degrees.size(); ++i) regular.push_back(line.start + static_cast<double>(i) * line.step);
        return regular;
    }
    return roundedBelowError(degrees, errors);
}

} // namespace edgescan::files::recognition
