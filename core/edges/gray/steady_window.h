// Fixes the range window of the gray levels while a sweep grows. Otherwise the levels would follow every new line and flicker.
#pragma once

#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

namespace edgescan::edges {

class SteadyWindow {
public:
    /// The settings with fixed values for near and far, if these are automatic. The thesis's scaling becomes the same scaling with a window
    /// from 0. The window is checked again when the number of lines has doubled, and changes only if it is wrong by more than a tenth.
    [[nodiscard]] Settings fix(const Scan& scan, const Settings& settings);

    /// The next scans belong to another sweep: it begins with the current window, which is checked again soon.
    void nextSweep();

private:
    Settings asked_, fixed_; // only the method and the settings for gray levels
    int lookedAt_ = 0;       // number of lines at the last check; 0: never
};

} // namespace edgescan::edges
