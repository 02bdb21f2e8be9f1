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
void redo(Frame& frame, const char* name, std::shared_ptr<const T>& slot, Stage stage) {
    const auto start = Clock::now();
    slot = std::make_shared<const T>(stage());
    frame.timings.push_back({name, millisecondsSince(start)});
}

} // namespace

Pipeline::Pipeline() { cv::setNumThreads(0); }

// Cells that take no part; null when all do.
const Grid<std::uint8_t>* Pipeline::masked(Frame& frame) {
    if (!frame.settings.maskMissing) return nullptr;
    if (!missing_) redo(frame, "missing", missing_, [&] { return missingCells(*frame.scan); });
    if (!frame.settings.maskIsolated) return missing_.get();
    if (!isolated_) redo(frame, "isolated", isolated_, [&] { return missingOrIsolated(*frame.scan, *missing_); });
    return isolated_.get();
}

// Levels, smoothing, gradient: what holds from the last frame stays.
void Pipeline::runGray(Frame& frame, bool smoothHolds) {
    const Settings& settings = frame.settings;
    const Grid<std::uint8_t>* missing = masked(frame);
    const Grid<std::uint8_t>& levels = frame.gray->levels;
    const bool smoothed = !smoothsItself(settings.method);
    if (smoothed && smoothHolds && last_->smoothed) frame.smoothed = last_->smoothed;
    if (smoothed && !frame.smoothed)
        redo(frame, "smooth", frame.smoothed,
             [&] { return missing != nullptr ? smoothAroundHoles(levels, *missing, settings) : smooth(levels, settings); });
    if (settings.method == Method::Canny) {
        redo(frame, "canny", frame.mask,
             [&] { return missing != nullptr ? cannyAroundHoles(*frame.smoothed, *missing, settings) : canny(*frame.smoothed, settings); });
    } else {
        redo(frame, "detector", frame.mask,
             [&] { return detectorMask(settings.method, frame.smoothed ? *frame.smoothed : levels, missing, settings); });
    }
}

void Pipeline::runLogRange(Frame& frame) {
    redo(frame, "log range", frame.mask, [&] { return logRangeEdges(*frame.scan, frame.settings); });
}

// What was measured holds while only the decision is turned.
void Pipeline::runDepth(Frame& frame) {
    const DepthEdgeSettings settings = depthEdgeSettings(frame.settings);
    if (!surface_ || measuredWith_.straighten != frame.settings.straighten)
        redo(frame, "surface", surface_, [&] { return depthSurface(*frame.scan, settings.straighten); });
    if (!responses_ || !sameResponses(measuredWith_, frame.settings))
        redo(frame, "jumps and creases", responses_, [&] { return depthResponses(*surface_, settings); });
    measuredWith_ = frame.settings;
    const auto start = Clock::now();
    DepthEdges found = decideDepthEdges(*responses_, settings);
    frame.mask = std::make_shared<const Grid<std::uint8_t>>(std::move(found.mask));
    frame.classes = std::make_shared<const Grid<DepthEdge>>(std::move(found.kind));
    frame.responses = responses_;
    frame.timings.push_back({"decision", millisecondsSince(start)});
}

// A hand on the threshold's slider: one map, and then a compare per cell.
void Pipeline::runThreshold(Frame& frame) {
    frame.smoothed = last_->smoothed;
    if (!thresholds_) redo(frame, "threshold map", thresholds_, [&] { return thresholdMapOf(*last_); });
    const Parameter& swept = *findParameter(sweptParameter(frame.settings.method));
    redo(frame, "threshold", frame.mask, [&] { return edgesAt(*thresholds_, swept.get(frame.settings)); });
}

std::shared_ptr<const Frame> Pipeline::run(const std::shared_ptr<const Scan>& scan, const Settings& settings) {
    const bool sameScan = last_ && last_->scan == scan;
    if (sameScan && last_->settings == settings) return last_;
    const auto start = Clock::now();
    const bool grayHolds = sameScan && sameGray(last_->settings, settings);
    const bool smoothHolds = grayHolds && sameSmoothing(last_->settings, settings);
    Frame frame;
    frame.scan = scan;
    frame.settings = settings;
    if (grayHolds) frame.gray = last_->gray;
    if (!sameScan) {
        missing_.reset();
        isolated_.reset();
        surface_.reset();
        responses_.reset();
    }
    // The gray image is what the edges are seen on, whatever the method.
    if (!grayHolds) redo(frame, "gray", frame.gray, [&] { return grayImage(*scan, settings); });
    const bool gray = settings.method == Method::Canny || hasOneThreshold(settings.method);
    const bool onlyThreshold = sameScan && (gray || settings.method == Method::LogRange) && sameThresholdMap(last_->settings, settings);
    if (!onlyThreshold) thresholds_.reset();
    if (onlyThreshold)
        runThreshold(frame);
    else if (gray)
        runGray(frame, smoothHolds);
    else if (settings.method == Method::LogRange)
        runLogRange(frame);
    else
        runDepth(frame);
    redo(frame, "edge cells", frame.edges, [&] { return edgeCells(*frame.mask); });
    frame.totalMs = millisecondsSince(start);
    last_ = std::make_shared<const Frame>(std::move(frame));
    return last_;
}

std::array<std::size_t, kDepthEdges> countClasses(const Frame& frame) {
    std::array<std::size_t, kDepthEdges> counts{};
    if (!frame.classes) return counts;
    for (const std::uint32_t k : *frame.edges) ++counts[static_cast<std::size_t>((*frame.classes)[k])];
    return counts;
}

std::shared_ptr<const Frame> detectEdges(const std::shared_ptr<const Scan>& scan, const Settings& settings) {
    return Pipeline().run(scan, settings);
}

} // namespace edgescan
