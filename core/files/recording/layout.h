// The recording layout "sweep/1" (docs/reference/recordings.md, "Topics"): topics, their schemas, and what is in their messages.
#pragma once

#include "core/containers/mcap/writer.h"
#include "core/scanner/sweep_assembly/counters.h"
#include "core/scanner/sweep_assembly/line_angles.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::files {

/// Bridge: a topic of a robot's bridge, with a channel of its own.
enum class RecordingTopic : std::uint8_t { ColaRx, ColaTx, Stepper, Inclinometer, Talin, Line, Bridge };
inline constexpr int kRecordingTopics = 6; ///< without Bridge

/// "/lidar/cola_rx", "/stepper" ...
[[nodiscard]] std::optional<RecordingTopic> topicNamed(std::string_view name);

/// A topic of a robot's bridge.
struct RecordedChannel {
    std::uint32_t id = 0; ///< as the bridge counts it
    std::string topic;
    std::string encoding;           ///< of its messages: "cdr", "ros1", "json"
    std::string type;               ///< "sensor_msgs/msg/LaserScan"
    std::string definition;         ///< text
    std::string definitionEncoding; ///< "ros2msg"; empty: the bridge does not say

    bool operator==(const RecordedChannel&) const = default;
};
using RecordedChannelPtr = std::shared_ptr<const RecordedChannel>;

/// One message, made once, never changed.
struct RecordingMessage {
    RecordingTopic topic = RecordingTopic::ColaRx;
    std::int64_t hostNs = 0;      ///< first byte received, sent, or read; ns since 1970 UTC
    Bytes payload;                ///< the exact frame, or JSON, or a message of a robot as it came
    RecordedChannelPtr channel{}; ///< of Bridge
    std::int64_t bridgeNs = 0;    ///< of Bridge: when the bridge received it
};
using RecordingMessagePtr = std::shared_ptr<const RecordingMessage>;

/// {"step":..,"phi_deg":..,"rate_deg_s":..,"moving":..,"t_host_ns":..}
[[nodiscard]] Bytes stepperJson(const scanner::StepperReading& reading);
/// Nothing when the JSON has no number "phi_deg". `hostNs` is taken when it does not say when it was read.
[[nodiscard]] std::optional<scanner::StepperReading> parseStepper(ByteView json, std::int64_t hostNs);

/// Turns messages into the bytes of a recording.
class RecordingEncoder {
public:
    explicit RecordingEncoder(const scanner::SweepMetadata& metadata, containers::McapLimits limits = {});

    void message(const RecordingMessage& message);
    void endChunk() { encoder_.endChunk(); }
    void finish() { encoder_.finish(); }
    Bytes popBytes() { return encoder_.popBytes(); }
    /// Messages that popBytes() would not give yet.
    [[nodiscard]] std::uint64_t openMessages() const { return encoder_.openMessages(); }

private:
    [[nodiscard]] std::int64_t publishNs(const RecordingMessage& message);
    [[nodiscard]] std::uint16_t channelOf(const RecordingMessage& message);

    containers::McapEncoder encoder_;
    std::vector<RecordedChannelPtr> bridge_;          ///< channels of a bridge that have been written
    std::map<std::uint16_t, std::uint32_t> sequence_; // by channel
    scanner::DeviceClock clock_;
    std::optional<std::int64_t> deviceUs_; // of the last line, unwrapped
};

} // namespace edgescan::files
