// The commands of A/B and of edge confidence, and where their legends stand.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class Comparing;
class Confidence;
class MainWindow;

[[nodiscard]] Command compareMenu(Comparing& comparing);

/// Over the cloud, above the legend of the edges, which gives way to it while a difference is shown.
void addChangeLegend(MainWindow& window);

/// Edge confidence: its switch, and its legend in the same place, which gives way to a difference.
[[nodiscard]] Command confidenceCommand(Confidence& confidence);
void addConfidenceLegend(MainWindow& window);

} // namespace edgescan::ui
