// Records of PCAP and blocks of PCAPNG. Every length is compared with the bytes that are there; nothing is copied.
#include "core/files/packet_capture/packets.h"
#include "core/base/translated_text.h"

#include "core/base/utc_time.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgescan::files {
namespace {

constexpr std::uint32_t kIpv4 = 0x0800, kIpv6 = 0x86DD;

/// What is behind the header of a link, when that is IP.
std::optional<ByteView> behindType(ByteView bytes, std::size_t typeAt, std::size_t headerBytes) {
    constexpr std::size_t kTag = 4;
    if (bytes.size() < headerBytes) return std::nullopt;
    std::uint32_t type = netU16(bytes, typeAt);
    ByteView rest = bytes.subspan(headerBytes);
    while (type == 0x8100 || type == 0x88A8 || type == 0x9100) { // VLAN, also several
        if (rest.size() < kTag) return std::nullopt;
        type = netU16(rest, 2);
        rest = rest.subspan(kTag);
    }
    return type == kIpv4 || type == kIpv6 ? std::optional(rest) : std::nullopt;
}

constexpr std::int64_t kNsPerS = 1'000'000'000;
constexpr const char* kCopyCapture = "copy the capture again";

/// Numbers in one of the two byte orders; the caller has checked that they are there.
class Numbers {
public:
    Numbers(ByteView bytes, bool bigEndian) : bytes_(bytes), bigEndian_(bigEndian) {}

    [[nodiscard]] std::uint32_t u16(std::size_t at) const { return number(at, 2); }
    [[nodiscard]] std::uint32_t u32(std::size_t at) const { return number(at, 4); }

private:
    [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t size) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i) value = value << 8U | bytes_[at + (bigEndian_ ? i : size - 1 - i)];
        return value;
    }

    ByteView bytes_;
    bool bigEndian_;
};

struct PcapKind {
    bool bigEndian = false;
    std::int64_t nsPerFraction = 1000;
};

std::optional<PcapKind> pcapKind(ByteView file) {
    if (file.size() < 4) return std::nullopt;
    for (const bool bigEndian : {false, true}) {
        const std::uint32_t magic = Numbers(file, bigEndian).u32(0);
        if (magic == 0xA1B2C3D4) return PcapKind{bigEndian, 1000};
        if (magic == 0xA1B23C4D) return PcapKind{bigEndian, 1};
    }
    return std::nullopt;
}

bool isPcapng(ByteView file) {
    if (file.size() < 12 || Numbers(file, false).u32(0) != 0x0A0D0D0A) return false;
    return Numbers(file, false).u32(8) == 0x1A2B3C4D || Numbers(file, true).u32(8) == 0x1A2B3C4D;
}

Result<PacketFile> readPcap(ByteView file, const PcapKind& kind, const std::string& where) {
    constexpr std::size_t kHeader = 24, kRecord = 16;
    if (file.size() < kHeader) return Error{"the capture ends within its header", where, kCopyCapture};
    const Numbers in(file, kind.bigEndian);
    const auto link = static_cast<LinkType>(in.u32(20) & 0x0FFFFFFFU); // the highest bits announce a checksum after packets
    PacketFile found;
    for (std::size_t at = kHeader; at < file.size();) {
        found.cutOff = file.size() - at < kRecord || file.size() - at - kRecord < in.u32(at + 8);
        if (found.cutOff) break;
        const std::size_t length = in.u32(at + 8);
        const std::int64_t ns = std::int64_t{in.u32(at)} * kNsPerS + std::int64_t{in.u32(at + 4)} * kind.nsPerFraction;
        found.packets.push_back({ns, link, file.subspan(at + kRecord, length)});
        at += kRecord + length;
    }
    return found;
}

/// An interface of a PCAPNG section and how its times are counted.
struct Interface {
    LinkType link = LinkType::Ethernet;
    std::uint32_t longest = 0; ///< packets are cut to it; 0: they are not
    int resolution = 6;        ///< times in 10^-n seconds, or 2^-n
    bool binary = false;
    std::int64_t offsetS = 0;

    /// Empty for a time before 1970 or after kLatestNs.
    [[nodiscard]] std::optional<std::int64_t> ns(std::uint64_t time) const {
        const double perSecond = binary ? std::exp2(resolution) : std::pow(10.0, resolution);
        constexpr double kMost = 1e12; // seconds
        const double counted = static_cast<double>(time) / perSecond;
        const double all = counted + static_cast<double>(offsetS);
        if (counted > kMost || all < 0 || all > static_cast<double>(kLatestNs / kNsPerS)) return std::nullopt;
        const bool whole = perSecond < 1.8e19;
        const std::uint64_t seconds = whole ? time / static_cast<std::uint64_t>(perSecond) : 0;
        const std::uint64_t rest = whole ? time % static_cast<std::uint64_t>(perSecond) : time;
        const auto ns = static_cast<std::int64_t>(std::llround(static_cast<double>(rest) / perSecond * 1e9));
        return (static_cast<std::int64_t>(seconds) + offsetS) * kNsPerS + ns;
    }
};

/// A block without its type and lengths.
struct Block {
    std::uint32_t type = 0;
    ByteView body;
};

