// Writes MCAP: records into bytes, and bytes onto the disk chunk by chunk so that a crash costs no more than the last chunk.
#pragma once

#include "core/base/result.h"
#include "core/containers/mcap/records.h"

#include <cstddef>
#include <filesystem>
#include <functional>

namespace edgescan::containers {

struct McapLimits {
    std::size_t chunkBytes = std::size_t{64} * 1024; ///< a longer single message gets a chunk of its own
    std::uint64_t chunkNs = 200'000'000;             ///< log time from the first to the last message of a chunk
};

/// Turns records into the bytes of a file: uncompressed chunks with CRC-32, message indexes, and a summary at the end.
class McapEncoder {
public:
    explicit McapEncoder(const std::string& library, McapLimits limits = {});

    void schema(const McapSchema& schema);
    void channel(const McapChannel& channel);
    void metadata(const McapMetadata& metadata);
    void message(const McapMessage& message);
    /// Closes the chunk that is being filled, if there is one.
    void endChunk();
    /// DataEnd, summary and footer. Nothing may follow.
    void finish();

    /// Messages in the chunk that is being filled.
    [[nodiscard]] std::uint64_t openMessages() const { return openMessages_; }
    /// Bytes made since the last call; they belong behind those of the last call.
    Bytes popBytes();

private:
    struct Span {
        std::uint64_t first = UINT64_MAX;
        std::uint64_t last = 0;
        void include(std::uint64_t t);
    };
    [[nodiscard]] std::uint64_t position() const { return taken_ + ready_.size(); }
    [[nodiscard]] Bytes statistics() const;

    McapLimits limits_;
    McapBytes ready_;
    std::uint64_t taken_ = 0;
    McapBytes chunk_;
    std::uint64_t openMessages_ = 0;
    Span chunkTime_, fileTime_;
    std::map<std::uint16_t, McapBytes> chunkIndex_; // per channel: time and offset of its messages in the open chunk
    McapBytes schemas_, channels_, chunkIndexes_, metadataIndexes_;
    std::uint16_t schemaCount_ = 0;
    std::uint32_t channelCount_ = 0, metadataCount_ = 0, chunkCount_ = 0;
    std::map<std::uint16_t, std::uint64_t> messageCounts_;
};

/// What a growing file asks of the system; tests put a slow or a broken disk here. As write(2) and fdatasync(2).
struct DiskCalls {
    std::function<std::ptrdiff_t(int, const void*, std::size_t)> write; ///< empty: the system's
    std::function<int(int)> sync;
};

/// A file that grows by whole pieces. After a failed append the file ends where it ended before it.
class GrowingFile {
public:
    /// Error: a file of that name exists, the folder does not, not allowed ... An existing recording is never overwritten.
    static Result<GrowingFile> create(const std::filesystem::path& path, DiskCalls calls = {});
    GrowingFile(GrowingFile&& other) noexcept;
    GrowingFile& operator=(GrowingFile&& other) noexcept;
    ~GrowingFile();

    /// Writes: what is written survives the end of the program, and a power failure once it is synced. Error: disk full, disk gone ...
    Result<Done> append(ByteView bytes);
    /// Waits until the disk has what was appended before; from another thread than append() too. Error: the disk lost some of it.
    [[nodiscard]] Result<Done> sync() const;
    /// The same for the file's name.
    void syncFolder() const;
    /// Removes the file's name, unless the name leads to another file by now.
    void removeName() const;
    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    GrowingFile(std::filesystem::path path, int descriptor, DiskCalls calls)
        : path_(std::move(path)), descriptor_(descriptor), calls_(std::move(calls)) {}
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    DiskCalls calls_;
};

} // namespace edgescan::containers
