// The result of a calibration in the words of the window.
#pragma once

#include "core/inspect/calibration/self_calibration.h"
#include "ui/panels/dialogs/calibration_card.h"

#include <array>

namespace edgescan::ui {

/// All parts except the pictures.
[[nodiscard]] CalibrationShown calibrationWords(const inspect::SelfCalibration& found);
/// About the edges at the seam; `met`: share of the late edges within a cell of an early one, before and after. The images are not set.
[[nodiscard]] CalibrationPicture seamWords(std::size_t lateEdges, const std::array<double, 2>& met);
/// About the distance between the views.
[[nodiscard]] CalibrationPicture apartWords(const inspect::SelfCalibration& found);

} // namespace edgescan::ui
