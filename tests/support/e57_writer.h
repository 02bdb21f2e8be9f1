// Writes E57 files from the description of the format, slowly and simply; shares no code with the reader.
#pragma once

#include "tests/support/bytes.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace edgescan::test {

struct E57Column {
    enum class As : std::uint8_t { Double, Single, Integer, Scaled };

    std::string name;
    As as = As::Double;
    std::vector<double> values{};
    std::int64_t minimum = 0, maximum = 0;
    double scale = 1.0, offset = 0.0;

    [[nodiscard]] std::string xml() const {
        if (as == As::Double) return "<" + name + " type=\"Float\"/>";
        if (as == As::Single) return "<" + name + " type=\"Float\" precision=\"single\" minimum=\"-5\"/>";
        std::string text = "<" + name + " type=\"" + (as == As::Integer ? "Integer" : "ScaledInteger") + "\"";
        if (minimum != std::numeric_limits<std::int64_t>::min()) text += " minimum=\"" + std::to_string(minimum) + "\"";
        if (maximum != std::numeric_limits<std::int64_t>::max()) text += " maximum=\"" + std::to_string(maximum) + "\"";
        char number[96];
        if (as == As::Scaled) {
            std::snprintf(number, sizeof number, " scale=\"%.17g\" offset=\"%.17g\"", scale, offset);
            text += number;
        }
        return text + "/>";
    }

    /// Bit by bit, the lowest first; the last byte is filled with zeros.
    [[nodiscard]] std::string stream() const {
        std::vector<bool> bits;
        const auto put = [&](std::uint64_t value, int count) {
            for (int bit = 0; bit < count; ++bit) bits.push_back((value >> bit & 1U) != 0);
        };
        int count = 0;
        for (auto span = static_cast<std::uint64_t>(maximum) - static_cast<std::uint64_t>(minimum); span > 0; span /= 2) ++count;
        for (const double value : values) {
            std::uint64_t raw = 0;
            if (as == As::Double) {
                std::memcpy(&raw, &value, 8);
                put(raw, 64);
            } else if (as == As::Single) {
                const auto single = static_cast<float>(value);
                std::memcpy(&raw, &single, 4);
                put(raw, 32);
            } else {
                const double whole = as == As::Scaled ? std::round((value - offset) / scale) : value;
                put(static_cast<std::uint64_t>(static_cast<std::int64_t>(whole)) - static_cast<std::uint64_t>(minimum), count);
            }
        }
        std::string bytes((bits.size() + 7) / 8, '\0');
        for (std::size_t i = 0; i < bits.size(); ++i)
            if (bits[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | 1 << i % 8);
        return bytes;
    }
};

struct E57Part {
    std::vector<E57Column> columns;
    std::string xml;                         ///< further elements next to the points: pose, bounds, name
    std::size_t bytesPerPacket = 96;         ///< of the first stream; the others are split at other places
    std::optional<std::uint64_t> promised{}; ///< the claimed number of points, if it is not the true one
};

inline std::uint32_t slowCrc32c(const std::string& bytes) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc / 2 ^ (crc % 2 != 0 ? 0x82F63B78U : 0U);
    }
    return ~crc;
}

/// Splits into pages of 1,024 bytes with the checksum, highest byte first, in the last four.
inline std::string e57Pages(std::string logical) {
    logical.resize((logical.size() + 1019) / 1020 * 1020, ' ');
    std::string file;
    for (std::size_t at = 0; at < logical.size(); at += 1020) {
        const std::string page = logical.substr(at, 1020);
        const std::uint32_t crc = slowCrc32c(page);
        file += page;
        for (int shift = 24; shift >= 0; shift -= 8) file += static_cast<char>(crc >> shift);
    }
    return file;
}

/// Corrects the checksums of the pages after a change.
inline std::string withE57Checksums(std::string file) {
    std::string logical;
    for (std::size_t at = 0; at + 1024 <= file.size(); at += 1024) logical += file.substr(at, 1020);
    return e57Pages(logical);
}

inline std::uint64_t e57Place(std::size_t logical) { return logical / 1020 * 1024 + logical % 1020; }

