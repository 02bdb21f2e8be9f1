// Assigns readings of the stepper to lines.
#include "core/scanner/sweep_assembly/stepper_track.h"

#include <algorithm>

namespace edgescan::scanner {
namespace {

constexpr std::size_t kReadings = 64; // readings stored for later lines
constexpr std::size_t kLines = 256;   // number of earlier lines that a reading can change

double rateOf(const StepperReading& reading) { return reading.moving ? reading.degPerSecond : 0.0; }

void setStepperAngle(LineTiming& line, double deg, double rate, bool settled) {
    line.stepperDeg = deg;
    line.degPerSecond = rate;
    line.stepperSettled = settled;
}

} // namespace

void StepperTrack::line(LineTiming& line) const {
    if (last_.empty()) return;
    const auto latched = std::find_if(last_.rbegin(), last_.rend(), [&](const StepperReading& r) { return r.hostNs == line.hostNs; });
    if (latched != last_.rend()) return setStepperAngle(line, latched->phiDeg, rateOf(*latched), true);
    const StepperReading& newest = last_.back();
    setStepperAngle(line, newest.phiDeg + rateOf(newest) * secondsBetween(newest.hostNs, line.stampNs), rateOf(newest), false);
}

void StepperTrack::reading(const StepperReading& reading, std::span<LineTiming> lines) {
    const std::size_t first = lines.size() > kLines ? lines.size() - kLines : 0;
    for (std::size_t row = lines.size(); row-- > first;) {
        LineTiming& line = lines[row];
        if (!line.received) continue;
        if (line.hostNs == reading.hostNs) {
            setStepperAngle(line, reading.phiDeg, rateOf(reading), true);
        } else if (!line.stepperSettled && line.stampNs > reading.hostNs) {
            setStepperAngle(line, reading.phiDeg + rateOf(reading) * secondsBetween(reading.hostNs, line.stampNs), rateOf(reading), false);
        } else if (!line.stepperSettled && !last_.empty() && line.stampNs >= last_.back().hostNs && line.stampNs <= reading.hostNs) {
            const StepperReading& before = last_.back();
            const double whole = secondsBetween(before.hostNs, reading.hostNs);
            const double share = whole > 0 ? secondsBetween(before.hostNs, line.stampNs) / whole : 0.0;
            setStepperAngle(line, before.phiDeg + (reading.phiDeg - before.phiDeg) * share, rateOf(reading), true);
        }
    }
    last_.push_back(reading);
    if (last_.size() > kReadings) last_.pop_front();
}

} // namespace edgescan::scanner
