// Captures of a scanner's telegrams: network packets, and the bytes as they came.
#include "core/files/formats/format.h"
#include "core/files/packet_capture/read_capture.h"

namespace edgescan::files {

Format packetCaptureFormat() {
    return {.title = "Network capture",
            .reads = {".pcap", ".pcapng", ".cap"},
            .recognises = looksLikePackets,
            .read = readingOf<readPacketCapture>,
            .options = {"scan"},
            .placesItself = true};
}

Format colaCaptureFormat() {
    return {.title = "CoLa stream",
            .reads = {".bin"},
            .recognises = looksLikeColaStream,
            .read = readingOf<readColaCapture>,
            .placesItself = true};
}

} // namespace edgescan::files
