// The directory at the end of a ZIP archive, and its entries.
#include "core/containers/compression/zip_archive.h"
#include "core/base/translated_text.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

namespace edgescan::containers {
namespace {

static_assert(std::endian::native == std::endian::little, "ZIP is read as the machine stores numbers");

constexpr const char* kCopyZip = "copy the file again, it may be cut off";
constexpr std::uint32_t kLocal = 0x04034B50, kCentral = 0x02014B50, kEnd = 0x06054B50, kEnd64 = 0x06064B50, kLocator64 = 0x07064B50;

/// Empty when the bytes are not there.
template <class T>
std::optional<T> valueIn(std::span<const std::byte> bytes, std::uint64_t at) {
    if (at > bytes.size() || bytes.size() - at < sizeof(T)) return std::nullopt;
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

struct Directory {
    std::uint64_t at = 0, entries = 0;
    std::uint64_t behind = 0; ///< byte of what follows the entries: the record that names their number
};

std::optional<Directory> directoryOf(std::span<const std::byte> file) {
    constexpr std::uint64_t kEndBytes = 22, kLongestComment = 65535, kLocatorBytes = 20;
    if (file.size() < kEndBytes) return std::nullopt;
    const std::uint64_t first = file.size() - std::min<std::uint64_t>(file.size(), kEndBytes + kLongestComment);
    for (std::uint64_t at = file.size() - kEndBytes + 1; at-- > first;) {
        if (*valueIn<std::uint32_t>(file, at) != kEnd) continue;
        const bool wide = at >= kLocatorBytes && *valueIn<std::uint32_t>(file, at - kLocatorBytes) == kLocator64;
        const std::uint64_t end64 = wide ? *valueIn<std::uint64_t>(file, at - kLocatorBytes + 8) : at;
        Directory found{*valueIn<std::uint32_t>(file, at + 16), *valueIn<std::uint16_t>(file, at + 10), end64};
        if (!wide || (found.at != 0xFFFFFFFF && found.entries != 0xFFFF)) return found;
        if (valueIn<std::uint32_t>(file, end64).value_or(0) != kEnd64) return std::nullopt;
        const auto entries = valueIn<std::uint64_t>(file, end64 + 32);
        const auto begin = valueIn<std::uint64_t>(file, end64 + 48);
        return entries && begin ? std::optional(Directory{*begin, *entries, end64}) : std::nullopt;
    }
    return std::nullopt;
}

/// Sizes and places that need 64 bits are in a field of their own, in this order, where the short ones are all ones.
bool readZip64(ZipEntry& entry, std::span<const std::byte> extra) {
    constexpr std::uint16_t kZip64 = 1;
    constexpr std::uint64_t kElsewhere = 0xFFFFFFFF;
    for (std::uint64_t at = 0; at + 4 <= extra.size();) {
        const auto id = *valueIn<std::uint16_t>(extra, at);
        const std::uint64_t length = *valueIn<std::uint16_t>(extra, at + 2);
        std::uint64_t from = at + 4;
        at = from + length;
        if (id != kZip64) continue;
        for (std::uint64_t* value : {&entry.bytes, &entry.packedBytes, &entry.headerAt}) {
            if (*value != kElsewhere) continue;
            const auto wide = valueIn<std::uint64_t>(extra, from);
            if (!wide) return false;
            *value = *wide;
            from += 8;
        }
    }
    return true;
}

} // namespace

bool isZip(std::span<const std::byte> file) {
    const auto first = valueIn<std::uint32_t>(file, 0);
    return first == kLocal || first == kEnd;
}

Result<std::vector<ZipEntry>> zipEntries(std::span<const std::byte> file, const std::string& where) {
    constexpr std::uint64_t kHead = 46;
    const auto directory = directoryOf(file);
    if (!directory) return Error{"this ZIP archive has no directory at its end", where, kCopyZip};
    std::vector<ZipEntry> entries;
    std::uint64_t at = directory->at;
    for (std::uint64_t n = 0; n < directory->entries; ++n) {
        const Error damaged{"the directory of this ZIP archive is damaged", withValues("%1: byte %2", {where, at}), kCopyZip};
        if (at > file.size() || file.size() - at < kHead || *valueIn<std::uint32_t>(file, at) != kCentral) return damaged;
        ZipEntry entry;
        entry.encrypted = (*valueIn<std::uint16_t>(file, at + 8) & 1U) != 0;
        entry.method = *valueIn<std::uint16_t>(file, at + 10);
        entry.crc = *valueIn<std::uint32_t>(file, at + 16);
        entry.packedBytes = *valueIn<std::uint32_t>(file, at + 20);
        entry.bytes = *valueIn<std::uint32_t>(file, at + 24);
        entry.headerAt = *valueIn<std::uint32_t>(file, at + 42);
        const std::uint64_t nameBytes = *valueIn<std::uint16_t>(file, at + 28);
        const std::uint64_t extraBytes = *valueIn<std::uint16_t>(file, at + 30);
        const std::uint64_t commentBytes = *valueIn<std::uint16_t>(file, at + 32);
        if (file.size() - at - kHead < nameBytes + extraBytes + commentBytes) return damaged;
        entry.name.assign(reinterpret_cast<const char*>(file.data()) + at + kHead, nameBytes);
        if (!readZip64(entry, file.subspan(at + kHead + nameBytes, extraBytes))) return damaged;
        at += kHead + nameBytes + extraBytes + commentBytes;
        entries.push_back(std::move(entry));
    }
    if (at != directory->behind)
        return Error{"this ZIP archive does not begin where its directory says: other bytes are before it or in it", where, kCopyZip};
    return entries;
}

Result<std::vector<std::byte>> unzip(std::span<const std::byte> file, const ZipEntry& entry, const std::string& where,
                                     const std::function<bool(double)>& goOn) {
    constexpr std::uint64_t kHead = 30;
    constexpr std::uint32_t kStored = 0, kDeflated = 8;
    const std::string place = where + ": " + entry.name;
    if (entry.encrypted) return Error{"this part of the archive is encrypted", place, "save it without a password"};
    if (entry.method != kStored && entry.method != kDeflated)
        return Error{withValues("this part of the archive is packed by method %1", {entry.method}), place,
                     "pack it with DEFLATE, as usual"};
    const bool there = valueIn<std::uint32_t>(file, entry.headerAt) == kLocal && file.size() - entry.headerAt >= kHead;
    const std::uint64_t from = there ? entry.headerAt + kHead + *valueIn<std::uint16_t>(file, entry.headerAt + 26) +
                                           *valueIn<std::uint16_t>(file, entry.headerAt + 28)
                                     : 0;
    if (!there || from > file.size() || file.size() - from < entry.packedBytes)
        return Error{"this part of the archive is not where its directory says", place, kCopyZip};
    if (entry.bytes > mostUnpackedBytes(entry.packedBytes)) {
        return Error{withValues("unpacked this is %1, far more than a scan of its size can be", {sizeText(entry.bytes)}), place,
                     "unpack it by hand and look at it"};
    }
    if (auto enough = checkMemory(entry.bytes, where); !enough) return enough.error();
    const auto packed = file.subspan(from, entry.packedBytes);
    std::vector<std::byte> bytes;
    if (entry.method == kStored) {
        bytes.assign(packed.begin(), packed.end());
    } else {
        bytes.reserve(entry.bytes);
        const auto used = inflateOne(packed, Packing::Deflate, entry.bytes, bytes, place, goOn);
        if (!used) return used.error();
    }
    uLong crc = ::crc32(0, nullptr, 0);
    crc = ::crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    if (bytes.size() != entry.bytes || crc != entry.crc)
        return Error{"this part of the archive is damaged: its length or its checksum does not fit", place, "copy the file again"};
    return bytes;
}

} // namespace edgescan::containers
