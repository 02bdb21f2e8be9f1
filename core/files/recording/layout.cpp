// Topics, schemas and messages of "sweep/1".
#include "core/files/recording/layout.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/physical_limits.h"
#include "core/base/utc_time.h"
#include "core/base/version.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace edgescan::files {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, kRecordingTopics> kTopics{"/lidar/cola_rx", "/lidar/cola_tx", "/stepper",
                                                            "/inclinometer",  "/talin",         "/line"};

std::uint16_t channelIdOf(RecordingTopic topic) { return static_cast<std::uint16_t>(static_cast<int>(topic) + 1); }

/// A JSON Schema of flat objects: "name:type", a '!' in front of the keys that must be there.
std::string jsonSchema(const char* title, std::initializer_list<std::pair<const char*, const char*>> keys) {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}, {"type", "object"}};
    Json required = Json::array();
    for (const auto& [name, type] : keys) {
        const bool must = *name == '!';
        schema["properties"][must ? name + 1 : name] = {{"type", type}};
        if (must) required.push_back(name + 1);
    }
    schema["required"] = required;
    return jsonText(schema);
}

std::vector<containers::McapSchema> schemas() {
    constexpr const char* kNumber = "number";
    constexpr const char* kInteger = "integer";
    constexpr const char* kString = "string";
    return {
        {1, "sick.cola.frame", "text", "One complete CoLa frame as on the wire (B: 02020202 length payload xor; A: STX text ETX)"},
        {2, "sweep.Stepper", "jsonschema",
         jsonSchema("sweep.Stepper",
                    {{"!step", kInteger}, {"!phi_deg", kNumber}, {"rate_deg_s", kNumber}, {"moving", "boolean"}, {"t_host_ns", kInteger}})},
        {3, "sweep.Inclinometer", "jsonschema",
         jsonSchema("sweep.Inclinometer",
                    {{"!tilt_x_deg", kNumber}, {"!tilt_y_deg", kNumber}, {"temp_c", kNumber}, {"t_host_ns", kInteger}})},
        {4, "sweep.Talin", "jsonschema",
         jsonSchema("sweep.Talin", {{"!northing_m", kNumber},
                                    {"!easting_m", kNumber},
                                    {"!elevation_m", kNumber},
                                    {"!heading_deg", kNumber},
                                    {"!pitch_deg", kNumber},
                                    {"!roll_deg", kNumber},
                                    {"heading_ref", kString},
                                    {"zone", kString},
                                    {"datum", kString},
                                    {"status", kInteger},
                                    {"t_host_ns", kInteger}})},
        {5, "sweep.Line", "jsonschema",
         jsonSchema("sweep.Line", {{"!line", kInteger},
                                   {"!telegram_counter", kInteger},
                                   {"scan_counter", kInteger},
                                   {"!t_dev_us", kInteger},
                                   {"t_host_ns", kInteger},
                                   {"!step", kInteger},
                                   {"!phi0_deg", kNumber},
                                   {"phi_rate_deg_s", kNumber},
                                   {"status", kInteger},
                                   {"flags", kInteger}})},
    };
}

struct DeviceTimes {
    std::uint32_t sinceStartUs = 0, transmittedUs = 0;
};

/// The two device times of a scan telegram, straight from their places (docs/developer/protocol.md, "Scan telegram"), without decoding the
/// rest.
std::optional<DeviceTimes> deviceTimes(ByteView frame) {
    constexpr std::size_t kBinaryPayload = 8;
    constexpr std::size_t kBinaryTimes = 38;
    const bool binary = frame.size() > kBinaryPayload && std::all_of(frame.begin(), frame.begin() + 4, [](auto b) { return b == 2; });
    const ByteView payload = frame.subspan(std::min(frame.size(), binary ? kBinaryPayload : std::size_t{1}));
    if (!scanner::isScanTelegram(payload)) return std::nullopt;
    if (binary) {
        if (frame.size() < kBinaryTimes + 8) return std::nullopt;
        const auto number = [&](std::size_t at) {
            return std::uint32_t{frame[at]} << 24U | std::uint32_t{frame[at + 1]} << 16U | std::uint32_t{frame[at + 2]} << 8U |
                   frame[at + 3];
        };
        return DeviceTimes{number(kBinaryTimes), number(kBinaryTimes + 4)};
    }
    constexpr int kTokensBefore = 9;
    const char* at = reinterpret_cast<const char*>(payload.data());
    const char* last = at + payload.size();
    for (int token = 0; token < kTokensBefore; ++token) {
        at = std::find(at, last, ' ');
        if (at == last) return std::nullopt;
        ++at;
    }
    DeviceTimes times;
    const auto first = std::from_chars(at, last, times.sinceStartUs, 16);
    if (first.ec != std::errc{} || first.ptr == last) return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, last, times.transmittedUs, 16);
    return second.ec == std::errc{} ? std::optional(times) : std::nullopt;
}

template <class T>
T numberOr(const Json& object, const char* key, T otherwise) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->template get<T>() : otherwise;
}

} // namespace

std::optional<RecordingTopic> topicNamed(std::string_view name) {
    for (std::size_t i = 0; i < kTopics.size(); ++i) {
        if (name == kTopics[i]) return static_cast<RecordingTopic>(i);
    }
    return std::nullopt;
}

