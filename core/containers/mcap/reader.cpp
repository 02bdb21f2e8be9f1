// Reading MCAP record by record.
#include "core/containers/mcap/reader.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/bytes_behind.h"
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/containers/compression/chunks.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <set>

namespace edgescan::containers {
namespace {

constexpr std::size_t kChunkFields = 8 + 8 + 8 + 4;                             // before the compression string
constexpr std::size_t kPlainChunkHead = kMcapRecordHead + kChunkFields + 4 + 8; // of an uncompressed chunk, up to its first record
constexpr std::uint64_t kAskFrom = 1ULL << 20U;                                 // bytes of a chunk: asking takes time too
constexpr std::size_t kLongestDataEnd = 64;                                     // longer: the opcode of something else was damaged
constexpr std::size_t kWarnings = 20;
constexpr std::size_t kBetweenLooks = 64; // at the wish to stop: records

struct Record {
    std::uint8_t opcode = 0;
    ByteView content;
    std::size_t length = 0; // with opcode and length
};

/// The record at the front, or nothing when it is torn or no record at all.
std::optional<Record> recordAt(ByteView bytes) {
    McapCursor cursor(bytes);
    const std::uint8_t opcode = cursor.number8();
    const std::uint64_t length = cursor.number64();
    const ByteView content = cursor.raw(length);
    if (cursor.bad() || opcode == 0) return std::nullopt;
    return Record{opcode, content, kMcapRecordHead + content.size()};
}

struct ChunkHead {
    std::uint64_t size = 0;
    std::uint32_t crc = 0;
    std::string_view compression;
    ByteView records;
    bool sound = false;
};
ChunkHead chunkHead(ByteView content) {
    McapCursor cursor(content);
    cursor.number64(); // times of the first and last message
    cursor.number64();
    ChunkHead head;
    head.size = cursor.number64();
    head.crc = cursor.number32();
    head.compression = cursor.text();
    head.records = cursor.raw(cursor.number64());
    head.sound = !cursor.bad();
    return head;
}

class Reader {
public:
    Reader(ByteView bytes, const std::string& where, const std::function<bool()>& goOn) : bytes_(bytes), where_(where), goOn_(goOn) {}

    Result<McapContent> read() {
        std::size_t at = kMcapMagic.size();
        for (std::size_t n = 0; at < bytes_.size() && (n % kBetweenLooks != 0 || !isCancelled()); ++n) {
            const auto record = recordAt(bytes_.subspan(at));
            if (record && record->opcode == static_cast<std::uint8_t>(McapOpcode::DataEnd) && record->content.size() <= kLongestDataEnd) {
                const std::size_t summary = at + record->length;
                if (damagedBetween_) mendFromSummary(summary);
                leaveOutBehindFooter(summary);
                content_.clean = !damagedBetween_ && footerIsSound(summary) && everythingWasRead(summary);
                break;
            }
            const std::size_t behind = record ? behindRecord(*record, at) : at;
            const bool fits = record && lengthsAgree(*record) && recordCanBeAt(behind);
            const bool checked = record && isSoundChunk(*record);
            if (fits || checked) readRecord(*record, at);
            if (fits) {
                at = behind;
                continue;
            }
            const std::size_t next = soundChunkAfter(checked ? behind - 1 : at);
            if (next == bytes_.size()) {
                if (checked) at = behind;
                salvage(at);
                break;
            }
            warn(withValues("bytes %1 to %2 are damaged and were left out", {checked ? behind : at, next}));
            damagedBetween_ = true;
            at = next;
        }
        if (isCancelled()) return Error{"cancelled", where_, ""};
        content_.end = at;
        if (untold_ > 0) content_.warnings.push_back(withValues("%1 more places are damaged or were left out", {untold_}));
        return std::move(content_);
    }

private:
    [[nodiscard]] bool isCancelled() const { return goOn_ && !goOn_(); }

    void warn(std::string sentence) {
        if (content_.warnings.size() < kWarnings)
            content_.warnings.push_back(std::move(sentence));
        else
            ++untold_;
    }

    /// A record may begin here: one that the specification knows, or a private one that fits; or the file ends.
    bool recordCanBeAt(std::size_t at) const {
        if (bytes_.size() - at < kMcapRecordHead) return true;
        constexpr std::uint8_t kLastKnown = 0x0F;
        constexpr std::uint8_t kFirstPrivate = 0x80;
        const std::uint8_t opcode = bytes_[at];
        const bool known = opcode >= 1 && opcode <= kLastKnown;
        return known || (opcode >= kFirstPrivate && recordAt(bytes_.subspan(at)).has_value());
    }

