// A permanent connection to a scanner: connect, identify, subscribe, watch, reconnect; on its own thread. It only reads.
#pragma once

#include "core/scanner/sick_lms/scanner_dialogue.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace edgescan::scanner {

enum class ConnectionPhase : std::uint8_t {
    Connecting,
    Identifying, ///< identifies and subscribes, until the first scan
    Live,
    Stale,   ///< connected, but without a scan for half of the watchdog's time
    Lost,    ///< not connected; reconnects by itself
    Stopped, ///< permanently, because stop() was called
};
[[nodiscard]] const char* connectionPhaseName(ConnectionPhase phase);

struct ConnectionState {
    ConnectionPhase phase = ConnectionPhase::Connecting;
    std::string sentence; ///< what happened and what to do, for the operator
    HostTime since;
    /// why scans are missing: the reason that ended the last connection or attempt; empty while scans arrive
    std::optional<Error> problem{};
};

/// The error for a scanner at `address` that never sent a line.
[[nodiscard]] Error noLinesError(const ConnectionState& state, const std::string& address);

struct ConnectionSettings {
    std::string host; ///< name, IPv4 or IPv6 address
    std::uint16_t port = 2112;
    std::optional<Dialect> dialect; ///< empty: detect it
    ScannerTimeouts timeouts;
    bool bridge = false;      ///< a robot's Foxglove bridge answers there, and not a scanner
    std::string topic, joint; ///< of a bridge; empty: the one that is found
};

/// All functions are called on the connection's thread and delay receiving while they run. They are not called after stop() has returned.
struct ConnectionEvents {
    std::function<void(const ConnectionState&)> stateChanged;
    std::function<void(const ScannerIdentity&)> identified; ///< at every connection
    std::function<void(const ColaFrame&)> frameReceived;    ///< every frame as it was on the wire, before it is parsed
    std::function<void(const ColaFrame&)> frameSent;        ///< `received` is the time of sending
};

struct ConnectionStatistics {
    ColaCounts stream; ///< bytes, frames, skipped bytes and reasons, over all connections
    std::uint64_t scans = 0;
    std::uint64_t connections = 0;
    std::uint64_t reconnects = 0; ///< connections made again after a loss
};

/// A permanent connection, whatever answers there: it connects, watches, and connects again after a loss; on its own thread.
/// The constructor of a derived class ends with begin(), its destructor begins with stop().
class LiveConnection {
public:
    LiveConnection(const LiveConnection&) = delete;
    LiveConnection& operator=(const LiveConnection&) = delete;
    virtual ~LiveConnection() = default;

    /// Ends every wait at once and returns when the thread has ended. Inside an event it only requests the end.
    void stop();
    [[nodiscard]] ConnectionState state() const;
    [[nodiscard]] ConnectionStatistics statistics() const;

protected:
    using Clock = Link::Clock;

    LiveConnection(ConnectionSettings settings, std::function<void(const ConnectionState&)> stateChanged);
    void begin();
    void enter(ConnectionPhase phase, std::string sentence, std::optional<Error> problem = std::nullopt);
    [[nodiscard]] std::string where() const { return addressText(settings_.host, settings_.port); }

    const ConnectionSettings settings_;
    std::atomic<std::uint64_t> scans_{0};

    // Used by the thread only.
    std::uint64_t scansHere_ = 0; ///< scans on this connection
    Clock::time_point lastScan_;
    double periodS_ = 0.0; ///< between scans; 0: unknown
    Clock::duration firstScanTimeout_;
    std::string note_; ///< follows the sentence that scans arrive; may be empty

private:
    virtual Link& link() = 0;
    [[nodiscard]] virtual ColaCounts counts() const = 0;
    /// From the accepted connection to the subscription.
    virtual Result<Done> start() = 0;
    /// Receives once, until the deadline at the latest.
    virtual Result<Done> receive(Clock::time_point deadline) = 0;
    /// The error when no scan came for this time.
    [[nodiscard]] virtual Error silent(const std::string& time) const = 0;

    void run();
    Error connection();
    Error watch();
    [[nodiscard]] Clock::duration watchdog() const;

    const std::function<void(const ConnectionState&)> stateChanged_;
    mutable std::mutex mutex_; ///< protects state_
    ConnectionState state_;
    std::atomic<std::uint64_t> connections_{0};
    std::thread thread_;
};

class ScannerConnection final : public LiveConnection {
public:
    /// Starts at once.
    ScannerConnection(ConnectionSettings settings, ConnectionEvents events);
    ~ScannerConnection() override { stop(); }

private:
    Link& link() override { return link_; }
    [[nodiscard]] ColaCounts counts() const override { return link_.counts(); }
    Result<Done> start() override;
    Result<Done> receive(Clock::time_point deadline) override;
    [[nodiscard]] Error silent(const std::string& time) const override;
    void noticeScan(const ColaFrame& frame);

    const ConnectionEvents events_;

    // Used by the thread only.
    Dialect dialect_; ///< dialect of the last connection: tried first
    std::uint16_t everyNth_ = 1;
    ColaLink link_;
};

} // namespace edgescan::scanner
