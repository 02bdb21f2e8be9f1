// The method on scans that may grow.
#include "core/live/growing_pipeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan {
namespace {

constexpr int kFirstLook = 16;       // lines that a window from before is kept for
constexpr double kWindowShare = 0.1; // of a limit that it may be off

bool near(double a, double b) { return std::abs(a - b) <= kWindowShare * std::max(std::abs(a), std::abs(b)); }

} // namespace

std::shared_ptr<const Detection> GrowingPipeline::run(const std::shared_ptr<const Scan>& scan, const Settings& settings,
                                                      const Growth& growth) {
    try {
        if (growth.growing && growth.id != 0 && scan->cells() > 0) return grow(scan, settings, growth);
        last_ = nullptr;
        return pipeline_.run(scan, settings);
    } catch (...) { // what is half done is begun anew
        pipeline_ = Pipeline();
        edges_.reset();
        last_ = nullptr;
        throw;
    }
}

std::shared_ptr<const Detection> GrowingPipeline::grow(const std::shared_ptr<const Scan>& scan, const Settings& settings,
                                                       const Growth& growth) {
    const Settings fixed = fixedWindow(*scan, settings, growth.id);
    if (last_ && last_->scan == scan && last_->settings == fixed) return last_;
    if (!edges_ || edgesOf_ != growth.id || !(edges_->settings() == fixed)) {
        edges_.reset();
        if (auto made = LiveEdges::make(fixed)) edges_.emplace(std::move(*made));
        edgesOf_ = growth.id;
    }
    if (!edges_) return last_ = pipeline_.run(scan, fixed);
    edges_->update(*scan);
    return last_ = edges_->detection(scan);
}

Settings GrowingPipeline::fixedWindow(const Scan& scan, const Settings& settings, std::uint64_t id) {
    Settings window; // nothing but what makes gray of ranges
    window.scaling = settings.scaling;
    window.nearMm = settings.nearMm;
    window.farMm = settings.farMm;
    const bool known = fixedAt_ > 0 && asked_ == window;
    if (known && fixedOf_ != id) fixedAt_ = std::min(fixedAt_, kFirstLook / 2); // the next sweep begins with the window of the last
    if (!known || scan.lines() >= 2 * fixedAt_) {
        const Settings now = withFixedWindow(window, scan);
        if (!known || !near(now.nearMm, fixed_.nearMm) || !near(now.farMm, fixed_.farMm)) fixed_ = now;
        asked_ = window;
        fixedAt_ = scan.lines();
    }
    fixedOf_ = id;
    Settings fixed = settings;
    fixed.scaling = fixed_.scaling;
    fixed.nearMm = fixed_.nearMm;
    fixed.farMm = fixed_.farMm;
    return fixed;
}

} // namespace edgescan
