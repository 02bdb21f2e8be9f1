// Opening and building files in memory, for tests.
#pragma once

#include "core/files/open_save/open_scan.h"

#include <cstring>
#include <span>
#include <string>

namespace edgescan::test {

inline Result<Scan> readBytes(const std::string& bytes, const std::string& extension, const ReadingOptions& options = {}) {
    return files::readScanBytes(std::as_bytes(std::span(bytes)), extension, options);
}

template <class T>
void putAt(std::string& bytes, std::size_t at, T value) {
    if (bytes.size() < at + sizeof value) bytes.resize(at + sizeof value, '\0');
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

template <class T>
T valueAt(const std::string& bytes, std::size_t at) {
    T value{};
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// The refusal, or "" if the bytes open.
inline std::string refusalOf(const std::string& bytes, const std::string& extension, const ReadingOptions& options = {}) {
    const auto scan = readBytes(bytes, extension, options);
    return scan ? std::string() : scan.error().sentence();
}

} // namespace edgescan::test
