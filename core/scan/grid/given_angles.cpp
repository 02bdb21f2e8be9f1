// Applies angles and mounting given by the operator.
#include "core/scan/grid/given_angles.h"

namespace edgescan {
namespace {

void useAngles(std::vector<double>& degrees, std::optional<double> start, std::optional<double> step) {
    if (degrees.empty() || (!start && !step)) return;
    const double first = start.value_or(degrees.front());
    const double shift = first - degrees.front();
    for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = step ? first + static_cast<double>(i) * *step : degrees[i] + shift;
}

} // namespace

void applyGivenAngles(Scan& scan, const ReadingOptions& options) {
    auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return;
    useAngles(polar->beamDeg, options.beamStartDeg, options.beamStepDeg);
    useAngles(polar->lineDeg, options.lineStartDeg, options.lineStepDeg);
    if (options.axis) polar->axis = *options.axis;
}

} // namespace edgescan
