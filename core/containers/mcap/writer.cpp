// MCAP records, chunks and summary.
#include "core/containers/mcap/writer.h"

#include <algorithm>

namespace edgescan::containers {
namespace {

constexpr std::size_t kMessageFields = 2 + 4 + 8 + 8;

} // namespace

void McapEncoder::Span::include(std::uint64_t t) {
    first = std::min(first, t);
    last = std::max(last, t);
}

McapEncoder::McapEncoder(const std::string& library, McapLimits limits) : limits_(limits) {
    ready_.raw(kMcapMagic);
    McapBytes header;
    header.string(""); // profile
    header.string(library);
    ready_.record(McapOpcode::Header, header.bytes());
}

void McapEncoder::schema(const McapSchema& schema) {
    McapBytes content;
    content.number16(schema.id);
    content.string(schema.name);
    content.string(schema.encoding);
    content.string(schema.text);
    ready_.record(McapOpcode::Schema, content.bytes());
    schemas_.record(McapOpcode::Schema, content.bytes());
    ++schemaCount_;
}

void McapEncoder::channel(const McapChannel& channel) {
    McapBytes content;
    content.number16(channel.id);
    content.number16(channel.schema);
    content.string(channel.topic);
    content.string(channel.encoding);
    content.map(channel.metadata);
    ready_.record(McapOpcode::Channel, content.bytes());
    channels_.record(McapOpcode::Channel, content.bytes());
    ++channelCount_;
}

void McapEncoder::metadata(const McapMetadata& metadata) {
    endChunk();
    McapBytes content;
    content.string(metadata.name);
    content.map(metadata.entries);
    McapBytes index;
    index.number64(position());
    index.number64(kMcapRecordHead + content.size());
    index.string(metadata.name);
    metadataIndexes_.record(McapOpcode::MetadataIndex, index.bytes());
    ready_.record(McapOpcode::Metadata, content.bytes());
    ++metadataCount_;
}

void McapEncoder::message(const McapMessage& message) {
    const std::size_t length = kMessageFields + message.payload.size();
    if (chunk_.size() > 0) {
        const std::uint64_t first = std::min(chunkTime_.first, message.logNs);
        const std::uint64_t last = std::max(chunkTime_.last, message.logNs);
        if (chunk_.size() + kMcapRecordHead + length > limits_.chunkBytes || last - first > limits_.chunkNs) endChunk();
    }
    McapBytes& index = chunkIndex_[message.channel];
    index.number64(message.logNs);
    index.number64(chunk_.size());
    chunk_.number8(static_cast<std::uint8_t>(McapOpcode::Message));
    chunk_.number64(length);
    chunk_.number16(message.channel);
    chunk_.number32(message.sequence);
    chunk_.number64(message.logNs);
    chunk_.number64(message.publishNs);
    chunk_.raw(message.payload);
    chunkTime_.include(message.logNs);
    fileTime_.include(message.logNs);
    ++messageCounts_[message.channel];
    ++openMessages_;
}

void McapEncoder::endChunk() {
    if (chunk_.size() == 0) return;
    const std::uint64_t start = position();
    McapBytes content;
    content.number64(chunkTime_.first);
    content.number64(chunkTime_.last);
    content.number64(chunk_.size());
    content.number32(crc32(chunk_.bytes()));
    content.string(""); // compression
    content.number64(chunk_.size());
    content.raw(chunk_.bytes());
    ready_.record(McapOpcode::Chunk, content.bytes());

    const std::uint64_t indexStart = position();
    McapBytes offsets;
    for (const auto& [channel, entries] : chunkIndex_) {
        offsets.number16(channel);
        offsets.number64(position());
        McapBytes messageIndex;
        messageIndex.number16(channel);
        messageIndex.number32(static_cast<std::uint32_t>(entries.size()));
        messageIndex.raw(entries.bytes());
        ready_.record(McapOpcode::MessageIndex, messageIndex.bytes());
    }
    McapBytes index;
    index.number64(chunkTime_.first);
    index.number64(chunkTime_.last);
    index.number64(start);
    index.number64(kMcapRecordHead + content.size());
    index.number32(static_cast<std::uint32_t>(offsets.size()));
    index.raw(offsets.bytes());
    index.number64(position() - indexStart);
    index.string(""); // compression
    index.number64(chunk_.size());
    index.number64(chunk_.size());
    chunkIndexes_.record(McapOpcode::ChunkIndex, index.bytes());
    ++chunkCount_;
    chunk_.clear();
    openMessages_ = 0;
    chunkIndex_.clear();
    chunkTime_ = {};
}

Bytes McapEncoder::statistics() const {
    std::uint64_t messages = 0;
    McapBytes counts;
    for (const auto& [channel, count] : messageCounts_) {
        counts.number16(channel);
        counts.number64(count);
        messages += count;
    }
    McapBytes content;
    content.number64(messages);
    content.number16(schemaCount_);
    content.number32(channelCount_);
    content.number32(0); // attachments
    content.number32(metadataCount_);
    content.number32(chunkCount_);
    content.number64(messages > 0 ? fileTime_.first : 0);
    content.number64(fileTime_.last);
    content.number32(static_cast<std::uint32_t>(counts.size()));
    content.raw(counts.bytes());
    return content.popBytes();
}

void McapEncoder::finish() {
    endChunk();
    McapBytes dataEnd;
    dataEnd.number32(0); // the chunks carry CRCs of their own
    ready_.record(McapOpcode::DataEnd, dataEnd.bytes());
    const std::uint64_t start = position();
    McapBytes summary;
    summary.raw(schemas_.bytes());
    summary.raw(channels_.bytes());
    summary.record(McapOpcode::Statistics, statistics());
    summary.raw(chunkIndexes_.bytes());
    summary.raw(metadataIndexes_.bytes());
    // The CRC covers the summary and the footer up to the CRC itself.
    summary.number8(static_cast<std::uint8_t>(McapOpcode::Footer));
    summary.number64(8 + 8 + 4);
    summary.number64(start);
    summary.number64(0); // no summary offsets
    ready_.raw(summary.bytes());
    ready_.number32(crc32(summary.bytes()));
    ready_.raw(kMcapMagic);
}

Bytes McapEncoder::popBytes() {
    taken_ += ready_.size();
    return ready_.popBytes();
}

} // namespace edgescan::containers
