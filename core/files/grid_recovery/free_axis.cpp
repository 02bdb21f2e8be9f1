// The search for a free axis: a guess from neighbours, then lines, their planes and the rays of their beams, twice.
#include "core/files/grid_recovery/free_axis.h"

#include "core/base/angles.h"
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/free_axis_parts.h"
#include "core/files/grid_recovery/runs.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace edgescan::files {
namespace {

using namespace turning;
using recognition::kPi;

constexpr std::size_t kFewestMoved = 200;
constexpr std::size_t kFewestLines = 4;
constexpr int kPasses = 3;
constexpr std::size_t kFewOfLine = 12; // returns: fewer are not a line by themselves, and two cuts so near are one
// Fans of scanners are even about their middle. A fan as wide as one of these is one, and what its middle is off is how it is mounted.
constexpr std::array<double, 4> kFansDeg{100.0, 180.0, 190.0, 270.0};
constexpr double kSameFanDeg = 0.02;
constexpr double kMostMountingDeg = 3.0;
constexpr double kExplained = 0.65; // of the rounding: a larger misfit has another reason
constexpr double kMostScale = 5e-3; // off 1
constexpr double kClearlyBetter = 0.9;
constexpr const char* kWayOut = "open the scan as the scanner stored it, or with its record";

struct Returns {
    std::vector<Eigen::Vector3d> points; ///< about the middle
    std::vector<std::size_t> place;      ///< in the list
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double rounding = 0.0;
};

Returns returnsIn(const PointList& list) {
    Returns returns;
    double largest = 0;
    for (std::size_t k = 0; k < list.points.size(); ++k) {
        const Eigen::Vector3d& p = list.points[k];
        if (!isReturn(p)) continue;
        returns.place.push_back(k);
        returns.middle += p;
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    if (!returns.place.empty()) returns.middle /= static_cast<double>(returns.place.size());
    for (const std::size_t k : returns.place) returns.points.emplace_back(list.points[k] - returns.middle);
    returns.rounding = list.precision.absolute + list.precision.relative * largest;
    return returns;
}

/// Lines, planes and rays as far as they are known.
struct Model {
    AxisFrame frame;
    std::vector<ScanLine> lines;
    FanModel fan;
    FanBeams beams;

    [[nodiscard]] std::vector<Eigen::Vector3d> inFans(const Returns& returns) const {
        std::vector<Eigen::Vector3d> fans(returns.points.size());
        for (const ScanLine& line : lines) {
            const auto inFan = intoFan(line.angle, fan.roll);
            for (std::size_t m = line.from; m < line.to; ++m) fans[m] = inFan(frame(returns.points[m]));
        }
        return fans;
    }
    /// The returns in the axis frame, as if roll and mirror were nothing, and the fan turned by `pitch` in its plane.
    [[nodiscard]] std::vector<Eigen::Vector3d> ideal(const Returns& returns, double pitch) const {
        std::vector<Eigen::Vector3d> points = inFans(returns);
        const Eigen::Matrix3d level = Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()).toRotationMatrix();
        for (const ScanLine& line : lines) {
            const Eigen::Matrix3d turn = Eigen::AngleAxisd(line.angle, Eigen::Vector3d::UnitZ()).toRotationMatrix() * level;
            for (std::size_t m = line.from; m < line.to; ++m) points[m] = turn * (points[m] - fan.mirror);
        }
        return points;
    }
    /// The same with the axis in the other direction.
    void turnAxis() {
        frame.turn.row(1) *= -1;
        frame.turn.row(2) *= -1;
        for (ScanLine& line : lines) line.angle = -line.angle;
        fan.mirror.y() *= -1;
        fan.mirror.z() *= -1;
        fan.step *= -1;
        beams.first *= -1;
        beams.last *= -1;
        beams.middle.y() *= -1;
    }
    /// The same with the other side of each plane as its first one.
    void turnSides() {
        for (ScanLine& line : lines) line.angle += kPi;
        fan.roll *= -1;
        fan.mirror.x() *= -1;
        fan.mirror.y() *= -1;
        fan.step *= -1;
        beams.first = kPi - beams.first;
        beams.last = kPi - beams.last;
        beams.middle.x() *= -1;
    }
};

/// Returns about the axis. A plane's angle is as uncertain as the axis, a tilt as the numbers.
std::vector<recognition::ReturnAngles> returnsAbout(std::span<const Eigen::Vector3d> points, double rounding, double misfit) {
    std::vector<recognition::ReturnAngles> seen;
    seen.reserve(points.size());
    for (std::size_t m = 0; m < points.size(); ++m) {
        const Eigen::Vector3d& q = points[m];
        const double away = std::max(q.head<2>().norm(), 1e-300), range = std::max(q.norm(), 1e-300);
        const double planeError = 1.75 * std::max(misfit, rounding) / away;
        seen.push_back({static_cast<std::uint32_t>(m), std::atan2(q.y(), q.x()), std::atan2(away, q.z()), planeError > 1 ? kPi : planeError,
                        1.75 * rounding / range});
    }
    return seen;
}

/// False when the list does not run along lines that have most of the returns.
bool findLines(Model& model, std::span<const Eigen::Vector3d> points, double rounding, double misfit) {
    const auto runs = recognition::runsOf(returnsAbout(points, rounding, misfit));
    if (!runs || runs->runs.size() < kFewestLines) return false;
    model.lines.clear();
    std::size_t inLines = 0;
    for (const recognition::Run& run : runs->runs) {
        model.lines.push_back({run.from, run.to, run.plane});
        inLines += run.to - run.from >= kFewOfLine ? run.to - run.from : 0;
    }
    return 2 * inLines > points.size();
}

std::vector<Eigen::Vector3d> inFrame(const AxisFrame& frame, const Returns& returns) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(returns.points.size());
    for (const Eigen::Vector3d& p : returns.points) points.push_back(frame(p));
    return points;
}

