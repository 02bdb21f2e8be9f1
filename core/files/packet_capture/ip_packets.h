// The IP packet in a captured packet of any known link.
#pragma once

#include "core/files/packet_capture/packets.h"

#include <optional>

namespace edgescan::files {

/// Numbers as networks send them; the caller has checked that they are there.
[[nodiscard]] inline std::uint32_t netU16(ByteView bytes, std::size_t at) { return std::uint32_t{bytes[at]} << 8U | bytes[at + 1]; }
[[nodiscard]] inline std::uint32_t netU32(ByteView bytes, std::size_t at) { return netU16(bytes, at) << 16U | netU16(bytes, at + 2); }

/// Empty: another protocol, or a link that is not known.
[[nodiscard]] std::optional<ByteView> ipPacket(const Packet& packet);

} // namespace edgescan::files
