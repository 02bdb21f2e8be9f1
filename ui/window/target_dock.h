// The dock of targets: it opens with the first target.
#pragma once

class QMainWindow;

namespace edgescan::ui {

class Targets;
class TargetsPanel;

void addTargetDock(QMainWindow& window, Targets& targets, TargetsPanel& panel);

} // namespace edgescan::ui
