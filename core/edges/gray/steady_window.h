// Keeps the range window of the gray levels while a sweep grows: levels that follow every new line would flicker.
#pragma once

#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

namespace edgescan {

class SteadyWindow {
public:
    /// The settings with near and far fixed where they would follow the ranges of the scan; the thesis's scaling becomes the same scaling
    /// by a window from 0. The window is looked at again when the lines have doubled, and changes only when it is more than a tenth off.
    [[nodiscard]] Settings fix(const Scan& scan, const Settings& settings);

    /// The scans that follow belong to another sweep: it begins with the window there is, and that is looked at again soon.
    void nextSweep();

private:
    Settings asked_, fixed_; // nothing but what makes gray of ranges
    int lookedAt_ = 0;       // lines; 0: never
};

} // namespace edgescan
