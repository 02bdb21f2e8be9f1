// Gauss-Newton with Tukey's weights, in both directions: early view against late view, and late against early.
#include "app/lab/calibration/self_calibration.h"

#include "app/lab/calibration/axis_ends.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace edgescan::inspect {
namespace {

constexpr std::size_t kCells = 12000; // per scan and direction
constexpr std::size_t kTurn = 4;      // index in AssemblyErrors
constexpr std::array<int, 2> kHalfWidths{4, 2};
constexpr std::array<EndScale, 2> kEndScales{{{240, 4}, {60, 1}}}; // of a sweep mounting
constexpr std::array<int, 2> kIterations{6, 8};
constexpr double kTukey = 4.685;
constexpr double kLeastScale = 0.3;
const AssemblyVector kPrior = (AssemblyVector() << 10, 10, 0.5, 0.5, 0.3).finished();
constexpr double kLongestMm = 15;
constexpr double kLongestDeg = 0.6;
constexpr double kLeastOverlapDeg = 5;
constexpr double kLeastSweepDeg = 300; // degrees of turn: a shorter turn gives a worse estimate than the nominal assembly
constexpr double kLeastBeyondDeg = 1;  // degrees of fan behind a sweep's axis
constexpr double kFullTurnDeg = 359;
constexpr double kHonestPart = 1.5, kHonestFull = 1.2, kHonestSweep = 1.5; // docs/reference/calibration.md, "Uncertainty"
constexpr double kAgreed = 1.5;                                            // times the misfit that noise explains
constexpr std::size_t kFewestCells = 500;
constexpr std::array<const char*, AssemblyErrors::kCount> kNames{"the lever arm t1", "the lever arm t2", "the tilt of the fan",
                                                                 "the beam index", "the length of the turn"};

/// A scan with the cells to compare.
struct Pass {
    PreparedSweep sweep;
    std::array<std::vector<SeenCell>, 2> cells; ///< by View
};

struct Solved {
    AssemblyErrors errors;
    AssemblyMatrix covariance = AssemblyMatrix::Zero();
    std::size_t cells = 0;
};

AssemblyVector vectorOf(const AssemblyErrors& errors) { return Eigen::Map<const AssemblyVector>(errors.values.data()); }

double tukeyWeight(double x, double limit) {
    const double share = x / limit;
    return std::abs(share) >= 1.0 ? 0.0 : std::pow(1.0 - share * share, 2);
}

/// 1.48 median |e / sigma|, with a lower limit so that pure noise is not cut off.
double scaleOf(const std::vector<Residual>& residuals) {
    std::vector<double> sizes;
    for (const Residual& r : residuals) sizes.push_back(std::abs(r.apartMm / r.sigmaMm));
    return std::max(kLeastScale, 1.48 * median(std::move(sizes), 1.0));
}

struct Normal {
    AssemblyMatrix matrix = kPrior.cwiseInverse().cwiseAbs2().asDiagonal();
    AssemblyVector right = AssemblyVector::Zero();
    std::map<std::pair<std::size_t, int>, AssemblyVector> together; ///< per scan: residuals with correlated errors
    std::size_t cells = 0;
};

/// The cells of a pass compared on one scale.
class Comparison {
public:
    Comparison(const Pass& pass, std::size_t level) : pass_(pass), level_(level), fits_(pass.sweep.inverse, kHalfWidths[level]) {}

