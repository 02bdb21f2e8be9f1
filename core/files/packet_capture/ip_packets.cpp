// From link to IP.
#include "core/files/packet_capture/ip_packets.h"

namespace edgescan::files {
namespace {

constexpr std::uint32_t kIpv4 = 0x0800, kIpv6 = 0x86DD;

/// What is behind the header of a link, when that is IP.
std::optional<ByteView> behindType(ByteView bytes, std::size_t typeAt, std::size_t headerBytes) {
    constexpr std::size_t kTag = 4;
    if (bytes.size() < headerBytes) return std::nullopt;
    std::uint32_t type = netU16(bytes, typeAt);
    ByteView rest = bytes.subspan(headerBytes);
    while (type == 0x8100 || type == 0x88A8 || type == 0x9100) { // VLAN, also several
        if (rest.size() < kTag) return std::nullopt;
        type = netU16(rest, 2);
        rest = rest.subspan(kTag);
    }
    return type == kIpv4 || type == kIpv6 ? std::optional(rest) : std::nullopt;
}

} // namespace

std::optional<ByteView> ipPacket(const Packet& packet) {
    switch (packet.link) {
    case LinkType::Ethernet:
        return behindType(packet.bytes, 12, 14);
    case LinkType::LinuxCooked:
        return behindType(packet.bytes, 14, 16);
    case LinkType::LinuxCooked2:
        return behindType(packet.bytes, 0, 20);
    case LinkType::Null:
    case LinkType::Loop: // the family of addresses in some byte order; the IP header says it again
        return packet.bytes.size() >= 4 ? std::optional(packet.bytes.subspan(4)) : std::nullopt;
    case LinkType::Raw:
    case LinkType::Ipv4:
    case LinkType::Ipv6:
        return packet.bytes;
    }
    constexpr std::uint32_t kRawOfBsd = 12, kRawOfOpenBsd = 14;
    const auto number = static_cast<std::uint32_t>(packet.link);
    return number == kRawOfBsd || number == kRawOfOpenBsd ? std::optional(packet.bytes) : std::nullopt;
}

} // namespace edgescan::files
