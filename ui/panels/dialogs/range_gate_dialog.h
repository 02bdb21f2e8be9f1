// Asks for the range gate: cells outside it are not drawn.
#pragma once

#include <optional>

class QWidget;

namespace edgescan::ui {

struct RangeGate {
    double nearM = 0.0;
    double farM = 0.0;
};

/// Starts with these values, rounded outwards to centimetres. Empty if the operator cancelled.
[[nodiscard]] std::optional<RangeGate> askForRangeGate(QWidget* parent, double nearM, double farM);

} // namespace edgescan::ui
