// What is asked of a scanner and what it answers, as values alike in both dialects (docs/protocol.md, "Requests and answers").
#pragma once

#include "core/base/result.h"
#include "core/scanner/cola/frames.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan {

/// All that is ever sent: reading a variable, and subscribing to one. Neither changes anything in the scanner.
struct ColaRequest {
    enum class Kind : std::uint8_t { Read, Subscribe };
    Kind kind = Kind::Read;
    std::string name;
};

[[nodiscard]] Bytes encodeRequest(const ColaRequest& request, Dialect dialect);

/// As CoLa A has it: "sRN FirmwareVersion", "sEN LMDscandata 1".
[[nodiscard]] std::string requestText(const ColaRequest& request);

/// LMPscancfg. Angles and steps in 1/10000 degree.
struct ScanConfiguration {
    std::uint32_t frequency = 2500; ///< 1/100 Hz
    std::uint16_t sectors = 1;
    std::uint32_t step = 1667;
    std::int32_t startAngle = -50000;
    std::int32_t stopAngle = 1850000;

    bool operator==(const ScanConfiguration&) const = default;
};

/// LMPoutputRange.
struct OutputRange {
    std::uint16_t sectors = 1;
    std::uint32_t step = 1667;
    std::int32_t startAngle = -50000;
    std::int32_t stopAngle = 1850000;

    bool operator==(const OutputRange&) const = default;
};

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

enum class AnswerKind : std::uint8_t {
    Read,       ///< sRA
    Subscribed, ///< sEA
    Telegram,   ///< sSN: sent by a subscription
    Refused,    ///< sFA
    Other,      ///< sWA, sAN, sMA: answers to what is never sent; a recording of other origin may hold them
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

/// Whether this answers that: kind and name, or a refusal (requests go one at a time).
[[nodiscard]] bool answers(const ColaAnswer& answer, const ColaRequest& request);

/// A code of sFA in words, "the variable is not known".
[[nodiscard]] const char* refusalText(int code);

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

/// STlms: 7 is measuring. Date and time are the scanner's own.
struct MeasuringState {
    int state = 0;
    std::string time, date;
};
[[nodiscard]] Result<MeasuringState> parseMeasuringState(const ColaAnswer& answer);
/// SCdevicestate: 0 busy, 1 ready, 2 error.
[[nodiscard]] const char* deviceStateText(int state);

} // namespace edgescan
