// Writes network captures from the descriptions of the formats: PCAP, PCAPNG, Ethernet, IP and TCP. Shares no code with the reader.
#pragma once

#include "tests/support/bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace edgescan::test {

/// The highest byte first, as in network protocols.
inline std::string netBytes(std::uint64_t value, int bytes) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(value >> shift);
    return text;
}

struct TcpPart {
    std::uint32_t sequence = 0;
    std::string payload;
    bool syn = false;
    std::int64_t timeNs = 0;
    std::uint16_t fromPort = 2112, toPort = 50000;
    std::uint8_t host = 1; ///< of the sender, 192.168.0.host
};

enum class Link : std::uint32_t { Null = 0, Ethernet = 1, Raw = 101, Loop = 108, Cooked = 113, Cooked2 = 276 };

struct PacketStyle {
    Link link = Link::Ethernet;
    bool ipv6 = false;
    int vlans = 0;
    bool bigEndian = false;
    bool nanoseconds = false;
    bool pcapng = false;
    int resolution = 6; ///< of PCAPNG times: 10^-n, or 2^-n with 128 added
};

inline std::string packetOf(const TcpPart& part, const PacketStyle& style) {
    std::string tcp = netBytes(part.fromPort, 2) + netBytes(part.toPort, 2) + netBytes(part.sequence, 4) + netBytes(77, 4);
    tcp += netBytes(0x8000U | (part.syn ? 0x02U : 0x18U), 2) + netBytes(512, 2) + netBytes(0, 4); // header of 32 bytes with options
    tcp += std::string("\1\1\x08\x0a", 4) + std::string(8, '\x11') + part.payload;
    std::string ip;
    if (style.ipv6) {
        const std::string options = std::string("\6\0\5\2\0\0\1\0", 8); // hop by hop, then TCP
        ip = netBytes(0x60000000, 4) + netBytes(options.size() + tcp.size(), 2) + std::string("\0\x40", 2);
        ip += netBytes(0xFE80, 2) + std::string(12, '\0') + netBytes(part.host, 2) + netBytes(0xFE80, 2) + std::string(12, '\0') +
              netBytes(99, 2);
        ip += options;
    } else {
        ip = netBytes(0x4500, 2) + netBytes(20 + tcp.size(), 2) + netBytes(0x12344000, 4) + netBytes(0x40060000, 4);
        ip += netBytes(0xC0A80000U + part.host, 4) + netBytes(0xC0A80063, 4);
    }
    ip += tcp;
    const std::string type = netBytes(style.ipv6 ? 0x86DD : 0x0800, 2);
    std::string tags;
    for (int n = 0; n < style.vlans; ++n) tags += netBytes(n == 0 ? 0x8100 : 0x88A8, 2) + netBytes(5, 2);
    switch (style.link) {
    case Link::Ethernet: {
        std::string frame = std::string(12, '\x22') + tags + type + ip;
        if (frame.size() < 60) frame.resize(60, '\x7e'); // the smallest frame of Ethernet
        return frame;
    }
    case Link::Cooked:
        return netBytes(0, 2) + netBytes(1, 2) + netBytes(6, 2) + std::string(8, '\x22') + type + ip;
    case Link::Cooked2:
        return type + std::string(18, '\x22') + ip;
    case Link::Null:
        return std::string(style.ipv6 ? "\x1e\0\0\0" : "\2\0\0\0", 4) + ip;
    case Link::Loop:
        return netBytes(style.ipv6 ? 24 : 2, 4) + ip;
    case Link::Raw:
        return ip;
    }
    return ip;
}

/// A file of packets in the order given.
inline std::string captureOf(const std::vector<TcpPart>& parts, const PacketStyle& style) {
    const auto number = [&](std::uint64_t value, int bytes) {
        std::string text = netBytes(value, bytes);
        if (!style.bigEndian) std::reverse(text.begin(), text.end());
        return text;
    };
    const auto link = static_cast<std::uint32_t>(style.link);
    std::string file;
    if (!style.pcapng) {
        file = number(style.nanoseconds ? 0xA1B23C4D : 0xA1B2C3D4, 4) + number(2, 2) + number(4, 2) + number(0, 8) + number(65535, 4) +
               number(link, 4);
        for (const TcpPart& part : parts) {
            const std::string packet = packetOf(part, style);
            const std::int64_t fraction = part.timeNs % 1'000'000'000 / (style.nanoseconds ? 1 : 1000);
            file += number(static_cast<std::uint64_t>(part.timeNs / 1'000'000'000), 4) + number(static_cast<std::uint64_t>(fraction), 4);
            file += number(packet.size(), 4) + number(packet.size(), 4) + packet;
        }
        return file;
    }
    const auto block = [&](std::uint32_t type, std::string body) {
        body.resize((body.size() + 3) / 4 * 4, '\0');
        return number(type, 4) + number(body.size() + 12, 4) + body + number(body.size() + 12, 4);
    };
    file = block(0x0A0D0D0A, number(0x1A2B3C4D, 4) + number(1, 2) + number(0, 2) + number(0xFFFFFFFFFFFFFFFF, 8));
    const std::string resolution = number(9, 2) + number(1, 2) + std::string(1, static_cast<char>(style.resolution)) + std::string(3, '\0');
    file += block(1, number(link, 2) + number(0, 2) + number(0, 4) + resolution + number(0, 4));
    file += block(0x0BAD, "something that nobody knows");
    for (const TcpPart& part : parts) {
        const std::string packet = packetOf(part, style);
        const double perSecond = style.resolution >= 128 ? std::exp2(style.resolution - 128) : std::pow(10.0, style.resolution);
        const auto seconds = static_cast<std::uint64_t>(part.timeNs / 1'000'000'000);
        const auto time = seconds * static_cast<std::uint64_t>(perSecond) +
                          static_cast<std::uint64_t>(static_cast<double>(part.timeNs % 1'000'000'000) / 1e9 * perSecond);
        file += block(6, number(0, 4) + number(time >> 32U, 4) + number(time & 0xFFFFFFFF, 4) + number(packet.size(), 4) +
                             number(packet.size(), 4) + packet);
    }
    return file;
}

} // namespace edgescan::test
