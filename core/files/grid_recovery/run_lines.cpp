// From runs to a grid: beams are what the runs have in common, each return takes the beam that it can have between its neighbours, and the
// lines stay in the order of the list unless that is scrambled.
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/runs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace edgescan::files::recognition {
namespace {

constexpr double kOnBeam = 0.3; // of a step: nearer and more precise, a return is on that beam
constexpr std::size_t kFewestInCommon = 4;
constexpr double kShort = 0.25; // of the usual number of returns of a line
constexpr int kSwapped = 3;     // beams by which neighbours in a list may have changed places

/// The beam of each return; kNone where it has none.
struct Beams {
    Ring ring;
    std::vector<std::uint32_t> of;
    std::size_t off = 0; ///< returns between the beams
};

class BeamFinder {
public:
    BeamFinder(std::span<const ReturnAngles> returns, const Runs& runs, std::span<const AxisPoint> points)
        : returns_(returns), runs_(runs) {
        tilts_.reserve(returns.size());
        for (const Run& run : runs.runs) {
            const double c = std::cos(run.plane);
            const double s = std::sin(run.plane);
            for (std::size_t m = run.from; m < run.to; ++m) {
                const AxisPoint& p = points[returns[m].point];
                tilts_.push_back({std::atan2(p.radiusIn(c, s), p.u), returns[m].tiltError});
            }
        }
    }

    /// The first ring on which nearly all returns lie.
    [[nodiscard]] std::optional<Beams> find(NoFit& best) const {
        std::vector<Ring> rings = ringsOfStep(tilts_, 2 * kPi, runs_.beamStep);
        bool more = true;
        for (std::size_t r = 0; r < rings.size() || more; ++r) {
            if (r >= rings.size()) { // voids of another size than the steps from return to return
                std::vector<Ring> others = ringsAmong(tilts_, 2 * kPi);
                std::move(others.begin(), others.end(), std::back_inserter(rings));
                more = false;
                if (r >= rings.size()) break;
            }
            const Ring& ring = rings[r];
            if (ring.centres.size() < 2 || returns_.size() < kPointsPerGroup * ring.centres.size()) continue;
            Beams beams = onRing(ring);
            const double share = 1 - static_cast<double>(beams.off) / static_cast<double>(returns_.size());
            if (share > best.onGrid && runs_.runs.size() >= 4) best = {runs_.runs.size(), ring.centres.size(), share};
            if (share >= kShareOnGrid) return beams;
        }
        return std::nullopt;
    }

private:
    struct Place {
        double at = 0.0;   ///< in beams
        double step = 0.0; ///< to the next beam on that side, radians
        bool sure = false, off = false;
    };
    [[nodiscard]] Place placeOn(const Ring& ring, const Angle& tilt) const {
        const Ring::Nearest near = ring.nearest(tilt.value);
        const double side = std::remainder(tilt.value - ring.centres[near.group], 2 * kPi) < 0 ? -1 : 1;
        // Beyond the first and the last beam the void is not a step.
        const double step = std::min(near.voidWidth, 2 * usualStep(ring));
        Place place{static_cast<double>(near.group) + side * near.distance / step, step, false, false};
        place.sure = tilt.error <= kOnBeam * step && near.distance <= std::max(kOnBeam * step, tilt.error);
        place.off = near.distance > 0.25 * step + tilt.error;
        return place;
    }
    [[nodiscard]] static double usualStep(const Ring& ring) {
        return (ring.centres.back() - ring.centres.front()) / static_cast<double>(ring.centres.size() - 1);
    }
    [[nodiscard]] Beams onRing(const Ring& ring) const {
        Beams beams{ring, std::vector<std::uint32_t>(returns_.size(), kNone), 0};
        std::vector<Place> places;
        places.reserve(returns_.size());
        for (const Angle& tilt : tilts_) {
            places.push_back(placeOn(ring, tilt));
            beams.off += places.back().off ? 1 : 0;
        }
        if (static_cast<double>(beams.off) > (1 - kShareOnGrid) * static_cast<double>(returns_.size())) return beams;
        for (const Run& run : runs_.runs) placeRun(run, places, ring.centres.size(), beams.of);
        return beams;
    }
    /// Sure returns are on their beams; those between two of them take what beams are left there, in their order.
    void placeRun(const Run& run, const std::vector<Place>& places, std::size_t beams, std::vector<std::uint32_t>& of) const {
        std::size_t unsureFrom = run.from;
        std::size_t free = 0; // the first beam behind the last sure one
        for (std::size_t m = run.from; m <= run.to; ++m) {
            if (m < run.to && !places[m].sure) continue;
            const std::size_t end = m < run.to ? static_cast<std::size_t>(std::lround(places[m].at)) : beams;
            placeBetween(unsureFrom, m, places, free, end, of);
            if (m == run.to) break;
            of[m] = static_cast<std::uint32_t>(end);
            unsureFrom = m + 1;
            free = end + 1;
        }
    }
    /// Returns from - to onto the beams first .. end - 1; where the run goes back, or there are too few, each to its nearest.
    static void placeBetween(std::size_t from, std::size_t to, const std::vector<Place>& places, std::size_t first, std::size_t end,
                             std::vector<std::uint32_t>& of) {
        std::vector<double> wanted, weights;
        std::vector<std::size_t> which;
        for (std::size_t m = from; m < to; ++m) {
            if (places[m].off) continue;
            which.push_back(m);
            wanted.push_back(places[m].at - static_cast<double>(first));
            weights.push_back(1 / (places[m].step * places[m].step + 1e-30));
        }
        if (end < first || which.size() > end - first) {
            for (const std::size_t m : which) of[m] = static_cast<std::uint32_t>(std::max(0.0, std::round(places[m].at)));
            return;
        }
        const auto taken = spreadInOrder(wanted, weights, end - first);
        for (std::size_t n = 0; n < which.size(); ++n) of[which[n]] = static_cast<std::uint32_t>(first + taken[n]);
    }

    std::span<const ReturnAngles> returns_;
    const Runs& runs_;
    std::vector<Angle> tilts_;
};

/// Lines of the grid to be: runs with their beams.
class LineMaker {
public:
    LineMaker(std::span<const ReturnAngles> returns, std::span<const AxisPoint> points, const Beams& beams)
        : returns_(returns), points_(points), beams_(beams) {}

    void add(const Run& run) {
        if (!lines_.empty() && (continues(run) || copies(run))) return append(run);
        lines_.push_back({run, {run}, filledBy(run)});
    }

    [[nodiscard]] std::optional<Fit> fit() {
        mergeStrays();
        const std::vector<std::size_t> order = orderOfLines();
        const double cells = static_cast<double>(lines_.size()) * static_cast<double>(beams_.ring.centres.size());
        if (static_cast<double>(returns_.size()) < kLeastFilled * cells) return std::nullopt;
        Fit fit;
        fit.tilt = beams_.ring.centres;
        fit.pointOf = Grid<std::uint32_t>(static_cast<int>(lines_.size()), static_cast<int>(fit.tilt.size()), kNone);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Line& line = lines_[order[i]];
            double plane = line.run.plane;
            if (sorted_ && i > 0) plane = fit.plane.back() + std::fmod(std::fmod(plane - fit.plane.back(), 2 * kPi) + 2 * kPi, 2 * kPi);
            fit.plane.push_back(plane);
            for (const Run& run : line.parts) {
                for (std::size_t m = run.from; m < run.to; ++m) put(fit, static_cast<int>(i), m);
            }
        }
        if (static_cast<double>(fit.doubled) > kMostDoubled * static_cast<double>(returns_.size())) return std::nullopt;
        return fit;
    }

private:
    struct Line {
        Run run;
        std::vector<Run> parts;
        std::vector<std::uint32_t> pointOf; ///< per beam
    };

    [[nodiscard]] std::vector<std::uint32_t> filledBy(const Run& run) const {
        std::vector<std::uint32_t> cells(beams_.ring.centres.size(), kNone);
        for (std::size_t m = run.from; m < run.to; ++m) {
            if (beams_.of[m] != kNone && beams_.of[m] < cells.size()) cells[beams_.of[m]] = returns_[m].point;
        }
        return cells;
    }
    [[nodiscard]] static bool onePlane(const Run& a, const Run& b) {
        return std::abs(std::remainder(a.plane - b.plane, 2 * kPi)) <= 2 * (a.planeError + b.planeError) + 1e-9;
    }
    /// A line goes on behind two returns that have changed places in the list: the run begins a little before the end of the last one.
    [[nodiscard]] bool continues(const Run& run) const {
        const Line& last = lines_.back();
        if (!onePlane(last.run, run)) return false;
        int end = -1;
        for (std::size_t j = 0; j < last.pointOf.size(); ++j) end = last.pointOf[j] != kNone ? static_cast<int>(j) : end;
        const std::vector<std::uint32_t> cells = filledBy(run);
        int first = -1;
        int most = -1;
        for (std::size_t j = 0; j < cells.size(); ++j) {
            if (cells[j] == kNone) continue;
            if (last.pointOf[j] != kNone) return false;
            if (first < 0) first = static_cast<int>(j);
            most = static_cast<int>(j);
        }
        return first >= 0 && first >= end - kSwapped && (most > end || run.to - run.from == 1);
    }
    void append(const Run& run) {
        Line& line = lines_.back();
        line.parts.push_back(run);
        const std::vector<std::uint32_t> cells = filledBy(run);
        for (std::size_t j = 0; j < cells.size(); ++j) line.pointOf[j] = cells[j] != kNone ? cells[j] : line.pointOf[j];
    }
    /// Some drivers store every line twice: the same numbers to the last digit wherever both have a return.
    [[nodiscard]] bool copies(const Run& run) const {
        const std::vector<std::uint32_t>& last = lines_.back().pointOf;
        const std::vector<std::uint32_t> cells = filledBy(run);
        std::size_t common = 0;
        for (std::size_t j = 0; j < cells.size(); ++j) {
            if (cells[j] == kNone || last[j] == kNone) continue;
            if (!samePoint(cells[j], last[j])) return false;
            ++common;
        }
        return common >= kFewestInCommon && common * 2 >= run.to - run.from;
    }
    [[nodiscard]] bool samePoint(std::uint32_t a, std::uint32_t b) const {
        return points_[a].u == points_[b].u && points_[a].v == points_[b].v && points_[a].w == points_[b].w;
    }
    /// Where a cell has a point already, the nearer one stays.
    void put(Fit& fit, int line, std::size_t m) const {
        const std::uint32_t beam = beams_.of[m];
        if (beam == kNone || beam >= fit.tilt.size()) {
            ++fit.unplaced;
            return;
        }
        std::uint32_t& cell = fit.pointOf.at(line, static_cast<int>(beam));
        const std::uint32_t point = returns_[m].point;
        if (cell != kNone) ++(samePoint(point, cell) ? fit.copied : fit.doubled);
        if (cell == kNone || points_[point].range() < points_[cell].range()) cell = point;
    }
    /// A few returns somewhere in the list, far from their line: no line of their own, but late returns of that one.
    void mergeStrays() {
        std::vector<double> lengths;
        for (const Line& line : lines_) lengths.push_back(static_cast<double>(line.run.to - line.run.from));
        const double few = kShort * median(std::move(lengths));
        std::vector<std::pair<double, std::size_t>> byPlane; // of the others
        std::vector<double> steps;
        std::vector<std::size_t> before(lines_.size(), lines_.size()), after(lines_.size(), lines_.size());
        const auto isShort = [&](std::size_t i) { return static_cast<double>(lines_[i].run.to - lines_[i].run.from) < few; };
        std::size_t last = lines_.size();
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            before[i] = last;
            if (isShort(i)) continue;
            if (last < lines_.size()) steps.push_back(lines_[i].run.plane - lines_[last].run.plane);
            byPlane.emplace_back(turnOf(lines_[i].run.plane), i);
            for (std::size_t k = i; k-- > 0 && after[k] == lines_.size();) after[k] = i;
            last = i;
        }
        if (byPlane.size() == lines_.size() || byPlane.size() < 3) return;
        std::sort(byPlane.begin(), byPlane.end());
        const double onward = median(std::move(steps)); // of the motor
        const double step = std::abs(onward);
        std::vector<bool> stray(lines_.size(), false);
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const Run& run = lines_[i].run;
            if (!isShort(i) || run.planeError >= kPi) continue;
            const auto inSequence = [&](std::size_t other) {
                if (other >= lines_.size()) return false;
                const double apart = static_cast<double>(i) - static_cast<double>(other);
                const double moved = std::remainder(run.plane - lines_[other].run.plane, 2 * kPi) * (onward * apart < 0 ? -1 : 1);
                return moved >= -2 * step - run.planeError && moved <= (std::abs(apart) + 2) * step + run.planeError;
            };
            if (inSequence(before[i]) || inSequence(after[i])) continue;
            const auto right = std::lower_bound(byPlane.begin(), byPlane.end(), std::pair(turnOf(run.plane), std::size_t{0}));
            const auto a = right == byPlane.end() ? byPlane.front() : *right;
            const auto b = right == byPlane.begin() ? byPlane.back() : *(right - 1);
            const auto far = [&](const auto& line) { return std::abs(std::remainder(line.first - run.plane, 2 * kPi)); };
            const auto& nearest = far(a) <= far(b) ? a : b;
            if (far(nearest) > 0.5 * step + run.planeError) continue;
            lines_[nearest.second].parts.push_back(run);
            stray[i] = true;
        }
        std::size_t i = 0;
        std::erase_if(lines_, [&](const Line&) { return stray[i++]; });
    }
    [[nodiscard]] static double turnOf(double plane) { return std::fmod(std::fmod(plane, 2 * kPi) + 2 * kPi, 2 * kPi); }
    /// The lines in the order of the list, which a motor that stops or turns on and on goes through with equal angles. Only where no
    /// two of them are equal and they go to and fro are they put in the order of their angles.
    [[nodiscard]] std::vector<std::size_t> orderOfLines() {
        std::vector<std::size_t> order(lines_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto planeOf = [&](std::size_t i) { return lines_[i].run.plane; };
        bool rises = true;
        bool falls = true;
        for (std::size_t i = 1; i < order.size(); ++i) {
            const double tolerance = lines_[i].run.planeError + lines_[i - 1].run.planeError;
            rises = rises && planeOf(i) >= planeOf(i - 1) - tolerance;
            falls = falls && planeOf(i) <= planeOf(i - 1) + tolerance;
        }
        if (rises || falls || order.size() < 3) return order;
        Ring ring;
        const auto around = [&](std::size_t i) { return turnOf(planeOf(i)); };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return around(a) < around(b); });
        for (const std::size_t i : order) ring.centres.push_back(around(i));
        const std::vector<double> voids = ring.voids();
        const double usual = median(voids);
        std::size_t widest = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::size_t a = order[i];
            const std::size_t b = order[(i + 1) % order.size()];
            const bool neighbours = a + 1 == b || b + 1 == a;
            if (voids[i] < 0.5 * usual && !neighbours) { // seen twice: only the list distinguishes them
                std::sort(order.begin(), order.end());
                return order;
            }
            if (voids[i] > voids[widest]) widest = i;
        }
        std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>((widest + 1) % order.size()), order.end());
        sorted_ = true;
        return order;
    }

    std::span<const ReturnAngles> returns_;
    std::span<const AxisPoint> points_;
    const Beams& beams_;
    std::vector<Line> lines_;
    bool sorted_ = false;
};

} // namespace

std::optional<Fit> fitRuns(std::span<const AxisPoint> points, const Precision& precision, NoFit& best) {
    const std::vector<ReturnAngles> returns = returnsOf(points, precision);
    if (returns.size() < 12) return std::nullopt;
    const auto runs = runsOf(returns);
    if (!runs) return std::nullopt;
    const auto beams = BeamFinder(returns, *runs, points).find(best);
    if (!beams) return std::nullopt;
    LineMaker maker(returns, points, *beams);
    for (const Run& run : runs->runs) maker.add(run);
    auto fit = maker.fit();
    if (!fit) return std::nullopt;
    const OnGrid judged = judge(*fit, points, precision);
    if (judged.share < kShareOnGrid) return std::nullopt;
    fit->residual = judged.residual;
    return fit;
}

} // namespace edgescan::files::recognition
