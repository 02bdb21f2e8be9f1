// Requests to a scanner and its answers, as values that are the same for both dialects (docs/developer/protocol.md, "Requests and
// answers").
#pragma once

#include "core/base/result.h"
#include "core/scanner/cola/frames.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// EdgeScan sends only two kinds of request: reading a variable, and subscribing to one. Neither changes anything in the scanner.
struct ColaRequest {
    enum class Kind : std::uint8_t { Read, Subscribe };
    Kind kind = Kind::Read;
    std::string name;
};

[[nodiscard]] Bytes encodeRequest(const ColaRequest& request, Dialect dialect);

/// The request as CoLa A text: "sRN FirmwareVersion", "sEN LMDscandata 1".
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

/// LMPoutputRange. Angles and steps in 1/10000 degree.
struct OutputRange {
    std::uint16_t sectors = 1;
    std::uint32_t step = 1667;
    std::int32_t startAngle = -50000;
    std::int32_t stopAngle = 1850000;

    bool operator==(const OutputRange&) const = default;
};

/// LMDscandatacfg: the content of a telegram.
struct TelegramContent {
    std::uint8_t channels = 1, channelsHigh = 0; ///< mask; the LMS5xx uses the echo filter instead
    bool remission = true;
    bool remission16 = false; ///< not on LMS5xx
    std::uint8_t unit = 0;
    std::uint8_t encoder = 0, encoderHigh = 0; ///< 0 no encoder, 1 channel 1
    bool position = false, deviceName = false, comment = false, time = true;
    std::uint16_t everyNth = 1; ///< every n-th scan is sent

    bool operator==(const TelegramContent&) const = default;
};

enum class AnswerKind : std::uint8_t {
    Read,       ///< sRA
    Subscribed, ///< sEA
    Telegram,   ///< sSN: sent by a subscription
    Refused,    ///< sFA
    Other,      ///< sWA, sAN, sMA: answers to requests that EdgeScan never sends; recordings of other programs may contain them
};

struct ColaAnswer {
    AnswerKind kind = AnswerKind::Read;
    std::string name; ///< empty if refused: the scanner does not name the refused variable
    Bytes arguments;  ///< the bytes behind the name and at most one blank
    int refusal = 0;  ///< code of sFA
    Dialect dialect = Dialect::B;
};

/// Error: the payload is not an answer of a scanner.
[[nodiscard]] Result<ColaAnswer> parseAnswer(ByteView payload, Dialect dialect);

/// Whether the answer belongs to the request: same kind and name, or a refusal (only one request is open at a time).
[[nodiscard]] bool answers(const ColaAnswer& answer, const ColaRequest& request);

/// The meaning of a code of sFA, for example "the variable is not known".
[[nodiscard]] const char* refusalText(int code);

// Read the arguments of answers. Error: too few bytes, or not a number.
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

/// STlms: state 7 means measuring. Date and time are from the scanner's own clock.
struct MeasuringState {
    int state = 0;
    std::string time, date;
};
[[nodiscard]] Result<MeasuringState> parseMeasuringState(const ColaAnswer& answer);
/// SCdevicestate: 0 busy, 1 ready, 2 error.
[[nodiscard]] const char* deviceStateText(int state);

} // namespace edgescan::scanner
