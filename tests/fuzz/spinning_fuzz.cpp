// Any bytes as a datagram of a VLP-16 or an Ouster, and as an Ouster's metadata. The first byte chooses.
#include "core/robots/spinning/os_packet.h"
#include "core/robots/spinning/vlp16.h"
#include "tests/fuzz/open_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace edgescan;
    if (size < 1) return 0;
    const ByteView input(bytes + 1, size - 1);
    std::vector<robots::SpinningColumn> columns;
    robots::SpinningBeams beams = robots::vlp16Beams();
    if (bytes[0] % 3 == 0) {
        robots::Vlp16Columns all;
        if (const auto packet = robots::decodeVlp16(input)) all.addPacket(*packet, 0);
        columns = all.columns();
    } else if (bytes[0] % 3 == 1) {
        const auto sensor = robots::osSensor({reinterpret_cast<const char*>(input.data()), input.size()}, "fuzz.json");
        fuzz::hold(sensor || sensor.error().sentence().find('\n') == std::string::npos);
        return 0;
    } else {
        robots::OsSensor sensor;
        sensor.altitudeDeg = {2, 1, 0};
        sensor.azimuthDeg = {0, 0, 0};
        sensor.columnsPerFrame = 1024;
        sensor.columnsPerPacket = 2;
        if (const auto found = robots::decodeOs(input, sensor, 0)) columns = *found;
        beams = robots::osBeams(sensor);
    }
    if (columns.empty()) return 0;
    const auto turns = robots::turnsOf(columns);
    const std::size_t last = turns.size() > 1 ? turns[1] : columns.size();
    const Scan scan = robots::scanOfTurn(columns, 0, last, beams);
    fuzz::hold(scan.lines() >= static_cast<int>(last) && scan.lines() <= static_cast<int>(last) + 4096);
    return 0;
}
