// Data packets of a Velodyne VLP-16 (public user manual 63-9243, chapter 9): 12 blocks of two shots of 16 beams.
#pragma once

#include "core/base/bytes.h"
#include "core/robots/spinning/turns.h"

#include <array>
#include <cstdint>
#include <optional>

namespace edgescan::robots {

inline constexpr std::size_t kVlp16PacketBytes = 1206;
inline constexpr int kVlp16Beams = 16, kVlp16Blocks = 12;

/// Which return of a shot the scanner sends.
enum class Vlp16Return : std::uint8_t { Strongest = 0x37, Last = 0x38, Dual = 0x39 };

struct Vlp16Packet {
    struct Block {
        double azimuthDeg = 0;
        std::array<std::array<float, kVlp16Beams>, 2> rangeMm{};    ///< by shot and beam from below; 0: no return
        std::array<std::array<float, kVlp16Beams>, 2> reflection{}; ///< 0 to 255
    };
    std::array<Block, kVlp16Blocks> blocks{};
    std::uint32_t usOfHour = 0; ///< of the first shot
    Vlp16Return returns = Vlp16Return::Strongest;
};

/// The packet in a datagram. Empty: another length, another product, or blocks without their mark.
[[nodiscard]] std::optional<Vlp16Packet> decodeVlp16(ByteView datagram);
/// The clock of such a packet, microseconds of the hour, without decoding the rest; empty as above.
[[nodiscard]] std::optional<std::uint32_t> vlp16Clock(ByteView datagram);

/// The beams of a VLP-16, with the time of each in a shot.
[[nodiscard]] SpinningBeams vlp16Beams();

/// The columns of packets in their order, each with the time of its datagram. With two returns the strongest counts; `others` counts those
/// that are left out.
class Vlp16Columns {
public:
    void addPacket(const Vlp16Packet& packet, std::int64_t timeNs);
    [[nodiscard]] const std::vector<SpinningColumn>& columns() const { return columns_; }
    [[nodiscard]] std::size_t others() const { return others_; }

private:
    std::vector<SpinningColumn> columns_;
    double lastStepDeg_ = 0.4; ///< from block to block
    std::size_t others_ = 0;
};

} // namespace edgescan::robots
