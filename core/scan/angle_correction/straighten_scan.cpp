// Converts displacements in index steps to angles.
#include "core/scan/angle_correction/straighten_scan.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/angle_correction/line_phases.h"
#include "core/scan/angle_correction/step_unevenness.h"
#include "core/scan/angle_correction/sureness.h"
#include "core/scan/grid/mean_step.h"
#include "core/scan/grid/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan {
namespace {

struct Parity {
    double steps = 0;  // index steps: median of the lines that show a displacement; 0 if no line shows one, or if chance explains it
    double surest = 0; // divided by its standard deviation
};

Parity parityOf(const std::vector<float>& parity) {
    std::vector<double> shown;
    std::copy_if(parity.begin(), parity.end(), std::back_inserter(shown), [](float steps) { return steps != 0; });
    const double middle = median(shown);
    const std::size_t lines = shown.size();
    for (double& steps : shown) steps -= middle;
    const double surest = std::abs(middle) / sdOfMedian(std::move(shown), lines);
    return surest >= kSignificantSds ? Parity{middle, surest} : Parity{};
}

void moveBeams(PolarGeometry& polar, double displacementDeg) {
    polar.lineSkewDeg.resize(polar.beamDeg.size());
    for (std::size_t j = 0; j < polar.lineSkewDeg.size(); ++j) polar.lineSkewDeg[j] += (j % 2 == 1 ? 0.5 : -0.5) * displacementDeg;
}

void moveLines(PolarGeometry& polar, const std::vector<double>& slipSteps, double stepDeg) {
    double shiftDeg = 0;
    for (std::size_t i = 0; i + 1 < polar.lineDeg.size(); ++i) {
        shiftDeg += slipSteps[i] * stepDeg;
        polar.lineDeg[i + 1] += shiftDeg;
    }
}

// How wrong the angles of a sweep are, according to its surfaces.
struct Displacement {
    double stepDeg = 0;            // from line to line
    double oddAheadDeg = 0;        // odd beams against even ones
    double oddSurest = 0;          // divided by its standard deviation
    std::vector<double> slipSteps; // `lines` values: excess of the step to the next line, index steps
    int slipCount = 0;             // number of values of slipSteps that are not 0
    double uneven = 0;             // normal difference between steps, index steps
    double surest = 0;             // the largest slip, index steps
    int turnedSteps = 0;           // steps at which the stepper swung back
    int left = 0;                  // slips on which even and odd beams disagree
};

// A measured displacement minus what the angles already contain; 0 where both agree within the accuracy of the measurement.
double beyond(double measured, double allowed, double agree) {
    return allowed != 0 && std::abs(measured - allowed) < agree ? 0.0 : measured - allowed;
}

// By how many degrees the recorded angles have odd beams ahead of even ones.
double oddSkewDeg(const PolarGeometry& polar) {
    const std::size_t pairs = polar.lineSkewDeg.size() / 2;
    double sum = 0;
    for (std::size_t n = 0; n < pairs; ++n) sum += polar.lineSkewDeg[2 * n + 1] - polar.lineSkewDeg[2 * n];
    return pairs == 0 ? 0.0 : sum / static_cast<double>(pairs);
}

double medianStepDeg(const std::vector<double>& lineDeg) {
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < lineDeg.size(); ++i) steps.push_back(lineDeg[i + 1] - lineDeg[i]);
    return median(std::move(steps));
}

// A stall and the leap that makes up for it belong together. The largest slip of a sweep proves all of them; without such proof EdgeScan
// reports no slip.
void dropUnproved(Displacement& found) {
    for (const double steps : found.slipSteps) found.surest = std::max(found.surest, std::abs(steps));
    if (found.surest < kSignificantSds * found.uneven) std::ranges::fill(found.slipSteps, 0.0);
}

Displacement displacementOf(InverseRange inverse, const PolarGeometry& polar) {
    constexpr double kAgreeBeams = 0.35; // index steps
    constexpr double kAgreeLines = 0.75;
    const SweepSlips slips = straighten(inverse);
    Displacement found;
    found.stepDeg = meanStepDeg(polar.lineDeg);
    if (slips.interlaced) {
        const Parity odd = parityOf(slips.parity);
        found.oddAheadDeg = beyond(odd.steps * found.stepDeg, oddSkewDeg(polar), kAgreeBeams * std::abs(found.stepDeg));
        found.oddSurest = odd.surest;
    }
    found.turnedSteps = static_cast<int>(std::ranges::count(slips.turned, std::uint8_t{1}));
    found.uneven = slips.slipCount > 0 ? static_cast<double>(stepUnevenness(inverse)) : 0.0;
    const double usualDeg = medianStepDeg(polar.lineDeg);
    found.slipSteps.resize(polar.lineDeg.size());
    for (std::size_t i = 0; i + 1 < polar.lineDeg.size(); ++i) {
        const double even = static_cast<double>(slips.measured[0][i]);
        const double odd = static_cast<double>(slips.measured[1][i]);
        if (even * odd <= 0) {
            found.left += even != 0 || odd != 0 ? 1 : 0;
            continue;
        }
        const double allowed = usualDeg == 0 ? 0.0 : (polar.lineDeg[i + 1] - polar.lineDeg[i]) / usualDeg - 1;
        found.slipSteps[i] = beyond(0.5 * (even + odd), std::abs(allowed) < 0.1 ? 0.0 : allowed, kAgreeLines);
    }
    dropUnproved(found);
    found.slipCount = static_cast<int>(std::ranges::count_if(found.slipSteps, [](double steps) { return steps != 0; }));
    return found;
}

const PolarGeometry* anglesOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    return polar != nullptr && polar->lineDeg.size() >= 2 ? polar : nullptr;
}