    [[nodiscard]] std::vector<Residual> residuals(View view, const AssemblyErrors& errors) {
        const auto& cells = pass_.cells[static_cast<std::size_t>(view)];
        if (pass_.sweep.polar.axis == Axis::Spin) return residualsOf(pass_.sweep, fits_, cells, view, errors);
        const auto& surface = pass_.cells[static_cast<std::size_t>(view == View::Late ? View::Early : View::Late)];
        return residualsAtEnds(pass_.sweep, cells, surface, errors, kEndScales[level_]);
    }

private:
    const Pass& pass_;
    std::size_t level_;
    SurfaceFits fits_;
};

Normal normalOf(std::vector<Comparison>& passes, View view, const AssemblyErrors& errors) {
    Normal normal;
    normal.right = -normal.matrix * vectorOf(errors);
    std::vector<std::vector<Residual>> all;
    std::vector<Residual> together;
    for (Comparison& pass : passes) {
        all.push_back(pass.residuals(view, errors));
        together.insert(together.end(), all.back().begin(), all.back().end());
    }
    const double limit = kTukey * scaleOf(together);
    for (std::size_t p = 0; p < all.size(); ++p) {
        for (const Residual& r : all[p]) {
            const double e = r.apartMm / r.sigmaMm;
            const double w = tukeyWeight(e, limit);
            if (w == 0.0) continue;
            const AssemblyVector slope = r.slope / r.sigmaMm;
            normal.matrix += w * slope * slope.transpose();
            normal.right -= w * e * slope;
            auto [shared, fresh] = normal.together.try_emplace({p, r.shares}, AssemblyVector::Zero());
            shared->second += w * e * slope;
            ++normal.cells;
        }
    }
    return normal;
}

std::vector<Comparison> comparisonsOf(const std::vector<Pass>& passes, std::size_t level) {
    std::vector<Comparison> all;
    for (const Pass& pass : passes) all.emplace_back(pass, level);
    return all;
}

/// Empty: cancelled.
std::optional<Solved> solve(const std::vector<Pass>& passes, View view, const CalibrationProgress& goOn) {
    const char* stage = view == View::Early ? "early cells on late surfaces" : "late cells on early surfaces";
    constexpr double kAll = kIterations[0] + kIterations[1];
    int done = 0;
    Solved solved;
    AssemblyVector q = AssemblyVector::Zero();
    Normal normal;
    for (std::size_t level = 0; level < kHalfWidths.size(); ++level) {
        std::vector<Comparison> compared = comparisonsOf(passes, level);
        for (int iteration = 0; iteration < kIterations[level]; ++iteration) {
            if (!goOn(stage, done++ / kAll)) return std::nullopt;
            normal = normalOf(compared, view, solved.errors);
            const AssemblyVector step = normal.matrix.ldlt().solve(normal.right);
            for (Eigen::Index n = 0; n < step.size(); ++n) {
                const double longest = n < 2 ? kLongestMm : kLongestDeg;
                q[n] += std::clamp(step[n], -longest, longest);
            }
            std::copy(q.data(), q.data() + q.size(), solved.errors.values.begin());
        }
    }
    const AssemblyMatrix inverse = normal.matrix.inverse();
    AssemblyMatrix middle = AssemblyMatrix::Zero();
    for (const auto& [shared, g] : normal.together) middle += g * g.transpose();
    // A parameter that only the prior determines is as uncertain as the prior, and so are the parameters that depend on it.
    if (passes.front().sweep.polar.axis == Axis::Sweep) middle.diagonal() += kPrior.cwiseInverse().cwiseAbs2();
    solved.covariance = inverse * middle * inverse;
    solved.cells = normal.cells;
    return solved;
}

struct Agreement {
    double medianMm = 0;
    double noiseMm = 0;
};

Agreement agreementOf(const std::vector<Pass>& passes, const AssemblyErrors& errors) {
    std::vector<double> apart, sigma;
    for (Comparison& pass : comparisonsOf(passes, kHalfWidths.size() - 1)) {
        for (const View view : {View::Early, View::Late}) {
            for (const Residual& r : pass.residuals(view, errors)) {
                apart.push_back(std::abs(r.apartMm));
                sigma.push_back(r.sigmaMm);
            }
        }
    }
    constexpr double kMedianOfNormal = 0.6745;
    return {median(std::move(apart)), kMedianOfNormal * median(std::move(sigma))};
}

std::optional<Error> sweepRefusal(const PolarGeometry& polar, const std::string& name) {
    if (turnOf(polar) < kLeastSweepDeg)
        return Error{"the stepper turned " + fixedText(turnOf(polar), 1) +
                         " degrees about an axis in the fan, so no surface is measured twice",
                     name, "turn the full 360 degrees once for the calibration, or mount the scanner to spin and turn 200"};
    const auto beyond = beyondAxisDeg(polar);
    if (std::max(beyond[0], beyond[1]) < kLeastBeyondDeg)
        return Error{"the fan ends at the axis that it turns about, so no place is seen twice", name,
                     "measure all beams of the scanner, or mount it to spin for the calibration"};
    return std::nullopt;
}

std::optional<Error> refusalOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr)
        return Error{"this cloud does not say at which angles its points were measured", scan.name,
                     "calibrate with a scan of the scanner itself"};
    if (polar->axis == Axis::Sweep) return sweepRefusal(*polar, scan.name);
    const double overlap = turnOf(*polar) - 180.0;
    if (overlap < kLeastOverlapDeg)
        return Error{"the stepper turned " + fixedText(turnOf(*polar), 1) + " degrees, so too little is seen twice", scan.name,
                     "turn 200 degrees once for the calibration; the first 20 are then measured a second time"};
    return std::nullopt;
}

void findCells(Pass& pass, View view, std::size_t most) {
    const PolarGeometry& polar = pass.sweep.polar;
    pass.cells[static_cast<std::size_t>(view)] = polar.axis == Axis::Spin ? cellsSeenTwice(polar, pass.sweep.inverse, view, most)
                                                                          : cellsAtEnds(polar, pass.sweep.inverse, view, most);
}

Pass passOf(const Scan& scan) {
    Pass pass{preparedSweep(scan, std::get<PolarGeometry>(scan.geometry)), {}};
    for (const View view : {View::Early, View::Late}) findCells(pass, view, kCells);
    return pass;
}

double honestFactor(const SelfCalibration& found) {
    if (found.axis == Axis::Sweep) return kHonestSweep;
    return found.overlapDeg + 180.0 < kFullTurnDeg ? kHonestPart : kHonestFull;
}

