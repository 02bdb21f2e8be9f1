// Cuts a list in order into lines.
#include "core/files/grid_recovery/runs.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace edgescan::files::recognition {
namespace {

constexpr double kDrift = 2e-4;       // radians from beam to beam: the stepper moves on while the mirror turns
constexpr double kShareOfPairs = 0.5; // neighbours in the list that are neighbours on a line
constexpr std::size_t kSamplePairs = 50'000;
constexpr std::size_t kLookAhead = 8;
constexpr double kFewestPerRun = 3.0; // on average
constexpr double kSideUnknown = 1.0;  // error of the plane angle, radians
constexpr double kForget = 0.9;       // what a plane remembers from return to return

double off(double a, double b, double period) { return std::abs(std::remainder(a - b, period)); }

/// Step of the tilt between two returns of one line; its sign is that of the frame in which the first one is on the positive side.
double stepBetween(const ReturnAngles& a, const ReturnAngles& b) {
    const bool acrossAxis = off(a.plane, b.plane, 2 * kPi) > kPi / 2;
    return acrossAxis ? -(a.tilt + b.tilt) : b.tilt - a.tilt;
}

/// The part of the circle that the fan leaves empty. Tilts count from its end, so that the mirror's way back never looks like a way on.
struct FanGap {
    double end = -kPi; ///< radians
    double width = 0.0;

    [[nodiscard]] double from(double tilt) const {
        const double ahead = std::fmod(tilt - end, 2 * kPi);
        return ahead < 0 ? ahead + 2 * kPi : ahead;
    }
};

/// The usual step from beam to beam; empty when neighbours in the list are not neighbours on a line.
std::optional<double> beamStepOf(std::span<const ReturnAngles> returns) {
    const std::size_t stride = std::max<std::size_t>(1, returns.size() / kSamplePairs);
    std::vector<double> steps;
    std::size_t pairs = 0;
    for (std::size_t m = 0; m + 1 < returns.size(); m += stride) {
        const ReturnAngles& a = returns[m];
        const ReturnAngles& b = returns[m + 1];
        if (a.planeError + b.planeError > kSideUnknown) continue;
        ++pairs;
        const double step = std::abs(stepBetween(a, b));
        if (off(a.plane, b.plane, kPi) > a.planeError + b.planeError + kDrift) continue;
        if (step > a.tiltError + b.tiltError) steps.push_back(step);
    }
    if (pairs < 8 || static_cast<double>(steps.size()) < kShareOfPairs * static_cast<double>(pairs)) return std::nullopt;
    return median(std::move(steps));
}

class Cutter {
public:
    Cutter(std::span<const ReturnAngles> returns, double beamStep) : returns_(returns), beamStep_(beamStep) {}

    /// Looks where no tilts are. Lines need not be cut well for that.
    void findGap(const std::vector<Run>& runs) {
        constexpr std::size_t kBins = 720;
        std::vector<bool> filled(kBins, false);
        const auto binOf = [](double angle) { return static_cast<std::size_t>((angle + kPi) / (2 * kPi) * kBins) % kBins; };
        for (const Run& run : runs) {
            for (std::size_t m = run.from; m < run.to; ++m) {
                const ReturnAngles& s = returns_[m];
                if (s.planeError <= kSideUnknown) filled[binOf(tiltOn(run.plane, s, 0.0))] = true;
            }
        }
        std::size_t empty = 0;
        std::size_t most = 0;
        for (std::size_t n = 0; n < 2 * kBins; ++n) {
            empty = filled[n % kBins] ? 0 : empty + 1;
            if (empty <= most || empty > kBins) continue;
            most = empty;
            gap_.end = -kPi + static_cast<double>((n + 1) % kBins) * 2 * kPi / kBins;
        }
        // Half of it on either side: no rounding carries a tilt across.
        gap_.width = static_cast<double>(most) * 2 * kPi / kBins;
        gap_.end -= gap_.width / 2;
    }

