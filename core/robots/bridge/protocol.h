// The Foxglove WebSocket protocol (public specification, github.com/foxglove/ws-protocol): what a bridge on a robot says, and the one thing
// that is said to it, a subscription.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/files/recording/layout.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::robots {

/// A topic that a bridge offers.
using BridgeChannel = files::RecordedChannel;
using BridgeChannelPtr = files::RecordedChannelPtr;

/// A message of text. What is not listed here is not used.
struct BridgeText {
    std::string op;                     ///< "serverInfo", "advertise", "unadvertise", "status" ...
    std::string server;                 ///< serverInfo: its name
    std::vector<BridgeChannel> offered; ///< advertise
    std::vector<std::uint32_t> gone;    ///< unadvertise: ids
    std::string problem;                ///< status: a warning or an error
};
/// Channels without id or topic are left out. Error: not a JSON object with an "op".
Result<BridgeText> bridgeText(std::string_view json, const std::string& where);

/// A message of a topic.
struct BridgeData {
    std::uint32_t subscription = 0;
    std::int64_t bridgeNs = 0; ///< when the bridge received it, ns since 1970 UTC
    ByteView payload;
};
/// Empty: another kind of binary message, or one that is cut off.
[[nodiscard]] std::optional<BridgeData> bridgeData(ByteView message);
/// The same as bytes, for an emulated bridge.
[[nodiscard]] Bytes bridgeDataBytes(const BridgeData& data);

/// Asks for the messages of these channels; a subscription has the number of its channel.
[[nodiscard]] std::string subscribeText(const std::vector<BridgeChannelPtr>& channels);

} // namespace edgescan::robots