/// The angle of each line; a few returns alone show none and take that of the line before or after them, whose plane is nearer.
std::vector<double> steadyAngles(const Model& model, const Returns& returns) {
    const auto isLine = [&](std::size_t i) { return model.lines[i].to - model.lines[i].from >= kFewOfLine; };
    std::vector<double> angles;
    for (const ScanLine& line : model.lines) angles.push_back(line.angle);
    constexpr std::size_t kNoLine = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> lineBefore(angles.size(), kNoLine), lineAfter = lineBefore; // the nearest ones with enough returns
    for (std::size_t i = 1; i < angles.size(); ++i) lineBefore[i] = isLine(i - 1) ? i - 1 : lineBefore[i - 1];
    for (std::size_t i = angles.size() - 1; i-- > 0;) lineAfter[i] = isLine(i + 1) ? i + 1 : lineAfter[i + 1];
    for (std::size_t i = 0; i < angles.size(); ++i) {
        if (isLine(i)) continue;
        double least = std::numeric_limits<double>::infinity();
        const auto tryLine = [&](std::size_t other) {
            const auto inFan = intoFan(model.lines[other].angle, model.fan.roll);
            double off = 0;
            for (std::size_t m = model.lines[i].from; m < model.lines[i].to; ++m)
                off = std::max(off, std::abs(inFan(model.frame(returns.points[m])).y() - model.fan.mirror.y()));
            if (off >= least) return;
            least = off;
            angles[i] = model.lines[other].angle;
        };
        for (const std::size_t other : {lineBefore[i], lineAfter[i]}) {
            if (other != kNoLine) tryLine(other);
        }
    }
    return angles;
}

