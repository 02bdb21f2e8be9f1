// Help > Change Keys.
#pragma once

class QWidget;

namespace edgescan::ui {

class Memory;

/// Shows the table of the window's commands; what is changed in it counts at once and is remembered.
void editKeys(QWidget& window, Memory& memory);

} // namespace edgescan::ui
