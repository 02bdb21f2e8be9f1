// Notes next to the titles of the views: how much of the scan each view shows, and how.
#pragma once

namespace edgescan::ui {

class MainWindow;
class Pane;

/// Keeps the notes up to date.
void keepPaneNotes(MainWindow& window, Pane& range, Pane& edges, Pane& cloud);

} // namespace edgescan::ui
