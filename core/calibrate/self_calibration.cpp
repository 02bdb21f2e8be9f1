// Gauss-Newton with Tukey's weights, both ways.
#include "core/calibrate/self_calibration.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace edgescan {
namespace {

constexpr std::size_t kCells = 12000; // per scan and way
constexpr std::array<int, 2> kHalfWidths{4, 2};
constexpr std::array<int, 2> kIterations{6, 8};
constexpr double kTukey = 4.685;
constexpr double kLeastScale = 0.3;
const AssemblyVector kPrior = (AssemblyVector() << 10, 10, 0.5, 0.5, 0.3).finished();
constexpr double kLongestMm = 15;
constexpr double kLongestDeg = 0.6;
constexpr double kLeastOverlapDeg = 5;
constexpr double kFullTurnDeg = 359;
constexpr double kHonestPart = 1.5, kHonestFull = 1.2; // docs/calibration.md, "Uncertainty"
constexpr double kAgreed = 1.5;                        // times what noise explains
constexpr std::size_t kFewestCells = 500;
constexpr std::array<const char*, AssemblyErrors::kCount> kNames{"the lever arm t1", "the lever arm t2", "the tilt of the fan",
                                                                 "the beam index", "the length of the turn"};

/// A scan with the cells that are compared.
struct Pass {
    TurnedSweep sweep;
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

/// 1.48 median |e / sigma|, never so small that noise itself is cut off.
double scaleOf(const std::vector<Residual>& residuals) {
    std::vector<double> sizes;
    for (const Residual& r : residuals) sizes.push_back(std::abs(r.apartMm / r.sigmaMm));
    return std::max(kLeastScale, 1.48 * median(std::move(sizes), 1.0));
}

struct Normal {
    AssemblyMatrix matrix = kPrior.cwiseInverse().cwiseAbs2().asDiagonal();
    AssemblyVector right = AssemblyVector::Zero();
    std::map<std::pair<std::size_t, int>, AssemblyVector> perLine; ///< of each scan: the jitter of a line is shared by its cells
    std::size_t cells = 0;
};

Normal normalOf(std::vector<Pass>& passes, View view, const AssemblyErrors& errors, std::vector<SurfaceFits>& fits) {
    Normal normal;
    normal.right = -normal.matrix * vectorOf(errors);
    std::vector<std::vector<Residual>> all;
    std::vector<Residual> together;
    for (std::size_t p = 0; p < passes.size(); ++p) {
        all.push_back(residualsOf(passes[p].sweep, fits[p], passes[p].cells[static_cast<std::size_t>(view)], view, errors));
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
            auto [line, fresh] = normal.perLine.try_emplace({p, r.line}, AssemblyVector::Zero());
            line->second += w * e * slope;
            ++normal.cells;
        }
    }
    return normal;
}

std::vector<SurfaceFits> fitsOf(const std::vector<Pass>& passes, int halfWidth) {
    std::vector<SurfaceFits> fits;
    for (const Pass& pass : passes) fits.emplace_back(pass.sweep.inverse, halfWidth);
    return fits;
}

/// Nothing: given up.
std::optional<Solved> solve(std::vector<Pass>& passes, View view, const CalibrationProgress& goOn) {
    const char* stage = view == View::Early ? "early cells on late surfaces" : "late cells on early surfaces";
    constexpr double kAll = kIterations[0] + kIterations[1];
    int done = 0;
    Solved solved;
    AssemblyVector q = AssemblyVector::Zero();
    Normal normal;
    for (std::size_t level = 0; level < kHalfWidths.size(); ++level) {
        std::vector<SurfaceFits> fits = fitsOf(passes, kHalfWidths[level]);
        for (int iteration = 0; iteration < kIterations[level]; ++iteration) {
            if (!goOn(stage, done++ / kAll)) return std::nullopt;
            normal = normalOf(passes, view, solved.errors, fits);
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
    for (const auto& [line, g] : normal.perLine) middle += g * g.transpose();
    solved.covariance = inverse * middle * inverse;
    solved.cells = normal.cells;
    return solved;
}

struct Agreement {
    double medianMm = 0;
    double noiseMm = 0;
};

Agreement agreementOf(std::vector<Pass>& passes, const AssemblyErrors& errors) {
    std::vector<double> apart, sigma;
    std::vector<SurfaceFits> fits = fitsOf(passes, kHalfWidths.back());
    for (std::size_t p = 0; p < passes.size(); ++p) {
        for (const View view : {View::Early, View::Late}) {
            for (const Residual& r : residualsOf(passes[p].sweep, fits[p], passes[p].cells[static_cast<std::size_t>(view)], view, errors)) {
                apart.push_back(std::abs(r.apartMm));
                sigma.push_back(r.sigmaMm);
            }
        }
    }
    constexpr double kMedianOfNormal = 0.6745;
    return {median(std::move(apart)), kMedianOfNormal * median(std::move(sigma))};
}

std::optional<Error> refusalOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr)
        return Error{"this cloud does not say at which angles its points were measured", scan.name,
                     "calibrate with a scan of the scanner itself"};
    if (polar->axis == Axis::Sweep)
        return Error{"the axis lies in the fan: nearly nothing is seen twice, and no error of the assembly can be told from it", scan.name,
                     "mount the scanner to spin for the calibration"};
    const double overlap = turnOf(*polar) - 180.0;
    if (overlap < kLeastOverlapDeg)
        return Error{"the stepper turned " + fixedText(turnOf(*polar), 1) + " degrees, so too little is seen twice", scan.name,
                     "turn 200 degrees once for the calibration; the first 20 are then measured a second time"};
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

Result<SelfCalibration> calibrateFromTurn(std::span<const std::shared_ptr<const Scan>> scans, const CalibrationProgress& told) {
    if (scans.empty()) return Error{"there is no scan to calibrate with", "", "name one"};
    const CalibrationProgress goOn = [&](const char* stage, double fraction) { return !told || told(stage, fraction); };
    const std::string where = scans.front()->name;
    const Error cancelled{"cancelled", where, ""};
    std::vector<Pass> passes;
    SelfCalibration result;
    result.overlapDeg = std::numeric_limits<double>::infinity();
    for (const auto& scan : scans) {
        if (const auto refusal = refusalOf(*scan)) return *refusal;
        if (!goOn("surfaces seen twice", static_cast<double>(passes.size()) / static_cast<double>(scans.size()))) return cancelled;
        const auto& polar = std::get<PolarGeometry>(scan->geometry);
        Pass pass{turnedSweep(*scan, polar), {}};
        for (const View view : {View::Early, View::Late})
            pass.cells[static_cast<std::size_t>(view)] = cellsSeenTwice(polar, pass.sweep.inverse, view, kCells);
        result.overlapDeg = std::min(result.overlapDeg, turnOf(polar) - 180.0);
        passes.push_back(std::move(pass));
    }
    const std::optional<Solved> early = solve(passes, View::Early, goOn);
    const std::optional<Solved> late = early ? solve(passes, View::Late, goOn) : std::nullopt;
    if (!late || !goOn("agreement of the views", 0.0)) return cancelled;
    result.cells = early->cells + late->cells;
    if (result.cells < kFewestCells)
        return Error{"only " + std::to_string(result.cells) + " cells lie on smooth surfaces that both views saw", where,
                     "scan a place with rocks or walls within the scanner's reach"};
    for (std::size_t n = 0; n < AssemblyErrors::kCount; ++n)
        result.errors.values[n] = 0.5 * (early->errors.values[n] + late->errors.values[n]);
    result.sd = uncertaintyOf(*early, *late, result.overlapDeg + 180.0 < kFullTurnDeg ? kHonestPart : kHonestFull);
    result.medianBeforeMm = agreementOf(passes, {}).medianMm;
    const Agreement after = agreementOf(passes, result.errors);
    result.medianAfterMm = after.medianMm;
    result.noiseMm = after.noiseMm;
    if (after.medianMm > kAgreed * after.noiseMm)
        return Error{"the two views still lie " + fixedText(after.medianMm, 1) + " mm apart where noise explains " +
                         fixedText(after.noiseMm, 1),
                     where, "see that nothing moved during the scan, and scan again"};
    for (std::size_t n = 0; n < AssemblyErrors::kCount; ++n) {
        if (result.sd.values[n] <= 0.5 * kPrior[static_cast<Eigen::Index>(n)]) continue;
        return Error{std::string(kNames[n]) + " stays unknown: what is seen twice is too plain", where,
                     "scan a place with rocks, or turn the full 360 degrees"};
    }
    return result;
}

Grid<float> viewsApartMm(const Scan& scan, const AssemblyErrors& errors) {
    Grid<float> apart(scan.lines(), scan.beams(), std::numeric_limits<float>::quiet_NaN());
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || refusalOf(scan)) return apart;
    const TurnedSweep sweep = turnedSweep(scan, *polar);
    SurfaceFits fits(sweep.inverse, kHalfWidths.back());
    const std::vector<SeenCell> cells = cellsSeenTwice(*polar, sweep.inverse, View::Late, scan.cells());
    for (const Residual& r : residualsOf(sweep, fits, cells, View::Late, errors)) apart.at(r.line, r.beam) = static_cast<float>(r.apartMm);
    return apart;
}

} // namespace edgescan
