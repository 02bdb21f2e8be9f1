// Unpacking the points of an E57 scan. Only the byte streams of the columns that are wanted are put together.
#include "core/containers/e57/columns.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/memory.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace edgescan::containers {
namespace {

constexpr const char* kCopy = "copy the file again";
constexpr std::uint64_t kSectionHeader = 32;
constexpr std::size_t kSlack = 16; // zero bytes behind a stream, so that eight and one may be read at its last bit

template <class T>
T valueAt(const std::vector<std::byte>& bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// The byte stream of one column, put together from the packets, and how long it must be.
struct Stream {
    const E57Field* field = nullptr;
    std::size_t number = 0; ///< of the stream in each packet
    std::uint64_t needed = 0;
    std::vector<std::byte> bytes;

    [[nodiscard]] bool whole() const { return bytes.size() >= needed; }
};

/// Where the packets of a section are, without checksums.
struct Packets {
    std::uint64_t from = 0, to = 0;
};

Result<Packets> packetsOf(E57File& file, const E57Scan& scan) {
    PagedBytes& pages = file.pages;
    const auto at = pages.logical(scan.sectionAt);
    std::vector<std::byte> head;
    if (!at || pages.size() - *at < kSectionHeader) {
        return Error{withValues("the points are said to begin at byte %1, which is not in the file", {scan.sectionAt}), pages.where(),
                     kCopy};
    }
    if (auto read = pages.read(*at, kSectionHeader, head); !read) return read.error();
    const auto length = valueAt<std::uint64_t>(head, 8);
    const auto data = pages.logical(valueAt<std::uint64_t>(head, 16));
    const std::string where = withValues("%1: byte %2", {pages.where(), scan.sectionAt});
    if (std::to_integer<int>(head[0]) != 1)
        return Error{"no list of points begins where the E57 file says", where, "export the file again"};
    if (length < kSectionHeader || length > pages.size() - *at || !data || *data < *at + kSectionHeader || *data > *at + length)
        return Error{"the header of the points does not fit the file", where, kCopy};
    return Packets{*data, *at + length};
}

/// One packet with points: takes the parts of the streams that are wanted.
Result<Done> appendPacket(const std::vector<std::byte>& packet, std::vector<Stream>& streams, std::size_t fields,
                          const std::string& where) {
    constexpr std::size_t kHead = 6;
    const auto damaged = [&](const std::string& what) { return Error{withValues("a packet of points %1", {what}), where, kCopy}; };
    if (packet.size() < kHead) return damaged("is too short");
    const std::size_t count = valueAt<std::uint16_t>(packet, 4);
    if (count != fields) {
        return damaged(withValues("holds %1 and the file describes %2", {counted(count, "column"), fields}));
    }
    if (packet.size() < kHead + 2 * count) return damaged("ends within its header");
    std::vector<std::size_t> starts(count + 1, kHead + 2 * count);
    for (std::size_t i = 0; i < count; ++i) starts[i + 1] = starts[i] + valueAt<std::uint16_t>(packet, kHead + 2 * i);
    if (starts.back() > packet.size()) return damaged("promises more bytes than it has");
    for (Stream& stream : streams) {
        const auto first = packet.begin() + static_cast<std::ptrdiff_t>(starts[stream.number]);
        const auto last = packet.begin() + static_cast<std::ptrdiff_t>(starts[stream.number + 1]);
        if (!stream.whole()) stream.bytes.insert(stream.bytes.end(), first, last);
    }
    return Done{};
}

Result<Done> readPackets(E57File& file, const E57Scan& scan, std::vector<Stream>& streams, const std::function<bool(double)>& goOn) {
    constexpr int kIndex = 0, kData = 1, kEmpty = 2;
    constexpr std::size_t kPacketHead = 4;
    const auto packets = packetsOf(file, scan);
    if (!packets) return packets.error();
    std::vector<std::byte> packet;
    std::size_t read = 0;
    for (std::uint64_t at = packets->from; at < packets->to; ++read) {
        if (std::ranges::all_of(streams, &Stream::whole)) break;
        const std::string where = withValues("%1: byte %2", {file.pages.where(), file.pages.physical(at)});
        if (packets->to - at < kPacketHead) break; // padding
        packet.clear();
        if (auto head = file.pages.read(at, kPacketHead, packet); !head) return head;
        const int kind = std::to_integer<int>(packet[0]);
        const std::uint64_t length = std::uint64_t{valueAt<std::uint16_t>(packet, 2)} + 1;
        if (kind != kIndex && kind != kData && kind != kEmpty)
            return Error{withValues("a packet of points is of kind %1, which E57 does not have", {kind}), where, kCopy};
        if (length < kPacketHead || length > packets->to - at)
            return Error{withValues("a packet of points says that it has %1 bytes, which are not there", {length}), where, kCopy};
        if (kind == kData) {
            if (auto rest = file.pages.read(at + kPacketHead, length - kPacketHead, packet); !rest) return rest;
            if (auto taken = appendPacket(packet, streams, scan.fields.size(), where); !taken) return taken;
        }
        at += length;
        const double done = static_cast<double>(at - packets->from) / static_cast<double>(packets->to - packets->from);
        if (read % 64 == 0 && !goOn(done)) return Error{"cancelled", file.pages.where(), ""};
    }
    return Done{};
}

/// `bits` bits from bit `at` on, the lowest first.
std::uint64_t bitsAt(const std::vector<std::byte>& bytes, std::uint64_t at, unsigned bits) {
    const std::size_t byte = at / 8;
    const auto shift = static_cast<unsigned>(at % 8);
    std::uint64_t value = valueAt<std::uint64_t>(bytes, byte) >> shift;
    if (shift + bits > 64) value |= std::to_integer<std::uint64_t>(bytes[byte + 8]) << (64 - shift);
    return bits < 64 ? value & ((std::uint64_t{1} << bits) - 1) : value;
}

std::vector<double> numbersIn(Stream& stream, std::uint64_t points) {
    const E57Field& field = *stream.field;
    const unsigned bits = field.bits();
    stream.bytes.resize(stream.bytes.size() + kSlack);
    std::vector<double> numbers(points);
    for (std::uint64_t n = 0; n < points; ++n) {
        const std::uint64_t raw = bits == 0 ? 0 : bitsAt(stream.bytes, n * bits, bits);
        switch (field.kind) {
        case E57Field::Kind::Single:
            numbers[n] = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
            break;
        case E57Field::Kind::Double:
            numbers[n] = std::bit_cast<double>(raw);
            break;
        default:
            numbers[n] = static_cast<double>(static_cast<std::int64_t>(raw + static_cast<std::uint64_t>(field.minimum)));
            if (field.kind == E57Field::Kind::ScaledInteger) numbers[n] = numbers[n] * field.scale + field.offset;
        }
    }
    return numbers;
}

} // namespace

Result<std::vector<std::vector<double>>> readE57Columns(E57File& file, const E57Scan& scan, const std::vector<std::size_t>& columns,
                                                        const std::function<bool(double)>& goOn) {
    // Points may take hardly a bit each, and then a file could promise any number of them: all that were ever measured take a byte.
    if (scan.points > file.pages.size()) {
        return Error{withValues("the file promises %1 and has %2 bytes for them", {counted(scan.points, "point"), file.pages.size()}),
                     file.pages.where(), kCopy};
    }
    if (auto enough = checkMemory((scan.points * columns.size() + file.pages.size() / 8) * sizeof(double), file.pages.where()); !enough)
        return enough.error();
    std::vector<Stream> streams;
    for (const std::size_t column : columns) {
        const E57Field& field = scan.fields[column];
        streams.push_back({&field, column, (scan.points * field.bits() + 7) / 8, {}});
    }
    if (auto taken = readPackets(file, scan, streams, goOn); !taken) return taken.error();
    std::vector<std::vector<double>> numbers;
    for (Stream& stream : streams) {
        if (!stream.whole()) {
            return Error{withValues("the file promises %1 and the column %2 ends after %3",
                                    {counted(scan.points, "point"), stream.field->name, stream.bytes.size() * 8 / stream.field->bits()}),
                         file.pages.where(), kCopy};
        }
        numbers.push_back(numbersIn(stream, scan.points));
        std::vector<std::byte>().swap(stream.bytes);
        if (!goOn(1.0)) return Error{"cancelled", file.pages.where(), ""};
    }
    return numbers;
}

} // namespace edgescan::containers
