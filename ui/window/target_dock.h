// Where the panel of targets stands in the window: it comes with the first target.
#pragma once

class QMainWindow;

namespace edgescan::ui {

class Targets;
class TargetsPanel;

void addTargetDock(QMainWindow& window, Targets& targets, TargetsPanel& panel);

} // namespace edgescan::ui
