// Lidar packets of an Ouster OS (public sensor documentation, "Lidar Data Packet Format"), and the metadata that says how to read them.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/robots/spinning/turns.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::robots {

/// The layouts of a pixel, as "udp_profile_lidar" names them.
enum class OsProfile : std::uint8_t { Legacy, Single, Dual, LowRate };

/// Of a sensor's metadata file.
struct OsSensor {
    std::string model;               ///< "OS-1-64"
    std::vector<double> altitudeDeg; ///< by pixel of a column, from above
    std::vector<double> azimuthDeg;  ///< likewise
    std::size_t columnsPerFrame = 0;
    std::size_t columnsPerPacket = 16;
};
/// Error: no JSON, or without beam angles or columns of a frame.
Result<OsSensor> osSensor(std::string_view json, const std::string& where);

/// The columns in a datagram that are valid, with `timeNs` as the time of the first. Empty: its length is not one of this sensor's packets.
[[nodiscard]] std::optional<std::vector<SpinningColumn>> decodeOs(ByteView datagram, const OsSensor& sensor, std::int64_t timeNs);

/// The sensor's clock at the first column of a datagram, nanoseconds; empty as above.
[[nodiscard]] std::optional<std::int64_t> osClockNs(ByteView datagram, const OsSensor& sensor);

[[nodiscard]] SpinningBeams osBeams(const OsSensor& sensor);

/// Whether the length of a datagram is that of a lidar packet of an OS with 16, 32, 64 or 128 beams.
[[nodiscard]] bool looksLikeOs(ByteView datagram);

} // namespace edgescan::robots
