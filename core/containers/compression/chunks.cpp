// zstd, lz4 and bz2, where the libraries were there when this was built.
#include "core/containers/compression/chunks.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <span>

#ifdef EDGESCAN_ZSTD
#include <zstd.h>
#endif
#ifdef EDGESCAN_LZ4
#include <lz4frame.h>
#endif
#ifdef EDGESCAN_BZ2
#include <bzlib.h>
#endif

namespace edgescan::containers {
namespace {

constexpr std::size_t kPiece = 256 * 1024;
constexpr std::size_t kBetweenLooks = 1024 * 1024; // at the wish to stop: bytes that come out

/// What is promised of a chunk, and how it is refused.
struct Promise {
    std::uint64_t size;
    Error damaged;
    const std::function<bool()>& goOn;
};

/// What one call of a library did.
struct Step {
    std::size_t eaten, made;
    bool sound, ended; ///< ended: nothing follows
};

/// All that next(packed, room) makes of the bytes, call by call.
template <class Next>
Result<Bytes> unpacked(ByteView packed, const Promise& promise, const Next& next) {
    const auto& [size, damaged, goOn] = promise;
    Bytes out;
    std::size_t used = 0;
    for (bool ended = false; !ended;) {
        if (used > 0 && goOn && !goOn()) return Error{"cancelled", damaged.where, ""};
        // Room within the promised size and one byte more, so that too long an output is noticed.
        if (used > size) return damaged;
        if (used == out.size()) out.resize(static_cast<std::size_t>(std::min<std::uint64_t>(size + 1, used + std::max(kPiece, used))));
        const Step step = next(packed, std::span(out).subspan(used, std::min(out.size() - used, kBetweenLooks)));
        ended = step.ended;
        if (!step.sound || (!ended && step.eaten == 0 && step.made == 0)) return damaged;
        packed = packed.subspan(step.eaten);
        used += step.made;
    }
    if (used != size) return damaged;
    out.resize(used);
    return out;
}

#ifdef EDGESCAN_ZSTD
Result<Bytes> unpackZstd(ByteView packed, const Promise& promise) {
    ZSTD_DStream* stream = ZSTD_createDStream();
    if (stream == nullptr) return promise.damaged;
    auto out = unpacked(packed, promise, [stream](ByteView from, std::span<std::uint8_t> room) {
        ZSTD_inBuffer in{from.data(), from.size(), 0};
        ZSTD_outBuffer piece{room.data(), room.size(), 0};
        const std::size_t left = ZSTD_decompressStream(stream, &piece, &in);
        return Step{in.pos, piece.pos, ZSTD_isError(left) == 0, left == 0 && in.pos == in.size}; // another frame may follow
    });
    ZSTD_freeDStream(stream);
    return out;
}
#endif

#ifdef EDGESCAN_LZ4
Result<Bytes> unpackLz4(ByteView packed, const Promise& promise) {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) return promise.damaged;
    auto out = unpacked(packed, promise, [context](ByteView from, std::span<std::uint8_t> room) {
        std::size_t made = room.size(), eaten = from.size();
        const std::size_t left = LZ4F_decompress(context, room.data(), &made, from.data(), &eaten, nullptr);
        return Step{eaten, made, LZ4F_isError(left) == 0, left == 0 && eaten == from.size()}; // another frame may follow
    });
    LZ4F_freeDecompressionContext(context);
    return out;
}
#endif

#ifdef EDGESCAN_BZ2
Result<Bytes> unpackBz2(ByteView packed, const Promise& promise) {
    bz_stream stream{};
    if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return promise.damaged;
    auto out = unpacked(packed, promise, [&stream](ByteView from, std::span<std::uint8_t> room) {
        const std::size_t most = std::size_t{1} << 30U; // its numbers have 32 bits
        const std::size_t in = std::min(from.size(), most), piece = std::min(room.size(), most);
        stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(from.data())); // read only
        stream.avail_in = static_cast<unsigned>(in);
        stream.next_out = reinterpret_cast<char*>(room.data());
        stream.avail_out = static_cast<unsigned>(piece);
        const int state = BZ2_bzDecompress(&stream);
        return Step{in - stream.avail_in, piece - stream.avail_out, state == BZ_OK || state == BZ_STREAM_END, state == BZ_STREAM_END};
    });
    BZ2_bzDecompressEnd(&stream);
    return out;
}
#endif

} // namespace

bool isZstd(ByteView packed) {
    return packed.size() >= 4 && packed[0] == 0x28 && packed[1] == 0xB5 && packed[2] == 0x2F && packed[3] == 0xFD;
}

std::optional<std::uint64_t> zstdSize([[maybe_unused]] ByteView packed) {
#ifdef EDGESCAN_ZSTD
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size != ZSTD_CONTENTSIZE_UNKNOWN && size != ZSTD_CONTENTSIZE_ERROR) return size;
#endif
    return std::nullopt;
}

Result<Bytes> unpackChunk(const std::string& compression, [[maybe_unused]] ByteView packed, [[maybe_unused]] std::uint64_t size,
                          const std::string& where, [[maybe_unused]] const std::function<bool()>& goOn) {
    [[maybe_unused]] const Promise promise{
        size, {withValues("it is compressed with %1 and damaged or cut off", {compression}), where, "copy the file again"}, goOn};
#ifdef EDGESCAN_ZSTD
    if (compression == "zstd") return unpackZstd(packed, promise);
#endif
#ifdef EDGESCAN_LZ4
    if (compression == "lz4") return unpackLz4(packed, promise);
#endif
#ifdef EDGESCAN_BZ2
    if (compression == "bz2") return unpackBz2(packed, promise);
#endif
    if (compression == "zstd" || compression == "lz4" || compression == "bz2")
        return Error{
            withValues("this program was built without %1, which this recording is compressed with", {compression}), where,
            withValues("unpack it with \"mcap compress --compression none\" or \"rosbag decompress\", or install lib%1 and build again",
                       {compression})};
    return Error{withValues("it is compressed with \"%1\", which is not known here", {compression.substr(0, 20)}), where,
                 "unpack it with the program that wrote it"};
}

} // namespace edgescan::containers