Bytes stepperJson(const scanner::StepperReading& reading) {
    const Json object{{"step", reading.step},
                      {"phi_deg", reading.phiDeg},
                      {"rate_deg_s", reading.degPerSecond},
                      {"moving", reading.moving},
                      {"t_host_ns", reading.hostNs}};
    const std::string text = jsonText(object);
    return {text.begin(), text.end()};
}

std::optional<scanner::StepperReading> parseStepper(ByteView json, std::int64_t hostNs) {
    const auto parsed = parseOrderedJson({reinterpret_cast<const char*>(json.data()), json.size()}, "", kReadingJson);
    if (!parsed) return std::nullopt;
    const Json& object = *parsed;
    if (!object.is_object() || !object.contains("phi_deg") || !object["phi_deg"].is_number()) return std::nullopt;
    scanner::StepperReading reading;
    reading.phiDeg = object["phi_deg"].get<double>();
    reading.degPerSecond = numberOr(object, "rate_deg_s", 0.0);
    reading.step = numberOr<std::int64_t>(object, "step", 0);
    reading.moving = object.value("moving", Json(reading.degPerSecond != 0.0)) == Json(true);
    const auto stated = numberOr<std::int64_t>(object, "t_host_ns", hostNs);
    reading.hostNs = stated >= 0 && stated <= kLatestNs ? stated : hostNs;
    const bool sane = physical::kLineDeg.hold(reading.phiDeg) && physical::kLineDeg.hold(reading.degPerSecond);
    return sane ? std::optional(reading) : std::nullopt;
}

RecordingEncoder::RecordingEncoder(const scanner::SweepMetadata& metadata, containers::McapLimits limits)
    : encoder_(std::string("edgescan ") + version(), limits) {
    for (const containers::McapSchema& schema : schemas()) encoder_.schema(schema);
    const auto dialect = metadata.find("lidar.dialect");
    for (std::size_t i = 0; i < kTopics.size(); ++i) {
        const bool cola = i < 2;
        containers::McapChannel channel{
            static_cast<std::uint16_t>(i + 1), static_cast<std::uint16_t>(cola ? 1 : i), kTopics[i], cola ? "x-sick-cola" : "json", {}};
        if (cola && dialect != metadata.end()) channel.metadata["dialect"] = dialect->second;
        encoder_.channel(channel);
    }
    scanner::SweepMetadata all{{"format", "sweep/1"}, {"software", std::string("edgescan ") + version()}};
    for (const auto& [key, value] : metadata) all[key] = value;
    encoder_.metadata({"sweep", all});
}

/// The line's own time by the host's clock; for everything else the time of receipt.
std::int64_t RecordingEncoder::publishNs(const RecordingMessage& message) {
    if (message.topic == RecordingTopic::Bridge && message.bridgeNs > 0) return message.bridgeNs;
    if (message.topic != RecordingTopic::ColaRx) return message.hostNs;
    const auto times = deviceTimes(message.payload);
    if (!times) return message.hostNs;
    const auto before = static_cast<std::uint32_t>(deviceUs_.value_or(0));
    const std::int64_t ahead = static_cast<std::int32_t>(times->sinceStartUs - before);
    constexpr std::int64_t kRestartUs = -10'000'000; // a clock set back by more was restarted
    if (!deviceUs_ || ahead < kRestartUs) {
        clock_.restart();
        deviceUs_ = times->sinceStartUs;
    } else {
        deviceUs_ = *deviceUs_ + ahead;
    }
    const std::int64_t sent = *deviceUs_ + static_cast<std::int32_t>(times->transmittedUs - times->sinceStartUs);
    clock_.line(sent, message.hostNs);
    return clock_.hostNs(*deviceUs_);
}

/// The channel of a message; a topic of a bridge gets schema and channel with its first message, so that the file is a ROS 2 bag, too.
std::uint16_t RecordingEncoder::channelOf(const RecordingMessage& message) {
    constexpr std::uint16_t kFirstOfBridge = 101;
    if (message.topic != RecordingTopic::Bridge || !message.channel) return channelIdOf(message.topic);
    const RecordedChannel& of = *message.channel;
    const auto same = [&](const RecordedChannelPtr& other) {
        return other == message.channel || (other->topic == of.topic && other->type == of.type && other->definition == of.definition &&
                                            other->encoding == of.encoding && other->definitionEncoding == of.definitionEncoding);
    };
    const auto found = std::ranges::find_if(bridge_, same);
    const auto id = static_cast<std::uint16_t>(kFirstOfBridge + (found - bridge_.begin()));
    if (found != bridge_.end()) return id;
    bridge_.push_back(message.channel);
    encoder_.schema({id, of.type, of.definitionEncoding, of.definition});
    encoder_.channel({id, id, of.topic, of.encoding, {}});
    return id;
}

void RecordingEncoder::message(const RecordingMessage& message) {
    const auto logNs = static_cast<std::uint64_t>(std::max<std::int64_t>(0, message.hostNs));
    const auto published = static_cast<std::uint64_t>(std::max<std::int64_t>(0, publishNs(message)));
    const std::uint16_t channel = channelOf(message);
    encoder_.message({channel, sequence_[channel]++, logNs, published, message.payload});
}

} // namespace edgescan::files
