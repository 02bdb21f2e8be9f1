// Looks for the sweep of a session in its recording, which opens at its longest sweep.
#include "ui/controllers/live.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/live/timeline.h"

namespace edgescan::ui {

/// False: it is another recording, or one without other sweeps.
bool Sessions::lookInSweeps() {
    const inspect::SessionScan& scan = wanted_->state.scan;
    const std::string& sha256 = scan.identity.sha256;
    if (scan.kind != inspect::SessionScan::Kind::Recording || nextSweep_) return false;
    if (!sha256.empty() && sha256 != engine_.picture()->detection->scan->sha256) return false;
    nextSweep_ = 0;
    if (live_.timeline().active()) lookInNextSweep(); // else when it was read
    return true;
}

void Sessions::lookInNextSweep() {
    Timeline& timeline = live_.timeline();
    while (*nextSweep_ < timeline.contents().sweeps.size()) {
        const int end = timeline.endOf((*nextSweep_)++);
        if (end != timeline.home()) return timeline.goTo(end);
    }
    nextSweep_.reset();
    timeline.goTo(timeline.home());
    refuseScan();
}

void Sessions::lookAt(const ReplayedSweep& at) {
    if (!wanted_ || !nextSweep_ || found_ || *nextSweep_ == 0 || at.position != live_.timeline().endOf(*nextSweep_ - 1)) return;
    if (at.sweep.scan && inspect::isSweepOf(wanted_->state.scan, *at.sweep.scan))
        found_ = at.sweep.scan; // given back when it is on the screen
    else
        lookInNextSweep();
}

} // namespace edgescan::ui
