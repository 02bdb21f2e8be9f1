// Actions after the first picture is on the screen.
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
/// Sets targets on the first picture; the card of the last one is shown. Reports a place that is outside the scan.
void pinWhenShown(ui::MainWindow& window, const std::vector<PinnedPlace>& places);

void compareWhenShown(ui::MainWindow& window, const QString& before);

struct WantedPicture {
    std::string path;   ///< of the PNG
    int lines = 1;      ///< of the scan, minimum
    bool live = false;  ///< more lines may follow
    std::string before; ///< the earlier scan for a comparison; empty: no comparison
};
/// Takes the screenshot when enough lines are shown and the cloud is still, then ends the application; with exit code 1 if the picture or
/// the comparison is missing.
void screenshotWhenShown(ui::MainWindow& window, const WantedPicture& wanted);

} // namespace edgescan::viewer
