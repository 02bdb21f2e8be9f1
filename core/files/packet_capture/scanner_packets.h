// The packets of one scanner out of all datagrams of a capture: each once, in the order in which the scanner sent them.
#pragma once

#include "core/base/bytes.h"
#include "core/files/packet_capture/tcp_streams.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace edgescan::files {

struct UdpDatagram {
    std::int64_t timeNs = 0;
    Endpoint scanner; ///< address of the sender, and the port that it sends to: its own port may change
    ByteView payload;
};

struct ScannerPackets {
    struct Packet {
        std::int64_t clockNs = 0; ///< of the scanner
        std::int64_t timeNs = 0;  ///< of the capturing computer; in order, as the packets are
        ByteView payload;
    };
    std::vector<Packet> packets;
    std::size_t repeated = 0;      ///< packets with the bytes of one before, on whatever way they came
    std::size_t late = 0;          ///< packets that came out of order
    std::size_t otherScanners = 0; ///< others than the one with most packets
};

/// `clockOf`: the scanner's clock in a payload, empty for one that is not its packet. The clock begins again after `periodNs` (0: never).
[[nodiscard]] ScannerPackets scannerPackets(const std::vector<UdpDatagram>& datagrams,
                                            const std::function<std::optional<std::int64_t>(ByteView)>& clockOf, std::int64_t periodNs);

} // namespace edgescan::files