std::string degreesText(double deg) { return withValues("%1 degrees", {deg < 0.1 ? significantText(deg, 2) : fixedText(deg, 2)}); }

// ", 40 times its uncertainty"
std::string sureText(double surest) { return withValues(", %1 times its uncertainty", {fixedText(std::floor(surest), 0)}); }

// "odd beams lie 0.12 degrees ahead of even ones"
std::string interlaceText(double oddAheadDeg, double surest) {
    return withValues(oddAheadDeg > 0 ? "odd beams lie %1 ahead of even ones%2" : "odd beams lie %1 behind even ones%2",
                      {degreesText(std::abs(oddAheadDeg)), sureText(surest)});
}

std::string slipText(const Displacement& found) {
    const auto slipped = [](double steps) { return steps != 0; };
    const auto first = std::find_if(found.slipSteps.begin(), found.slipSteps.end(), slipped) - found.slipSteps.begin();
    double most = 0;
    for (const double steps : found.slipSteps) most = std::max(most, std::abs(steps * found.stepDeg));
    const std::string sure = found.uneven > 0 ? withValues(", %1 times the usual unevenness of its steps",
                                                           {fixedText(std::floor(found.surest / found.uneven), 0)})
                                              : "";
    return withValues("the stepper slipped at %1 (first at line %2, by up to %3%4)",
                      {counted(static_cast<std::size_t>(found.slipCount), "line"), first + 1, degreesText(most), sure});
}

// Empty if nothing is displaced.
std::string displacementText(const Displacement& found) {
    std::string text;
    if (found.oddAheadDeg != 0) text = interlaceText(found.oddAheadDeg, found.oddSurest);
    if (found.slipCount > 0) text = text.empty() ? slipText(found) : withValues("%1, and %2", {text, slipText(found)});
    return text;
}

/// Phases of the lines of a cycle. Empty for scans with a pose per line or with points behind other points: these could not be merged along
/// with the lines.
LinePhases phasesIn(const Scan& scan, const InverseRange& inverse) {
    if ((scan.placement && scan.placement->poses.size() > 1) || !scan.attached.empty()) return {};
    return linePhases(inverse);
}

// "the beams of 4 lines in turn lie 0, 0.25, 0.5 and 0.75 degrees ahead of them"
std::string phasesText(const LinePhases& found, const PolarGeometry& polar) {
    const std::vector<double>& phases = found.steps;
    const double stepDeg = std::abs(meanStepDeg(polar.beamDeg));
    std::string first; // all but the last
    for (std::size_t k = 0; k + 1 < phases.size(); ++k) first += (k == 0 ? "" : ", ") + significantText(phases[k] * stepDeg, 3);
    return withValues("the beams of %1 lines in turn lie %2 and %3 degrees ahead of where they should be%4",
                      {phases.size(), first, significantText(phases.back() * stepDeg, 3), sureText(found.significance)});
}

// A sentence about the lines at which the stepper turned; empty if it did not.
std::string turnText(const Displacement& found) {
    if (found.turnedSteps == 0) return "";
    return withValues(" At %1 of the first and last lines the stepper still swung back: folds there are left out.", {found.turnedSteps});
}

constexpr const char* kDisplaced = "Not measured at the angles that the file gives: ";

} // namespace

Scan straightened(Scan scan) {
    if (anglesOf(scan) == nullptr) {
        scan.warnings.emplace_back("Not straightened: the scan has no lines with angles.");
        return scan;
    }
    InverseRange inverse = inverseRange(scan);
    if (const auto phases = phasesIn(scan, inverse); !phases.steps.empty()) {
        Scan folded = withPhasesFolded(scan, phases.steps);
        folded.warnings.push_back(withValues("Straightened: %1, and were put side by side: %2 lines make one.",
                                             {phasesText(phases, std::get<PolarGeometry>(scan.geometry)), phases.steps.size()}));
        return folded;
    }
    auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    const Displacement found = displacementOf(std::move(inverse), *polar);
    if (found.oddAheadDeg != 0) moveBeams(*polar, found.oddAheadDeg);
    moveLines(*polar, found.slipSteps, found.stepDeg);
    const std::string text = displacementText(found);
    if (!text.empty())
        scan.warnings.push_back(withValues("Straightened: %1.%2", {text, turnText(found)}));
    else if (found.left == 0)
        scan.warnings.emplace_back("Straightened: no interlaced beams and no slips were found; the angles stay.");
    if (found.left > 0)
        scan.warnings.push_back(counted(static_cast<std::size_t>(found.left),
                                        "slip was seen in every second beam only, and is left as it is.",
                                        "slips were seen in every second beam only, and are left as they are."));
    return scan;
}

std::optional<std::string> displacementWarning(const Scan& scan) {
    const PolarGeometry* polar = anglesOf(scan);
    if (polar == nullptr) return std::nullopt;
    InverseRange inverse = inverseRange(scan);
    if (const auto phases = phasesIn(scan, inverse); !phases.steps.empty()) {
        return kDisplaced + phasesText(phases, *polar) +
               "; edges across the lines are combed: --straighten (Scan > Straighten Beams) puts these lines side by side as one.";
    }
    const Displacement found = displacementOf(std::move(inverse), *polar);
    const std::string text = displacementText(found);
    if (text.empty()) return std::nullopt;
    return kDisplaced + text +
           "; EdgeScan+ allows for it, but the cloud does not: --straighten (Scan > Straighten Beams) corrects the angles." +
           turnText(found);
}

bool isDisplacementWarning(const std::string& warning) { return warning.starts_with(kDisplaced); }

} // namespace edgescan
