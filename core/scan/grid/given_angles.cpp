// Applies angles and mounting given by the operator.
#include "core/scan/grid/given_angles.h"

#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

namespace edgescan {
namespace {

void useAngles(std::vector<double>& degrees, std::optional<double> start, std::optional<double> step) {
    if (degrees.empty() || (!start && !step)) return;
    const double first = start.value_or(degrees.front());
    const double shift = first - degrees.front();
    for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = step ? first + static_cast<double>(i) * *step : degrees[i] + shift;
}

/// The first angle and the step of the file, in ten thousandths of a degree; as given where they are equal within that.
void storeStartAndStep(const std::vector<double>& degrees, std::optional<double> givenStart, std::optional<double> givenStep,
                       std::optional<double>& start, std::optional<double>& step) {
    const auto rounded = [](double of, std::optional<double> given) {
        constexpr double kPerDegree = 1e4;
        return given && std::abs(*given - of) < 1 / kPerDegree ? *given : std::round(of * kPerDegree) / kPerDegree;
    };
    if (degrees.size() < 2) return;
    start = rounded(degrees.front(), givenStart);
    step = rounded((degrees.back() - degrees.front()) / static_cast<double>(degrees.size() - 1), givenStep);
}

void append(std::vector<std::string>& warnings, std::vector<std::string> more) {
    warnings.insert(warnings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

void applyGivenAngles(Scan& scan, const ReadingOptions& options) {
    constexpr std::array<std::string_view, 5> kAngles{"beam-start", "beam-step", "line-start", "line-step", "axis"};
    auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) {
        // The axis decides which grid of its points is taken.
        const std::size_t idle = std::get<PointGeometry>(scan.geometry).angles ? kAngles.size() - 1 : kAngles.size();
        append(scan.warnings, idleOptions(options, std::span(kAngles).first(idle), "the file gives points and not angles"));
        return;
    }
    ReadingOptions file;
    file.axis = polar->axis;
    storeStartAndStep(polar->beamDeg, options.beamStartDeg, options.beamStepDeg, file.beamStartDeg, file.beamStepDeg);
    storeStartAndStep(polar->lineDeg, options.lineStartDeg, options.lineStepDeg, file.lineStartDeg, file.lineStepDeg);
    append(scan.warnings, replacedByOptions(options, file));
    useAngles(polar->beamDeg, options.beamStartDeg, options.beamStepDeg);
    useAngles(polar->lineDeg, options.lineStartDeg, options.lineStepDeg);
    if (options.axis) polar->axis = *options.axis;
}

} // namespace edgescan
