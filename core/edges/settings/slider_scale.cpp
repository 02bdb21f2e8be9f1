// The scale of a slider.
#include "core/edges/settings/slider_scale.h"

#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr int kPlaces = 200; // values along the slider

// A slider with more steps than pixels cannot reach every value, so such scales are stretched at the small end.
double bend(const Parameter& p) {
    const double steps = (p.sliderMaximum - p.minimum) / p.step;
    return steps > 1000.0 ? 3.0 : steps > 250.0 ? 2.0 : 1.0;
}

} // namespace

int sliderPosition(const Parameter& p, double value) {
    if (!p.choices.empty()) {
        const auto found = std::ranges::find_if(p.choices, [&](const Choice& c) { return c.value == value; });
        return static_cast<int>(found - p.choices.begin());
    }
    const double share = std::clamp((value - p.minimum) / (p.sliderMaximum - p.minimum), 0.0, 1.0);
    return static_cast<int>(std::lround(std::pow(share, 1.0 / bend(p)) * kSliderSteps));
}

double sliderValue(const Parameter& p, int position) {
    if (!p.choices.empty()) return p.choices[static_cast<std::size_t>(position)].value;
    const double share = std::pow(static_cast<double>(position) / kSliderSteps, bend(p));
    const double value = p.minimum + share * (p.sliderMaximum - p.minimum);
    return snapped(p, p.minimum + std::round((value - p.minimum) / p.step) * p.step);
}

std::vector<double> sliderValues(const Parameter& parameter) {
    std::vector<double> values;
    for (int n = 0; n <= kPlaces; ++n) {
        const double value = sliderValue(parameter, n * kSliderSteps / kPlaces);
        if (values.empty() || value > values.back()) values.push_back(value);
    }
    return values;
}

} // namespace edgescan::edges
