// The menus of the window as a table of commands.
#pragma once

#include "ui/panels/keys/commands.h"

#include <QImage>

class QMainWindow;

namespace edgescan::ui {

struct Viewer;

/// What the window itself does.
struct WindowCommands {
    std::function<QImage()> screenshot;
    std::function<void()> resetLayout, tour, manual;
    std::vector<Command> sessions;
    Command shares, cab;
    std::function<void()> quit; ///< asks where it must
};

/// One entry per menu of the menu bar, for the window that holds the viewer. Both must outlive everything made from them.
[[nodiscard]] std::vector<Command> menusOf(Viewer& viewer, QMainWindow& window, const WindowCommands& commands);

} // namespace edgescan::ui
