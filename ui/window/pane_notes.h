// What stands beside the titles of the views: how much of the scan each one shows, and how.
#pragma once

namespace edgescan::ui {

class MainWindow;
class Pane;

/// Keeps them true from now on.
void keepPaneNotes(MainWindow& window, Pane& range, Pane& edges, Pane& cloud);

} // namespace edgescan::ui
