// The records of an MCAP file (public specification, mcap.dev/spec) and the little-endian bytes that they are made of.
#pragma once

#include "core/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::containers {

inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

enum class McapOpcode : std::uint8_t {
    Header = 0x01,
    Footer = 0x02,
    Schema = 0x03,
    Channel = 0x04,
    Message = 0x05,
    Chunk = 0x06,
    MessageIndex = 0x07,
    ChunkIndex = 0x08,
    Statistics = 0x0B,
    Metadata = 0x0C,
    MetadataIndex = 0x0D,
    DataEnd = 0x0F,
};

/// Opcode and 64-bit length before every record.
inline constexpr std::size_t kMcapRecordHead = 9;

struct McapSchema {
    std::uint16_t id = 0; ///< never 0
    std::string name;
    std::string encoding; ///< "jsonschema", "text" ...
    std::string text;
    bool operator==(const McapSchema&) const = default;
};

struct McapChannel {
    std::uint16_t id = 0;
    std::uint16_t schema = 0; ///< 0 = none
    std::string topic;
    std::string encoding; ///< of its messages: "json", "x-sick-cola" ...
    std::map<std::string, std::string> metadata;
    bool operator==(const McapChannel&) const = default;
};

struct McapMetadata {
    std::string name;
    std::map<std::string, std::string> entries;
    bool operator==(const McapMetadata&) const = default;
};

/// A message whose bytes have another owner.
struct McapMessage {
    std::uint16_t channel = 0;
    std::uint32_t sequence = 0;
    std::uint64_t logNs = 0;     ///< when it was received, ns since 1970 UTC
    std::uint64_t publishNs = 0; ///< when it was made
    ByteView payload;
};

/// Puts numbers and strings behind one another.
class McapBytes {
public:
    void number8(std::uint8_t v) { append(v, 1); }
    void number16(std::uint16_t v) { append(v, 2); }
    void number32(std::uint32_t v) { append(v, 4); }
    void number64(std::uint64_t v) { append(v, 8); }
    void raw(ByteView bytes) { put(bytes.data(), bytes.size()); }
    void raw(std::string_view text) { put(text.data(), text.size()); }
    void string(std::string_view text) {
        number32(static_cast<std::uint32_t>(text.size()));
        raw(text);
    }
    void map(const std::map<std::string, std::string>& entries) {
        McapBytes inner;
        for (const auto& [key, value] : entries) {
            inner.string(key);
            inner.string(value);
        }
        number32(static_cast<std::uint32_t>(inner.bytes_.size()));
        raw(inner.bytes_);
    }
    void record(McapOpcode opcode, ByteView content) {
        number8(static_cast<std::uint8_t>(opcode));
        number64(content.size());
        raw(content);
    }
    [[nodiscard]] const Bytes& bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    Bytes popBytes() { return std::exchange(bytes_, {}); }
    void clear() { bytes_.clear(); }

private:
    void append(std::uint64_t v, unsigned count);
    void put(const void* from, std::size_t count);
    Bytes bytes_;
};

/// CRC-32 as MCAP, zip and PNG use it.
[[nodiscard]] std::uint32_t crc32(ByteView bytes);

/// The CRC-32 of any part of some bytes in a time that does not depend on its length: sums from the front are stored every 1,024 bytes.
class PartChecksums {
public:
    /// The bytes must outlive it.
    explicit PartChecksums(ByteView bytes);
    [[nodiscard]] std::uint32_t of(std::size_t from, std::size_t count) const;

private:
    [[nodiscard]] std::uint32_t upTo(std::size_t end) const;
    ByteView bytes_;
    std::vector<std::uint32_t> kept_;
};

/// Takes numbers and strings off the front; once something is missing it is bad() and gives zeros and nothing.
class McapCursor {
public:
    explicit McapCursor(ByteView bytes) : bytes_(bytes) {}
    std::uint8_t number8() { return static_cast<std::uint8_t>(number(1)); }
    std::uint16_t number16() { return static_cast<std::uint16_t>(number(2)); }
    std::uint32_t number32() { return static_cast<std::uint32_t>(number(4)); }
    std::uint64_t number64() { return number(8); }
    ByteView raw(std::uint64_t count) {
        if (count > bytes_.size()) {
            bad_ = true;
            bytes_ = {};
            return {};
        }
        const auto front = bytes_.first(static_cast<std::size_t>(count));
        bytes_ = bytes_.subspan(front.size());
        return front;
    }
    std::string string() { return std::string(text()); }
    /// The same in place: what searches for records must not copy what they claim to hold.
    std::string_view text() {
        const auto text = raw(number32());
        return {reinterpret_cast<const char*>(text.data()), text.size()};
    }
    std::map<std::string, std::string> map() {
        std::map<std::string, std::string> entries;
        McapCursor inner(raw(number32()));
        while (!inner.bytes_.empty() && !inner.bad_) {
            std::string key = inner.string();
            entries[std::move(key)] = inner.string();
        }
        bad_ = bad_ || inner.bad_;
        return entries;
    }
    [[nodiscard]] ByteView rest() const { return bytes_; }
    [[nodiscard]] bool bad() const { return bad_; }

private:
    std::uint64_t number(std::size_t count) { return littleEndian(raw(count)); }
    ByteView bytes_;
    bool bad_ = false;
};

} // namespace edgescan::containers
