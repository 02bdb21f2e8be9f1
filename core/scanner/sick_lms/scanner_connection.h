// A permanent connection to a scanner: connect, identify, subscribe, watch, reconnect; on its own thread. It only reads.
#pragma once

#include "core/scanner/cola/commands.h"
#include "core/scanner/cola/link.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace edgescan::scanner {

/// The scanner's description of itself. A value that it refused is empty and listed in `refused`.
struct ScannerIdentity {
    Dialect dialect = Dialect::B;
    std::optional<int> deviceState; ///< SCdevicestate
    std::optional<DeviceIdentity> device;
    std::optional<std::string> firmware;
    std::optional<std::string> location;          ///< the name that the operator gave the scanner
    std::optional<std::uint32_t> operatingTenths; ///< tenths of an hour
    std::optional<std::uint32_t> powerOns;
    std::optional<MeasuringState> measuring;
    std::optional<ScanConfiguration> scan;
    std::optional<OutputRange> range;
    std::optional<TelegramContent> content;
    std::optional<int> echoFilter;
    std::vector<std::string> refused; ///< "DeviceIdent: the variable is not known"

    /// For people: "SN 18110550, firmware V1.80, CoLa B, 25 Hz, 0.1667 degrees from -5 to 185".
    [[nodiscard]] std::string words() const;
};

/// Waiting times.
struct ScannerTimeouts {
    std::chrono::milliseconds connect{5000};
    std::chrono::milliseconds detect{1000};
    std::chrono::milliseconds answer{2000};
    std::chrono::milliseconds firstScan{5000};
    std::chrono::milliseconds startUp{30000}; ///< first scan of a scanner that is still starting
    std::chrono::milliseconds silence{1000};  ///< between two scans; at least ten scan periods
    /// Pauses before connecting again; the last one is repeated.
    std::vector<std::chrono::milliseconds> rests{std::chrono::milliseconds(500), std::chrono::milliseconds(1000),
                                                 std::chrono::milliseconds(2000), std::chrono::milliseconds(4000),
                                                 std::chrono::milliseconds(5000)};
};

class ScannerDialogue {
public:
    /// `onFrame`: called with every frame that arrives during the wait for an answer, because scans keep arriving. `link` must outlive this
    /// object.
    ScannerDialogue(ColaLink& link, const ScannerTimeouts& timeouts, std::function<void(const ColaFrame&)> onFrame)
        : link_(link), timeouts_(timeouts), onFrame_(std::move(onFrame)) {}

    /// Finds the dialect in which the scanner answers, trying `first` first. Returns the device state, or -1 if it cannot be read.
    Result<int> detect(Dialect first, bool onlyThat);
    [[nodiscard]] Dialect dialect() const { return dialect_; }

    /// The answer, which may be a refusal. Error: no answer came, or the connection is gone.
    Result<ColaAnswer> ask(const ColaRequest& request);

private:
    Result<std::optional<ColaAnswer>> await(const ColaRequest& request, std::chrono::milliseconds timeout);

    ColaLink& link_;
    const ScannerTimeouts& timeouts_;
    std::function<void(const ColaFrame&)> onFrame_;
    Dialect dialect_ = Dialect::B;
};

/// Reads everything that describes the scanner and its configuration. A refused read is not an error.
[[nodiscard]] Result<ScannerIdentity> identify(ScannerDialogue& dialogue, int deviceState);

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
    bool bridge = false;       ///< a robot's Foxglove bridge answers there, and not a scanner
    std::string topic, joint;  ///< of a bridge; empty: the one that is found
    bool keepRepeated = false; ///< of a bridge: a range or point that repeats far apart from the rest is measured and not "no return"
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
