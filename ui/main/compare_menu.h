// The commands of A/B and where its legend stands.
#pragma once

#include "ui/control/commands.h"

namespace edgescan::ui {

class MainWindow;

[[nodiscard]] Command compareMenu(MainWindow& window);

/// Over the cloud, above the legend of the edges, which gives way to it while a difference is shown.
void addChangeLegend(MainWindow& window);

} // namespace edgescan::ui
