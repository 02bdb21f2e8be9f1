// A scanner kept alive: connect, identify, subscribe, watch, reconnect; on a thread of its own. It only reads.
#pragma once

#include "core/scanner/sick_lms/scanner_dialogue.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace edgescan {

enum class SessionPhase : std::uint8_t {
    Connecting,
    Identifying, ///< asking who it is and subscribing, until the first scan
    Live,
    Stale,   ///< connected, but no scan for half of the watchdog's time
    Lost,    ///< not connected; tries again by itself
    Stopped, ///< for good, because stop() was called
};
[[nodiscard]] const char* sessionPhaseName(SessionPhase phase);

struct SessionState {
    SessionPhase phase = SessionPhase::Connecting;
    std::string sentence; ///< what happened and what to do, for the operator
    HostTime since;
    std::optional<Error> problem{}; ///< why there is no scan: what ended the last connection, or the try for one; empty while scans come
};

/// What to say where no line has come from `address`.
[[nodiscard]] Error withoutLines(const SessionState& state, const std::string& address);

struct SessionSettings {
    std::string host; ///< name, IPv4 or IPv6 address
    std::uint16_t port = 2112;
    std::optional<Dialect> dialect; ///< empty: find out
    ScannerTimeouts timeouts;
};

/// All are called on the session's thread and hold up receiving while they run; none may be called after stop() returned.
struct SessionEvents {
    std::function<void(const SessionState&)> stateChanged;
    std::function<void(const ScannerIdentity&)> identified; ///< at every connection
    std::function<void(const ColaFrame&)> frameReceived;    ///< every frame as it was on the wire, before anything looks into it
    std::function<void(const ColaFrame&)> frameSent;        ///< `received` is the time of sending
};

struct SessionStatistics {
    ColaCounts stream; ///< bytes, frames, skipped bytes and why, over all connections
    std::uint64_t scans = 0;
    std::uint64_t connections = 0;
    std::uint64_t reconnects = 0; ///< connections that were made again after a loss
};

class ScannerSession {
public:
    /// Starts at once.
    ScannerSession(SessionSettings settings, SessionEvents events);
    ~ScannerSession();
    ScannerSession(const ScannerSession&) = delete;
    ScannerSession& operator=(const ScannerSession&) = delete;

    /// Ends every wait at once and returns when the thread is done. From within an event it only asks for it.
    void stop();

    [[nodiscard]] SessionState state() const;
    [[nodiscard]] SessionStatistics statistics() const;

private:
    using Clock = ColaLink::Clock;

    void run();
    Error connection();
    Result<Done> start(ScannerDialogue& dialogue);
    Error watch();
    void noticeScan(const ColaFrame& frame);
    void enter(SessionPhase phase, std::string sentence, std::optional<Error> problem = std::nullopt);
    [[nodiscard]] Clock::duration watchdog() const;
    [[nodiscard]] std::string where() const { return addressText(settings_.host, settings_.port); }

    const SessionSettings settings_;
    const SessionEvents events_;
    mutable std::mutex mutex_; ///< of state_
    SessionState state_;
    std::atomic<std::uint64_t> scans_{0}, connections_{0};

    // The thread's own.
    Dialect dialect_;             ///< of the last connection: tried first
    double periodS_ = 0.0;        ///< between telegrams; 0 while unknown
    std::uint64_t scansHere_ = 0; ///< on this connection
    Clock::time_point lastScan_;
    Clock::duration firstScanTimeout_{};
    std::uint16_t everyNth_ = 1;

    ColaLink link_;
    std::thread thread_; // last: starts when all the rest is there
};

} // namespace edgescan