    /// Where the tilts turn back. `bothWays`: lines are listed to and fro, else all in one direction, which makes their tilts ascend.
    [[nodiscard]] std::vector<Run> cut(bool bothWays) const {
        std::vector<Run> runs;
        for (std::size_t from = 0; from < returns_.size();) {
            double plane = planeFrom(from);
            if (!bothWays && descends(from, plane)) plane += kPi;
            if (bothWays && !runs.empty() && off(plane, runs.back().plane, 2 * kPi) > kPi / 2) plane += kPi;
            const std::size_t to = endOf(from, plane, bothWays);
            runs.push_back({from, to, plane, 0.0});
            from = to;
        }
        return runs;
    }
    /// Runs on which the plane changes at once are two lines: the second one has no returns where the first one ends.
    [[nodiscard]] std::vector<Run> cutWherePlanesChange(const std::vector<Run>& runs) const {
        std::vector<double> steps;
        for (std::size_t i = 1; i < runs.size(); ++i) {
            if (runs[i].planeError + runs[i - 1].planeError < kSideUnknown) steps.push_back(off(runs[i].plane, runs[i - 1].plane, kPi));
        }
        const double lineStep = median(std::move(steps));
        std::vector<Run> all;
        for (const Run& run : runs) {
            for (std::size_t from = run.from; from < run.to;) {
                const std::size_t to = lineStep > 0 ? planeChange(from, run.to, 0.4 * lineStep) : run.to;
                all.push_back({from, to, run.plane, run.planeError});
                if (to - from < run.to - run.from) measure(all.back());
                from = to;
            }
        }
        return all;
    }
    /// The plane through the axis that fits all returns of the run best.
    void measure(Run& run) const {
        std::complex<double> sum;
        double weights = 0;
        for (std::size_t m = run.from; m < run.to; ++m) {
            if (returns_[m].planeError > kSideUnknown) continue;
            const double weight = 1 / (returns_[m].planeError * returns_[m].planeError + 1e-30);
            sum += weight * std::polar(1.0, 2 * returns_[m].plane);
            weights += weight;
        }
        run.planeError = weights > 0 ? 1 / std::sqrt(weights) : kPi;
        if (weights > 0) run.plane += std::remainder(0.5 * std::arg(sum) - run.plane, kPi);
    }

private:
    /// The best known plane angle of the next few returns.
    [[nodiscard]] double planeFrom(std::size_t from) const {
        const auto first = returns_.begin() + static_cast<std::ptrdiff_t>(from);
        const auto last = first + static_cast<std::ptrdiff_t>(std::min(kLookAhead, returns_.size() - from));
        return std::min_element(first, last, [](const ReturnAngles& a, const ReturnAngles& b) { return a.planeError < b.planeError; })
            ->plane;
    }
    [[nodiscard]] bool descends(std::size_t from, double plane) const {
        int votes = 0;
        const std::size_t to = std::min(from + kLookAhead, returns_.size());
        double before = tiltOn(plane, returns_[from], returns_[from].tilt);
        for (std::size_t m = from + 1; m < to; ++m) {
            const double here = tiltOn(plane, returns_[m], before);
            const double step = std::remainder(here - before, 2 * kPi);
            if (std::abs(step) > returns_[m].tiltError + returns_[m - 1].tiltError && std::abs(step) < 4 * beamStep_)
                votes += step > 0 ? 1 : -1;
            before = here;
        }
        return votes < 0;
    }
    /// The first return behind the run that begins at `from`; `plane` follows the most precise return of the run.
    [[nodiscard]] std::size_t endOf(std::size_t from, double& plane, bool bothWays) const {
        double before = tiltOn(plane, returns_[from], returns_[from].tilt);
        double travelled = 0;
        double lastStep = kPi;
        double best = kPi;
        int direction = bothWays ? 0 : 1;
        for (std::size_t m = from + 1; m < returns_.size(); ++m) {
            const ReturnAngles& s = returns_[m];
            if (s.planeError < best) {
                plane += std::remainder(s.plane - plane, kPi);
                best = s.planeError;
            }
            const double here = tiltOn(plane, s, before);
            const double step = stepFrom(before, here);
            travelled += step;
            if (std::abs(step) > s.tiltError + returns_[m - 1].tiltError) {
                const int sign = step > 0 ? 1 : -1;
                if (direction == 0) direction = sign;
                // To and fro, the turning point is measured twice: the second time by the new line.
                if (sign != direction) return bothWays && m - 1 > from && std::abs(lastStep) < 0.5 * beamStep_ ? m - 1 : m;
            }
            if (std::abs(travelled) > 2 * kPi - 0.5 * beamStep_) return m;
            lastStep = step;
            before = here;
        }
        return returns_.size();
    }
    [[nodiscard]] double stepFrom(double before, double here) const {
        return gap_.width > 4 * beamStep_ ? gap_.from(here) - gap_.from(before) : std::remainder(here - before, 2 * kPi);
    }
    /// The first return that is off the plane of those before it by more than `least` and what rounding explains.
    [[nodiscard]] std::size_t planeChange(std::size_t from, std::size_t to, double least) const {
        std::complex<double> sum;
        double weights = 0;
        for (std::size_t m = from; m < to; ++m) {
            const ReturnAngles& s = returns_[m];
            if (s.planeError > kSideUnknown) continue;
            if (weights > 0) {
                const double far = off(s.plane, 0.5 * std::arg(sum), kPi);
                if (far > s.planeError + 1 / std::sqrt(weights) + least) return m;
            }
            const double weight = 1 / (s.planeError * s.planeError + 1e-30);
            sum = kForget * sum + weight * std::polar(1.0, 2 * s.plane);
            weights = kForget * weights + weight;
        }
        return to;
    }

