// zstd, lz4 and bz2, where the libraries were there when this was built.
#include "core/containers/compression/chunks.h"

#include <algorithm>

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

Error damaged(const std::string& compression, const std::string& where) {
    return {"it is compressed with " + compression + " and damaged or cut off", where, "copy the file again"};
}

// Room for the next piece of output, within the promised size and one byte more, so that too long an output is noticed.
bool grow(Bytes& out, std::size_t used, std::uint64_t size) {
    if (used > size) return false;
    if (used == out.size()) out.resize(static_cast<std::size_t>(std::min<std::uint64_t>(size + 1, used + std::max(kPiece, used))));
    return true;
}

#ifdef EDGESCAN_ZSTD
Result<Bytes> unpackZstd(ByteView packed, std::uint64_t size, const std::string& where) {
    ZSTD_DStream* stream = ZSTD_createDStream();
    if (stream == nullptr) return damaged("zstd", where);
    Bytes out;
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    std::size_t used = 0;
    bool sound = true;
    std::size_t left = 1;
    while (sound && left != 0) {
        sound = grow(out, used, size);
        if (!sound) break;
        ZSTD_outBuffer piece{out.data() + used, out.size() - used, 0};
        const std::size_t before = in.pos;
        left = ZSTD_decompressStream(stream, &piece, &in);
        used += piece.pos;
        if (ZSTD_isError(left) != 0 || (piece.pos == 0 && in.pos == before)) sound = false;
        if (left == 0 && in.pos < in.size) left = 1; // another frame follows
    }
    ZSTD_freeDStream(stream);
    if (!sound || used != size) return damaged("zstd", where);
    out.resize(used);
    return out;
}
#endif

#ifdef EDGESCAN_LZ4
Result<Bytes> unpackLz4(ByteView packed, std::uint64_t size, const std::string& where) {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) return damaged("lz4", where);
    Bytes out;
    std::size_t used = 0;
    bool sound = true;
    std::size_t left = 1;
    while (sound && left != 0) {
        sound = grow(out, used, size);
        if (!sound) break;
        std::size_t made = out.size() - used;
        std::size_t eaten = packed.size();
        left = LZ4F_decompress(context, out.data() + used, &made, packed.data(), &eaten, nullptr);
        packed = packed.subspan(eaten);
        used += made;
        if (LZ4F_isError(left) != 0 || (made == 0 && eaten == 0)) sound = false;
        if (left == 0 && !packed.empty()) left = 1; // another frame follows
    }
    LZ4F_freeDecompressionContext(context);
    if (!sound || used != size) return damaged("lz4", where);
    out.resize(used);
    return out;
}
#endif

#ifdef EDGESCAN_BZ2
Result<Bytes> unpackBz2(ByteView packed, std::uint64_t size, const std::string& where) {
    bz_stream stream{};
    if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return damaged("bz2", where);
    Bytes out;
    std::size_t used = 0;
    int state = BZ_OK;
    while (state == BZ_OK) {
        if (!grow(out, used, size)) break;
        if (stream.avail_in == 0) { // its numbers have 32 bits
            const std::size_t piece = std::min(packed.size(), std::size_t{1} << 30U);
            stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(packed.data())); // read only
            stream.avail_in = static_cast<unsigned>(piece);
            packed = packed.subspan(piece);
        }
        const std::size_t room = std::min(out.size() - used, std::size_t{1} << 30U);
        stream.next_out = reinterpret_cast<char*>(out.data()) + used;
        stream.avail_out = static_cast<unsigned>(room);
        const unsigned before = stream.avail_in;
        state = BZ2_bzDecompress(&stream);
        const std::size_t made = room - stream.avail_out;
        used += made;
        if (state == BZ_OK && made == 0 && stream.avail_in == before) break; // cut off
    }
    BZ2_bzDecompressEnd(&stream);
    if (state != BZ_STREAM_END || used != size) return damaged("bz2", where);
    out.resize(used);
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
                          const std::string& where) {
#ifdef EDGESCAN_ZSTD
    if (compression == "zstd") return unpackZstd(packed, size, where);
#endif
#ifdef EDGESCAN_LZ4
    if (compression == "lz4") return unpackLz4(packed, size, where);
#endif
#ifdef EDGESCAN_BZ2
    if (compression == "bz2") return unpackBz2(packed, size, where);
#endif
    if (compression == "zstd" || compression == "lz4" || compression == "bz2")
        return Error{"this program was built without " + compression + ", which this recording is compressed with", where,
                     "unpack it with \"mcap compress --compression none\" or \"rosbag decompress\", or install lib" + compression +
                         " and build again"};
    return Error{"it is compressed with \"" + compression.substr(0, 20) + "\", which is not known here", where,
                 "unpack it with the program that wrote it"};
}

} // namespace edgescan::containers