    /// Records other than messages and chunks say inside how long they are, give or take fields that are still to be invented.
    static bool lengthsAgree(const Record& record) {
        constexpr std::size_t kNewFields = 256;
        McapCursor cursor(record.content);
        switch (static_cast<McapOpcode>(record.opcode)) {
        case McapOpcode::MessageIndex:
            cursor.number16(); // channel
            cursor.raw(cursor.number32());
            break;
        case McapOpcode::Channel:
            cursor.number16(); // channel
            [[fallthrough]];
        case McapOpcode::Schema:
            cursor.number16(); // schema
            [[fallthrough]];
        case McapOpcode::Header:
            cursor.string();
            cursor.string();
            if (record.opcode != static_cast<std::uint8_t>(McapOpcode::Header)) cursor.raw(cursor.number32());
            break;
        case McapOpcode::Metadata:
            cursor.string();
            cursor.map();
            break;
        default:
            return true;
        }
        return !cursor.bad() && cursor.rest().size() <= kNewFields;
    }

    /// The byte after a record. Where the length of a chunk was damaged its inner lengths say more.
    std::size_t behindRecord(const Record& record, std::size_t at) const {
        const std::size_t behind = at + record.length;
        if (record.opcode != static_cast<std::uint8_t>(McapOpcode::Chunk)) return behind;
        const ChunkHead chunk = chunkHead(record.content);
        if (!chunk.sound) return behind;
        const std::size_t inner = static_cast<std::size_t>(chunk.records.data() + chunk.records.size() - bytes_.data());
        return inner < behind && recordCanBeAt(inner) ? inner : behind;
    }

    static bool isSoundChunk(const Record& record) {
        if (record.opcode != static_cast<std::uint8_t>(McapOpcode::Chunk)) return false;
        const ChunkHead chunk = chunkHead(record.content);
        return chunk.sound && chunk.compression.empty() && chunk.crc != 0 && crc32(chunk.records) == chunk.crc;
    }

    void readRecord(const Record& record, std::size_t at) {
        McapCursor cursor(record.content);
        switch (static_cast<McapOpcode>(record.opcode)) {
        case McapOpcode::Header:
            content_.profile = cursor.string();
            content_.library = cursor.string();
            break;
        case McapOpcode::Metadata: {
            McapMetadata metadata;
            metadata.name = cursor.string();
            metadata.entries = cursor.map();
            if (!cursor.bad()) content_.metadata.push_back(std::move(metadata));
            break;
        }
        case McapOpcode::Chunk:
            readChunk(record.content, at);
            break;
        default:
            readInnerRecord(record);
        }
    }

    /// Records that may be inside of a chunk and outside. False: not understood.
    void readInnerRecord(const Record& record) {
        McapCursor cursor(record.content);
        if (record.opcode == static_cast<std::uint8_t>(McapOpcode::Message)) {
            McapMessage message;
            message.channel = cursor.number16();
            message.sequence = cursor.number32();
            message.logNs = cursor.number64();
            message.publishNs = cursor.number64();
            message.payload = cursor.rest();
            if (!cursor.bad()) content_.messages.push_back(message);
        } else if (record.opcode == static_cast<std::uint8_t>(McapOpcode::Schema)) {
            McapSchema schema;
            schema.id = cursor.number16();
            schema.name = cursor.string();
            schema.encoding = cursor.string();
            schema.text = cursor.string();
            if (!cursor.bad() && schema.id != 0) content_.schemas.emplace(schema.id, std::move(schema));
        } else if (record.opcode == static_cast<std::uint8_t>(McapOpcode::Channel)) {
            McapChannel channel;
            channel.id = cursor.number16();
            channel.schema = cursor.number16();
            channel.topic = cursor.string();
            channel.encoding = cursor.string();
            channel.metadata = cursor.map();
            if (!cursor.bad()) content_.channels.emplace(channel.id, std::move(channel));
        }
    }

