// The packets of a network capture: PCAP (both byte orders, microseconds and nanoseconds) and PCAPNG.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

/// What a packet begins with (tcpdump.org, "Link-layer header types"); others are in the file as they are.
enum class LinkType : std::uint32_t {
    Null = 0,
    Ethernet = 1,
    Raw = 101,
    Loop = 108,
    LinuxCooked = 113,
    Ipv4 = 228,
    Ipv6 = 229,
    LinuxCooked2 = 276,
};

struct Packet {
    std::int64_t timeNs = 0; ///< since 1970 UTC
    LinkType link = LinkType::Ethernet;
    ByteView bytes; ///< as far as they were captured
};

struct PacketFile {
    std::vector<Packet> packets; ///< in the order of the file; their bytes are those of the file
    std::size_t outOfTime = 0;   ///< packets with a time before 1970 or after kLatestNs; they have the time 0
    bool cutOff = false;         ///< the file ends within a packet; all before it are here
};

/// True when the file begins like one.
[[nodiscard]] bool isPacketFile(ByteView file);

/// Error: no such file, or damaged at a byte that it names.
Result<PacketFile> readPackets(ByteView file, const std::string& where);

/// Numbers as networks send them; the caller has checked that they are there.
[[nodiscard]] inline std::uint32_t netU16(ByteView bytes, std::size_t at) { return std::uint32_t{bytes[at]} << 8U | bytes[at + 1]; }
[[nodiscard]] inline std::uint32_t netU32(ByteView bytes, std::size_t at) { return netU16(bytes, at) << 16U | netU16(bytes, at + 2); }

/// Empty: another protocol, or a link that is not known.
[[nodiscard]] std::optional<ByteView> ipPacket(const Packet& packet);

} // namespace edgescan::files
