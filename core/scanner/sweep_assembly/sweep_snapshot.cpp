// The state of a sweep so far: as a scan and as text.
#include "core/base/translated_text.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include "core/base/number_text.h"
#include "core/base/utc_time.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/axis_from_ranges.h"

#include <algorithm>
#include <iterator>

namespace edgescan::scanner {
namespace {

/// Interpolates the times of lines that did not arrive.
std::vector<double> lineTimes(std::span<const LineTiming> rows) {
    std::vector<double> times(rows.size(), 0.0);
    std::size_t last = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i].received) continue;
        times[i] = static_cast<double>(rows[i].stampNs) * 1e-9;
        const std::size_t from = last < rows.size() ? last : i;
        for (std::size_t lost = last < rows.size() ? last + 1 : 0; lost < i; ++lost) {
            const double share = from == i ? 1.0 : static_cast<double>(lost - from) / static_cast<double>(i - from);
            times[lost] = times[from] + (times[i] - times[from]) * share;
        }
        last = i;
    }
    if (last >= rows.size()) return {};
    std::fill(times.begin() + static_cast<std::ptrdiff_t>(last), times.end(), times[last]);
    return times;
}

/// The device and the times of the scan, from the sweep's own telegrams. Times count as UTC, because recordings and live feeds stamp lines
/// so.
std::shared_ptr<const Acquisition> sweepAcquisition(GrowingSweep& sweep, std::size_t rows, const SweepSettings& settings) {
    auto acquisition = std::make_shared<Acquisition>();
    Acquisition& a = *acquisition;
    a.vendor = "SICK";
    if (sweep.serialNumber() != 0) a.serial = std::to_string(sweep.serialNumber());
    a.lineTimesS = lineTimes(sweep.facts().first(rows));
    if (!a.lineTimesS.empty()) {
        a.startUtc = utcText(a.lineTimesS.front());
        a.endUtc = utcText(a.lineTimesS.back());
        a.clockSource = "the recording computer's clock, carried on by the scanner's";
    }
    const DeviceFlags& ever = sweep.deviceEver();
    const std::string from = withValues(" from line %1 on", {std::max(0, sweep.firstFlagged())});
    a.contamination = ever.contaminationError     ? "window too dirty to measure through" + from
                      : ever.contaminationWarning ? "dirty window" + from
                                                  : "none reported";
    a.echoFilter = settings.echo == Echo::First ? "first echo that the scanner sent" : "last echo that the scanner sent";
    a.linesExpected = settings.expectedLines;
    return acquisition;
}

/// A step that is counted is assumed, too; an encoder or the stepper reports its angles itself.
std::string assumedText(const SweepSettings& settings, bool fromRanges, AngleSource source) {
    std::string what, flags;
    const auto addAssumption = [&](const std::string& words, const char* flag) {
        what += (what.empty() ? "" : ", ") + words;
        flags += (flags.empty() ? "" : ", ") + std::string(flag);
    };
    if (settings.axisAssumed) {
        const bool spin = settings.axis == Axis::Spin;
        addAssumption(std::string(kAxisAssumed) + (spin ? "spin" : "sweep") + (fromRanges ? kAxisFromRanges : ")"), "--axis");
    }
    if (settings.stepAssumed && source == AngleSource::Steps) {
        addAssumption(kStepAssumed + shortestText(*settings.degPerLine) + " degrees" +
                          (settings.continuous ? ", the motor turning on while a line is measured)" : ")"),
                      "--line-step");
    }
    if (settings.firstAssumed && source != AngleSource::Stepper)
        addAssumption(kFirstAssumed + shortestText(settings.firstLineDeg) + " degrees)", "--line-start");
    if (what.empty()) return {};
    return kMountingAssumed + withValues("%1. Give %2 where that is wrong.", {what, flags});
}

/// "312/1000 lines"; `of` 0: how many the sweep has is not known.
std::string linesText(int count, int of) { return std::to_string(count) + (of > 0 ? "/" + std::to_string(of) : "") + " lines"; }

} // namespace

std::string SweepProgress::text() const {
    const int of = expected > 0 ? expected : lines;
    return (complete() ? "" : "INCOMPLETE ") + linesText(received, expected > 0 || received < lines ? of : 0) +
           (irregular.countersInDoubt() ? ", COUNTERS IN DOUBT" : "");
}

std::string SweepProgress::textSoFar() const {
    return linesText(lines, expected) + (irregular.countersInDoubt() ? ", COUNTERS IN DOUBT" : "");
}

std::string rowsText(const std::vector<int>& rows, int groups) {
    std::string text;
    int listed = 0;
    for (std::size_t i = 0; i < rows.size();) {
        std::size_t last = i;
        while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1) ++last;
        if (listed++ == groups) return withValues("lines %1 and others", {text});
        if (listed > 1) text += ", ";
        text += std::to_string(rows[i]);
        if (last > i) text += " to " + std::to_string(rows[last]);
        i = last + 1;
    }
    return withValues(rows.size() == 1 ? "line %1" : "lines %1", {text});
}

