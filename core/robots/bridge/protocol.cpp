// JSON and bytes of the Foxglove WebSocket protocol.
#include "core/robots/bridge/protocol.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace edgescan::robots {
namespace {

using Json = nlohmann::json;

constexpr std::uint8_t kMessageData = 1;
constexpr std::size_t kDataHead = 1 + 4 + 8;

std::string textIn(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::uint32_t> idIn(const Json& value) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
    return value.get<std::uint32_t>();
}

std::optional<BridgeChannel> channelIn(const Json& value) {
    if (!value.is_object() || !value.contains("id")) return std::nullopt;
    const auto id = idIn(value["id"]);
    BridgeChannel channel{id.value_or(0),          textIn(value, "topic"),         textIn(value, "encoding"), textIn(value, "schemaName"),
                          textIn(value, "schema"), textIn(value, "schemaEncoding")};
    if (!id || channel.topic.empty()) return std::nullopt;
    return channel;
}

} // namespace

Result<BridgeText> bridgeText(std::string_view json, const std::string& where) {
    constexpr std::size_t kLongest = std::size_t{4} << 20U; // a robot's topics with their definitions take a quarter of it
    if (json.size() > kLongest)
        return Error{"the bridge describes its topics in a text of more than 4 MB", where,
                     "choose another bridge, or let it offer fewer topics"};
    const auto parsed = parseJson(json, where);
    if (!parsed || !parsed->is_object() || textIn(*parsed, "op").empty())
        return Error{"what it sends is not the Foxglove WebSocket protocol", where,
                     "check the port (8765) and that foxglove_bridge runs there"};
    BridgeText text;
    text.op = textIn(*parsed, "op");
    if (text.op == "serverInfo") text.server = textIn(*parsed, "name");
    if (text.op == "advertise" && parsed->contains("channels")) {
        for (const Json& value : (*parsed)["channels"]) {
            if (auto channel = channelIn(value)) text.offered.push_back(std::move(*channel));
        }
    }
    if (text.op == "unadvertise" && parsed->contains("channelIds")) {
        for (const Json& value : (*parsed)["channelIds"]) {
            if (const auto id = idIn(value)) text.gone.push_back(*id);
        }
    }
    const bool bad = parsed->contains("level") && (*parsed)["level"].is_number() && (*parsed)["level"].get<double>() >= 1;
    if (text.op == "status" && bad) text.problem = textIn(*parsed, "message");
    return text;
}

std::optional<BridgeData> bridgeData(ByteView message) {
    if (message.size() < kDataHead || message[0] != kMessageData) return std::nullopt;
    BridgeData data;
    data.subscription = static_cast<std::uint32_t>(littleEndian(message.subspan(1, 4)));
    const std::uint64_t ns = littleEndian(message.subspan(5, 8));
    data.bridgeNs = ns <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) ? static_cast<std::int64_t>(ns) : 0;
    data.payload = message.subspan(kDataHead);
    return data;
}

Bytes bridgeDataBytes(const BridgeData& data) {
    Bytes bytes{kMessageData};
    for (unsigned n = 0; n < 4; ++n) bytes.push_back(static_cast<std::uint8_t>(data.subscription >> (8 * n)));
    for (unsigned n = 0; n < 8; ++n) bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(data.bridgeNs) >> (8 * n)));
    bytes.insert(bytes.end(), data.payload.begin(), data.payload.end());
    return bytes;
}

std::string subscribeText(const std::vector<BridgeChannelPtr>& channels) {
    Json subscriptions = Json::array();
    for (const BridgeChannelPtr& channel : channels) subscriptions.push_back({{"id", channel->id}, {"channelId", channel->id}});
    return jsonText(Json{{"op", "subscribe"}, {"subscriptions", subscriptions}});
}

} // namespace edgescan::robots
