// Captures of scanners that turn all round: a Velodyne VLP-16, an Ouster OS.
#pragma once

#include "core/files/packet_capture/packets.h"
#include "core/files/point_tables/source.h"
#include "core/scan/grid/scan.h"

#include <optional>

namespace edgescan::robots {

/// The turn with most lines, or turn ReadingOptions::scanIndex, of the sender with most packets. The beam angles of an Ouster come from its
/// metadata, NAME.json next to NAME.pcap. Empty: the capture holds no packets of such a scanner.
[[nodiscard]] std::optional<Result<Scan>> spinningScanIn(const files::PacketFile& file, const files::Source& source);

} // namespace edgescan::robots
