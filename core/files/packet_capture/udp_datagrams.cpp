// From IP to UDP.
#include "core/files/packet_capture/udp_datagrams.h"

#include "core/files/packet_capture/ip_packets.h"

#include <algorithm>

namespace edgescan::files {
namespace {

constexpr std::uint8_t kUdp = 17;
constexpr std::size_t kUdpHead = 8, kIpv4Head = 20, kIpv6Head = 40;
constexpr std::size_t kOpenPackets = 64; // fragmented, at once
constexpr std::size_t kLongestIp = 65535;

struct Pieces {
    ByteView from, to;
    std::uint32_t id = 0;
    Bytes bytes;
    std::vector<std::size_t> places;
    std::size_t held = 0, whole = 0; // whole: 0 while the last piece is missing
};

class Reader {
public:
    void take(const Packet& packet) {
        const auto ip = ipPacket(packet);
        if (!ip || ip->empty()) return;
        const int version = (*ip)[0] / 16;
        if (version == 4) takeIpv4(*ip, packet.timeNs);
        if (version == 6 && ip->size() >= kIpv6Head && (*ip)[6] == kUdp) takeUdp(ip->subspan(kIpv6Head), ip->subspan(8, 16), packet.timeNs);
    }
    UdpDatagrams all() {
        found_.torn += open_.size();
        return std::move(found_);
    }

private:
    void takeIpv4(ByteView ip, std::int64_t timeNs) {
        if (ip.size() < kIpv4Head || ip[9] != kUdp) return;
        const std::size_t header = std::size_t{ip[0]} % 16 * 4, stated = netU16(ip, 2);
        if (header < kIpv4Head || ip.size() < header) return;
        const std::size_t end = stated >= header ? std::min(stated, ip.size()) : ip.size();
        const ByteView body = ip.subspan(header, end - header), from = ip.subspan(12, 4);
        const std::uint32_t place = netU16(ip, 6);
        const bool more = (place & 0x2000U) != 0;
        const std::size_t offset = std::size_t{place & 0x1FFFU} * 8;
        if (!more && offset == 0) return takeUdp(body, from, timeNs);
        if (offset + body.size() > kLongestIp) return;
        Pieces& pieces = piecesOf(from, ip.subspan(16, 4), netU16(ip, 4));
        if (pieces.bytes.size() < offset + body.size()) pieces.bytes.resize(offset + body.size());
        if (std::ranges::find(pieces.places, offset) != pieces.places.end()) return; // once more
        pieces.places.push_back(offset);
        std::ranges::copy(body, pieces.bytes.begin() + static_cast<std::ptrdiff_t>(offset));
        pieces.held += body.size();
        if (!more) pieces.whole = offset + body.size();
        if (pieces.whole == 0 || pieces.held < pieces.whole) return;
        found_.joined.push_back(std::move(pieces.bytes));
        std::erase_if(open_, [&](const Pieces& one) { return &one == &pieces; });
        takeUdp(found_.joined.back(), from, timeNs);
    }

    Pieces& piecesOf(ByteView from, ByteView to, std::uint32_t id) {
        const auto same = [&](const Pieces& one) {
            return one.id == id && std::ranges::equal(one.from, from) && std::ranges::equal(one.to, to);
        };
        const auto found = std::ranges::find_if(open_, same);
        if (found != open_.end()) return *found;
        if (open_.size() >= kOpenPackets) {
            open_.pop_front();
            ++found_.torn;
        }
        open_.push_back({from, to, id, {}, {}, 0, 0});
        return open_.back();
    }

    void takeUdp(ByteView udp, ByteView from, std::int64_t timeNs) {
        if (udp.size() < kUdpHead) return;
        const std::size_t stated = netU16(udp, 4);
        const std::size_t end = stated >= kUdpHead ? std::min(stated, udp.size()) : udp.size();
        UdpDatagram datagram;
        datagram.timeNs = timeNs;
        datagram.from = {std::string(from.begin(), from.end()), static_cast<std::uint16_t>(netU16(udp, 0))};
        datagram.toPort = static_cast<std::uint16_t>(netU16(udp, 2));
        datagram.payload = udp.subspan(kUdpHead, end - kUdpHead);
        found_.datagrams.push_back(std::move(datagram));
    }

    std::list<Pieces> open_;
    UdpDatagrams found_;
};

} // namespace

UdpDatagrams udpDatagrams(const std::vector<Packet>& packets) {
    Reader reader;
    for (const Packet& packet : packets) reader.take(packet);
    return reader.all();
}

} // namespace edgescan::files
