// Any bytes as a datagram of a VLP-16 or an Ouster, and as an Ouster's metadata. The first byte chooses.
#include "core/scanner/ouster/os_packet.h"
#include "core/scanner/velodyne/vlp16.h"
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace edgescan;
    if (size < 1) return 0;
    const ByteView input(bytes + 1, size - 1);
    std::vector<scanner::SpinningColumn> columns;
    scanner::SpinningBeams beams = scanner::vlp16Beams();
    if (bytes[0] % 3 == 0) {
        scanner::Vlp16Columns all;
        if (const auto packet = scanner::decodeVlp16(input)) all.take(*packet, 0);
        columns = all.columns();
    } else if (bytes[0] % 3 == 1) {
        const auto sensor = scanner::osSensor({reinterpret_cast<const char*>(input.data()), input.size()}, "fuzz.json");
        fuzz::hold(sensor || sensor.error().sentence().find('\n') == std::string::npos);
        return 0;
    } else {
        scanner::OsSensor sensor;
        sensor.altitudeDeg = {2, 1, 0};
        sensor.azimuthDeg = {0, 0, 0};
        sensor.columnsPerFrame = 1024;
        sensor.columnsPerPacket = 2;
        if (const auto found = scanner::decodeOs(input, sensor, 0)) columns = *found;
        beams = scanner::osBeams(sensor);
    }
    if (columns.empty()) return 0;
    const auto turns = scanner::turnsOf(columns);
    const std::size_t last = turns.size() > 1 ? turns[1] : columns.size();
    const Scan scan = scanner::scanOfTurn(columns, 0, last, beams);
    fuzz::hold(scan.lines() >= static_cast<int>(last) && scan.lines() <= static_cast<int>(last) + 4096);
    return 0;
}
