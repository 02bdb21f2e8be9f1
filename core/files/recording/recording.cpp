// Reading a recording.
#include "core/files/recording/recording.h"

#include "core/base/inputs.h"

#include <algorithm>

namespace edgescan::files {
namespace {

/// Times that no clock shows are cut to what the arithmetic of times can bear.
std::int64_t sane(std::uint64_t ns) { return static_cast<std::int64_t>(std::min(ns, std::uint64_t{1} << 62U)); }

} // namespace

Result<std::shared_ptr<const Recording>> Recording::open(const std::filesystem::path& path) {
    const auto read = readInput(path);
    if (!read) return read.error();
    const auto* first = reinterpret_cast<const std::uint8_t*>(read->data());
    return fromBytes(Bytes(first, first + read->size()), path.string());
}

Result<std::shared_ptr<const Recording>> Recording::fromBytes(Bytes bytes, const std::string& where) {
    auto recording = std::make_shared<Recording>();
    if (auto taken = recording->take(std::move(bytes), where); !taken) return taken.error();
    return std::shared_ptr<const Recording>(std::move(recording));
}

Result<Done> Recording::take(Bytes bytes, const std::string& where) {
    bytes_ = std::move(bytes);
    auto content = containers::readMcap(bytes_, where);
    if (!content) return content.error();
    content_ = std::move(*content);
    for (const containers::McapMetadata& record : content_.metadata) {
        if (record.name == "sweep") metadata_ = record.entries;
    }
    for (const containers::McapMessage& message : content_.messages) {
        const containers::McapChannel* channel = containers::channelOf(content_, message);
        const auto topic = channel != nullptr ? topicNamed(channel->topic) : std::nullopt;
        if (topic) messages_.push_back({*topic, sane(message.logNs), sane(message.publishNs), message.payload});
    }
    warnings_ = content_.warnings;
    if (!content_.clean && content_.badChunks == 0 && content_.warnings.empty())
        warnings_.emplace_back("The recording was cut off: everything up to the cut is here.");
    if (metadata_.empty() && messages_.empty()) {
        const std::string leftOut = whatWasLeftOut();
        if (leftOut.empty()) return Error{"this MCAP file holds nothing that a laser scanner sent", where, "choose a recording of a sweep"};
        return Error{"nothing that a laser scanner sent can be read in this MCAP file" + leftOut, where, "copy it again"};
    }
    return Done{};
}

std::string Recording::whatWasLeftOut() const {
    if (content_.warnings.empty()) return {};
    const std::size_t more = content_.warnings.size() - 1;
    return "; " + content_.warnings.front() + (more > 0 ? ", and " + std::to_string(more) + " more" : "");
}

} // namespace edgescan::files
