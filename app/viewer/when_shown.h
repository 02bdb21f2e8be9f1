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

/// Once the first picture of so many lines is shown and the cloud has come to rest; the application ends then, with 1 where there is none.
void screenshotWhenShown(ui::MainWindow& window, const std::string& path, int lines, bool live);

} // namespace edgescan::viewer
