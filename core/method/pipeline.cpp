// Runs the method stage by stage.
#include "core/method/pipeline.h"

#include "core/depth/depth_settings.h"
#include "core/gray/canny.h"
#include "core/gray/detector.h"
#include "core/gray/log_range.h"
#include "core/gray/smooth.h"
#include "core/method/detection_thresholds.h"
#include "core/scan/missing_cells.h"
#include "core/settings/method_traits.h"
#include "core/settings/parameters.h"

#include <opencv2/core/utility.hpp>

#include <chrono>
#include <cmath>

namespace edgescan {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool sameGray(const Settings& a, const Settings& b) { return a.scaling == b.scaling && same(a.nearMm, b.nearMm) && same(a.farMm, b.farMm); }

bool sameSmoothing(const Settings& a, const Settings& b) {
    return a.kernel == b.kernel && same(a.sigma, b.sigma) && a.maskMissing == b.maskMissing && a.maskIsolated == b.maskIsolated;
}

bool sameResponses(const Settings& a, const Settings& b) {
    return same(a.jumpMm, b.jumpMm) && a.growthPercent == b.growthPercent && a.creaseDeg == b.creaseDeg && a.grazing == b.grazing &&
           a.straighten == b.straighten && same(a.noiseMm, b.noiseMm);
}

Grid<std::uint8_t> missingOrIsolated(const Scan& scan, const Grid<std::uint8_t>& missing) {
    Grid<std::uint8_t> both = isolatedCells(scan);
    for (std::size_t k = 0; k < both.size(); ++k) both[k] |= missing[k];
    return both;
}

// Runs one stage into `slot`, and notes its time.
template <class T, class Stage>
void redo(Detection& detection, const char* name, std::shared_ptr<const T>& slot, Stage stage) {
    const auto start = Clock::now();
    slot = std::make_shared<const T>(stage());
    detection.timings.push_back({name, millisecondsSince(start)});
}

} // namespace

Pipeline::Pipeline() { cv::setNumThreads(0); }

// Cells that take no part; null when all do.
const Grid<std::uint8_t>* Pipeline::masked(Detection& detection) {
    if (!detection.settings.maskMissing) return nullptr;
    if (!missing_) redo(detection, "missing", missing_, [&] { return missingCells(*detection.scan); });
    if (!detection.settings.maskIsolated) return missing_.get();
    if (!isolated_) redo(detection, "isolated", isolated_, [&] { return missingOrIsolated(*detection.scan, *missing_); });
    return isolated_.get();
}

// Levels, smoothing, gradient: what holds from the last detection stays.
void Pipeline::runGray(Detection& detection, bool smoothHolds) {
    const Settings& settings = detection.settings;
    const Grid<std::uint8_t>* missing = masked(detection);
    const Grid<std::uint8_t>& levels = detection.gray->levels;
    const bool smoothed = !smoothsItself(settings.method);
    if (smoothed && smoothHolds && last_->smoothed) detection.smoothed = last_->smoothed;
    if (smoothed && !detection.smoothed)
        redo(detection, "smooth", detection.smoothed,
             [&] { return missing != nullptr ? smoothAroundHoles(levels, *missing, settings) : smooth(levels, settings); });
    if (settings.method == Method::Canny) {
        redo(detection, "canny", detection.mask, [&] {
            return missing != nullptr ? cannyAroundHoles(*detection.smoothed, *missing, settings) : canny(*detection.smoothed, settings);
        });
    } else {
        redo(detection, "detector", detection.mask,
             [&] { return detectorMask(settings.method, detection.smoothed ? *detection.smoothed : levels, missing, settings); });
    }
}

void Pipeline::runLogRange(Detection& detection) {
    redo(detection, "log range", detection.mask, [&] { return logRangeEdges(*detection.scan, detection.settings); });
}

// What was measured holds while only the decision is turned.
void Pipeline::runDepth(Detection& detection) {
    const DepthEdgeSettings settings = depthEdgeSettings(detection.settings);
    if (!surface_ || measuredWith_.straighten != detection.settings.straighten)
        redo(detection, "surface", surface_, [&] { return depthSurface(*detection.scan, settings.straighten); });
    if (!responses_ || !sameResponses(measuredWith_, detection.settings))
        redo(detection, "jumps and creases", responses_, [&] { return depthResponses(*surface_, settings); });
    measuredWith_ = detection.settings;
    const auto start = Clock::now();
    DepthEdges found = decideDepthEdges(*responses_, settings);
    detection.mask = std::make_shared<const Grid<std::uint8_t>>(std::move(found.mask));
    detection.classes = std::make_shared<const Grid<DepthEdge>>(std::move(found.kind));
    detection.responses = responses_;
    detection.timings.push_back({"decision", millisecondsSince(start)});
}

// A hand on the threshold's slider: one map, and then a compare per cell.
void Pipeline::runThreshold(Detection& detection) {
    detection.smoothed = last_->smoothed;
    if (!thresholds_) redo(detection, "threshold map", thresholds_, [&] { return thresholdMapOf(*last_); });
    const Parameter& swept = *findParameter(sweptParameter(detection.settings.method));
    redo(detection, "threshold", detection.mask, [&] { return edgesAt(*thresholds_, swept.get(detection.settings)); });
}

std::shared_ptr<const Detection> Pipeline::run(const std::shared_ptr<const Scan>& scan, const Settings& settings) {
    const bool sameScan = last_ && last_->scan == scan;
    if (sameScan && last_->settings == settings) return last_;
    const auto start = Clock::now();
    const bool grayHolds = sameScan && sameGray(last_->settings, settings);
    const bool smoothHolds = grayHolds && sameSmoothing(last_->settings, settings);
    Detection detection;
    detection.scan = scan;
    detection.settings = settings;
    if (grayHolds) detection.gray = last_->gray;
    if (!sameScan) {
        missing_.reset();
        isolated_.reset();
        surface_.reset();
        responses_.reset();
    }
    // The gray image is what the edges are seen on, whatever the method.
    if (!grayHolds) redo(detection, "gray", detection.gray, [&] { return grayImage(*scan, settings); });
    const bool gray = settings.method == Method::Canny || hasOneThreshold(settings.method);
    const bool onlyThreshold = sameScan && (gray || settings.method == Method::LogRange) && sameThresholdMap(last_->settings, settings);
    if (!onlyThreshold) thresholds_.reset();
    if (onlyThreshold)
        runThreshold(detection);
    else if (gray)
        runGray(detection, smoothHolds);
    else if (settings.method == Method::LogRange)
        runLogRange(detection);
    else
        runDepth(detection);
    redo(detection, "edge cells", detection.edges, [&] { return edgeCells(*detection.mask); });
    detection.totalMs = millisecondsSince(start);
    last_ = std::make_shared<const Detection>(std::move(detection));
    return last_;
}

std::array<std::size_t, kDepthEdges> countClasses(const Detection& detection) {
    std::array<std::size_t, kDepthEdges> counts{};
    if (!detection.classes) return counts;
    for (const std::uint32_t k : *detection.edges) ++counts[static_cast<std::size_t>((*detection.classes)[k])];
    return counts;
}

std::shared_ptr<const Detection> detectEdges(const std::shared_ptr<const Scan>& scan, const Settings& settings) {
    return Pipeline().run(scan, settings);
}

} // namespace edgescan
