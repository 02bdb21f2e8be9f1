// A permanent connection to a Foxglove bridge: connect, choose topics, subscribe, watch, reconnect; on its own thread. It only reads.
#pragma once

#include "core/scanner/foxglove/protocol.h"
#include "core/scanner/foxglove/web_socket.h"
#include "core/scanner/sick_lms/scanner_connection.h"

#include <map>
#include <set>

namespace edgescan::scanner {

/// The topics of a bridge that are wanted.
struct BridgeChoice {
    std::vector<BridgeChannelPtr> channels;
    BridgeChannelPtr lines; ///< one of them: its messages are scan lines
    std::string note;       ///< a sentence that the choice is a guess; may be empty
};

/// All functions are called on the connection's thread. They are not called after stop() has returned.
struct BridgeEvents {
    std::function<void(const ConnectionState&)> stateChanged;
    /// Chooses among all topics that the bridge offers by now. Error: no topic is a laser's.
    std::function<Result<BridgeChoice>(const std::vector<BridgeChannelPtr>&)> choose;
    std::function<void(const BridgeChannelPtr&, const BridgeData&, const HostTime&)> received; ///< every message, before it is parsed
};

class BridgeConnection : public LiveConnection {
public:
    /// Starts at once.
    BridgeConnection(ConnectionSettings settings, BridgeEvents events);
    ~BridgeConnection() override;
    BridgeConnection(const BridgeConnection&) = delete;
    BridgeConnection& operator=(const BridgeConnection&) = delete;

    /// Ends every wait at once and returns when the thread has ended. Inside an event it only requests the end.
    void stop() override;
    [[nodiscard]] ConnectionState state() const override;
    [[nodiscard]] ConnectionStatistics statistics() const override;

private:
    using Clock = WebSocket::Clock;

    void run();
    Error connection();
    Error watch();
    Result<Done> take(const WebSocketMessage& message);
    Result<Done> takeText(std::string_view json);
    void takeData(const WebSocketMessage& message);
    Result<Done> chooseAgain();
    void enter(ConnectionPhase phase, std::string sentence, std::optional<Error> problem = std::nullopt);
    [[nodiscard]] Clock::duration watchdog() const;
    [[nodiscard]] std::string where() const { return addressText(settings_.host, settings_.port); }

    const ConnectionSettings settings_;
    const BridgeEvents events_;
    mutable std::mutex mutex_; ///< protects state_
    ConnectionState state_;
    std::atomic<std::uint64_t> scans_{0}, connections_{0}, bytes_{0}, skipped_{0};

    // Used by the thread only.
    std::map<std::uint32_t, BridgeChannelPtr> offered_, subscribed_;
    std::optional<Error> noChoice_; ///< why no topic is chosen
    BridgeChannelPtr lines_;
    std::string note_, said_;     ///< said_: the last warning of the bridge
    std::uint64_t scansHere_ = 0; ///< lines on this connection
    Clock::time_point lastScan_;
    double periodS_ = 0; ///< between lines, smoothed; 0: unknown

    WebSocket socket_;
    std::thread thread_; // last member: the thread starts when all the others exist
};

} // namespace edgescan::scanner
