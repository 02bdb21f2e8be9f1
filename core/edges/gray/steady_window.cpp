// Range windows of growing sweeps.
#include "core/edges/gray/steady_window.h"

#include "core/edges/gray/gray.h"

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr int kFirstLook = 16;       // number of lines of a sweep after which a window of the sweep before is checked
constexpr double kWindowShare = 0.1; // tolerated error of a limit, as a share of it

void copyWindow(Settings& to, const Settings& from) {
    to.scaling = from.scaling;
    to.nearMm = from.nearMm;
    to.farMm = from.farMm;
}

Settings windowNow(const Scan& scan, const Settings& asked) {
    Settings now = asked;
    const GrayScale scale = grayScale(scan, asked);
    if (asked.scaling == Scaling::Thesis) now.scaling = Scaling::Window;
    now.nearMm = scale.nearMm;
    now.farMm = scale.farMm;
    return now;
}

bool near(double a, double b) { return std::abs(a - b) <= kWindowShare * std::max(std::abs(a), std::abs(b)); }

} // namespace

Settings SteadyWindow::fix(const Scan& scan, const Settings& settings) {
    Settings asked;
    asked.method = settings.method; // a window that no threshold reads is narrower
    copyWindow(asked, settings);
    const bool known = lookedAt_ > 0 && asked_ == asked;
    if (!known || scan.lines() >= 2 * lookedAt_) {
        const Settings now = windowNow(scan, asked);
        if (!known || !near(now.nearMm, fixed_.nearMm) || !near(now.farMm, fixed_.farMm)) fixed_ = now;
        asked_ = asked;
        lookedAt_ = std::max(1, scan.lines());
    }
    Settings fixed = settings;
    copyWindow(fixed, fixed_);
    return fixed;
}

void SteadyWindow::nextSweep() { lookedAt_ = std::min(lookedAt_, kFirstLook / 2); }

} // namespace edgescan::edges
