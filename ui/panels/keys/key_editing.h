// Help > Change Keys.
#pragma once

class QWidget;

namespace edgescan::ui {

class Memory;

/// Shows the table of the window's commands. Changes are valid at once and are remembered.
void editKeys(QWidget& window, Memory& memory);

} // namespace edgescan::ui