    std::span<const ReturnAngles> returns_;
    double beamStep_;
    FanGap gap_;
};

/// Every line seems to be on the other side of the axis from the one before: they are listed to and fro.
bool turnsOverAndOver(const std::vector<Run>& runs) {
    std::size_t turned = 0;
    for (std::size_t i = 1; i < runs.size(); ++i) turned += off(runs[i].plane, runs[i - 1].plane, 2 * kPi) > 2.6 ? 1 : 0;
    return runs.size() >= 4 && turned * 2 > runs.size();
}

/// Planes that no return shows lie between those of their neighbours; angles run on from line to line.
void continuePlanes(std::vector<Run>& runs) {
    std::size_t before = runs.size();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].planeError >= kPi) continue;
        if (before < runs.size()) {
            runs[i].plane = runs[before].plane + std::remainder(runs[i].plane - runs[before].plane, 2 * kPi);
            for (std::size_t k = before + 1; k < i; ++k)
                runs[k].plane = runs[before].plane +
                                (runs[i].plane - runs[before].plane) * static_cast<double>(k - before) / static_cast<double>(i - before);
        } else {
            for (std::size_t k = 0; k < i; ++k) runs[k].plane = runs[i].plane;
        }
        before = i;
    }
    for (std::size_t k = before + 1; before < runs.size() && k < runs.size(); ++k) runs[k].plane = runs[before].plane;
}

} // namespace

double tiltOn(double plane, const ReturnAngles& angles, double near) {
    if (angles.planeError <= kSideUnknown) return std::cos(angles.plane - plane) >= 0 ? angles.tilt : -angles.tilt;
    return std::abs(std::remainder(angles.tilt - near, 2 * kPi)) <= std::abs(std::remainder(-angles.tilt - near, 2 * kPi)) ? angles.tilt
                                                                                                                           : -angles.tilt;
}

std::optional<Runs> runsOf(std::span<const ReturnAngles> returns) {
    const auto beamStep = beamStepOf(returns);
    if (!beamStep) return std::nullopt;
    Cutter cutter(returns, *beamStep);
    Runs found{cutter.cut(false), *beamStep};
    const bool bothWays = turnsOverAndOver(found.runs);
    if (bothWays) found.runs = cutter.cut(true);
    if (static_cast<double>(returns.size()) < kFewestPerRun * static_cast<double>(found.runs.size())) return std::nullopt;
    cutter.findGap(found.runs);
    found.runs = cutter.cut(bothWays);
    if (static_cast<double>(returns.size()) < kFewestPerRun * static_cast<double>(found.runs.size())) return std::nullopt;
    for (Run& run : found.runs) cutter.measure(run);
    found.runs = cutter.cutWherePlanesChange(found.runs);
    if (static_cast<double>(returns.size()) < kFewestPerRun * static_cast<double>(found.runs.size())) return std::nullopt;
    continuePlanes(found.runs);
    return found;
}

} // namespace edgescan::files::recognition
