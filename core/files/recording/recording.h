// A recording that was read: its messages in order and what its metadata says.
#pragma once

#include "core/base/result.h"
#include "core/containers/mcap/reader.h"
#include "core/files/recording/layout.h"
#include "core/files/recording/recorded_source.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace edgescan::files {

/// Never changed; messages point into the bytes it holds.
class Recording {
public:
    /// Of another source, too. `goOn` is called many times a second; false cancels. Error: cannot be read, is not MCAP, holds nothing of
    /// "sweep/1" and of another source, or cancelled; from bytes without the other source's.
    static Result<std::shared_ptr<const Recording>> open(const std::filesystem::path& path, const std::function<bool()>& goOn = {});
    static Result<std::shared_ptr<const Recording>> fromBytes(Bytes bytes, const std::string& where,
                                                              const std::function<bool()>& goOn = {});

    [[nodiscard]] const std::vector<RecordedMessage>& messages() const { return messages_; }
    /// The record "sweep".
    [[nodiscard]] const scanner::SweepMetadata& metadata() const { return metadata_; }
    /// What plays the messages, where they are not telegrams of a SICK scanner; else null.
    [[nodiscard]] const RecordedSource* source() const { return source_.get(); }
    /// Everything else that the file says of itself.
    [[nodiscard]] const containers::McapContent& content() const { return content_; }
    /// The file was closed properly and nothing in it is damaged.
    [[nodiscard]] bool clean() const { return content_.clean && content_.badChunks == 0; }
    /// What was cut off, damaged or not understood, in sentences.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// "; the chunk at byte 96 was left out: its checksum does not fit", for a sentence that says that something is not there; or nothing.
    [[nodiscard]] std::string whatWasLeftOut() const;

    Recording() = default;
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

private:
    Result<Done> load(Bytes bytes, const std::string& where, const std::function<bool()>& goOn);

    Bytes bytes_;
    containers::McapContent content_;
    std::unique_ptr<RecordedSource> source_;
    scanner::SweepMetadata metadata_;
    std::vector<RecordedMessage> messages_;
    std::vector<std::string> warnings_;
};

} // namespace edgescan::files
