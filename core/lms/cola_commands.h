// What is said to a scanner and what it answers, as values, alike for both dialects (docs/protocol.md, "Requests and answers").
#pragma once

#include "core/base/result.h"
#include "core/lms/cola_frames.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace edgescan {

/// One argument of a request; the type decides its width in CoLa B.
using ColaArgument = std::variant<std::uint8_t, std::uint16_t, std::uint32_t, std::int32_t, float, std::string>;

struct ColaRequest {
    std::string type; ///< sRN read, sWN write, sMN method, sEN subscribe
    std::string name;
    std::vector<ColaArgument> arguments;

    /// Reads and subscriptions change nothing in the scanner.
    [[nodiscard]] bool readsOnly() const { return type == "sRN" || type == "sEN"; }
};

[[nodiscard]] Bytes encodeRequest(const ColaRequest& request, Dialect dialect);

/// The request with its arguments in words, for logs and sentences: "sMN mLMPsetscancfg 2500 1 1667 -50000 1850000".
[[nodiscard]] std::string requestText(const ColaRequest& request);

[[nodiscard]] ColaRequest readRequest(std::string name);
[[nodiscard]] ColaRequest subscribeRequest(std::string name, bool on);

/// Levels of SetAccessMode; the hashes are the factory's.
enum class AccessLevel : std::uint8_t { Maintenance = 2, AuthorisedClient = 3, Service = 4 };
[[nodiscard]] std::uint32_t accessHash(AccessLevel level);
[[nodiscard]] ColaRequest logInRequest(AccessLevel level = AccessLevel::AuthorisedClient);

/// LMPscancfg. Angles and steps in 1/10000 degree.
struct ScanConfiguration {
    std::uint32_t frequency = 2500; ///< 1/100 Hz
    std::uint16_t sectors = 1;
    std::uint32_t step = 1667;
    std::int32_t startAngle = -50000;
    std::int32_t stopAngle = 1850000;

    bool operator==(const ScanConfiguration&) const = default;
};
[[nodiscard]] ColaRequest scanConfigurationRequest(const ScanConfiguration& wanted);

/// LMPoutputRange.
struct OutputRange {
    std::uint16_t sectors = 1;
    std::uint32_t step = 1667;
    std::int32_t startAngle = -50000;
    std::int32_t stopAngle = 1850000;

    bool operator==(const OutputRange&) const = default;
};
[[nodiscard]] ColaRequest outputRangeRequest(const OutputRange& wanted);

/// LMDscandatacfg: what a telegram carries.
struct TelegramContent {
    std::uint8_t channels = 1, channelsHigh = 0; ///< mask; the LMS5xx goes by the echo filter instead
    bool remission = true;
    bool remission16 = false; ///< not on LMS5xx
    std::uint8_t unit = 0;
    std::uint8_t encoder = 0, encoderHigh = 0; ///< 0 none, 1 channel 1
    bool position = false, deviceName = false, comment = false, time = true;
    std::uint16_t everyNth = 1; ///< scan

    bool operator==(const TelegramContent&) const = default;
};
[[nodiscard]] ColaRequest telegramContentRequest(const TelegramContent& wanted);

enum class EchoFilter : std::uint8_t { First = 0, All = 1, Last = 2 };
[[nodiscard]] ColaRequest echoFilterRequest(EchoFilter wanted);

enum class AnswerKind : std::uint8_t {
    Read,     ///< sRA
    Written,  ///< sWA
    Method,   ///< sAN
    Event,    ///< sEA
    Accepted, ///< sMA: a slow method has begun, sAN follows
    Telegram, ///< sSN: sent by a subscription
    Refused,  ///< sFA
};

struct ColaAnswer {
    AnswerKind kind = AnswerKind::Read;
    std::string name; ///< empty when refused: the scanner does not say what it refuses
    Bytes arguments;  ///< what follows the name and at most one blank
    int refusal = 0;  ///< code of sFA
    Dialect dialect = Dialect::B;
};

/// Error: this is no answer of a scanner.
[[nodiscard]] Result<ColaAnswer> parseAnswer(ByteView payload, Dialect dialect);

/// Whether this answers that: type letter and name, or a refusal (requests go one at a time).
[[nodiscard]] bool answers(const ColaAnswer& answer, const ColaRequest& request);

/// A code of sFA in words, "the variable is not known".
[[nodiscard]] const char* refusalText(int code);

/// Code and text of the answer for a log; binary arguments in hex.
[[nodiscard]] std::string answerText(const ColaAnswer& answer);

// What the arguments of answers say. Error: cut short or not a number.
[[nodiscard]] Result<int> parseNumber8(const ColaAnswer& answer);
[[nodiscard]] Result<std::uint32_t> parseNumber32(const ColaAnswer& answer);
[[nodiscard]] Result<std::string> parseText(const ColaAnswer& answer);
[[nodiscard]] Result<ScanConfiguration> parseScanConfiguration(const ColaAnswer& answer);
[[nodiscard]] Result<OutputRange> parseOutputRange(const ColaAnswer& answer);
[[nodiscard]] Result<TelegramContent> parseTelegramContent(const ColaAnswer& answer);

/// DeviceIdent: name and version.
struct DeviceIdentity {
    std::string name;
    std::string version;
};
[[nodiscard]] Result<DeviceIdentity> parseDeviceIdentity(const ColaAnswer& answer);

/// The answer to mLMPsetscancfg: what the scanner took.
struct ScanConfigurationTaken {
    int status = 0; ///< 0 taken; else see scanConfigurationProblem()
    ScanConfiguration configuration;
};
[[nodiscard]] Result<ScanConfigurationTaken> parseScanConfigurationTaken(const ColaAnswer& answer);
[[nodiscard]] const char* scanConfigurationProblem(int status);

/// STlms: 7 is measuring. Date and time are the scanner's own.
struct MeasuringState {
    int state = 0;
    std::string time, date;
};
[[nodiscard]] Result<MeasuringState> parseMeasuringState(const ColaAnswer& answer);
[[nodiscard]] const char* measuringStateText(int state);
/// SCdevicestate: 0 busy, 1 ready, 2 error.
[[nodiscard]] const char* deviceStateText(int state);

} // namespace edgescan
