// The health of a live scan in words.
#include "core/files/live_feed/live_health.h"

#include "core/base/number_text.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/placement.h"

#include <cmath>
#include <numeric>
#include <string_view>

namespace edgescan::files {
namespace {

std::string ageText(double seconds) {
    if (seconds < 120.0) return fixedText(std::floor(seconds), 0) + " s";
    if (seconds < 7200.0) return fixedText(std::floor(seconds / 60.0), 0) + " min";
    return fixedText(std::floor(seconds / 3600.0), 0) + " h";
}

/// Seconds since the newest line that is shown arrived; empty before the first.
std::optional<double> ageOf(const LiveStatus& status, const scanner::SweepProgress* shown) {
    if (!status.secondsSinceLine || shown == nullptr) return status.secondsSinceLine;
    return *status.secondsSinceLine + static_cast<double>(status.sweep.newestNs - shown->newestNs) * 1e-9;
}

/// All lines of the sweep were sent: that no more come is as it should be.
bool isOver(const scanner::SweepProgress& sweep) { return sweep.expected > 0 && sweep.lines >= sweep.expected; }

Liveness livenessOf(const LiveStatus& status, std::optional<double> ageSeconds) {
    const scanner::ConnectionPhase phase = status.connection.phase;
    if (phase == scanner::ConnectionPhase::Stopped) return Liveness::Stopped;
    if (!ageSeconds) return phase == scanner::ConnectionPhase::Lost ? Liveness::Lost : Liveness::Connecting;
    if (phase == scanner::ConnectionPhase::Lost || phase == scanner::ConnectionPhase::Connecting) return Liveness::Lost;
    const bool late = phase != scanner::ConnectionPhase::Live || *ageSeconds >= kStaleAfterSeconds;
    return late ? Liveness::Stale : Liveness::Live;
}

std::string badgeOf(Liveness liveness, std::optional<double> ageSeconds) {
    const std::string age = ageSeconds ? " " + ageText(*ageSeconds) : std::string();
    switch (liveness) {
    case Liveness::Connecting:
        return "CONNECTING";
    case Liveness::Live:
        return "LIVE";
    case Liveness::Stale:
        return "STALE" + age;
    case Liveness::Lost:
        return ageSeconds ? "LOST" + age : "NOT CONNECTED"; // nothing came that could be lost
    case Liveness::Stopped:
        break;
    }
    return "STOPPED";
}

std::string noReturnOf(const scanner::SweepProgress& sweep) {
    const std::size_t all = std::accumulate(sweep.cells.begin(), sweep.cells.end(), std::size_t{0});
    if (all == 0) return {};
    const auto none = static_cast<double>(sweep.cells[static_cast<std::size_t>(CellState::NoReturn)]);
    return "no return " + fixedText(100.0 * none / static_cast<double>(all), 1) + " %";
}

std::string endOf(const LiveStatus& status, Liveness liveness) {
    const scanner::SweepProgress& sweep = status.sweep;
    if (sweep.expected == 0) return {};
    const int left = sweep.expected - sweep.lines;
    if (left <= 0) return sweep.complete() && !sweep.irregular.countersInDoubt() ? "sweep complete" : "sweep ended";
    // Without lines the time of the last one is unknown, and so it is where the sweep was joined in its middle.
    if (liveness != Liveness::Live || status.linesPerSecond <= 0.0 || sweep.endUnknown) return {};
    return ageText(std::ceil(left / status.linesPerSecond)) + " left";
}

/// A sweep that grows is under way, not incomplete: more lines come. Those that it lost are named next to it.
std::string linesOf(const scanner::SweepProgress& sweep, Liveness liveness) {
    return liveness == Liveness::Live && sweep.growing ? sweep.textSoFar() : sweep.text();
}

void tellWindow(LiveHealth& health, const scanner::SweepProgress& sweep) {
    const bool error = sweep.device.contaminationError || sweep.deviceEver.contaminationError;
    const bool warning = sweep.device.contaminationWarning || sweep.deviceEver.contaminationWarning;
    health.window = error ? Condition::Failure : warning ? Condition::OutOfSpec : Condition::Good;
    health.contamination = error ? "WINDOW TOO DIRTY" : warning ? "WINDOW DIRTY" : "window clean";
    const bool now = error ? sweep.device.contaminationError : sweep.device.contaminationWarning;
    if ((error || warning) && !now) health.contamination += " earlier in this sweep";
}

/// "MOUNTING ASSUMED", "MOUNTING FROM RANGES", "FIRST ANGLE ASSUMED", or "STEP ASSUMED 0.18°".
std::string assumedWords(const std::string& sentence) {
    const Assumed what = assumedIn(sentence);
    if (what == Assumed::SeenAxis) return "MOUNTING FROM RANGES";
    if (what == Assumed::Direction) return "FIRST ANGLE ASSUMED";
    if (what != Assumed::Step) return "MOUNTING ASSUMED";
    const std::size_t number = sentence.find(kStepAssumed) + std::string_view(kStepAssumed).size();
    return "STEP ASSUMED " + sentence.substr(number, sentence.find(' ', number) - number) + "°";
}

/// What is wrong with the telegrams themselves.
void tellTelegrams(LiveHealth& health, const LiveStatus& status, const scanner::SweepProgress& sweep) {
    health.remarks = sweep.irregular.sentences();
    if (!sweep.assumed.empty()) health.remarks.push_back(sweep.assumed);
    const bool startAssumed = !sweep.startAssumed.empty() && health.liveness != Liveness::Stopped; // then it is a warning of the scan
    if (startAssumed) health.remarks.push_back(sweep.startAssumed);
    const auto tell = [&](std::uint64_t count, const std::string& what) {
        if (count > 0) health.remarks.push_back(std::to_string(count) + what);
    };
    tell(static_cast<std::uint64_t>(status.undecodable),
         " scan telegrams since the start could not be decoded, so their lines are lost: " + status.whyUndecodable + ".");
    tell(status.statistics.stream.skipped, " bytes since the start were not a telegram and were skipped.");
    const bool wrong = !health.remarks.empty();
    tell(static_cast<std::uint64_t>(status.noReturns), kNoReturnsOfLaser);
    if (!wrong) return;
    health.telegrams = Condition::OutOfSpec;
    const std::size_t count = health.remarks.size();
    health.remark = sweep.irregular.countersInDoubt() ? "COUNTERS IN DOUBT"
                    : startAssumed                    ? "START ASSUMED" // what was joined in its middle may be turned by half a turn
                    : !sweep.assumed.empty()          ? assumedWords(sweep.assumed)
                    : count > 1                       ? std::to_string(count) + " remarks"
                                                      : "1 remark";
}

void tellRecording(LiveHealth& health, const RecordingState& recording) {
    if (recording.problem) {
        health.recorded = Condition::Failure;
        health.recording = (recording.ended ? "RECORDING ENDED: " : "RECORDING HAS GAPS: ") + recording.problem->sentence();
        return;
    }
    health.recording = "recording " + fixedText(static_cast<double>(recording.bytes) / 1e6, 1) + " MB";
    const std::string lag = lagText(recording);
    if (lag.empty()) return;
    health.recorded = Condition::OutOfSpec;
    health.recording += ", " + lag;
}

/// What the newest telegram said is not known of the present.
void tellAge(LiveHealth& health, double ageSeconds) {
    const auto tell = [&](std::string& words) {
        if (!words.empty()) words += ", " + ageText(ageSeconds) + " ago";
    };
    tell(health.contamination);
    tell(health.deviceState);
    if (health.recorded != Condition::Failure) tell(health.recording);
}

} // namespace

LiveHealth healthOf(const LiveStatus& status, const Placement* placement, const scanner::SweepProgress* shown) {
    const scanner::SweepProgress& sweep = status.sweep;
    const scanner::SweepProgress& lines = shown != nullptr ? *shown : sweep;
    const std::optional<double> age = ageOf(status, shown);
    LiveHealth health;
    health.liveness = livenessOf(status, age);
    health.badge = badgeOf(health.liveness, age);
    health.sentence = status.connection.sentence;
    if (health.stale() && age && isOver(sweep) && !status.wholeClouds) {
        if (health.liveness == Liveness::Stale) health.sentence = "The sweep has ended; no line has come since.";
        health.liveness = Liveness::Stopped;
        health.badge = "STOPPED " + ageText(*age);
    }
    if (status.scanner) health.scanner = status.scanner->words();
    if (status.lines > 0) {
        health.lines = linesOf(lines, health.liveness);
        health.sweep = lines.number + 1;
        health.row = lines.lines;
        health.rows = lines.expected;
        health.lostRows = lines.lost;
        health.noReturn = noReturnOf(lines);
        if (lines.number == sweep.number) health.end = endOf(status, health.liveness); // else it is that of the next sweep
        tellWindow(health, sweep);
        health.device = sweep.device.error || sweep.deviceEver.error ? Condition::Failure : Condition::Good;
        health.deviceState = health.device == Condition::Good ? "device ok"
                             : sweep.device.error             ? "DEVICE ERROR"
                                                              : "DEVICE ERROR earlier in this sweep";
    }
    if (!lines.lost.empty()) health.lost = std::to_string(lines.lost.size()) + " lost: " + scanner::rowsText(lines.lost, 4);
    tellTelegrams(health, status, lines);
    if (placement != nullptr)
        health.pose = std::isnan(placement->ageSeconds) ? "pose of unknown age" : "pose " + ageText(placement->ageSeconds) + " old";
    if (status.recording) tellRecording(health, *status.recording);
    if (health.stale() && age) tellAge(health, *age);
    return health;
}

} // namespace edgescan::files
