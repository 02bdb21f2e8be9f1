// Assembles sweeps from scan telegrams: lines go in, a growing scan comes out (docs/developer/protocol.md, "Scan telegram",
// docs/reference/rules.md, "S1", "S2", "S5").
#pragma once

#include "core/scanner/sweep_assembly/counters.h"
#include "core/scanner/sweep_assembly/growing_sweep.h"
#include "core/scanner/sweep_assembly/irregularities.h"
#include "core/scanner/sweep_assembly/line_angles.h"

#include <array>
#include <deque>
#include <memory>
#include <string>

namespace edgescan::scanner {

/// The progress of a sweep. "Lines" are rows of the grid; a row consists of one or more telegrams.
struct SweepProgress {
    int number = 0;                               ///< number of this sweep since the start, from 0
    bool growing = false;                         ///< true: more lines will come
    int lines = 0;                                ///< rows so far, including lost ones
    int received = 0;                             ///< rows without missing cells
    int expected = 0;                             ///< rows of the whole sweep; 0: unknown
    std::vector<int> lost;                        ///< rows with missing cells, ascending
    std::vector<int> narrow;                      ///< those of them whose telegrams came, but with fewer beams than the sweep has
    std::int64_t duplicates = 0;                  ///< telegrams that came twice, since the start
    std::int64_t misfits = 0;                     ///< telegrams with other beams or without beams, since the start
    int restarts = 0;                             ///< of the scanner, since the start
    Irregularities irregular;                     ///< of this sweep
    Irregularities irregularEver;                 ///< since the start
    TelegramAccount account;                      ///< since the start
    std::array<std::size_t, kCellStates> cells{}; ///< by CellState; they add up to lines x beams
    AngleSource angleSource = AngleSource::Steps;
    /// a sentence about the assumed mounting: "How a motor turned ... ASSUMED: the axis (spin) ..."; empty: all values were given
    std::string assumed;
    Axis axis = Axis::Spin;    ///< given, shown by the ranges (core/scan/grid/axis_from_ranges.h), or assumed
    double firstLineDeg = 0.0; ///< given, or assumed
    /// "The first line received is taken as line 0 of the sweep.": until the start of a sweep was seen, a connection in the middle of one
    /// has its lines at wrong angles; empty: the start was seen, or the stepper reports its angles
    std::string startAssumed;
    bool endUnknown = false;   ///< the stepper's place is in the stream, and its start was not seen: the sweep may end before `expected`
    std::int64_t newestNs = 0; ///< host time of the newest line, by the clock of push()
    DeviceFlags device;        ///< at the newest line
    DeviceFlags deviceEver;    ///< at any line of the sweep

    /// All sentences about what was assumed; empty: nothing was.
    [[nodiscard]] std::string allAssumed() const { return assumed + (assumed.empty() || startAssumed.empty() ? "" : " ") + startAssumed; }
    /// Nothing is missing, and the expected number of rows is there.
    [[nodiscard]] bool complete() const { return received == lines && (expected == 0 || lines >= expected); }
    /// "1000/1000 lines", "INCOMPLETE 970/1000 lines", "INCOMPLETE 20/24 lines", "24/24 lines, COUNTERS IN DOUBT"; of unknown length
    /// "243 lines", or "INCOMPLETE 240/243 lines" where lines are lost.
    [[nodiscard]] std::string text() const;
    /// While it grows and nothing is missing: "312/1000 lines"; of unknown length "312 lines".
    [[nodiscard]] std::string textSoFar() const;
};

/// "lines 3, 7 and 20 to 49": rows as text, at most `groups` groups.
[[nodiscard]] std::string rowsText(const std::vector<int>& rows, int groups = 8);

/// A sweep and its progress.
struct SweepState {
    std::shared_ptr<const Scan> scan; ///< null: no row yet
    SweepProgress progress;
};
using FinishedSweep = SweepState;

/// A value type; not for several threads at once, but the scans that it returns are. Memory is bounded: one growing sweep and the last
/// finished ones.
class SweepAssembler {
public:
    explicit SweepAssembler(const SweepSettings& settings = {});

