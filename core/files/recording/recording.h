// A recording that was read: its messages in order and what its metadata says.
#pragma once

#include "core/base/result.h"
#include "core/containers/mcap/reader.h"
#include "core/containers/ros/bag.h"
#include "core/files/recording/layout.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace edgescan::files {

struct RecordedMessage {
    RecordingTopic topic = RecordingTopic::ColaRx;
    std::int64_t logNs = 0;     ///< when it was received, ns since 1970 UTC
    std::int64_t publishNs = 0; ///< a line's own time
    ByteView payload;
    std::uint32_t robotTopic = 0; ///< of Bridge: index in Recording::robot().topics
};

/// Never changed; messages point into the bytes it holds.
class Recording {
public:
    /// Of a robot, too. `goOn` is called many times a second; false cancels. Error: cannot be read, is not MCAP, holds nothing of "sweep/1"
    /// and of a robot, or cancelled; from bytes without the robot's.
    static Result<std::shared_ptr<const Recording>> open(const std::filesystem::path& path, const std::function<bool()>& goOn = {});
    static Result<std::shared_ptr<const Recording>> fromBytes(Bytes bytes, const std::string& where,
                                                              const std::function<bool()>& goOn = {});

    [[nodiscard]] const std::vector<RecordedMessage>& messages() const { return messages_; }
    /// The record "sweep".
    [[nodiscard]] const scanner::SweepMetadata& metadata() const { return metadata_; }
    /// What a robot's bridge sent, or the file is its bag, and no scanner of SICK: its messages are those of the recording.
    [[nodiscard]] const containers::RosBag& robot() const { return robot_; }
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
    Result<Done> take(Bytes bytes, const std::string& where, const std::function<bool()>& goOn);

    Bytes bytes_;
    containers::McapContent content_;
    containers::RosBag robot_;
    scanner::SweepMetadata metadata_;
    std::vector<RecordedMessage> messages_;
    std::vector<std::string> warnings_;
};

} // namespace edgescan::files
