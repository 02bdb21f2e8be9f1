// Reads MCAP front to back, as much as is sound: a torn tail, damaged chunks and unknown records cost only themselves.
#pragma once

#include "core/base/result.h"
#include "core/containers/mcap/records.h"

#include <functional>
#include <list>
#include <string>

namespace edgescan::containers {

/// What an MCAP file holds. Messages point into the bytes that were read, or into `unpacked`.
struct McapContent {
    std::string profile, library;
    std::map<std::uint16_t, McapSchema> schemas;
    std::map<std::uint16_t, McapChannel> channels;
    std::vector<McapMetadata> metadata;
    std::vector<McapMessage> messages; ///< in the order of the file
    std::list<Bytes> unpacked;         ///< chunks that were compressed

    bool clean = false;                ///< the file was closed: DataEnd, summary and footer are there and sound
    std::uint64_t end = 0;             ///< byte where reading stopped
    std::size_t salvaged = 0;          ///< messages of a torn last chunk
    std::size_t badChunks = 0;         ///< left out: CRC wrong, compression not readable
    std::vector<std::string> warnings; ///< one sentence per thing that was left out

    McapContent() = default;
    McapContent(McapContent&&) = default;
    McapContent& operator=(McapContent&&) = default;
    McapContent(const McapContent&) = delete; // the copy's messages would point into the original
    McapContent& operator=(const McapContent&) = delete;
};

[[nodiscard]] bool looksLikeMcap(ByteView bytes);

/// `bytes` must outlive the content. `goOn` is called many times a second; false cancels. Error: not MCAP at all, a version that is not
/// known, or cancelled.
Result<McapContent> readMcap(ByteView bytes, const std::string& where, const std::function<bool()>& goOn = {});

/// The channel of a message, or null.
[[nodiscard]] const McapChannel* channelOf(const McapContent& content, const McapMessage& message);

} // namespace edgescan::containers