SweepProgress SweepAssembler::progress() const {
    SweepProgress progress;
    if (sweep_) {
        progress.lines = sweep_->wholeRows();
        for (int row = 0; row < progress.lines; ++row) {
            if (!sweep_->isIncomplete(row)) continue;
            progress.lost.push_back(row);
            if (sweep_->missing()[static_cast<std::size_t>(row)] == 0) progress.narrow.push_back(row);
        }
        progress.received = progress.lines - static_cast<int>(progress.lost.size());
        progress.cells = sweep_->grid().counts(progress.lines);
        progress.angleSource = angleSourceOf(sweep_->facts(), settings_);
        const SweepSettings used = settingsInUse();
        progress.axis = used.axis;
        progress.firstLineDeg = used.firstLineDeg;
        progress.assumed = assumedText(used, axisFound_.has_value(), progress.angleSource);
        progress.startAssumed = startAssumed(progress.angleSource);
        const bool placed = encoderAt_ || progress.angleSource == AngleSource::Stepper;
        progress.endUnknown = placed && !startIsKnown_;
        progress.deviceEver = sweep_->deviceEver();
        progress.number = number_;
        progress.irregular = irregular_;
    } else {
        progress = finishedProgress_;
    }
    progress.irregularEver = irregularEver_;
    progress.account = account();
    progress.expected = settings_.expectedLines;
    progress.growing = sweep_ && (progress.expected == 0 || progress.lines < progress.expected);
    if (last_) progress.newestNs = last_->hostNs;
    progress.device = device_;
    progress.duplicates = irregularEver_.count(Irregularity::Duplicate);
    progress.misfits = irregularEver_.count(Irregularity::Misfit) + irregularEver_.count(Irregularity::NoRanges);
    progress.restarts = restarts_;
    return progress;
}

std::shared_ptr<const Scan> SweepAssembler::snapshot() {
    if (!changed_ || !sweep_) return snapshot_;
    changed_ = false;
    const int rows = sweep_->wholeRows();
    if (rows == 0 || sweep_->grid().beams() == 0) return snapshot_ = nullptr;
    const std::shared_ptr<Scan> scan = sweep_->grid().scan(rows);
    describe(*scan);
    return snapshot_ = scan;
}

/// What is taken as the start of the sweep where nothing shows it.
std::string SweepAssembler::startAssumed(AngleSource source) const {
    if (source == AngleSource::Encoder && !settings_.encoderZero)
        return "The encoder count of the first line received is taken as the first angle of the sweep.";
    const bool isCounted = source == AngleSource::Steps || source == AngleSource::Time;
    return isCounted && !startIsKnown_ ? "The first line received is taken as line 0 of the sweep." : "";
}

/// With the axis that the ranges show, and the angle of the first line that follows from it, where these are assumed.
SweepSettings SweepAssembler::settingsInUse() const {
    SweepSettings used = settings_;
    used.axis = axisFound_.value_or(used.axis);
    if (used.firstAssumed) used.firstLineDeg = assumedFirstDeg(used.axis, used);
    return used;
}

/// Sets everything but ranges and states; the scan may hold an earlier snapshot.
void SweepAssembler::describe(Scan& scan) {
    if (settings_.axisAssumed) {
        const auto seen = axisFromRanges(scan.rangeMm, scan.state, sweep_->beams().beamDeg());
        axisFound_ = seen ? seen : axisBefore_;
    }
    const SweepProgress now = progress();
    const auto rows = static_cast<std::size_t>(now.lines);
    const SweepSettings used = settingsInUse();
    LineAngles angles = lineAngles(sweep_->facts().first(rows), used);
    PolarGeometry polar;
    polar.beamDeg = sweep_->beams().beamDeg();
    polar.lineDeg = std::move(angles.lineDeg);
    polar.axis = used.axis;
    polar.lineDirection = settings_.lineDirection;
    polar.lineSkewDeg = lineSkewDeg(polar.beamDeg, sweep_->turnsOf(), angles.degPerTurn, settings_.indexDeg);
    scan.geometry = std::move(polar);
    scan.format = "sweep";
    scan.name = "sweep " + std::to_string(number_ + 1);
    scan.unitMm = sweep_->unitMm();
    scan.noReturnCodes = {0};
    scan.statusCodes = sweep_->statusCodes();
    scan.acquisition = sweepAcquisition(*sweep_, rows, settings_);
    scan.warnings.clear();
    const auto warn = [&](std::string sentence) { scan.warnings.push_back(std::move(sentence)); };
    if (!now.complete()) warn(now.text() + ".");
    const auto warnAboutRows = [&](const char* what, const std::vector<int>& lines) {
        if (!lines.empty()) warn(withValues(what, {rowsText(lines), lines.size()}));
    };
    std::vector<int> gone;
    std::set_difference(now.lost.begin(), now.lost.end(), now.narrow.begin(), now.narrow.end(), std::back_inserter(gone));
    warnAboutRows("Telegrams were lost: %1 (%2 in all).", gone);
    warnAboutRows("Telegrams had fewer beams than the sweep, the others are lost: %1 (%2 in all).", now.narrow);
    for (std::string& sentence : now.irregular.sentences()) warn(std::move(sentence));
    if (std::string assumed = now.allAssumed(); !assumed.empty()) warn(std::move(assumed));
    if (angles.source == AngleSource::Time) warn("The line angles are computed from time alone: a change of speed bends the cloud.");
    if (encoderWithoutScale_)
        warn("The telegrams carry encoder counts, but the number of counts per degree was not given: angles do not follow them.");
    if (encoderWasReset_) warn("The scanner lost its encoder count when it restarted: the line angles after that are computed.");
    const DeviceFlags& ever = now.deviceEver;
    const std::string from = withValues(" (from line %1 on).", {std::max(0, sweep_->firstFlagged())});
    if (ever.error) warn("The scanner reported an error or was not ready" + from);
    if (ever.contaminationError) warn("The scanner reported a window too dirty to measure through" + from);
    if (ever.contaminationWarning) warn("The scanner reported a dirty window" + from);
}

} // namespace edgescan::scanner
