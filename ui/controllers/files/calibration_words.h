// What a calibration found, in the words of the window.
#pragma once

#include "core/inspect/calibration/self_calibration.h"
#include "ui/panels/dialogs/calibration_card.h"

#include <array>

namespace edgescan::ui {

/// All but the pictures.
[[nodiscard]] CalibrationShown calibrationWords(const SelfCalibration& found);
/// Over the seam's edges; `met`: share of the late edges beside an early one, before and after. The images are not set.
[[nodiscard]] CalibrationPicture seamWords(std::size_t lateEdges, const std::array<double, 2>& met);
/// Over the distance of the views.
[[nodiscard]] CalibrationPicture apartWords(const SelfCalibration& found);

} // namespace edgescan::ui