/// Cuts the list again where the beams start over, and where the first cut found another plane without that.
void cutWhereBeamsStartOver(Model& model, const Returns& returns) {
    const std::vector<double> angles = steadyAngles(model, returns);
    const auto isLine = [](const ScanLine& line) { return line.to - line.from >= kFewOfLine; };
    for (std::size_t i = 0; i < angles.size(); ++i) model.lines[i].angle = angles[i];
    const std::vector<Eigen::Vector3d> inFans = model.inFans(returns);
    const FanBeams& beams = model.beams;
    const double middle = std::atan2(beams.middle.y(), beams.middle.x());
    const double onward = model.fan.step > 0 ? 1.0 : -1.0;
    const auto angleOf = [&](const Eigen::Vector3d& f) {
        return onward * std::remainder(std::atan2(f.z() - model.fan.mirror.z(), f.x() - model.fan.mirror.x()) - middle, 2 * kPi);
    };
    std::vector<double> apart;
    for (std::size_t i = 1; i < model.lines.size(); ++i) apart.push_back(std::abs(std::remainder(angles[i] - angles[i - 1], kPi)));
    const double lineStep = median(apart);
    std::vector<std::size_t> starts{0};
    double before = angleOf(inFans[0]);
    for (std::size_t m = 1; m < inFans.size(); ++m) {
        const double here = angleOf(inFans[m]);
        if (here < before - 0.4 * std::abs(model.fan.step)) starts.push_back(m);
        before = here;
    }
    std::vector<std::size_t> all = starts;
    for (std::size_t i = 1; i < model.lines.size(); ++i) {
        const std::size_t cut = model.lines[i].from;
        const auto after = std::lower_bound(starts.begin(), starts.end(), cut);
        const std::size_t next = after == starts.end() ? inFans.size() : *after;
        const bool isNear = next - cut < kFewOfLine || (after != starts.begin() && cut - *(after - 1) < kFewOfLine);
        if (!isNear && isLine(model.lines[i - 1]) && isLine(model.lines[i]) && apart[i - 1] > 0.4 * lineStep) all.push_back(cut);
    }
    std::sort(all.begin(), all.end());
    std::vector<ScanLine> lines;
    for (std::size_t i = 0, old = 0; i < all.size(); ++i) {
        const std::size_t to = i + 1 < all.size() ? all[i + 1] : inFans.size();
        const std::size_t centre = (all[i] + to) / 2;
        while (old + 1 < model.lines.size() && model.lines[old + 1].from <= centre) ++old;
        lines.push_back({all[i], to, model.lines[old].angle});
    }
    model.lines = std::move(lines);
}

/// Called between passes over the returns; false cancels.
using GoOn = std::function<bool(double fraction)>;

/// Empty when the lines turn about no common axis, or when it was cancelled.
std::optional<Model> modelOf(const Returns& returns, const GoOn& goOn) {
    Model model;
    auto frame = guessAxis(returns.points, returns.rounding);
    if (!frame || !goOn(0.1)) return std::nullopt;
    guessPlaceOnAxis(*frame, returns.points);
    model.frame = *frame;
    if (!findLines(model, inFrame(model.frame, returns), returns.rounding, model.frame.misfit)) return std::nullopt;
    for (int pass = 0; pass < kPasses; ++pass) {
        if (!goOn(0.2 + 0.3 * pass / kPasses)) return std::nullopt;
        if (pass > 0) cutWhereBeamsStartOver(model, returns);
        fitPlanes(model.frame, model.lines, model.fan, returns.points);
        const auto beams = fitRays(model.fan, model.inFans(returns), model.lines);
        if (!beams) return std::nullopt;
        model.beams = *beams;
    }
    return model;
}

/// The same returns in a grid of another scale.
Returns scaled(Returns returns, double scale) {
    for (Eigen::Vector3d& p : returns.points) p.head<2>() /= scale;
    return returns;
}

/// The model fitted again to returns of another scale; empty when their rays do not fit.
std::optional<Model> fittedTo(const Returns& returns, Model model) {
    fitPlanes(model.frame, model.lines, model.fan, returns.points);
    const auto beams = fitRays(model.fan, model.inFans(returns), model.lines);
    if (!beams) return std::nullopt;
    model.beams = *beams;
    return model;
}

/// Takes the scale of the grid at which lines and beams fit best into returns and model. The result is this scale; 1 where the fit is not
/// clearly better, or when it was cancelled: then nothing changes. The square of the misfit is a parabola.
double applyGridScale(Returns& returns, Model& model, const GoOn& goOn) {
    double best = 1.0, done = 0.5;
    for (const double reach : {5e-4, 5e-5}) {
        std::array<double, 3> squares{};
        for (int i = 0; i < 3; ++i, done += 0.06) {
            const auto fitted = goOn(done) ? fittedTo(scaled(returns, best + (i - 1) * reach), model) : std::nullopt;
            if (!fitted) return 1.0;
            squares[static_cast<std::size_t>(i)] = fitted->fan.misfit * fitted->fan.misfit;
        }
        const double bend = squares[0] - 2 * squares[1] + squares[2];
        if (!(bend > 0)) return 1.0;
        best += reach * (squares[0] - squares[2]) / (2 * bend);
        if (std::abs(best - 1.0) > kMostScale) return 1.0;
    }
    Returns moved = scaled(returns, best);
    auto fitted = fittedTo(moved, model);
    if (!fitted || !(fitted->fan.misfit < kClearlyBetter * model.fan.misfit)) return 1.0;
    returns = std::move(moved);
    model = std::move(*fitted);
    return best;
}

