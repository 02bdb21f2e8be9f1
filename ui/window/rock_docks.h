// Where panel and table of rocks stand in the window: they come and go with the rocks.
#pragma once

class QMainWindow;

namespace edgescan::ui {

class Rocks;
class RocksPanel;
class RockTable;

void addRockDocks(QMainWindow& window, Rocks& rocks, RocksPanel& panel, RockTable& table);

} // namespace edgescan::ui
