// The docks of rocks: panel and table are shown and hidden with the rocks.
#pragma once

class QMainWindow;

namespace edgescan::ui {

class Rocks;
class RocksPanel;
class RockTable;

void addRockDocks(QMainWindow& window, Rocks& rocks, RocksPanel& panel, RockTable& table);

} // namespace edgescan::ui
