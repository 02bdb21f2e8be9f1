// From link to IP to TCP, and from segments to streams.
#include "core/files/packet_capture/tcp_streams.h"

#include "core/files/packet_capture/packets.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>

namespace edgescan::files {
namespace {

constexpr std::uint8_t kTcp = 6;

/// A TCP segment as it is in a packet.
struct Segment {
    Endpoint from, to;
    std::uint32_t sequence = 0;
    bool starts = false; ///< SYN
    ByteView payload;
};

struct Inside {
    std::optional<Segment> segment;
    bool fragment = false;
};

std::optional<Segment> segmentIn(ByteView tcp, ByteView fromAddress, ByteView toAddress) {
    constexpr std::size_t kLeast = 20;
    if (tcp.size() < kLeast) return std::nullopt;
    const std::size_t header = std::size_t{tcp[12]} / 16 * 4;
    if (header < kLeast || header > tcp.size()) return std::nullopt;
    Segment segment;
    segment.from = {std::string(fromAddress.begin(), fromAddress.end()), static_cast<std::uint16_t>(netU16(tcp, 0))};
    segment.to = {std::string(toAddress.begin(), toAddress.end()), static_cast<std::uint16_t>(netU16(tcp, 2))};
    segment.sequence = netU32(tcp, 4);
    segment.starts = (tcp[13] & 0x02U) != 0;
    segment.payload = tcp.subspan(header);
    return segment;
}

Inside insideIpv4(ByteView ip) {
    constexpr std::size_t kLeast = 20;
    const std::size_t header = std::size_t{ip[0]} % 16 * 4;
    if (header < kLeast || ip.size() < header) return {};
    if ((netU16(ip, 6) & 0x3FFFU) != 0) return {{}, true};
    if (ip[9] != kTcp) return {};
    const std::size_t stated = netU16(ip, 2); // 0: cut into packets by the network card behind the capture
    const std::size_t end = stated >= header ? std::min(stated, ip.size()) : ip.size();
    return {segmentIn(ip.subspan(header, end - header), ip.subspan(12, 4), ip.subspan(16, 4)), false};
}

Inside insideIpv6(ByteView ip) {
    constexpr std::size_t kHeader = 40;
    constexpr std::uint8_t kHopByHop = 0, kRouting = 43, kFragment = 44, kAuthentication = 51, kDestination = 60;
    if (ip.size() < kHeader) return {};
    const std::size_t stated = netU16(ip, 4);
    ByteView rest = ip.subspan(kHeader, stated > 0 ? std::min(stated, ip.size() - kHeader) : ip.size() - kHeader);
    std::uint8_t next = ip[6];
    while (next == kHopByHop || next == kRouting || next == kDestination || next == kAuthentication) {
        if (rest.size() < 8) return {};
        const std::size_t length = next == kAuthentication ? (std::size_t{rest[1]} + 2) * 4 : (std::size_t{rest[1]} + 1) * 8;
        next = rest[0];
        if (length > rest.size()) return {};
        rest = rest.subspan(length);
    }
    if (next == kFragment) return {{}, true};
    if (next != kTcp) return {};
    return {segmentIn(rest, ip.subspan(8, 16), ip.subspan(24, 16)), false};
}

Inside insideOf(const Packet& packet) {
    const auto ip = ipPacket(packet);
    if (!ip || ip->size() < 20) return {};
    const int version = (*ip)[0] / 16;
    return version == 4 ? insideIpv4(*ip) : version == 6 ? insideIpv6(*ip) : Inside{};
}

/// Segments of one direction, each at its place in the stream; sequence numbers run on over 2^32.
class Direction {
public:
    Direction(Endpoint from, Endpoint to) : from_(std::move(from)), to_(std::move(to)) {}

    /// A SYN with another number than the first is another connection between the same ports.
    [[nodiscard]] bool isAnother(const Segment& segment) const {
        return segment.starts && last_ && (!firstSyn_ || *firstSyn_ != segment.sequence);
    }

