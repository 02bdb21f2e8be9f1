// CoLa A and B framing over a byte stream (docs/developer/protocol.md, "Framing"): takes bytes, returns complete frames, and resynchronises
// after any damage.
#pragma once

#include "core/base/bytes.h"
#include "core/scanner/cola/host_time.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace edgescan::scanner {

/// A: text between STX and ETX. B: binary with length and checksum.
enum class Dialect : std::uint8_t { A, B };

/// "CoLa A", "CoLa B".
[[nodiscard]] const char* dialectName(Dialect dialect);

inline constexpr std::size_t kLongestPayload = 65536;             ///< the largest telegram of this scanner family has 17.4 kB
inline constexpr std::size_t kLongestFrame = kLongestPayload + 9; ///< start mark, length, payload, checksum

/// One frame as it was on the wire.
struct ColaFrame {
    Dialect dialect = Dialect::B;
    Bytes bytes;                     ///< the whole frame, with STX and checksum, unchanged
    HostTime received;               ///< when the frame's first byte arrived (or when the frame was sent)
    std::uint64_t offset = 0;        ///< of the first byte in the stream
    std::uint64_t skippedBefore = 0; ///< bytes between the previous frame and this one that do not belong to a frame

    [[nodiscard]] ByteView payload() const;

    bool operator==(const ColaFrame&) const = default;
};

/// Counts of the bytes pushed, and the reasons why some of them are not in a frame. `skipped` counts bytes, the reasons count events.
struct ColaCounts {
    std::uint64_t bytes = 0;
    std::uint64_t frames = 0;
    std::uint64_t skipped = 0;
    std::uint64_t badChecksum = 0; ///< CoLa B frames with a wrong checksum
    std::uint64_t tooLong = 0;     ///< start marks followed by a length above kLongestPayload
    std::uint64_t notCola = 0;     ///< start marks without the 's' that begins every telegram
    std::uint64_t torn = 0;        ///< CoLa A frames with a new start before their end

    bool operator==(const ColaCounts&) const = default;
};

/// The state between two reads; a value type. The same bytes give the same frames, in whatever pieces they are pushed. Between pushes it
/// holds at most the start of one frame (kLongestFrame).
class ColaStream {
public:
    /// Without a dialect, the start of each frame decides: 02 02 02 02 is B, 02 's' is A (docs/developer/protocol.md, "Dialect").
    explicit ColaStream(std::optional<Dialect> only = std::nullopt) : only_(only) {}

    /// Returns the frames that are complete now. `received`: host time directly after these bytes were read.
    [[nodiscard]] std::vector<ColaFrame> push(ByteView bytes, HostTime received = {});

    [[nodiscard]] const ColaCounts& counts() const { return counts_; }
    /// Number of bytes of an incomplete frame.
    [[nodiscard]] std::size_t waiting() const { return buffer_.size(); }

private:
    enum class Step : std::uint8_t { Frame, Drop, Wait };

    [[nodiscard]] ByteView rest() const { return ByteView(buffer_).subspan(start_); }
    Step tryStep(ColaFrame& frame);
    Step tryText(ColaFrame& frame);
    Step tryBinary(ColaFrame& frame);
    Step popFrame(ColaFrame& frame, Dialect dialect, std::size_t length);
    Step drop(std::size_t count);
    void compact();

    struct Arrival {
        std::uint64_t offset = 0;
        HostTime time;
    };

    std::optional<Dialect> only_;
    Bytes buffer_;
    /// per byte of buffer_: exclusive or of this byte and all before, so that checking a false start does not read all the bytes that it
    /// claims
    Bytes sums_;
    std::size_t start_ = 0;          ///< first byte of buffer_ that is not yet decided
    std::size_t searched_ = 0;       ///< of a CoLa A frame: number of bytes known to be neither STX nor ETX
    std::uint64_t offset_ = 0;       ///< position of buffer_[start_] in the stream
    std::deque<Arrival> arrivals_;   ///< one per push whose bytes are still in the buffer
    std::uint64_t skippedSince_ = 0; ///< bytes skipped since the last frame
    ColaCounts counts_;
};

/// Puts the frame around a payload.
[[nodiscard]] Bytes framed(ByteView payload, Dialect dialect);

} // namespace edgescan::scanner
