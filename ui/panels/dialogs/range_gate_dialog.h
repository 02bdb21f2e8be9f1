// Asks between which ranges cells are drawn.
#pragma once

#include <optional>

class QWidget;

namespace edgescan::ui {

struct RangeGate {
    double nearM = 0.0;
    double farM = 0.0;
};

/// Starts with these, to the outside rounded centimetres. Empty when it was cancelled.
[[nodiscard]] std::optional<RangeGate> askForRangeGate(QWidget* parent, double nearM, double farM);

} // namespace edgescan::ui
