// A scanner from its socket to a growing scan, recorded before anything is parsed: the live end of the one path for file, replay and live.
// A scanner of whole clouds makes a scan of each message.
#pragma once

#include "core/files/addons/addon.h"
#include "core/files/recording/layout.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/writer.h"
#include "core/scanner/sick_lms/scanner_connection.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace edgescan::files {

struct LiveStatus;
struct OfferedTopic;

/// Everything but connect(), heard() of a message and finish() is called with the feed's lock.
class LiveSource {
public:
    struct Events {
        std::function<void(const scanner::ConnectionState&)> stateChanged;
        /// Every message before it is parsed, without its time of receipt. `isLine`: of the topic that is shown.
        std::function<void(RecordingMessage message, const scanner::HostTime& time, bool isLine)> received;
    };
    virtual ~LiveSource() = default;

    virtual std::unique_ptr<scanner::LiveConnection> connect(scanner::ConnectionSettings settings, Events events) = 0;
    /// Counts a message that came at this monotonic time.
    virtual void heard(const RecordingMessagePtr& message, std::int64_t monotonicNs) = 0;
    /// Gives the number of lines or whole scans that the message makes known.
    virtual int play(const RecordingMessagePtr& message, scanner::SweepAssembler& to) = 0;
    virtual void useSweep(const scanner::SweepSettings& settings) = 0;

    /// The newest scan, where each message is a whole one; empty: messages are lines.
    [[nodiscard]] virtual std::optional<scanner::SweepState> newest() const = 0;
    /// What the source knows in addition to what is in the status.
    virtual void complete(LiveStatus& status) const = 0;
    [[nodiscard]] virtual std::vector<OfferedTopic> offered() const = 0;
    /// Messages that come only once.
    [[nodiscard]] virtual const std::vector<RecordingMessagePtr>& standing() const = 0;
    /// After the last message.
    virtual void finish() = 0;
};

/// Behind LiveStatus::noReturns in a sentence.
inline constexpr const char* kNoReturnsOfLaser =
    " ranges are range_min or range_max of their messages, repeat, and were taken as no return.";

/// Everything that the health of a live scan is derived from (docs/reference/rules.md, "S2", "S4", "S5"). A copy, true at the moment it was
/// asked for.
struct LiveStatus {
    scanner::ConnectionState connection;
    std::optional<scanner::ScannerIdentity> scanner;
    scanner::ConnectionStatistics statistics;
    scanner::SweepProgress sweep;
    scanner::SweepSettings settings;         ///< that lines are placed with, with what a bridge's transforms gave
    std::int64_t lines = 0;                  ///< scan telegrams that became a line, over all sweeps; of clouds: messages
    std::int64_t linesAfter = 0;             ///< scan telegrams that came after the last line that is taken
    std::int64_t undecodable = 0;            ///< scan telegrams that could not be decoded
    std::string whyUndecodable;              ///< of one of them
    std::int64_t noReturns = 0;              ///< ranges of a bridge's laser that repeat range_min or range_max and were not measured
    std::optional<double> secondsSinceLine;  ///< empty before the first
    double linesPerSecond = 0.0;             ///< over the last lines; 0: not known
    bool wholeClouds = false;                ///< each message is a whole cloud, so that the next one is due at once
    std::optional<RecordingState> recording; ///< while one is written
};

/// A topic of a bridge. Messages are counted of those that are subscribed; of the others only the type is known.
struct OfferedTopic {
    ListedTopic topic;
    bool subscribed = false;
    bool lines = false; ///< the one that the lines or clouds come from
};

struct LiveLimits {
    std::int64_t lines = 0;              ///< are taken; what the scanner sends afterwards is neither recorded nor shown; 0: all
    std::size_t keptBytes = 128U << 20U; ///< of the last minute
};

/// From any thread. Destroying it stops scanner and recording.
class LiveFeed {
public:
    /// `changed` is called after every line, cloud and change of state, on the scanner's thread or, with clouds, on one of the pool; it
    /// must return at once and must not call back into the feed.
    LiveFeed(scanner::ConnectionSettings scanner, const scanner::SweepSettings& sweep, std::function<void()> changed,
             const LiveLimits& limits = {});
    ~LiveFeed();
    LiveFeed(const LiveFeed&) = delete;
    LiveFeed& operator=(const LiveFeed&) = delete;

    /// The sweep so far; the same pointer while nothing changed, null before the first line.
    [[nodiscard]] std::shared_ptr<const Scan> snapshot();
    /// The same with how far it is, both of one moment.
    [[nodiscard]] scanner::SweepState sweep();
    [[nodiscard]] LiveStatus status() const;
    /// Of a bridge: what it offers and which of it is subscribed; by name.
    [[nodiscard]] std::vector<OfferedTopic> offered() const;
    /// Sweeps finished since the last call.
    [[nodiscard]] std::vector<scanner::FinishedSweep> popFinished();

    /// Other mounting, steps or lines from now on; the lines of the sweep under way, as far as they are remembered, are put into their new
    /// places. A recording that is being written keeps the settings it began with. Gives the number of lines that are no longer remembered;
    /// nothing where the settings are those in use.
    std::optional<int> useSweep(const scanner::SweepSettings& sweep);

    /// Begins with what is remembered of the sweep that is growing, so that pressing Record a moment late loses nothing.
    /// Returns the number of lines that it begins with. Error: a recording is being written already, or the file cannot be made.
    Result<int> startRecording(const std::filesystem::path& path);
    /// Closes the recording, within seconds whatever the disk does; what was written. Error: what could not be since its start.
    Result<RecordingState> stopRecording();
    /// For a recording of nothing: closes and removes it.
    void discardRecording();
    /// Writes the last minute as a recording of its own.
    [[nodiscard]] Result<Done> keepRecent(const std::filesystem::path& path) const;

    /// Ends the connection; the sweep is finished as it is.
    void stop();

private:
    [[nodiscard]] std::unique_ptr<scanner::LiveConnection> connect(scanner::ConnectionSettings settings);
    void changedTo(const scanner::ConnectionState& state);
    void received(const scanner::ColaFrame& frame);
    void received(RecordingMessage message, const scanner::HostTime& time, bool isLine);
    template <class AddLines>
    void addMessage(const RecordingMessagePtr& message, const scanner::HostTime& time, const AddLines& addLines);
    [[nodiscard]] bool comesAfterTheLast(bool isLine);
    void record(RecordingMessagePtr message);
    [[nodiscard]] std::vector<RecordingMessagePtr> messagesOfSweep() const; // with the lock
    [[nodiscard]] scanner::SweepSettings sweepSettings() const;

    const std::function<void()> changed_;
    const std::int64_t mostLines_;         // 0: all
    scanner::SweepSettings sweepSettings_; // with the lock below, after the constructor
    RecordingClock clock_;
    RecentMessages recent_;
    mutable std::mutex mutex_; // of all that follows, but not of the connection
    scanner::SweepFeed feed_;
    std::unique_ptr<LiveSource> source_; // of a bridge; null: a scanner of SICK
    scanner::ConnectionState state_;
    std::optional<scanner::ScannerIdentity> identity_;
    std::unique_ptr<RecordingWriter> recorder_;
    bool starting_ = false;          // a recorder is being made
    RecordingMessagePtr sweepFirst_; // that began the sweep under way; null: the first one
    std::int64_t lines_ = 0, linesAfter_ = 0;
    std::deque<std::int64_t> lineNs_;                     // of the last lines, monotonic
    std::unique_ptr<scanner::LiveConnection> connection_; // null: this build has none. Last: its thread uses all of the above
};

} // namespace edgescan::files