    void readChunk(ByteView content, std::size_t at) {
        const ChunkHead chunk = chunkHead(content);
        if (!chunk.sound) return leaveOut(at, "it is not a whole chunk");
        ByteView records = chunk.records;
        if (!chunk.compression.empty()) {
            const auto unpacked = unpack(chunk);
            if (!unpacked) return leaveOut(at, unpacked.error().what);
            records = *unpacked;
        }
        if (chunk.crc != 0 && crc32(records) != chunk.crc) return leaveOut(at, "its checksum does not fit");
        readRecords(records);
    }

    Result<ByteView> unpack(const ChunkHead& chunk) {
        const std::uint64_t allowed = mostUnpackedBytes(bytes_.size());
        if (chunk.size > allowed - std::min(allowed, unpacked_))
            return Error{withValues("it promises to unpack to %1, more than a file of this size holds", {sizeText(chunk.size)}), where_,
                         ""};
        if (chunk.size >= kAskFrom) {
            if (auto enough = checkMemory(chunk.size, where_); !enough) return enough.error();
        }
        auto bytes = unpackChunk(std::string(chunk.compression), chunk.records, chunk.size, where_, goOn_);
        if (!bytes) return bytes.error();
        unpacked_ += bytes->size();
        content_.unpacked.push_back(std::move(*bytes));
        return ByteView(content_.unpacked.back());
    }

    void leaveOut(std::size_t at, const std::string& why) {
        ++content_.badChunks;
        warn(withValues("the chunk at byte %1 was left out: %2", {at, why}));
    }

    /// Whole records from the front.
    void readRecords(ByteView records) {
        while (const auto record = recordAt(records)) {
            readInnerRecord(*record);
            records = records.subspan(record->length);
        }
    }

    /// The records of a torn last chunk are plain; its checksum cannot be checked any more.
    void salvage(std::size_t at) {
        const ByteView rest = bytes_.subspan(at);
        if (rest.size() <= kPlainChunkHead || rest[0] != static_cast<std::uint8_t>(McapOpcode::Chunk)) return;
        McapCursor compression(rest.subspan(kMcapRecordHead + kChunkFields));
        if (compression.number32() != 0) return;
        const std::size_t before = content_.messages.size();
        readRecords(rest.subspan(kPlainChunkHead));
        content_.salvaged = content_.messages.size() - before;
    }

    /// First byte of a chunk that can be trusted behind damage, or the end: an uncompressed one whose checksum fits, or a compressed one
    /// with the mark of its packing that ends where a record can be.
    std::size_t soundChunkAfter(std::size_t at) {
        for (std::size_t i = at + 1; i + kPlainChunkHead < bytes_.size(); ++i) {
            if (bytes_[i] != static_cast<std::uint8_t>(McapOpcode::Chunk)) continue;
            const auto record = recordAt(bytes_.subspan(i));
            if (!record || record->content.size() < kPlainChunkHead - kMcapRecordHead) continue;
            const ChunkHead chunk = chunkHead(record->content);
            if (chunk.sound && (chunk.compression.empty() ? hasItsChecksum(chunk) : isPacked(chunk, i + record->length))) return i;
        }
        return bytes_.size();
    }
    bool hasItsChecksum(const ChunkHead& chunk) {
        if (chunk.crc == 0 || chunk.size != chunk.records.size()) return false;
        if (!checksums_) checksums_.emplace(bytes_);
        return checksums_->of(static_cast<std::size_t>(chunk.records.data() - bytes_.data()), chunk.records.size()) == chunk.crc;
    }
    bool isPacked(const ChunkHead& chunk, std::size_t behind) const {
        constexpr std::array<std::uint8_t, 4> kZstd{0x28, 0xB5, 0x2F, 0xFD}, kLz4{0x04, 0x22, 0x4D, 0x18};
        const bool zstd = chunk.compression == "zstd";
        if (!zstd && chunk.compression != "lz4") return false;
        return chunk.records.size() >= 4 && std::ranges::equal(chunk.records.first(4), zstd ? kZstd : kLz4) && recordCanBeAt(behind);
    }

    /// Bytes behind the footer and its magic are not of this recording.
    void leaveOutBehindFooter(std::size_t at) {
        while (const auto record = recordAt(bytes_.subspan(at))) {
            at += record->length;
            if (record->opcode != static_cast<std::uint8_t>(McapOpcode::Footer)) continue;
            const std::size_t end = at + kMcapMagic.size();
            if (end > bytes_.size() || !looksLikeMcap(bytes_.subspan(at))) return;
            if (auto behind = bytesBehind(std::as_bytes(bytes_.subspan(end)), "the end of the recording")) {
                behind->pop_back();
                warn(*behind);
            }
            bytes_ = bytes_.first(end);
            return;
        }
    }

