// Bytes of a VLP-16 as shots.
#include "core/robots/spinning/vlp16.h"

#include <cmath>

namespace edgescan::robots {
namespace {

constexpr std::size_t kBlockBytes = 100, kChannelBytes = 3;
constexpr double kMmPerCount = 2.0, kDegPerCount = 0.01;
constexpr double kBeamS = 2.304e-6, kShotS = 55.296e-6;
constexpr std::uint8_t kVlp16 = 0x22;

// By laser in the order of firing, its place from below: -15, 1, -13, 3 ... -1, 15 degrees.
constexpr int placeOf(int laser) { return laser % 2 == 0 ? laser / 2 : 8 + laser / 2; }

std::uint32_t azimuthCount(ByteView block) { return static_cast<std::uint32_t>(littleEndian(block.subspan(2, 2))); }

double stepDeg(double fromDeg, double toDeg) {
    const double step = toDeg - fromDeg;
    return step < 0 ? step + 360.0 : step;
}

} // namespace

std::optional<std::uint32_t> vlp16Clock(ByteView datagram) {
    if (datagram.size() != kVlp16PacketBytes) return std::nullopt;
    const std::uint8_t returns = datagram[kVlp16PacketBytes - 2], product = datagram[kVlp16PacketBytes - 1];
    if (product != kVlp16 || returns < 0x37 || returns > 0x39) return std::nullopt;
    for (std::size_t b = 0; b < kVlp16Blocks; ++b) {
        const ByteView bytes = datagram.subspan(b * kBlockBytes, kBlockBytes);
        if (bytes[0] != 0xFF || bytes[1] != 0xEE || azimuthCount(bytes) >= 36000) return std::nullopt;
    }
    return static_cast<std::uint32_t>(littleEndian(datagram.subspan(kBlockBytes * kVlp16Blocks, 4)));
}

std::optional<Vlp16Packet> decodeVlp16(ByteView datagram) {
    const auto clock = vlp16Clock(datagram);
    if (!clock) return std::nullopt;
    Vlp16Packet packet;
    packet.returns = static_cast<Vlp16Return>(datagram[kVlp16PacketBytes - 2]);
    packet.usOfHour = *clock;
    for (std::size_t b = 0; b < packet.blocks.size(); ++b) {
        const ByteView bytes = datagram.subspan(b * kBlockBytes, kBlockBytes);
        Vlp16Packet::Block& block = packet.blocks[b];
        block.azimuthDeg = azimuthCount(bytes) * kDegPerCount;
        for (int shot = 0; shot < 2; ++shot) {
            for (int laser = 0; laser < kVlp16Beams; ++laser) {
                const std::size_t at = 4 + static_cast<std::size_t>(shot * kVlp16Beams + laser) * kChannelBytes;
                const auto s = static_cast<std::size_t>(shot), place = static_cast<std::size_t>(placeOf(laser));
                block.rangeMm[s][place] = static_cast<float>(static_cast<double>(littleEndian(bytes.subspan(at, 2))) * kMmPerCount);
                block.reflection[s][place] = static_cast<float>(bytes[at + 2]);
            }
        }
    }
    return packet;
}

SpinningBeams vlp16Beams() {
    SpinningBeams beams;
    beams.vendor = "Velodyne";
    beams.model = "VLP-16";
    beams.unitMm = kMmPerCount;
    beams.laterS.resize(kVlp16Beams);
    for (int place = 0; place < kVlp16Beams; ++place) beams.elevationDeg.push_back(2.0 * place - 15.0);
    for (int laser = 0; laser < kVlp16Beams; ++laser) beams.laterS[static_cast<std::size_t>(placeOf(laser))] = laser * kBeamS;
    return beams;
}

void Vlp16Columns::addPacket(const Vlp16Packet& packet, std::int64_t timeNs) {
    const bool dual = packet.returns == Vlp16Return::Dual;
    const std::size_t every = dual ? 2 : 1;
    for (std::size_t b = 0; b < packet.blocks.size(); b += every) {
        const Vlp16Packet::Block& block = packet.blocks[dual ? b + 1 : b]; // of two the second is the strongest
        if (b + every < packet.blocks.size()) lastStepDeg_ = stepDeg(block.azimuthDeg, packet.blocks[b + every].azimuthDeg);
        for (std::size_t shot = 0; shot < 2; ++shot) {
            SpinningColumn column;
            column.azimuthDeg = std::fmod(block.azimuthDeg + static_cast<double>(shot) * lastStepDeg_ / 2, 360.0);
            column.timeNs = timeNs + std::llround((static_cast<double>(2 * (b / every) + shot)) * kShotS * 1e9);
            column.rangeMm.assign(block.rangeMm[shot].begin(), block.rangeMm[shot].end());
            column.reflection.assign(block.reflection[shot].begin(), block.reflection[shot].end());
            columns_.push_back(std::move(column));
            for (std::size_t beam = 0; dual && beam < kVlp16Beams; ++beam) {
                const float other = packet.blocks[b].rangeMm[shot][beam];
                others_ += other > 0 && other != block.rangeMm[shot][beam] ? 1 : 0;
            }
        }
    }
}

} // namespace edgescan::robots
