// An emulated Foxglove bridge of a robot whose laser is turned, or whose scanner sends whole clouds. It answers subscriptions, notes
// everything else that it is asked, and produces faults on request.
#pragma once

#include "app/lab/emulator/emulator.h"
#include "app/lab/robots/bridge_sweep.h"

#include <map>
#include <memory>
#include <set>
#include <string>

namespace edgescan::robots {

struct EmulatedBridgeStatistics {
    std::uint64_t lines = 0; ///< or clouds: sent or lost on purpose
    std::uint64_t clients = 0;
    std::set<std::string> subscribed;           ///< topics
    std::map<std::string, std::uint64_t> asked; ///< by "op" what clients sent; "binary" for messages that are not text
    bool finished = false;                      ///< AtEnd::Stop: the last line was sent
};

/// Runs on its own thread from construction to destruction. Of the settings of a scanner it uses address, port, lines per second, what
/// comes at the end and these faults: lose, duplicate, garbage (a message that is not JSON), corrupt (a message that is cut off), stall,
/// drop, mute.
class EmulatedBridge {
public:
    ~EmulatedBridge();
    EmulatedBridge(const EmulatedBridge&) = delete;
    EmulatedBridge& operator=(const EmulatedBridge&) = delete;

    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] EmulatedBridgeStatistics statistics() const;
    /// Closes every connection, like a pulled cable.
    void dropConnections();

private:
    friend Result<std::unique_ptr<EmulatedBridge>> serveBridge(BridgeSweep, const scanner::EmulatedScannerSettings&);
    struct Server;
    explicit EmulatedBridge(std::shared_ptr<Server> server);
    std::shared_ptr<Server> server_;
};

/// Starts serving. Error: the address cannot be used, or the sweep has no lines.
[[nodiscard]] Result<std::unique_ptr<EmulatedBridge>> serveBridge(BridgeSweep sweep, const scanner::EmulatedScannerSettings& settings);

} // namespace edgescan::robots