    /// Footer and magic are where they belong and the summary's checksum fits.
    bool footerIsSound(std::size_t summary) const {
        constexpr std::size_t kFooter = kMcapRecordHead + 8 + 8 + 4;
        if (bytes_.size() < summary + kFooter + kMcapMagic.size() || !looksLikeMcap(bytes_.last(kMcapMagic.size()))) return false;
        const std::size_t at = bytes_.size() - kMcapMagic.size() - kFooter;
        const auto record = recordAt(bytes_.subspan(at));
        if (!record || record->opcode != static_cast<std::uint8_t>(McapOpcode::Footer) || record->length != kFooter) return false;
        McapCursor cursor(record->content);
        const std::uint64_t start = cursor.number64();
        cursor.number64(); // summary offsets
        const std::uint32_t crc = cursor.number32();
        if (crc == 0) return true;
        const std::size_t covered = at + kFooter - 4;
        const std::size_t from = start == 0 ? at : static_cast<std::size_t>(std::min<std::uint64_t>(start, covered));
        return crc32(bytes_.subspan(from, covered - from)) == crc;
    }

    /// The summary repeats schemas and channels and knows where the metadata are. Entries that name the same place, or places inside each
    /// other, must not make more of the file than there is: what is read in all is no longer than the file.
    void mendFromSummary(std::size_t summary) {
        std::set<std::string, std::less<>> known;
        for (const McapMetadata& m : content_.metadata) known.insert(m.name);
        std::size_t left = bytes_.size();
        while (const auto record = recordAt(bytes_.subspan(summary))) {
            summary += record->length;
            const auto opcode = static_cast<McapOpcode>(record->opcode);
            if (opcode == McapOpcode::Schema || opcode == McapOpcode::Channel) readInnerRecord(*record);
            if (opcode != McapOpcode::MetadataIndex) continue;
            McapCursor cursor(record->content);
            const std::uint64_t at = cursor.number64();
            cursor.number64(); // length
            if (known.contains(cursor.text()) || at > bytes_.size()) continue;
            const auto metadata = recordAt(bytes_.subspan(static_cast<std::size_t>(at)));
            if (!metadata || metadata->opcode != static_cast<std::uint8_t>(McapOpcode::Metadata) || metadata->length > left) continue;
            left -= metadata->length;
            const std::size_t before = content_.metadata.size();
            readRecord(*metadata, static_cast<std::size_t>(at));
            if (content_.metadata.size() > before) known.insert(content_.metadata.back().name);
        }
    }

    /// As many messages were read as the summary counts.
    bool everythingWasRead(std::size_t summary) {
        while (const auto record = recordAt(bytes_.subspan(summary))) {
            summary += record->length;
            if (record->opcode != static_cast<std::uint8_t>(McapOpcode::Statistics)) continue;
            const std::uint64_t count = McapCursor(record->content).number64();
            if (count == content_.messages.size()) return true;
            warn(withValues("the file says that it holds %1 and %2 could be read", {counted(count, "message"), content_.messages.size()}));
            return false;
        }
        return true; // a summary need not have statistics
    }

    ByteView bytes_;
    const std::string& where_;
    const std::function<bool()>& goOn_;
    McapContent content_;
    std::uint64_t unpacked_ = 0;
    std::size_t untold_ = 0;
    std::optional<PartChecksums> checksums_; // made by the first search behind damage
    bool damagedBetween_ = false;
};

} // namespace

bool looksLikeMcap(ByteView bytes) {
    return bytes.size() >= kMcapMagic.size() && std::memcmp(bytes.data(), kMcapMagic.data(), kMcapMagic.size()) == 0;
}

Result<McapContent> readMcap(ByteView bytes, const std::string& where, const std::function<bool()>& goOn) {
    if (!looksLikeMcap(bytes)) return Error{"this is not an MCAP recording of a known version", where, "choose a recording"};
    return Reader(bytes, where, goOn).read();
}

const McapChannel* channelOf(const McapContent& content, const McapMessage& message) {
    const auto found = content.channels.find(message.channel);
    return found == content.channels.end() ? nullptr : &found->second;
}

} // namespace edgescan::containers
