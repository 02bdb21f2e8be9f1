// Runs the method and redoes only the stages whose inputs changed since the last run.
#pragma once

#include "core/gray/threshold_map.h"
#include "core/method/detection.h"

namespace edgescan {

/// Not for several threads at once; the detections it returns are.
class Pipeline {
public:
    /// Switches OpenCV's thread pool off for the process: one worker thread is enough, and a pool makes its times jumpy.
    Pipeline();

    /// The same scan pointer and settings give the last detection again. `scan` must not be null.
    std::shared_ptr<const Detection> run(const std::shared_ptr<const Scan>& scan, const Settings& settings);

private:
    void runGray(Detection& detection, bool smoothHolds);
    static void runLogRange(Detection& detection);
    void runDepth(Detection& detection);
    void runThreshold(Detection& detection);
    [[nodiscard]] const Grid<std::uint8_t>* masked(Detection& detection);

    std::shared_ptr<const Detection> last_;
    std::shared_ptr<const Grid<std::uint8_t>> missing_;  // 255 = no valid range
    std::shared_ptr<const Grid<std::uint8_t>> isolated_; // 255 = missing_ or standing alone; null until wanted
    std::shared_ptr<const DepthSurface> surface_;        // of the scan of last_, null until wanted
    std::shared_ptr<const DepthResponses> responses_;    // the same
    Settings measuredWith_;                              // both
    std::shared_ptr<const ThresholdMap> thresholds_;     // of last_, while nothing but its threshold is turned; else null
};

/// One run from nothing.
[[nodiscard]] std::shared_ptr<const Detection> detectEdges(const std::shared_ptr<const Scan>& scan, const Settings& settings);

} // namespace edgescan
