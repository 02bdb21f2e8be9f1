// UDP packets to columns, and the turn that is opened.
#include "core/files/packet_capture/spinning_capture.h"

#include "core/base/inputs.h"
#include "core/files/packet_capture/udp_datagrams.h"
#include "core/scanner/ouster/os_packet.h"
#include "core/scanner/velodyne/vlp16.h"

#include <algorithm>
#include <map>

namespace edgescan::files {
namespace {

/// The sender with most datagrams that `fits`, and how many others there are.
template <class Fits>
std::pair<std::optional<Endpoint>, std::size_t> busiest(const UdpDatagrams& udp, const Fits& fits) {
    std::map<Endpoint, std::size_t> counts;
    for (const UdpDatagram& datagram : udp.datagrams) {
        if (fits(datagram.payload)) ++counts[datagram.from];
    }
    const auto most = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    if (most == counts.end()) return {std::nullopt, 0};
    return {most->first, counts.size() - 1};
}

Result<Scan> chosenTurn(const std::vector<scanner::SpinningColumn>& columns, const scanner::SpinningBeams& beams, const Source& source) {
    const std::vector<std::size_t> firsts = scanner::turnsOf(columns);
    const auto lastOf = [&](std::size_t turn) { return turn + 1 < firsts.size() ? firsts[turn + 1] : columns.size(); };
    const std::optional<std::size_t> wanted = source.options->scanIndex;
    if (wanted.value_or(0) >= firsts.size())
        return source.refused("the capture holds " + std::to_string(firsts.size()) + " turns of the scanner, counted from 0",
                              "choose one of them with --scan");
    std::size_t turn = wanted.value_or(0);
    for (std::size_t n = 0; n < firsts.size() && !wanted; ++n) {
        if (lastOf(n) - firsts[n] > lastOf(turn) - firsts[turn]) turn = n;
    }
    Scan scan = scanner::scanOfTurn(columns, firsts[turn], lastOf(turn), beams);
    scan.format = "capture";
    if (firsts.size() > 1)
        scan.warnings.push_back("The capture holds " + std::to_string(firsts.size()) + " turns of the scanner; turn " +
                                std::to_string(turn) + ", counted from 0, was opened. --scan chooses another.");
    return scan;
}

void sayLosses(Scan& scan, const UdpDatagrams& udp, const PacketFile& file, std::size_t otherSenders) {
    std::vector<std::string> said;
    if (file.cutOff) said.emplace_back("The capture was cut off: everything up to the cut is here.");
    if (udp.torn > 0) said.push_back(std::to_string(udp.torn) + " packets are missing in part in the capture: their lines are lost.");
    if (otherSenders > 0)
        said.push_back("The capture holds packets of " + std::to_string(otherSenders + 1) +
                       " scanners; the one with most of them was opened.");
    scan.warnings.insert(scan.warnings.begin(), said.begin(), said.end());
}

std::optional<Result<Scan>> velodyneIn(const UdpDatagrams& udp, const PacketFile& file, const Source& source) {
    const auto [sender, others] = busiest(udp, [](ByteView bytes) { return scanner::decodeVlp16(bytes).has_value(); });
    if (!sender) return std::nullopt;
    scanner::Vlp16Columns all;
    for (const UdpDatagram& datagram : udp.datagrams) {
        if (datagram.from != *sender) continue;
        if (const auto packet = scanner::decodeVlp16(datagram.payload)) all.take(*packet, datagram.timeNs);
    }
    auto scan = chosenTurn(all.columns(), scanner::vlp16Beams(), source);
    if (!scan) return scan;
    if (all.others() > 0)
        scan->warnings.push_back("The scanner sent two returns for each beam: the strongest ones are here, and " +
                                 std::to_string(all.others()) + " others of the capture were left out.");
    scan->warnings.emplace_back("The beams of a VLP-16 begin up to 11 mm above and below its middle: points are that far off.");
    sayLosses(*scan, udp, file, others);
    return scan;
}

std::optional<Result<Scan>> ousterIn(const UdpDatagrams& udp, const PacketFile& file, const Source& source) {
    const auto [sender, others] = busiest(udp, scanner::looksLikeOs);
    if (!sender) return std::nullopt;
    std::filesystem::path metadata = source.path;
    metadata.replace_extension(".json");
    std::error_code unknown;
    if (source.inMemory || !std::filesystem::exists(metadata, unknown))
        return source.refused("the packets of an Ouster do not say the angles of its beams",
                              "save the sensor's metadata as " + metadata.filename().string() + " next to the capture");
    const auto text = readInput(metadata);
    if (!text) return text.error();
    const auto sensor = scanner::osSensor({reinterpret_cast<const char*>(text->data()), text->size()}, metadata.string());
    if (!sensor) return sensor.error();
    std::vector<scanner::SpinningColumn> columns;
    for (const UdpDatagram& datagram : udp.datagrams) {
        if (datagram.from != *sender) continue;
        if (auto found = scanner::decodeOs(datagram.payload, *sensor, datagram.timeNs))
            std::ranges::move(*found, std::back_inserter(columns));
    }
    if (columns.empty())
        return source.refused("no packet of the capture fits the sensor of " + metadata.filename().string(),
                              "save the metadata of the sensor that was captured");
    auto scan = chosenTurn(columns, scanner::osBeams(*sensor), source);
    if (!scan) return scan;
    scan->warnings.emplace_back(
        "The beams of an Ouster begin some centimetres away from its axis, and the ranges are as measured: points are that far off.");
    sayLosses(*scan, udp, file, others);
    return scan;
}

} // namespace

std::optional<Result<Scan>> spinningScanIn(const PacketFile& file, const Source& source) {
    const UdpDatagrams udp = udpDatagrams(file.packets);
    if (auto scan = velodyneIn(udp, file, source)) return scan;
    return ousterIn(udp, file, source);
}

} // namespace edgescan::files
