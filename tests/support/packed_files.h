// Writes gzip, ZIP and numpy files for tests: the containers byte by byte, DEFLATE by zlib.
#pragma once

#include "tests/support/bytes.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgescan::test {

/// DEFLATE with gzip's header and checksum, or without.
inline std::string packedBytes(const std::string& bytes, bool gzip) {
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, gzip ? 15 + 16 : -15, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

inline std::string gzipBytes(const std::string& bytes) { return packedBytes(bytes, true); }

/// A zstd frame of so many MiB of zeros, in blocks that repeat one byte.
inline std::string zstdZeros(std::uint32_t mebibytes) {
    constexpr std::uint32_t kBlock = 128U << 10U, kRepeats = 1U << 1U, kLast = 1;
    std::string frame("\x28\xB5\x2F\xFD\xA0", 5); // one segment, its size has four bytes
    putAt(frame, 5, mebibytes << 20U);
    for (std::uint32_t left = mebibytes * 8; left > 0; --left) {
        putAt(frame, frame.size(), kBlock << 3U | kRepeats | (left == 1 ? kLast : 0)); // three bytes, and the zero to repeat
    }
    return frame;
}

/// An archive of these files, each with the ZIP64 field that numpy writes.
inline std::string zipBytes(const std::vector<std::pair<std::string, std::string>>& files, bool packed) {
    std::string archive, directory;
    for (const auto& [name, bytes] : files) {
        const std::string data = packed ? packedBytes(bytes, false) : bytes;
        const auto crc =
            static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
        std::string common;
        putAt(common, 0, std::uint16_t{45});
        putAt(common, 2, std::uint16_t{0});
        putAt(common, 4, static_cast<std::uint16_t>(packed ? 8 : 0));
        putAt(common, 6, std::uint32_t{0x21});
        putAt(common, 10, crc);
        putAt(common, 14, static_cast<std::uint32_t>(data.size()));
        putAt(common, 18, static_cast<std::uint32_t>(bytes.size()));
        putAt(common, 22, static_cast<std::uint16_t>(name.size()));
        std::string extra;
        putAt(extra, 0, std::uint16_t{1});
        putAt(extra, 2, std::uint16_t{16});
        putAt(extra, 4, std::uint64_t{bytes.size()});
        putAt(extra, 12, std::uint64_t{data.size()});
        const auto at = static_cast<std::uint32_t>(archive.size());
        std::string sizes = common;
        putAt(sizes, 14, std::uint64_t{0xFFFFFFFFFFFFFFFF}); // the sizes are in the field behind the name
        putAt(sizes, 22, static_cast<std::uint16_t>(name.size()));
        archive += "PK\x03\x04" + sizes;
        putAt(archive, archive.size(), static_cast<std::uint16_t>(extra.size()));
        archive += name + extra + data;
        directory += std::string("PK\x01\x02\x2d\x03", 6) + common;
        putAt(directory, directory.size(), std::uint16_t{0});
        directory += std::string(10, '\0');
        putAt(directory, directory.size(), at);
        directory += name;
    }
    const auto begin = static_cast<std::uint32_t>(archive.size());
    archive += directory + std::string("PK\x05\x06\0\0\0\0", 8);
    putAt(archive, archive.size(), static_cast<std::uint16_t>(files.size()));
    putAt(archive, archive.size(), static_cast<std::uint16_t>(files.size()));
    putAt(archive, archive.size(), static_cast<std::uint32_t>(directory.size()));
    putAt(archive, archive.size(), begin);
    putAt(archive, archive.size(), std::uint16_t{0});
    return archive;
}

/// As numpy writes it.
inline std::string npyHeader(const std::string& type, bool fortran, const std::string& shape) {
    return "{'descr': " + type + ", 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }";
}
inline std::string npyBytes(std::string header, const std::string& data) {
    while ((header.size() + 11) % 64 != 0) header += ' ';
    header += '\n';
    std::string bytes = "\x93NUMPY";
    bytes += std::string("\1\0", 2);
    putAt(bytes, 8, static_cast<std::uint16_t>(header.size()));
    return bytes + header + data;
}

/// Numbers as "<f4", ">u2" ...; with `sides` (lines, beams) in Fortran order.
inline std::string npyData(const std::vector<double>& values, const std::string& type,
                           std::optional<std::pair<std::size_t, std::size_t>> sides = {}) {
    std::string data;
    const std::string kind = type.substr(1);
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double value = sides ? values[n % sides->first * sides->second + n / sides->first] : values[n];
        std::string one;
        if (kind == "f4") putAt(one, 0, static_cast<float>(value));
        if (kind == "f8") putAt(one, 0, value);
        if (kind == "i4") putAt(one, 0, static_cast<std::int32_t>(value));
        if (kind == "u4") putAt(one, 0, static_cast<std::uint32_t>(value));
        if (kind == "i8") putAt(one, 0, static_cast<std::int64_t>(value));
        if (kind == "u2") putAt(one, 0, static_cast<std::uint16_t>(value));
        if (type[0] == '>') std::reverse(one.begin(), one.end());
        data += one;
    }
    return data;
}

} // namespace edgescan::test
