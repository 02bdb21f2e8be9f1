// Chooses how many points a frame draws within its time.
#include "ui/views/cloud/drawing_budget.h"

#include "ui/views/cloud/cloud_geometry.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr std::size_t kRemembered = 12;
constexpr double kLeastSlope = 0.6; // of the slope that holds if all of the time is due to the points

} // namespace

DrawingBudget::DrawingBudget(double allPointsMs) { restart(allPointsMs); }

void DrawingBudget::restart(double allPointsMs) {
    drawings_.clear();
    base_ = 0.0;
    slope_ = allPointsMs;
}

void DrawingBudget::measured(double fraction, double ms) {
    drawings_.push_back({fraction, ms});
    if (drawings_.size() > kRemembered) drawings_.pop_front();
    fit();
}

void DrawingBudget::grown(double share) {
    for (Drawing& drawing : drawings_) drawing.fraction *= share;
    slope_ /= share;
}

void DrawingBudget::fit() {
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    double weight = 1.0; // older frames have less weight: the load of the machine may have changed
    for (auto drawing = drawings_.rbegin(); drawing != drawings_.rend(); ++drawing, weight *= 0.8) {
        n += weight;
        sx += weight * drawing->fraction;
        sy += weight * drawing->ms;
        sxx += weight * drawing->fraction * drawing->fraction;
        sxy += weight * drawing->fraction * drawing->ms;
    }
    const double meanX = sx / n;
    const double meanY = sy / n;
    const double varX = sxx / n - meanX * meanX;
    const double measuredSlope = varX > 0.01 * meanX * meanX ? (sxy / n - meanX * meanY) / varX : 0.0;
    // Frames with similar or noisy times must not lead to the conclusion that more points cost almost nothing.
    slope_ = std::clamp(measuredSlope, kLeastSlope * meanY / meanX, meanY / meanX);
    base_ = meanY - slope_ * meanX;
}

double DrawingBudget::expectedMs(double fraction) const { return base_ + slope_ * fraction; }

int DrawingBudget::lastPart(bool moving) const {
    const double aim = moving ? kMovingMs : kRestMs;
    int last = 0;
    while (last + 1 < kCloudParts && expectedMs(kPartEnds[static_cast<std::size_t>(last) + 1]) <= aim) ++last;
    return last;
}

} // namespace edgescan::ui
