// Reading a recording.
#include "core/files/recording/recording.h"
#include "core/base/translated_text.h"

#include "core/base/inputs.h"
#include "core/base/utc_time.h"
#include "core/files/addons/addon.h"

namespace edgescan::files {

Result<std::shared_ptr<const Recording>> Recording::open(const std::filesystem::path& path, const std::function<bool()>& goOn) {
    const auto read = readInput(path);
    if (!read) return read.error();
    const auto* first = reinterpret_cast<const std::uint8_t*>(read->data());
    auto recording = std::make_shared<Recording>();
    const auto taken = recording->load(Bytes(first, first + read->size()), path.string(), goOn);
    std::vector<RecordedMessage>& messages = recording->messages_;
    if (messages.empty() && addon().recorded != nullptr) {
        auto source = addon().recorded(recording->content_, path.string(), goOn);
        if (!source) return source.error();
        recording->source_ = std::move(*source);
        if (recording->source_) messages = recording->source_->messages();
    }
    if (!taken && messages.empty()) return taken.error();
    return std::shared_ptr<const Recording>(std::move(recording));
}

Result<std::shared_ptr<const Recording>> Recording::fromBytes(Bytes bytes, const std::string& where, const std::function<bool()>& goOn) {
    auto recording = std::make_shared<Recording>();
    if (auto taken = recording->load(std::move(bytes), where, goOn); !taken) return taken.error();
    return std::shared_ptr<const Recording>(std::move(recording));
}

Result<Done> Recording::load(Bytes bytes, const std::string& where, const std::function<bool()>& goOn) {
    bytes_ = std::move(bytes);
    auto content = containers::readMcap(bytes_, where, goOn);
    if (!content) return content.error();
    content_ = std::move(*content);
    for (const containers::McapMetadata& record : content_.metadata) {
        if (record.name == "sweep") metadata_ = record.entries;
    }
    std::size_t later = 0;
    const auto bounded = [&](std::uint64_t ns) {
        if (ns <= static_cast<std::uint64_t>(kLatestNs)) return static_cast<std::int64_t>(ns);
        ++later;
        return kLatestNs;
    };
    for (const containers::McapMessage& message : content_.messages) {
        const containers::McapChannel* channel = containers::channelOf(content_, message);
        const auto topic = channel != nullptr ? topicNamed(channel->topic) : std::nullopt;
        if (topic) messages_.push_back({*topic, bounded(message.logNs), bounded(message.publishNs), message.payload});
    }
    warnings_ = content_.warnings;
    if (!content_.clean && content_.badChunks == 0 && content_.warnings.empty())
        warnings_.emplace_back("The recording was cut off: everything up to the cut is here.");
    if (later > 0)
        warnings_.push_back(withValues("%1 times in the recording are after %2 and were read as this time.",
                                       {later, utcText(static_cast<double>(kLatestNs) * 1e-9)}));
    if (metadata_.empty() && messages_.empty()) {
        const std::string leftOut = whatWasLeftOut();
        if (leftOut.empty()) return Error{"this MCAP file holds nothing that a laser scanner sent", where, "choose a recording of a sweep"};
        return Error{withValues("nothing that a laser scanner sent can be read in this MCAP file%1", {leftOut}), where, "copy it again"};
    }
    return Done{};
}

std::string Recording::whatWasLeftOut() const {
    if (content_.warnings.empty()) return {};
    const std::size_t more = content_.warnings.size() - 1;
    return "; " + content_.warnings.front() + (more > 0 ? withValues(", and %1 more", {more}) : "");
}

} // namespace edgescan::files
