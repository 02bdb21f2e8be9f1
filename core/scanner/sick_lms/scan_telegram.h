// The scan telegram LMDscandata (docs/developer/protocol.md, "Scan telegram"): one line as the scanner sent it, every field, raw.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"
#include "core/scanner/cola/frames.h"
#include "core/scanner/scan_line/scan_line.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::scanner {

struct ScanEncoder {
    std::uint32_t position = 0; ///< counts modulo 2^32; use differences
    std::int16_t speed = 0;

    bool operator==(const ScanEncoder&) const = default;
};

/// One measured quantity of all beams. `values` are raw; 16 or 8 bits wide, according to the list that holds the channel.
struct ScanChannel {
    std::string content; ///< 5 characters: DIST1..5, RSSI1..5; others exist on other devices
    float scale = 1.0F;
    float offset = 0.0F;
    std::int32_t startAngle = 0; ///< 1/10000 degree, rounded by the scanner: see beamGrid()
    std::uint16_t step = 0;      ///< 1/10000 degree, rounded by the scanner
    std::vector<std::uint16_t> values;

    bool operator==(const ScanChannel&) const = default;
};

struct ScanPosition {
    std::array<float, 3> xyz{};
    std::array<float, 3> rotation{};
    std::uint8_t rotationType = 0; ///< 0 none, 1 pitch, 2 roll, 3 free

    bool operator==(const ScanPosition&) const = default;
};

/// The scanner's own calendar. After each power-up it starts at 1970-01-01, unless it is set.
struct ScanClock {
    std::uint16_t year = 0;
    std::uint8_t month = 0, day = 0, hour = 0, minute = 0, second = 0;
    std::uint32_t microsecond = 0;

    bool operator==(const ScanClock&) const = default;
};

struct ScanEvent {
    std::string type; ///< 4 characters, "FDIN"
    std::uint32_t encoder = 0;
    std::uint32_t timeUs = 0;
    std::int32_t angle = 0;

    bool operator==(const ScanEvent&) const = default;
};

struct ScanTelegram {
    bool polled = false; ///< answer to "sRN LMDscandata" (sRA) instead of a subscribed telegram (sSN)
    std::uint16_t version = 0;
    std::uint16_t deviceNumber = 0;
    std::uint32_t serialNumber = 0;
    std::array<std::uint8_t, 2> status{}; ///< see deviceFlags()
    std::uint16_t telegramCounter = 0;    ///< wraps; see LineCounter
    std::uint16_t scanCounter = 0;        ///< wraps; may start again with a new measurement
    std::uint32_t sinceStartUs = 0;       ///< device clock at the line's stamp (docs/developer/protocol.md, "Time of a beam"); wraps
    std::uint32_t transmittedUs = 0;      ///< device clock when the telegram was sent; wraps
    std::array<std::uint8_t, 2> digitalIn{};
    std::array<std::uint8_t, 2> digitalOut{};
    std::int16_t layer = 0;                 ///< reserved; layer angle on MRS1000
    std::uint32_t scanFrequency = 0;        ///< 1/100 Hz
    std::uint32_t measurementFrequency = 0; ///< 100 Hz, or 1 Hz on some firmwares (docs/developer/protocol.md, "Scan telegram")
    std::vector<ScanEncoder> encoders;
    std::vector<ScanChannel> channels16;
    std::vector<ScanChannel> channels8;
    std::optional<ScanPosition> position;
    std::optional<std::string> deviceName;
    std::optional<std::string> comment;
    std::optional<ScanClock> clock;
    std::optional<ScanEvent> event;
    std::size_t trailingBytes = 0; ///< bytes behind the last known field; accepted, not stored

    bool operator==(const ScanTelegram&) const = default;
};

/// Whether a payload is "sSN LMDscandata ..." or "sRA LMDscandata ...".
[[nodiscard]] bool isScanTelegram(ByteView payload);

/// Error: not a scan telegram, too few bytes, or a token that is not a number; `where` names the byte of the payload.
[[nodiscard]] Result<ScanTelegram> decodeScanTelegram(ByteView payload, Dialect dialect);
[[nodiscard]] inline Result<ScanTelegram> decodeScanTelegram(const ColaFrame& frame) {
    return decodeScanTelegram(frame.payload(), frame.dialect);
}

/// The payload: the inverse of decoding, in the canonical text form (docs/developer/protocol.md, "Numbers").
[[nodiscard]] Bytes encodeScanTelegram(const ScanTelegram& telegram, Dialect dialect);

/// The channel called `content`, or null.
[[nodiscard]] const ScanChannel* findChannel(const ScanTelegram& telegram, std::string_view content);

/// A channel's ranges: raw 0 is NoReturn, raw 1..15 DeviceStatus.
[[nodiscard]] LineRanges rangesMm(const ScanChannel& channel);

/// The beams of a channel without the scanner's rounding: start and step are moved to the 1/24-degree grid if they round to it
/// (docs/developer/protocol.md, "Beam angles").
[[nodiscard]] BeamGrid beamGrid(const ScanChannel& channel);

/// The meaning of the two status bytes.
[[nodiscard]] DeviceFlags deviceFlags(const ScanTelegram& telegram);

[[nodiscard]] double scanFrequencyHz(const ScanTelegram& telegram);
/// The period of the mirror in seconds. If the telegram gives an impossible frequency, that of the usual 25 Hz.
[[nodiscard]] double linePeriodS(const ScanTelegram& telegram);

} // namespace edgescan::scanner
