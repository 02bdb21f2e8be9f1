// Edges of a sweep that is still growing: a new line costs a few rows, and the result is that of the whole method.
#pragma once

#include "core/base/result.h"
#include "core/live/live_hysteresis.h"
#include "core/live/live_rows.h"
#include "core/method/detection.h"

namespace edgescan {

/// The settings with near and far fixed as they are for this scan now, so that gray levels stay as they are while it grows. The scaling
/// of the thesis becomes the same scaling by a window from 0.
[[nodiscard]] Settings withFixedWindow(const Settings& settings, const Scan& scan);

/// Result after every update: exactly that of detectEdges() with the same settings on the same scan. Not for several threads at once.
class LiveEdges {
public:
    /// Error: a method other than Canny; near or far is automatic, or the scaling is one that depends on all ranges: use withFixedWindow()
    /// first.
    static Result<LiveEdges> make(const Settings& settings);

    /// Takes the lines that are new in `scan`; earlier ones must be as they were. A scan that does not continue the last one (fewer
    /// lines, other beams, other ranges) is begun anew.
    void update(const Scan& scan);

    [[nodiscard]] int lines() const { return gray_.lines; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] const Grid<std::uint8_t>& gray() const { return gray_; }
    [[nodiscard]] const Grid<std::uint8_t>& smoothed() const { return smoothed_; }
    /// 255 = edge, lines x beams.
    [[nodiscard]] const Grid<std::uint8_t>& mask() const { return hysteresis_.mask(); }
    /// Rows at the end whose gradient may still change; before them only a chain of weak cells can become an edge or cease to be one.
    [[nodiscard]] int unsettledRows() const;

    /// As detectEdges() gives it. `scan` must be the one of the last update.
    [[nodiscard]] std::shared_ptr<const Detection> detection(const std::shared_ptr<const Scan>& scan) const;

private:
    explicit LiveEdges(const Settings& settings);
    void reset(int beams);
    [[nodiscard]] bool continues(const Scan& scan) const;
    void takeGray(const Scan& scan, int first);
    void takeMasked(const Scan& scan, int first);
    [[nodiscard]] std::uint8_t levelOf(float rangeMm) const;
    [[nodiscard]] int smoothReach() const { return settings_.kernel / 2; }
    [[nodiscard]] int gradientReach() const { return settings_.aperture / 2; }

    Settings settings_;
    std::vector<std::uint8_t> levels_; // of whole millimetres
    GrayScale scale_;
    std::size_t saturated_ = 0;
    Grid<std::uint8_t> gray_, masked_, smoothed_;
    GradientRows gradient_; // of the last rows
    LiveHysteresis hysteresis_;
};

} // namespace edgescan