Interface interfaceOf(const Block& block, bool bigEndian) {
    constexpr std::size_t kFixed = 8;
    constexpr std::uint32_t kResolution = 9, kOffset = 14;
    const Numbers in(block.body, bigEndian);
    Interface interface;
    interface.link = static_cast<LinkType>(in.u16(0));
    interface.longest = in.u32(4);
    for (std::size_t at = kFixed; at + 4 <= block.body.size();) {
        const std::uint32_t code = in.u16(at);
        const std::size_t length = in.u16(at + 2);
        const std::size_t from = at + 4;
        if (code == 0 || from + length > block.body.size()) break;
        if (code == kResolution && length >= 1) {
            interface.binary = (block.body[from] & 0x80U) != 0;
            interface.resolution = block.body[from] & 0x7F;
        }
        if (code == kOffset && length >= 8) {
            const std::uint64_t high = in.u32(from + (bigEndian ? 0 : 4));
            interface.offsetS = static_cast<std::int64_t>(high << 32U | in.u32(from + (bigEndian ? 4 : 0)));
        }
        at = from + (length + 3) / 4 * 4;
    }
    return interface;
}

/// The packet in a block; empty for blocks of other kinds. Error text: what is wrong with it.
struct PacketFound {
    std::optional<Packet> packet;
    const char* wrong = nullptr;
    bool outOfTime = false;
};
PacketFound packetIn(const Block& block, const std::vector<Interface>& interfaces, bool bigEndian) {
    constexpr std::uint32_t kOldPacket = 2, kSimple = 3, kEnhanced = 6;
    if (block.type != kOldPacket && block.type != kSimple && block.type != kEnhanced) return {};
    const bool simple = block.type == kSimple;
    const std::size_t head = simple ? 4 : 20;
    if (block.body.size() < head) return {{}, "is too short for a packet"};
    const Numbers in(block.body, bigEndian);
    const std::size_t number = simple ? 0 : block.type == kOldPacket ? in.u16(0) : in.u32(0);
    if (number >= interfaces.size()) return {{}, "names an interface that the capture does not describe"};
    const Interface& interface = interfaces[number];
    std::size_t length = simple ? in.u32(0) : in.u32(12);
    if (simple && interface.longest > 0) length = std::min<std::size_t>(length, interface.longest);
    if (simple) length = std::min(length, block.body.size() - head);
    if (length > block.body.size() - head) return {{}, "promises more bytes of a packet than it has"};
    const auto ns = simple ? std::optional<std::int64_t>(0) : interface.ns(std::uint64_t{in.u32(4)} << 32U | in.u32(8));
    return {Packet{ns.value_or(0), interface.link, block.body.subspan(head, length)}, nullptr, !ns.has_value()};
}

Result<PacketFile> readPcapng(ByteView file, const std::string& where) {
    constexpr std::uint32_t kSection = 0x0A0D0D0A, kInterface = 1;
    constexpr std::size_t kAround = 12; // type and length before, length behind
    PacketFile found;
    std::vector<Interface> interfaces;
    bool bigEndian = false;
    for (std::size_t at = 0; at < file.size();) {
        const auto damaged = [&](const std::string& what) {
            return Error{withValues("a block of this PCAPNG capture %1", {what}), withValues("%1: byte %2", {where, at}), kCopyCapture};
        };
        found.cutOff = file.size() - at < kAround;
        if (found.cutOff) break;
        const ByteView rest = file.subspan(at);
        if (Numbers(rest, false).u32(0) == kSection) {
            bigEndian = Numbers(rest, true).u32(8) == 0x1A2B3C4D;
            interfaces.clear();
        }
        const Numbers in(rest, bigEndian);
        const std::size_t length = in.u32(4);
        if (length < kAround || length % 4 != 0) return damaged(withValues("says that it has %1 bytes", {length}));
        found.cutOff = length > rest.size();
        if (found.cutOff) break;
        const Block block{in.u32(0), rest.subspan(8, length - kAround)};
        if (block.type == kInterface) {
            if (block.body.size() < 8) return damaged("is too short for an interface");
            interfaces.push_back(interfaceOf(block, bigEndian));
        }
        const PacketFound packet = packetIn(block, interfaces, bigEndian);
        if (packet.wrong != nullptr) return damaged(packet.wrong);
        if (packet.packet) found.packets.push_back(*packet.packet);
        found.outOfTime += packet.outOfTime ? 1 : 0;
        at += length;
    }
    return found;
}

} // namespace

std::optional<ByteView> ipPacket(const Packet& packet) {
    switch (packet.link) {
    case LinkType::Ethernet:
        return behindType(packet.bytes, 12, 14);
    case LinkType::LinuxCooked:
        return behindType(packet.bytes, 14, 16);
    case LinkType::LinuxCooked2:
        return behindType(packet.bytes, 0, 20);
    case LinkType::Null:
    case LinkType::Loop: // the family of addresses in some byte order; the IP header says it again
        return packet.bytes.size() >= 4 ? std::optional(packet.bytes.subspan(4)) : std::nullopt;
    case LinkType::Raw:
    case LinkType::Ipv4:
    case LinkType::Ipv6:
        return packet.bytes;
    }
    constexpr std::uint32_t kRawOfBsd = 12, kRawOfOpenBsd = 14;
    const auto number = static_cast<std::uint32_t>(packet.link);
    return number == kRawOfBsd || number == kRawOfOpenBsd ? std::optional(packet.bytes) : std::nullopt;
}

bool isPacketFile(ByteView file) { return pcapKind(file).has_value() || isPcapng(file); }

Result<PacketFile> readPackets(ByteView file, const std::string& where) {
    if (const auto kind = pcapKind(file)) return readPcap(file, *kind, where);
    if (isPcapng(file)) return readPcapng(file, where);
    return Error{"this is not a capture of network packets", where, "choose a PCAP or PCAPNG file"};
}

} // namespace edgescan::files
