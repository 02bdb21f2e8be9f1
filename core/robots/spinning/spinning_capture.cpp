// UDP packets to columns, and the turn that is opened.
#include "core/robots/spinning/spinning_capture.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/bytes.h"
#include "core/base/inputs.h"
#include "core/files/packet_capture/packets.h"
#include "core/files/packet_capture/tcp_streams.h"
#include "core/robots/spinning/os_packet.h"
#include "core/robots/spinning/vlp16.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace edgescan::robots {
namespace {

struct UdpDatagram {
    std::int64_t timeNs = 0;
    files::Endpoint scanner; ///< address of the sender, and the port that it sends to: its own port may change
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

using SentPacket = ScannerPackets::Packet;

constexpr std::int64_t kBeganAgainNs = 1'000'000'000; // a clock that goes back so far and stays there

std::string_view charactersOf(ByteView bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// A clock that begins again after a period goes on instead.
void unwrap(std::vector<SentPacket>& packets, std::int64_t periodNs) {
    for (std::size_t n = 1; n < packets.size() && periodNs > 0; ++n) {
        std::int64_t& clock = packets[n].clockNs;
        const std::int64_t before = packets[n - 1].clockNs;
        while (clock < before - periodNs / 2) clock += periodNs;
        while (clock > before + periodNs / 2) clock -= periodNs;
    }
}

/// Where a scanner that was started again begins: its clock goes back by a second and more, and does not come back. Late packets jump there
/// and back.
std::vector<std::size_t> startsOf(const std::vector<SentPacket>& packets) {
    std::vector<std::size_t> starts{0};
    std::size_t forward = 0;
    for (std::size_t n = 1; n < packets.size(); ++n) {
        const std::int64_t step = packets[n].clockNs - packets[n - 1].clockNs;
        if (step < -kBeganAgainNs) starts.push_back(n);
        forward += step > kBeganAgainNs ? 1 : 0;
    }
    if (forward + 1 >= starts.size()) starts.resize(1);
    return starts;
}

/// Sorts them; returns how many came late.
std::size_t orderByClock(std::vector<SentPacket>& packets) {
    const auto steps = [&](bool back) {
        std::size_t count = 0;
        for (std::size_t n = 1; n < packets.size(); ++n)
            count += (back ? packets[n].clockNs < packets[n - 1].clockNs : packets[n].clockNs > packets[n - 1].clockNs) ? 1 : 0;
        return count;
    };
    std::size_t late = 0;
    if (const std::size_t back = steps(true); back > steps(false)) { // a capture written from its end
        std::ranges::reverse(packets);
        late = back;
    }
    std::vector<std::size_t> starts = startsOf(packets);
    starts.push_back(packets.size());
    for (std::size_t s = 0; s + 1 < starts.size(); ++s) {
        const auto from = packets.begin() + static_cast<std::ptrdiff_t>(starts[s]),
                   to = packets.begin() + static_cast<std::ptrdiff_t>(starts[s + 1]);
        std::int64_t newest = from->clockNs;
        for (auto one = from; one != to; ++one) {
            late += one->clockNs < newest ? 1 : 0;
            newest = std::max(newest, one->clockNs);
        }
        std::ranges::stable_sort(from, to, {}, &SentPacket::clockNs);
    }
    return late;
}

/// `clockOf`: the scanner's clock in a payload, empty for one that is not its packet. The clock begins again after `periodNs` (0: never).
ScannerPackets scannerPackets(const std::vector<UdpDatagram>& datagrams,
                              const std::function<std::optional<std::int64_t>(ByteView)>& clockOf, std::int64_t periodNs) {
    struct Sent {
        files::Endpoint scanner;
        SentPacket packet;
    };
    ScannerPackets found;
    std::vector<Sent> all;
    std::unordered_map<std::string_view, std::size_t> first; // by payload
    std::map<files::Endpoint, files::Endpoint> sameAs;       // a mirror sends what the scanner sent
    const auto original = [&](files::Endpoint scanner) {
        for (auto at = sameAs.find(scanner); at != sameAs.end(); at = sameAs.find(scanner)) scanner = at->second;
        return scanner;
    };
    for (const UdpDatagram& datagram : datagrams) {
        const auto clock = clockOf(datagram.payload);
        if (!clock) continue;
        const auto [known, isNew] = first.try_emplace(charactersOf(datagram.payload), all.size());
        if (isNew) {
            all.push_back({datagram.scanner, {*clock, datagram.timeNs, datagram.payload}});
            continue;
        }
        ++found.repeated;
        const files::Endpoint one = original(all[known->second].scanner), other = original(datagram.scanner);
        if (one != other) sameAs.emplace(other, one);
    }
    std::map<files::Endpoint, std::size_t> counts;
    for (Sent& sent : all) ++counts[sent.scanner = original(sent.scanner)];
    if (counts.empty()) return found;
    found.otherScanners = counts.size() - 1;
    const auto most = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    for (const Sent& sent : all) {
        if (sent.scanner == most->first) found.packets.push_back(sent.packet);
    }
    unwrap(found.packets, periodNs);
    if (std::ranges::is_sorted(found.packets, {}, &SentPacket::clockNs)) return found;
    std::vector<std::int64_t> times;
    for (const SentPacket& packet : found.packets) times.push_back(packet.timeNs);
    std::ranges::sort(times);
    found.late = orderByClock(found.packets);
    for (std::size_t n = 0; n < times.size(); ++n) found.packets[n].timeNs = times[n];
    return found;
}

struct UdpDatagrams {
    std::vector<UdpDatagram> datagrams; ///< in the order of the file, of a fragmented one that of its last piece
    std::list<Bytes> joined;            ///< bytes of those that were fragmented
    std::size_t torn = 0;               ///< fragmented ones of which a piece is missing
    std::size_t repeated = 0;           ///< fragmented ones that were captured twice, and are here once

    UdpDatagrams() = default;
    UdpDatagrams(UdpDatagrams&&) = default;
    UdpDatagrams& operator=(UdpDatagrams&&) = default;
    UdpDatagrams(const UdpDatagrams&) = delete; // the copy's datagrams would point into the original
    UdpDatagrams& operator=(const UdpDatagrams&) = delete;
};

constexpr std::uint8_t kUdp = 17;
constexpr std::size_t kUdpHead = 8, kIpv4Head = 20, kIpv6Head = 40;
constexpr std::size_t kOpenPackets = 64; // fragmented, at once
constexpr std::size_t kLongestIp = 65535;
constexpr std::int64_t kLongestApartNs = 2'000'000'000; // pieces of one packet: its number of 16 bits comes again after some seconds

struct Pieces {
    ByteView from, to;
    std::uint32_t id = 0;
    std::int64_t firstNs = 0; ///< when the first of them came
    Bytes bytes;
    std::vector<std::size_t> places;
    std::size_t held = 0, whole = 0; // whole: 0 while the last piece is missing
    ByteView joined;                 // of a packet that is complete: its pieces may come once more
};

class Reader {
public:
    void addPacket(const files::Packet& packet) {
        const auto ip = files::ipPacket(packet);
        if (!ip || ip->empty()) return;
        const int version = (*ip)[0] / 16;
        if (version == 4) addIpv4(*ip, packet.timeNs);
        if (version == 6 && ip->size() >= kIpv6Head && (*ip)[6] == kUdp) addUdp(ip->subspan(kIpv6Head), ip->subspan(8, 16), packet.timeNs);
    }
    UdpDatagrams all() {
        for (const Pieces& pieces : open_) giveUp(pieces);
        return std::move(found_);
    }

private:
    void addIpv4(ByteView ip, std::int64_t timeNs) {
        if (ip.size() < kIpv4Head || ip[9] != kUdp) return;
        const std::size_t header = std::size_t{ip[0]} % 16 * 4, stated = files::netU16(ip, 2);
        if (header < kIpv4Head || ip.size() < header) return;
        const std::size_t end = stated >= header ? std::min(stated, ip.size()) : ip.size();
        const ByteView body = ip.subspan(header, end - header), from = ip.subspan(12, 4);
        const std::uint32_t place = files::netU16(ip, 6);
        const bool more = (place & 0x2000U) != 0;
        const std::size_t offset = std::size_t{place & 0x1FFFU} * 8;
        if (!more && offset == 0) return addUdp(body, from, timeNs);
        if (offset + body.size() > kLongestIp) return;
        Pieces& pieces = piecesOf(from, ip.subspan(16, 4), files::netU16(ip, 4), timeNs);
        if (std::ranges::find(pieces.places, offset) != pieces.places.end()) {
            const ByteView bytes = pieces.joined.empty() ? ByteView(pieces.bytes) : pieces.joined;
            if (std::ranges::equal(bytes.subspan(offset, std::min(body.size(), bytes.size() - offset)), body)) { // once more
                found_.repeated += offset == 0 ? 1 : 0;
                return;
            }
            giveUp(pieces); // this one is of another packet with the same number
            pieces = {from, ip.subspan(16, 4), pieces.id, timeNs, {}, {}, 0, 0, {}};
        }
        if (pieces.bytes.size() < offset + body.size()) pieces.bytes.resize(offset + body.size());
        pieces.places.push_back(offset);
        std::ranges::copy(body, pieces.bytes.begin() + static_cast<std::ptrdiff_t>(offset));
        pieces.held += body.size();
        if (!more) pieces.whole = offset + body.size();
        if (pieces.whole == 0 || pieces.held < pieces.whole) return;
        found_.joined.push_back(std::move(pieces.bytes));
        pieces.joined = found_.joined.back();
        addUdp(found_.joined.back(), from, timeNs);
    }

    /// The pieces that one belongs to; those of a packet that is too old with the same number are given up.
    Pieces& piecesOf(ByteView from, ByteView to, std::uint32_t id, std::int64_t timeNs) {
        const auto same = [&](const Pieces& one) {
            return one.id == id && std::ranges::equal(one.from, from) && std::ranges::equal(one.to, to);
        };
        const auto found = std::ranges::find_if(open_, same);
        if (found != open_.end() && std::abs(timeNs - found->firstNs) <= kLongestApartNs) return *found;
        if (found != open_.end()) {
            giveUp(*found);
            open_.erase(found);
        }
        if (open_.size() >= kOpenPackets) {
            giveUp(open_.front());
            open_.pop_front();
        }
        open_.push_back({from, to, id, timeNs, {}, {}, 0, 0, {}});
        return open_.back();
    }

    void giveUp(const Pieces& pieces) { found_.torn += pieces.joined.empty() ? 1 : 0; }

    void addUdp(ByteView udp, ByteView from, std::int64_t timeNs) {
        if (udp.size() < kUdpHead) return;
        const std::size_t stated = files::netU16(udp, 4);
        const std::size_t end = stated >= kUdpHead ? std::min(stated, udp.size()) : udp.size();
        const auto toPort = static_cast<std::uint16_t>(files::netU16(udp, 2));
        found_.datagrams.push_back({timeNs, {std::string(from.begin(), from.end()), toPort}, udp.subspan(kUdpHead, end - kUdpHead)});
    }

    std::list<Pieces> open_;
    UdpDatagrams found_;
};

/// Over IPv4, and over IPv6 without extension headers. The packets must outlive it.
UdpDatagrams udpDatagrams(const std::vector<files::Packet>& packets) {
    Reader reader;
    for (const files::Packet& packet : packets) reader.addPacket(packet);
    return reader.all();
}

Result<Scan> chosenTurn(const std::vector<SpinningColumn>& columns, const SpinningBeams& beams, const files::Source& source) {
    const std::vector<std::size_t> firsts = turnsOf(columns);
    const auto lastOf = [&](std::size_t turn) { return turn + 1 < firsts.size() ? firsts[turn + 1] : columns.size(); };
    const std::optional<std::size_t> wanted = source.options->scanIndex;
    if (wanted.value_or(0) >= firsts.size()) return noSuchScan(wanted.value_or(0), firsts.size(), "the capture", "one turn", "%1 turns");
    std::size_t turn = wanted.value_or(0);
    for (std::size_t n = 0; n < firsts.size() && !wanted; ++n) {
        if (lastOf(n) - firsts[n] > lastOf(turn) - firsts[turn]) turn = n;
    }
    Scan scan = scanOfTurn(columns, firsts[turn], lastOf(turn), beams);
    scan.format = "capture";
    if (firsts.size() > 1)
        scan.warnings.push_back(
            withValues("The capture holds %1 turns of the scanner; turn %2, counted from 0, was opened. --scan chooses another.",
                       {firsts.size(), turn}));
    return scan;
}

void sayLosses(Scan& scan, const UdpDatagrams& udp, const files::PacketFile& file, const ScannerPackets& of) {
    std::vector<std::string> said;
    if (of.late > 0)
        said.push_back(counted(of.late, "packet came out of order and was put in the order of the scanner's clock.",
                               "packets came out of order and were put in the order of the scanner's clock."));
    if (file.cutOff) said.emplace_back("The capture was cut off: everything up to the cut is here.");
    if (udp.torn > 0)
        said.push_back(counted(udp.torn, "packet is missing in part in the capture: its lines are lost.",
                               "packets are missing in part in the capture: their lines are lost."));
    if (const std::size_t repeated = udp.repeated + of.repeated; repeated > 0)
        said.push_back(counted(repeated, "packet is in the capture twice: it was read once.",
                               "packets are in the capture twice: each was read once."));
    if (of.otherScanners > 0)
        said.push_back(
            withValues("The capture holds packets of %1 scanners; the one with most of them was opened.", {of.otherScanners + 1}));
    scan.warnings.insert(scan.warnings.begin(), said.begin(), said.end());
}

std::optional<Result<Scan>> velodyneIn(const UdpDatagrams& udp, const files::PacketFile& file, const files::Source& source) {
    constexpr std::int64_t kHourNs = 3'600'000'000'000;
    const auto clockOf = [](ByteView bytes) {
        const auto us = vlp16Clock(bytes);
        return us ? std::optional(std::int64_t{*us} * 1000) : std::nullopt;
    };
    const ScannerPackets found = scannerPackets(udp.datagrams, clockOf, kHourNs);
    if (found.packets.empty()) return std::nullopt;
    Vlp16Columns all;
    for (const auto& one : found.packets) all.addPacket(*decodeVlp16(one.payload), one.timeNs);
    auto scan = chosenTurn(all.columns(), vlp16Beams(), source);
    if (!scan) return scan;
    if (all.others() > 0)
        scan->warnings.push_back(withValues("The scanner sent two returns for each beam: the strongest ones are here, and %1 left out.",
                                            {counted(all.others(), "other of the capture was", "others of the capture were")}));
    scan->warnings.emplace_back("The beams of a VLP-16 begin up to 11 mm above and below its middle: points are that far off.");
    sayLosses(*scan, udp, file, found);
    return scan;
}

std::optional<Result<Scan>> ousterIn(const UdpDatagrams& udp, const files::PacketFile& file, const files::Source& source) {
    if (std::ranges::none_of(udp.datagrams, looksLikeOs, &UdpDatagram::payload)) return std::nullopt;
    std::filesystem::path metadata = source.path;
    metadata.replace_extension(".json");
    std::error_code unknown;
    if (source.inMemory || !std::filesystem::exists(metadata, unknown))
        return source.refused("the packets of an Ouster do not say the angles of its beams",
                              withValues("save the sensor's metadata as %1 next to the capture", {metadata.filename().string()}));
    const auto text = readInput(metadata);
    if (!text) return text.error();
    const auto sensor = osSensor({reinterpret_cast<const char*>(text->data()), text->size()}, metadata.string());
    if (!sensor) return sensor.error();
    const auto clockOf = [&](ByteView bytes) { return looksLikeOs(bytes) ? osClockNs(bytes, *sensor) : std::nullopt; };
    const ScannerPackets found = scannerPackets(udp.datagrams, clockOf, 0);
    std::vector<SpinningColumn> columns;
    for (const auto& one : found.packets) std::ranges::move(*decodeOs(one.payload, *sensor, one.timeNs), std::back_inserter(columns));
    if (columns.empty())
        return source.refused(withValues("no packet of the capture fits the sensor of %1", {metadata.filename().string()}),
                              "save the metadata of the sensor that was captured");
    auto scan = chosenTurn(columns, osBeams(*sensor), source);
    if (!scan) return scan;
    scan->warnings.emplace_back(
        "The beams of an Ouster begin some centimetres away from its axis, and the ranges are as measured: points are that far off.");
    sayLosses(*scan, udp, file, found);
    return scan;
}

} // namespace

std::optional<Result<Scan>> spinningScanIn(const files::PacketFile& file, const files::Source& source) {
    const UdpDatagrams udp = udpDatagrams(file.packets);
    if (auto scan = velodyneIn(udp, file, source)) return scan;
    return ousterIn(udp, file, source);
}

} // namespace edgescan::robots
