// Repeats by their bytes, order by the scanner's own clock.
#include "core/files/packet_capture/scanner_packets.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <unordered_map>

namespace edgescan::files {
namespace {

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

} // namespace

ScannerPackets scannerPackets(const std::vector<UdpDatagram>& datagrams,
                              const std::function<std::optional<std::int64_t>(ByteView)>& clockOf, std::int64_t periodNs) {
    struct Sent {
        Endpoint scanner;
        SentPacket packet;
    };
    ScannerPackets found;
    std::vector<Sent> all;
    std::unordered_map<std::string_view, std::size_t> first; // by payload
    std::map<Endpoint, Endpoint> sameAs;                     // a mirror sends what the scanner sent
    const auto original = [&](Endpoint scanner) {
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
        const Endpoint one = original(all[known->second].scanner), other = original(datagram.scanner);
        if (one != other) sameAs.emplace(other, one);
    }
    std::map<Endpoint, std::size_t> counts;
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

} // namespace edgescan::files