    void addSegment(const Segment& segment, std::int64_t timeNs) {
        const std::uint32_t sequence = segment.sequence + (segment.starts ? 1U : 0U);
        if (segment.starts) firstSyn_ = segment.sequence;
        const std::int64_t place = last_ ? place_ + static_cast<std::int32_t>(sequence - *last_) : 0;
        if (!last_ && segment.starts) begin_ = place;
        last_ = sequence;
        place_ = place;
        if (!segment.payload.empty()) parts_.push_back({place, timeNs, segment.payload});
    }

    [[nodiscard]] TcpStream stream() && {
        TcpStream stream{std::move(from_), std::move(to_), {}};
        std::int64_t latest = parts_.empty() ? 0 : parts_.front().place;
        for (const Part& part : parts_) {
            stream.late += part.place < latest ? 1 : 0;
            latest = std::max(latest, part.place);
        }
        std::ranges::stable_sort(parts_, {}, &Part::place);
        std::int64_t next = begin_.value_or(parts_.empty() ? 0 : parts_.front().place);
        for (Part& part : parts_) {
            const auto length = static_cast<std::int64_t>(part.bytes.size());
            const std::int64_t known = std::clamp<std::int64_t>(next - part.place, 0, length);
            stream.repeated += known > 0 ? 1 : 0;
            if (known == length) continue;
            const auto missing = static_cast<std::uint64_t>(std::max<std::int64_t>(0, part.place - next));
            stream.missing += missing;
            stream.gaps += missing > 0 ? 1 : 0;
            stream.pieces.push_back({part.timeNs, missing, part.bytes.subspan(static_cast<std::size_t>(known))});
            stream.bytes += stream.pieces.back().bytes.size();
            next = part.place + length;
        }
        stream.late -= std::min(stream.late, stream.repeated); // what is sent again comes late too
        return stream;
    }

private:
    struct Part {
        std::int64_t place = 0;
        std::int64_t timeNs = 0;
        ByteView bytes;
    };

    Endpoint from_, to_;
    std::optional<std::uint32_t> last_; // sequence number of the last segment
    std::optional<std::uint32_t> firstSyn_;
    std::optional<std::int64_t> begin_; // of the stream, when its start was captured
    std::int64_t place_ = 0;            // of the last segment
    std::vector<Part> parts_;
};

} // namespace

std::string Endpoint::text() const {
    std::string text;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<std::uint8_t>(address[i])); };
    if (address.size() == 4) {
        for (std::size_t i = 0; i < 4; ++i) text += (i > 0 ? "." : "") + std::to_string(byte(i));
        return text + ":" + std::to_string(port);
    }
    for (std::size_t i = 0; i + 1 < address.size(); i += 2) {
        std::array<char, 8> group{};
        const auto end = std::to_chars(group.data(), group.data() + group.size(), byte(i) << 8U | byte(i + 1), 16).ptr;
        text += i > 0 ? ":" : "";
        text.append(group.data(), end);
    }
    return "[" + text + "]:" + std::to_string(port);
}

TcpStreams tcpStreams(const std::vector<Packet>& packets) {
    TcpStreams found;
    std::vector<Direction> directions;
    std::map<std::pair<Endpoint, Endpoint>, std::size_t> newest; // direction between these two
    for (const Packet& packet : packets) {
        Inside inside = insideOf(packet);
        if (!inside.segment) {
            (inside.fragment ? found.fragments : found.otherPackets) += 1;
            continue;
        }
        ++found.packets;
        const Segment& segment = *inside.segment;
        const auto [entry, isNew] = newest.try_emplace({segment.from, segment.to}, directions.size());
        if (isNew || directions[entry->second].isAnother(segment)) {
            entry->second = directions.size();
            directions.emplace_back(segment.from, segment.to);
        }
        directions[entry->second].addSegment(segment, packet.timeNs);
    }
    for (Direction& direction : directions) found.streams.push_back(std::move(direction).stream());
    std::erase_if(found.streams, [](const TcpStream& stream) { return stream.pieces.empty(); });
    return found;
}

} // namespace edgescan::files
