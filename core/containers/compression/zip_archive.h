// ZIP archives: what is in them, and one file out of them (APPNOTE.TXT of PKWARE, with its ZIP64 fields).
#pragma once

#include "core/containers/compression/inflate.h"

namespace edgescan::containers {

struct ZipEntry {
    std::string name;
    std::uint32_t method = 0; ///< 0 stored, 8 DEFLATE
    bool encrypted = false;
    std::uint32_t crc = 0;
    std::uint64_t packedBytes = 0;
    std::uint64_t bytes = 0;
    std::uint64_t headerAt = 0; ///< byte of the file
};

[[nodiscard]] bool isZip(std::span<const std::byte> file);

/// The archive's directory. Error: it is missing, as in a file that was cut off, or it is damaged.
Result<std::vector<ZipEntry>> zipEntries(std::span<const std::byte> file, const std::string& where);

/// The bytes of one entry, checked against its CRC-32. Error: as inflateOne(), encrypted, packed in another way.
Result<std::vector<std::byte>> unzip(std::span<const std::byte> file, const ZipEntry& entry, const std::string& where,
                                     const std::function<bool(double)>& goOn);

} // namespace edgescan::containers
