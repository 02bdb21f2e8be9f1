// Chooses how many points a frame draws within its time, from measured frames.
#pragma once

#include <deque>

namespace edgescan::ui {

/// Fits time = base + slope x fraction to the last frames. Pure: uses no clock and no view.
class DrawingBudget {
public:
    static constexpr double kMovingMs = 26.0; ///< target while the camera or a slider moves; the worker needs its share of the cores
    static constexpr double kRestMs =
        80.0; ///< target for the still picture, with a margin for jitter: each step on the GUI thread must take less than 100 ms

    /// `allPointsMs`: first estimate of the time for all points, ms; a high value keeps the first frame short.
    explicit DrawingBudget(double allPointsMs = 150.0);

    void measured(double fraction, double ms);
    /// Index into kPartEnds: draw the parts 0 .. index.
    [[nodiscard]] int lastPart(bool moving) const;
    [[nodiscard]] double expectedMs(double fraction) const;
    /// The same scan has more points now: a former share s of the points is now `share` x s.
    void grown(double share);
    /// A new scan: drops the measured frames of the old one.
    void restart(double allPointsMs = 150.0);

private:
    struct Drawing {
        double fraction;
        double ms;
    };
    void fit();

    std::deque<Drawing> drawings_;
    double base_ = 0.0;
    double slope_ = 150.0;
};

} // namespace edgescan::ui
