// The commands of the A/B comparison and of edge confidence, and the places of their legends.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class Comparing;
class Confidence;
class MainWindow;

[[nodiscard]] Command compareMenu(Comparing& comparing);

/// Over the cloud, above the legend of the edges, which is hidden while a difference is shown.
void followChanges(MainWindow& window);

/// Edge confidence: its switch, and its legend at the same place; hidden while a difference is shown.
[[nodiscard]] Command confidenceCommand(Confidence& confidence);

} // namespace edgescan::ui
