// Captures of what a scanner sent, opened as the sweep that they hold.
#pragma once

#include "core/files/point_tables/source.h"
#include "core/scan/grid/scan.h"

namespace edgescan::files {

/// A PCAP or PCAPNG file.
[[nodiscard]] bool looksLikePackets(const Source& source);
/// Bytes that hold a whole telegram within their first part, in either dialect.
[[nodiscard]] bool looksLikeColaStream(const Source& source);

/// The sweep of the scanner whose telegrams are in it: of the connection with most of them. Warnings name what is missing in the capture
/// and what it does not say and was assumed. Error: damaged, or without a scan telegram.
Result<Scan> readPacketCapture(const Source& source);
/// The same of the bytes as they came from the scanner, without times.
Result<Scan> readColaCapture(const Source& source);

} // namespace edgescan::files
