// CoLa A and B framing over a byte stream (docs/protocol.md, "Framing"): bytes in, whole frames out, resynchronising after anything.
#pragma once

#include "core/base/bytes.h"
#include "core/scanner/cola/host_time.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace edgescan {

/// A: text between STX and ETX. B: binary with length and checksum.
enum class Dialect : std::uint8_t { A, B };

/// "CoLa A", "CoLa B".
[[nodiscard]] const char* dialectName(Dialect dialect);

inline constexpr std::size_t kLongestPayload = 65536;             ///< the largest telegram of the family has 17.4 kB
inline constexpr std::size_t kLongestFrame = kLongestPayload + 9; ///< start mark, length, payload, checksum

/// One frame as it was on the wire.
struct ColaFrame {
    Dialect dialect = Dialect::B;
    Bytes bytes;                     ///< all of it, STX and checksum included, untouched
    HostTime received;               ///< when the frame's first byte arrived (or when it was sent)
    std::uint64_t offset = 0;        ///< of the first byte in the stream
    std::uint64_t skippedBefore = 0; ///< bytes between the previous frame and this one that belong to none

    [[nodiscard]] ByteView payload() const;

    bool operator==(const ColaFrame&) const = default;
};

/// What was pushed and why some of it is in no frame. `skipped` counts bytes, the reasons count events.
struct ColaCounts {
    std::uint64_t bytes = 0;
    std::uint64_t frames = 0;
    std::uint64_t skipped = 0;
    std::uint64_t badChecksum = 0; ///< CoLa B frames whose bytes do not add up
    std::uint64_t tooLong = 0;     ///< start marks followed by more than kLongestPayload
    std::uint64_t notCola = 0;     ///< start marks not followed by the 's' that every telegram starts with
    std::uint64_t torn = 0;        ///< CoLa A frames with a new start before their end

    bool operator==(const ColaCounts&) const = default;
};

/// The state between two reads; a value. However the same bytes are cut into pushes, the same frames come out. Holds never more than
/// the start of one frame (kLongestFrame) between pushes.
class ColaStream {
public:
    /// Without a dialect each frame decides for itself: 02 02 02 02 is B, 02 's' is A (docs/protocol.md, "Dialect").
    explicit ColaStream(std::optional<Dialect> only = std::nullopt) : only_(only) {}

    /// The frames that are complete now. `received`: host time right after these bytes were read.
    [[nodiscard]] std::vector<ColaFrame> push(ByteView bytes, HostTime received = {});

    [[nodiscard]] const ColaCounts& counts() const { return counts_; }
    /// Bytes of a frame that is not complete yet.
    [[nodiscard]] std::size_t waiting() const { return buffer_.size(); }

private:
    enum class Step : std::uint8_t { Frame, Drop, Wait };

    [[nodiscard]] ByteView rest() const { return ByteView(buffer_).subspan(start_); }
    Step tryStep(ColaFrame& frame);
    Step tryText(ColaFrame& frame);
    Step tryBinary(ColaFrame& frame);
    Step take(ColaFrame& frame, Dialect dialect, std::size_t length);
    Step drop(std::size_t count);
    void compact();

    struct Arrival {
        std::uint64_t offset = 0;
        HostTime time;
    };

    std::optional<Dialect> only_;
    Bytes buffer_;
    Bytes sums_; ///< per byte of buffer_: exclusive or of it and all before, so that a false start costs no reading of what it claims
    std::size_t start_ = 0;          ///< first byte of buffer_ that is still undecided
    std::size_t searched_ = 0;       ///< of a CoLa A frame: bytes already known to be neither STX nor ETX
    std::uint64_t offset_ = 0;       ///< in the stream, of buffer_[start_]
    std::deque<Arrival> arrivals_;   ///< one per push that still has bytes in the buffer
    std::uint64_t skippedSince_ = 0; ///< since the last frame
    ColaCounts counts_;
};

/// The frame around a payload.
[[nodiscard]] Bytes framed(ByteView payload, Dialect dialect);

} // namespace edgescan
