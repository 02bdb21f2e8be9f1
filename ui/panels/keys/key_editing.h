// Help > Change Keys.
#pragma once

class QWidget;

namespace edgescan::ui {

class Preferences;

/// Shows the table of the window's commands. Changes are valid at once and are remembered.
void editKeys(QWidget& window, Preferences& preferences);

} // namespace edgescan::ui