/// The fan looks along the axis (spin) or away from it (sweep), and its angles ascend in the list.
Axis turnLikeAScanner(Model& model, std::optional<Axis> asked) {
    const Eigen::Vector2d& middle = model.beams.middle;
    if (asked.value_or(std::abs(middle.y()) > std::abs(middle.x()) ? Axis::Spin : Axis::Sweep) == Axis::Spin) {
        if (middle.y() < 0) model.turnAxis();
        if (model.fan.step < 0) model.turnSides();
        return Axis::Spin;
    }
    if (middle.x() < 0) model.turnSides();
    if (model.fan.step > 0) model.turnAxis();
    return Axis::Sweep;
}

/// How a fan of a scanner is mounted in its plane, radians.
double pitchOf(const Model& model, Axis axis) { return (axis == Axis::Spin ? kPi / 2 : 0.0) - (model.beams.first + model.beams.last) / 2; }

/// The width of the fan where scanners have one as wide, and it is mounted as scanners are; else 0.
double fanDegOf(const Model& model, Axis axis) {
    const double width = degrees(std::abs(model.beams.last - model.beams.first));
    const auto known = std::ranges::find_if(kFansDeg, [&](double fan) { return std::abs(width - fan) < kSameFanDeg; });
    return known != kFansDeg.end() && std::abs(degrees(pitchOf(model, axis))) <= kMostMountingDeg ? *known : 0.0;
}

/// Axes with the third along the rotation axis -> axes of the scanner (docs/reference/coordinates.md, "Step 1").
Eigen::Matrix3d scannerAxes(Axis axis) {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (axis == Axis::Sweep) axes << 0, 0, 1, 0, -1, 0, 1, 0, 0;
    return axes;
}

} // namespace

Result<FreeAxis> findFreeAxis(const PointList& list) {
    Returns returns = returnsIn(list);
    std::optional<Model> model;
    bool cancelled = false;
    const GoOn goOn = [&](double fraction) {
        cancelled = cancelled || (list.progress && !list.progress("finding the axis", fraction));
        return !cancelled;
    };
    if (goOn(0.0) && returns.points.size() >= kFewestMoved) model = modelOf(returns, goOn);
    if (cancelled) return Error{"cancelled", "", ""};
    if (!model) return Error{"they do not follow each other in scan lines that turn about an axis elsewhere", "", kWayOut};
    FreeAxis found;
    if (model->fan.misfit > kExplained * returns.rounding) found.scale = applyGridScale(returns, *model, goOn);
    if (cancelled) return Error{"cancelled", "", ""};
    found.axis = turnLikeAScanner(*model, list.axis);
    found.fanDeg = fanDegOf(*model, found.axis);
    const double pitch = found.fanDeg > 0 ? pitchOf(*model, found.axis) : 0.0;
    const Eigen::Matrix3d axes = scannerAxes(found.axis);
    const Eigen::Matrix3d roll = Eigen::AngleAxisd(model->fan.roll, Eigen::Vector3d::UnitX()).toRotationMatrix();
    Eigen::Vector3d lever = roll * model->fan.mirror;
    found.turn = axes * model->frame.turn;
    found.place = model->frame.centre + model->frame.turn.transpose() * Eigen::Vector3d(0, 0, lever.z());
    found.place.head<2>() *= found.scale;
    found.place += returns.middle;
    lever.z() = 0;
    found.lever = axes * lever;
    found.tilt = axes * roll * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()).toRotationMatrix() * axes.transpose();
    found.misfit = model->fan.misfit;
    found.precision = {returns.rounding, 1e-15};
    found.points.assign(list.points.size(), Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    const std::vector<Eigen::Vector3d> ideal = model->ideal(returns, pitch);
    for (std::size_t m = 0; m < ideal.size(); ++m) found.points[returns.place[m]] = axes * ideal[m];
    return found;
}

} // namespace edgescan::files