/// The packets of one scan: packets with points, an index packet and an empty packet; the streams are split without regard to points.
inline std::string e57Packets(const E57Part& part) {
    std::vector<std::string> streams;
    for (const E57Column& column : part.columns) streams.push_back(column.stream());
    std::string packets;
    std::vector<std::size_t> at(streams.size(), 0);
    for (int number = 0;; ++number) {
        std::string lengths, data;
        bool more = false;
        for (std::size_t i = 0; i < streams.size(); ++i) {
            const std::string piece = streams[i].substr(at[i], part.bytesPerPacket + 13 * i);
            at[i] += piece.size();
            more = more || at[i] < streams[i].size();
            putAt(lengths, lengths.size(), static_cast<std::uint16_t>(piece.size()));
            data += piece;
        }
        std::string packet("\1\0\0\0\0\0", 6);
        putAt(packet, 4, static_cast<std::uint16_t>(streams.size()));
        packet += lengths + data;
        packet.resize((packet.size() + 3) / 4 * 4, '\0');
        putAt(packet, 2, static_cast<std::uint16_t>(packet.size() - 1));
        packets += packet;
        if (!more) break;
        if (number == 0) packets += std::string("\0\0\x1f\0", 4) + std::string(28, '\x55') + std::string("\2\0\3\0", 4);
    }
    return packets;
}

/// A whole file. `extra`: further elements of the root next to data3D.
inline std::string e57Bytes(const std::vector<E57Part>& parts, const std::string& extra = {}) {
    std::string logical(48, '\0');
    std::string scans;
    for (const E57Part& part : parts) {
        const std::size_t section = logical.size();
        const std::string packets = e57Packets(part);
        std::string head(32, '\0');
        head[0] = 1;
        putAt(head, 8, std::uint64_t{32 + packets.size()});
        putAt(head, 16, e57Place(section + 32));
        logical += head + packets;
        const std::uint64_t count = part.promised.value_or(part.columns.empty() ? 0 : part.columns[0].values.size());
        scans += "<vectorChild type=\"Structure\">" + part.xml + "<points type=\"CompressedVector\" fileOffset=\"" +
                 std::to_string(e57Place(section)) + "\" recordCount=\"" + std::to_string(count) + "\"><prototype type=\"Structure\">";
        for (const E57Column& column : part.columns) scans += column.xml();
        scans += "</prototype><codecs type=\"Vector\"/></points></vectorChild>\n";
    }
    const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" "
                            "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\"><data3D type=\"Vector\">" +
                            scans + "</data3D>" + extra + "</e57Root>\n";
    const std::size_t xmlAt = logical.size();
    logical += xml;
    logical.replace(0, 8, "ASTM-E57");
    putAt(logical, 8, std::uint32_t{1});
    putAt(logical, 16, std::uint64_t{(logical.size() + 1019) / 1020 * 1024});
    putAt(logical, 24, e57Place(xmlAt));
    putAt(logical, 32, std::uint64_t{xml.size()});
    putAt(logical, 40, std::uint64_t{1024});
    return e57Pages(logical);
}

/// Points as columns x y z, metres.
inline std::vector<E57Column> e57Cartesian(const std::vector<Eigen::Vector3d>& points, E57Column::As as = E57Column::As::Double,
                                           double scale = 1e-6) {
    std::vector<E57Column> columns{{"cartesianX"}, {"cartesianY"}, {"cartesianZ"}};
    for (int axis = 0; axis < 3; ++axis) {
        E57Column& column = columns[static_cast<std::size_t>(axis)];
        column.as = as;
        column.scale = scale;
        column.minimum = -20'000'000'000; // 20 km in steps of a micrometre: 36 bits
        column.maximum = 20'000'000'000;
        for (const auto& p : points) column.values.push_back(p[axis]);
    }
    return columns;
}

/// Integers with as many bits as they need.
inline E57Column e57Whole(const std::string& name, std::vector<double> values) {
    E57Column column{name, E57Column::As::Integer, std::move(values)};
    for (const double value : column.values) {
        column.minimum = std::min(column.minimum, static_cast<std::int64_t>(value));
        column.maximum = std::max(column.maximum, static_cast<std::int64_t>(value));
    }
    return column;
}

} // namespace edgescan::test
