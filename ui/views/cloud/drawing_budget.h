// How many points to draw so that a frame stays within its time, learnt from the frames so far.
#pragma once

#include <deque>

namespace edgescan::ui {

/// Fits time = base + slope x fraction to the last frames. Pure: knows no clock and no view.
class DrawingBudget {
public:
    static constexpr double kMovingMs = 26.0; ///< aim while a hand moves the camera or a slider; the worker needs its share of the cores
    static constexpr double kRestMs =
        80.0; ///< aim for the still picture; leaves room for jitter: nothing on the GUI thread may take 100 ms

    /// `allPointsMs`: first guess of the time for all points, ms; a guess on the safe side keeps the first frame short.
    explicit DrawingBudget(double allPointsMs = 150.0);

    void measured(double fraction, double ms);
    /// Index into kPartEnds: draw parts 0 .. index.
    [[nodiscard]] int lastPart(bool moving) const;
    [[nodiscard]] double expectedMs(double fraction) const;
    /// The same scan with more points: what was a share of them is now `share` times that share of all.
    void grown(double share);
    /// A new scan: forget the frames of the old one.
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