/// Error for a parameter whose uncertainty is hardly smaller than that of the prior.
std::optional<Error> stillUnknown(const SelfCalibration& found, const std::string& where) {
    for (std::size_t n = 0; n < AssemblyErrors::kCount; ++n) {
        if (n == kTurn && !found.turnIsEstimated) continue;
        if (found.sd.values[n] <= 0.5 * kPrior[static_cast<Eigen::Index>(n)]) continue;
        return Error{std::string(kNames[n]) + " stays unknown: what is seen twice is too plain", where,
                     found.axis == Axis::Spin
                         ? "scan a place with rocks, or turn the full 360 degrees"
                         : "scan a place with rocks before both ends of the axis, or mount the scanner to spin and turn 200"};
    }
    return std::nullopt;
}

AssemblyErrors uncertaintyOf(const Solved& early, const Solved& late, double honest) {
    AssemblyErrors sd;
    for (std::size_t n = 0; n < AssemblyErrors::kCount; ++n) {
        const auto at = static_cast<Eigen::Index>(n);
        const double half = 0.25 * (early.covariance(at, at) + late.covariance(at, at));
        const double ways = 0.5 * (early.errors.values[n] - late.errors.values[n]);
        sd.values[n] = honest * std::sqrt(half + ways * ways);
    }
    return sd;
}

} // namespace

Result<SelfCalibration> calibrateFromSweeps(std::span<const std::shared_ptr<const Scan>> scans, const CalibrationProgress& progress) {
    if (scans.empty()) return Error{"there is no scan to calibrate with", "", "name one"};
    const CalibrationProgress goOn = [&](const char* stage, double fraction) { return !progress || progress(stage, fraction); };
    const std::string where = scans.front()->name;
    const Error cancelled{"cancelled", where, ""};
    std::vector<Pass> passes;
    SelfCalibration result;
    result.overlapDeg = std::numeric_limits<double>::infinity();
    for (const auto& scan : scans) {
        if (const auto refusal = refusalOf(*scan)) return *refusal;
        if (!goOn("surfaces seen twice", static_cast<double>(passes.size()) / static_cast<double>(scans.size()))) return cancelled;
        passes.push_back(passOf(*scan));
        const PolarGeometry& polar = passes.back().sweep.polar;
        if (polar.axis != passes.front().sweep.polar.axis)
            return Error{"it turns about another axis than the first scan", scan->name, "give scans of one assembly"};
        result.overlapDeg = std::min(result.overlapDeg, turnOf(polar) - 180.0);
    }
    result.axis = passes.front().sweep.polar.axis;
    result.turnIsEstimated = result.axis == Axis::Spin;
    const std::optional<Solved> early = solve(passes, View::Early, goOn);
    const std::optional<Solved> late = early ? solve(passes, View::Late, goOn) : std::nullopt;
    if (!late || !goOn("agreement of the views", 0.0)) return cancelled;
    result.cells = early->cells + late->cells;
    if (result.cells < kFewestCells)
        return Error{"only " + std::to_string(result.cells) + " cells lie on smooth surfaces that both views saw", where,
                     "scan a place with rocks or walls within the scanner's reach"};
    for (std::size_t n = 0; n < AssemblyErrors::kCount; ++n)
        result.errors.values[n] = 0.5 * (early->errors.values[n] + late->errors.values[n]);
    result.sd = uncertaintyOf(*early, *late, honestFactor(result));
    if (!result.turnIsEstimated) result.errors.turnDeg() = result.sd.turnDeg() = 0;
    result.medianBeforeMm = agreementOf(passes, {}).medianMm;
    const Agreement after = agreementOf(passes, result.errors);
    result.medianAfterMm = after.medianMm;
    result.noiseMm = after.noiseMm;
    if (after.medianMm > kAgreed * after.noiseMm)
        return Error{"the two views still lie " + fixedText(after.medianMm, 1) + " mm apart where noise explains " +
                         fixedText(after.noiseMm, 1),
                     where, "see that nothing moved during the scan, and scan again"};
    if (const auto unknown = stillUnknown(result, where)) return *unknown;
    return result;
}

Grid<float> viewDistanceMm(const Scan& scan, const AssemblyErrors& errors) {
    Grid<float> apart(scan.lines(), scan.beams(), std::numeric_limits<float>::quiet_NaN());
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || refusalOf(scan)) return apart;
    Pass pass{preparedSweep(scan, *polar), {}};
    if (polar->axis == Axis::Sweep) findCells(pass, View::Early, kCells); // the surface that the late cells are compared with
    findCells(pass, View::Late, scan.cells());
    for (const Residual& r : Comparison(pass, kHalfWidths.size() - 1).residuals(View::Late, errors))
        apart.at(r.line, r.beam) = static_cast<float>(r.apartMm);
    return apart;
}

} // namespace edgescan::inspect
