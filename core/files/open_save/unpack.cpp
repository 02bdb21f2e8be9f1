// Unpacks by content; most files are not packed and stay where they are.
#include "core/files/open_save/unpack.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/containers/compression/chunks.h"
#include "core/containers/compression/gunzip.h"
#include "core/files/open_save/plain_text.h"

namespace edgescan::files {
namespace {

/// Of a zstd archive that says its size, and this is in reason; another one is named as a foreign file.
std::optional<std::uint64_t> zstdSizeOf(const Source& packed) {
    const ByteView bytes(reinterpret_cast<const std::uint8_t*>(packed.bytes.data()), packed.bytes.size());
    if (!containers::isZstd(bytes)) return std::nullopt;
    const auto size = containers::zstdSize(bytes);
    if (!size || *size > mostUnpackedBytes(bytes.size())) return std::nullopt;
    return size;
}

} // namespace

Error UnpackedSource::refused(const Error& error) const {
    const std::string path = source.path.string();
    if (!packed || !error.where.starts_with(path)) return error;
    return {error.what, path + " (unpacked)" + error.where.substr(path.size()), error.hint};
}

Result<UnpackedSource> unpack(const Source& packed) {
    UnpackedSource plain{packed, nullptr, false};
    if (containers::isGzip(packed.bytes)) {
        auto bytes = containers::gunzip(packed.bytes, packed.path.string(), [&](double done) { return packed.goOn("unpacking", done); });
        if (!bytes) return bytes.error();
        plain.bytes = std::make_shared<const std::vector<std::byte>>(std::move(*bytes));
        plain.source.bytes = *plain.bytes;
        plain.packed = true;
    }
    if (const auto size = zstdSizeOf(packed)) { // rosbag2 packs whole files so
        if (auto enough = checkMemory(*size, packed.path.string()); !enough) return enough.error();
        const ByteView bytes(reinterpret_cast<const std::uint8_t*>(packed.bytes.data()), packed.bytes.size());
        auto unpacked = containers::unpackChunk("zstd", bytes, *size, packed.path.string(), [&] { return packed.goOn("unpacking", 0.0); });
        if (!unpacked) return unpacked.error();
        const auto all = std::as_bytes(std::span(*unpacked));
        plain.bytes = std::make_shared<const std::vector<std::byte>>(all.begin(), all.end());
        plain.source.bytes = *plain.bytes;
        plain.packed = true;
    }
    if (plain.source.bytes.empty()) return plain.refused(packed.refused("the file is empty", "copy it again or choose another"));
    auto text = plainText(plain.source);
    if (!text) return text.error();
    if (!*text) return plain;
    plain.warnings = std::move((*text)->warnings);
    plain.source.bytes = (*text)->bytes;
    if ((*text)->converted.empty()) return plain;
    const auto start = static_cast<std::size_t>((*text)->bytes.data() - (*text)->converted.data());
    const std::size_t length = (*text)->bytes.size();
    plain.bytes = std::make_shared<const std::vector<std::byte>>(std::move((*text)->converted));
    plain.source.bytes = std::span(*plain.bytes).subspan(start, length);
    return plain;
}

} // namespace edgescan::files
