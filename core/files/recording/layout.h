// The recording layout "sweep/1" (docs/reference/recordings.md, "Topics"): topics, their schemas, and what is in their messages.
#pragma once

#include "core/containers/mcap/writer.h"
#include "core/scanner/sweep_assembly/counters.h"
#include "core/scanner/sweep_assembly/stepper_track.h"

#include <array>
#include <memory>
#include <optional>

namespace edgescan::files {

enum class RecordingTopic : std::uint8_t { ColaRx, ColaTx, Stepper, Inclinometer, Talin, Line };
inline constexpr int kRecordingTopics = 6;

/// "/lidar/cola_rx", "/stepper" ...
[[nodiscard]] std::optional<RecordingTopic> topicNamed(std::string_view name);

/// One message, made once, never changed.
struct RecordingMessage {
    RecordingTopic topic = RecordingTopic::ColaRx;
    std::int64_t hostNs = 0; ///< first byte received, sent, or read; ns since 1970 UTC
    Bytes payload;           ///< the exact frame, or JSON
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
    Bytes take() { return encoder_.take(); }
    /// Messages that take() would not give yet.
    [[nodiscard]] std::uint64_t openMessages() const { return encoder_.openMessages(); }

private:
    [[nodiscard]] std::int64_t publishNs(const RecordingMessage& message);

    containers::McapEncoder encoder_;
    std::array<std::uint32_t, kRecordingTopics> sequence_{};
    scanner::DeviceClock clock_;
    std::optional<std::int64_t> deviceUs_; // of the last line, unwrapped
};

} // namespace edgescan::files
