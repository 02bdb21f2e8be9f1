// What the operator sees of a live scan, in words and states: a function of the status alone.
// (docs/reference/rules.md, "S2", "S4", "S5"; states as in NE 107.)
#pragma once

#include "core/files/live_feed/live_feed.h"

#include <string>
#include <vector>

namespace edgescan::files {

inline constexpr double kStaleAfterSeconds = 2.0; ///< at the latest (docs/reference/rules.md, "S4")

enum class Liveness : std::uint8_t {
    Connecting, ///< no line came yet
    Live,
    Stale,   ///< connected, but no line for too long
    Lost,    ///< not connected
    Stopped, ///< or the sweep has ended, and no line has come since
};

enum class Condition : std::uint8_t {
    Good,
    OutOfSpec, ///< maintenance is due or a result is doubtful
    Failure,   ///< results are not to be used
};

struct LiveHealth {
    Liveness liveness = Liveness::Connecting;
    std::string badge;    ///< "LIVE", "STALE 3 s", "LOST 12 s", "NOT CONNECTED", "CONNECTING", "STOPPED"
    std::string sentence; ///< of the session: what happened and what to do
    std::string scanner;  ///< what the device says it is; empty before it said so

    /// "312/1000 lines", of unknown length "312 lines"; "INCOMPLETE 312/1000 lines" where lines are missing and no more come.
    std::string lines;
    std::string lost;                 ///< "3 lost: lines 5 and 9 to 10"; empty when none
    int sweep = 0;                    ///< the sweep that is counted: 1 is the first since the connection; 0: no line came yet
    int row = 0, rows = 0;            ///< of the sweep: so far, and of the whole sweep (0: unknown)
    std::vector<int> lostRows;        ///< ascending
    std::string noReturn;             ///< "no return 4.2 %"
    std::string remark;               ///< "2 remarks", "COUNTERS IN DOUBT"; empty where all telegrams are as they should be
    std::vector<std::string> remarks; ///< each in a sentence
    Condition telegrams = Condition::Good;
    Condition window = Condition::Good;
    std::string contamination; ///< "window clean", "WINDOW DIRTY", "WINDOW TOO DIRTY"; also of an earlier line of the sweep
    Condition device = Condition::Good;
    std::string deviceState; ///< "device ok", "DEVICE ERROR"
    std::string pose;        ///< "pose 12 s old"; empty without a pose
    std::string end;         ///< "27 s left", "sweep complete"; empty when it is not known
    std::string recording;   ///< "recording 1.2 MB", "RECORDING ENDED: why"; empty when none is written
    Condition recorded = Condition::Good;

    /// What is on the screen is older than it seems.
    [[nodiscard]] bool stale() const { return liveness == Liveness::Stale || liveness == Liveness::Lost; }
    bool operator==(const LiveHealth&) const = default;
};

/// `placement`: of the scan shown; null: none. `shown`: of the growing sweep that the picture on the screen was computed from, where it
/// follows the scanner: lines and age are those of the picture, which may be older than what has arrived.
[[nodiscard]] LiveHealth healthOf(const LiveStatus& status, const Placement* placement = nullptr,
                                  const scanner::SweepProgress* shown = nullptr);

} // namespace edgescan::files
