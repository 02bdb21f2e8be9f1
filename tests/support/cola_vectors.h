// Telegrams that no code of EdgeScan wrote, and what they decode to: the project's own in tests/data/telegrams, real ones in
// ../shared/protocol/vectors.
#pragma once

#include "core/scanner/sick_lms/scan_telegram.h"
#include "tests/support/shared_folder.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace edgescan::test {

inline std::filesystem::path protocolFolder() { return sharedFolder() / "protocol"; }
inline std::filesystem::path vectorsFolder() { return protocolFolder() / "vectors"; }

inline std::filesystem::path ownTelegrams() { return ownData() / "telegrams"; }

inline Bytes fileBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}
inline nlohmann::json fileJson(const std::filesystem::path& path) {
    std::ifstream file(path);
    return nlohmann::json::parse(file);
}

/// CRC-32 bit by bit, as "dfb4b09c".
inline std::string crc32Text(ByteView bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    char text[9];
    std::snprintf(text, sizeof text, "%08x", crc ^ 0xFFFFFFFFU);
    return text;
}

/// Over the values as 16-bit numbers, whatever their width on the wire, as in the tables.
inline std::string crc32Text(const scanner::ScanChannel& channel) {
    Bytes bytes;
    for (const std::uint16_t value : channel.values) {
        bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
        bytes.push_back(static_cast<std::uint8_t>(value));
    }
    return crc32Text(bytes);
}

/// All frames of a file.
inline std::vector<scanner::ColaFrame> framesOf(const std::filesystem::path& path, std::optional<scanner::Dialect> only = std::nullopt) {
    scanner::ColaStream stream(only);
    return stream.push(fileBytes(path));
}
/// All scan telegrams of a file, undecoded.
inline std::vector<scanner::ColaFrame> scanFramesOf(const std::filesystem::path& path) {
    std::vector<scanner::ColaFrame> frames = framesOf(path);
    std::erase_if(frames, [](const scanner::ColaFrame& frame) { return !scanner::isScanTelegram(frame.payload()); });
    return frames;
}

/// The rows of a CSV file by column name.
inline std::vector<std::map<std::string, std::string>> csvRows(const std::filesystem::path& path) {
    const auto cut = [](const std::string& line) {
        std::vector<std::string> cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        return cells;
    };
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = cut(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = cut(line);
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) row[names[i]] = cells[i];
    }
    return rows;
}

} // namespace edgescan::test

#define EDGESCAN_NEEDS_VECTORS() EDGESCAN_NEEDS_SHARED("protocol/vectors")