    /// `hostNs`: when the line's first byte arrived; any clock that only runs forward, the same for lines and readings.
    void push(SweepLine line, std::int64_t hostNs);
    void push(const StepperReading& reading);
    /// The connection was made again; the scanner may have restarted.
    void reconnected() { counter_.reconnected(); }
    /// Call it after the last line: finishes the sweep as it is.
    void finish();

    /// The whole rows so far as a scan; the same pointer while nothing has changed, null before the first row. After finish(): the finished
    /// sweep.
    [[nodiscard]] std::shared_ptr<const Scan> snapshot();
    [[nodiscard]] SweepProgress progress() const;
    /// Sweeps finished since the last call, oldest first; at most the last four are stored.
    [[nodiscard]] std::vector<FinishedSweep> popFinished();

    /// SweepProgress::number.
    [[nodiscard]] int sweepNumber() const { return number_; }

    [[nodiscard]] const SweepSettings& settings() const { return settings_; }

private:
    bool isNew(SweepLine& line, std::int64_t hostNs, LineStamp& stamp);
    void note(const SweepLine& line, const LineStamp& stamp);
    void note(Irregularity kind, std::int64_t times = 1, std::int64_t ahead = 0);
    void addLine(SweepLine line, std::int64_t lost);
    void startAtMisfit(const SweepLine& line, std::int64_t between);
    void start(const SweepLine& line);
    void finishSweep();
    void splitAtReversal();
    void followEncoder(SweepLine& line, std::int64_t lost, bool restarted);
    [[nodiscard]] bool encoderLeapsBack(std::uint32_t position, std::int64_t lost, bool restarted);
    [[nodiscard]] std::int64_t lostInRestart(const SweepLine& line) const;
    void describe(Scan& scan);
    [[nodiscard]] SweepSettings settingsInUse() const;
    [[nodiscard]] std::string startAssumed(AngleSource source) const;
    [[nodiscard]] TelegramAccount account() const;

    SweepSettings settings_;
    LineCounter counter_;
    DeviceClock clock_;
    StepperTrack stepper_;
    std::optional<GrowingSweep> sweep_;
    std::optional<SweepLine> misfit_; // the last line, if its beams did not fit
    std::int64_t lostSince_ = 0;      // telegrams without a row since the last one with a row

    std::string echoes_;             // range channels of the sweep's first telegram
    std::optional<LineTiming> last_; // of the newest line
    double restartSeconds_ = 0.0;    // added to the device clock since its last restart
    std::optional<std::uint32_t> encoderAt_;
    std::int64_t encoderCount_ = 0, encoderStep_ = 0; // step: counts to the newest line, of an encoder without a scale
    bool encoderWithoutScale_ = false, encoderWasReset_ = false;
    std::optional<Axis> axisFound_,
        axisBefore_;            // that the ranges show where none was given: of this sweep or those before, of those before
    bool startIsKnown_ = false; // the stepper went back to its start; before that, it may have been turning at the first line
    DeviceFlags device_;

    int number_ = 0;
    Irregularities irregular_, irregularEver_;
    TelegramAccount ended_;    // of the sweeps that have ended; the number of telegrams is that of all sweeps
    std::uint32_t serial_ = 0; // of the newest telegram with a serial number
    int repeats_ = 0;          // consecutive telegrams that were there already, according to counters and clock
    int restarts_ = 0;

    std::deque<FinishedSweep> finished_;
    std::shared_ptr<const Scan> snapshot_;
    SweepProgress finishedProgress_;
    bool changed_ = true; // since snapshot_
};

struct PlayedLine {
    int line = 0;            ///< over the whole recording, from 0
    std::int64_t timeNs = 0; ///< when it was received
    std::int64_t nextNs = 0; ///< the same of the next line; 0: it is the last one
    SweepProgress progress;  ///< with this line
};

} // namespace edgescan::scanner
