// What is done once the first picture is on the screen.
#pragma once

#include <QString>

#include <string>
#include <vector>

namespace edgescan::ui {
class MainWindow;
}

namespace edgescan::viewer {

struct PinnedPlace {
    int line = 0, beam = 0;
};
/// On the first picture; the last one has the card. A place that the scan does not have is told.
void pinWhenShown(ui::MainWindow& window, const std::vector<PinnedPlace>& places);

void compareWhenShown(ui::MainWindow& window, const QString& before);

struct WantedPicture {
    std::string path;   ///< of the PNG
    int lines = 1;      ///< of the scan, at least
    bool live = false;  ///< more lines may come
    std::string before; ///< the earlier scan that it is to be compared with; empty: none
};
/// Once so many lines are shown and the cloud has come to rest; the application ends then, with 1 where there is no picture or no
/// comparison.
void screenshotWhenShown(ui::MainWindow& window, const WantedPicture& wanted);

} // namespace edgescan::viewer
