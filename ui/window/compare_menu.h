// The commands of the A/B comparison and of edge confidence.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class Comparing;
class Confidence;
class MainWindow;

[[nodiscard]] Command compareMenu(Comparing& comparing);

/// Hides the legend of edges while a difference is shown.
void followChanges(MainWindow& window);

/// The switch of edge confidence.
[[nodiscard]] Command confidenceCommand(Confidence& confidence);

} // namespace edgescan::ui
