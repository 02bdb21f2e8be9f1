// What went over UDP, with the pieces of fragmented IP packets put together.
#pragma once

#include "core/files/packet_capture/tcp_streams.h"

#include <list>

namespace edgescan::files {

struct UdpDatagram {
    std::int64_t timeNs = 0;
    Endpoint from;
    std::uint16_t toPort = 0;
    ByteView payload;
};

struct UdpDatagrams {
    std::vector<UdpDatagram> datagrams; ///< in the order of the file, of a fragmented one that of its last piece
    std::list<Bytes> joined;            ///< bytes of those that were fragmented
    std::size_t torn = 0;               ///< fragmented ones of which a piece is missing

    UdpDatagrams() = default;
    UdpDatagrams(UdpDatagrams&&) = default;
    UdpDatagrams& operator=(UdpDatagrams&&) = default;
    UdpDatagrams(const UdpDatagrams&) = delete; // the copy's datagrams would point into the original
    UdpDatagrams& operator=(const UdpDatagrams&) = delete;
};

/// Over IPv4, and over IPv6 without extension headers. The packets must outlive it.
[[nodiscard]] UdpDatagrams udpDatagrams(const std::vector<Packet>& packets);

} // namespace edgescan::files
