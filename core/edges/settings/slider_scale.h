// The scale of a slider: from a position to a value of its parameter and back.
#pragma once

#include <vector>

namespace edgescan::edges {

struct Parameter;

/// Positions run from 0 to kSliderSteps. Large ranges of values have a finer scale at the small end.
inline constexpr int kSliderSteps = 1000;
[[nodiscard]] int sliderPosition(const Parameter& parameter, double value);
[[nodiscard]] double sliderValue(const Parameter& parameter, int position);
/// The values at evenly spaced positions, ascending, without duplicates: the thresholds of the edge-count curve under a slider.
[[nodiscard]] std::vector<double> sliderValues(const Parameter& parameter);

} // namespace edgescan::edges
