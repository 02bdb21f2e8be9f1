// A permanent connection to a Foxglove bridge: connect, choose topics, subscribe, watch, reconnect; on its own thread. It only reads.
#pragma once

#include "core/base/bytes.h"
#include "core/robots/bridge/protocol.h"
#include "core/scanner/cola/link.h"
#include "core/scanner/sick_lms/scanner_connection.h"

#include <map>
#include <optional>
#include <string>

namespace edgescan::robots {

struct WebSocketMessage {
    bool isText = false;
    Bytes bytes;
    scanner::HostTime received;
};

class WebSocket : public scanner::Link {
public:
    WebSocket();

    Result<Done> send(const std::string& text, Clock::duration timeout);
    /// Empty if the deadline passes or another thread interrupts. Error: the connection is gone, or a message is longer than 64 MB.
    Result<std::optional<WebSocketMessage>> receive(Clock::time_point deadline);

private:
    struct Messages;
    [[nodiscard]] Messages& messages() const;
};

/// The topics of a bridge that are wanted.
struct BridgeChoice {
    std::vector<BridgeChannelPtr> channels;
    BridgeChannelPtr lines; ///< one of them: its messages are scan lines
    std::string note;       ///< a sentence that the choice is a guess; may be empty
};

/// All functions are called on the connection's thread. They are not called after stop() has returned.
struct BridgeEvents {
    std::function<void(const scanner::ConnectionState&)> stateChanged;
    /// Chooses among all topics that the bridge offers by now. Error: no topic is a laser's.
    std::function<Result<BridgeChoice>(const std::vector<BridgeChannelPtr>&)> choose;
    std::function<void(const BridgeChannelPtr&, const BridgeData&, const scanner::HostTime&)>
        received; ///< every message, before it is parsed
};

class BridgeConnection final : public scanner::LiveConnection {
public:
    /// Starts at once.
    BridgeConnection(scanner::ConnectionSettings settings, BridgeEvents events);
    ~BridgeConnection() override { stop(); }

private:
    scanner::Link& link() override { return socket_; }
    [[nodiscard]] scanner::ColaCounts counts() const override;
    Result<Done> start() override;
    Result<Done> receive(Clock::time_point deadline) override;
    [[nodiscard]] Error silent(const std::string& time) const override;
    Result<Done> receiveText(std::string_view json);
    void receiveData(const WebSocketMessage& message);
    Result<Done> chooseAgain();

    const BridgeEvents events_;
    std::atomic<std::uint64_t> bytes_{0}, skipped_{0};

    // Used by the thread only.
    std::map<std::uint32_t, BridgeChannelPtr> offered_, subscribed_;
    std::optional<Error> noChoice_; ///< why no topic is chosen
    BridgeChannelPtr lines_;
    std::string said_; ///< the last warning of the bridge
    WebSocket socket_;
};

} // namespace edgescan::robots
