// The menus of the tools: rocks and measuring.
#pragma once

#include "ui/panels/keys/commands.h"

class QMainWindow;

namespace edgescan::ui {

struct Viewer;

[[nodiscard]] Command rocksMenu(Viewer& v, QMainWindow& window);
[[nodiscard]] Command measureMenu(Viewer& v);

} // namespace edgescan::ui
