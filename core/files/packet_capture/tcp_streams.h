// What went over TCP, put together from captured packets: out of order, sent twice, overlapping, or with parts that are not there.
#pragma once

#include "core/files/packet_capture/packets.h"

#include <compare>
#include <string>

namespace edgescan::files {

/// An address and a port.
struct Endpoint {
    std::string address; ///< bytes as on the network: four, or 16 of IPv6
    std::uint16_t port = 0;

    auto operator<=>(const Endpoint&) const = default;
    /// "192.168.0.1:2112", "[fe80:0:0:0:0:0:0:1]:2112".
    [[nodiscard]] std::string text() const;
};

/// A piece of a stream and when it came.
struct StreamPiece {
    std::int64_t timeNs = 0;
    std::uint64_t missingBefore = 0; ///< bytes between the piece before and this one that the capture does not have
    ByteView bytes;
};

/// One direction of one connection.
struct TcpStream {
    Endpoint from, to;
    std::vector<StreamPiece> pieces; ///< in the order of the stream; no byte twice
    std::uint64_t bytes = 0;
    std::uint64_t missing = 0; ///< bytes that the capture does not have
    std::size_t gaps = 0;      ///< places where they are missing
    std::size_t repeated = 0;  ///< packets that brought bytes that were there already
    std::size_t late = 0;      ///< packets that came behind later bytes
};

struct TcpStreams {
    std::vector<TcpStream> streams; ///< in the order of their first packets
    std::size_t packets = 0;        ///< with TCP in them
    std::size_t fragments = 0;      ///< pieces of IP packets, which are not put together
    std::size_t otherPackets = 0;   ///< without TCP, or of a link that is not known
};

/// Streams whose bytes are those of the packets. Linear in the packets, but for their sorting.
[[nodiscard]] TcpStreams tcpStreams(const std::vector<Packet>& packets);

} // namespace edgescan::files
