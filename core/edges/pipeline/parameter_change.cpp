// The effect of changing one parameter on the others.
#include "core/edges/pipeline/parameter_change.h"

#include "core/edges/pipeline/step_meaning.h"

#include <algorithm>

namespace edgescan::edges {

Settings withParameterChanged(const Settings& before, const Parameter& parameter, double value, const Settings& lastGray) {
    constexpr double kApartMm = 1.0;
    Settings settings = before;
    parameter.set(settings, value);
    if (settings.method != before.method) settings.lower = lowerWithSameStep(lastGray, settings);
    if (checkSettings(settings)) return settings;
    if (settings.farMm != before.farMm) settings.nearMm = std::max(0.0, settings.farMm - kApartMm);
    if (!checkSettings(settings)) settings.farMm = settings.nearMm + kApartMm;
    return settings;
}

} // namespace edgescan::edges
