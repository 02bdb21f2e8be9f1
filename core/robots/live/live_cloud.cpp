// Clouds become scans as those of a bag do.
#include "core/robots/live/live_cloud.h"

#include "core/files/formats/reading.h"
#include "core/files/open_save/open_scan.h"
#include "core/robots/sweeps/bag_sweep.h"

#include <new>
#include <utility>

namespace edgescan::robots {

LiveCloud::~LiveCloud() { ending_ = true; }

void LiveCloud::receive(RosTopic topic, files::RecordingMessagePtr message) {
    {
        const std::lock_guard lock(mutex_);
        ++messages_;
        arrivedNs_ = message->hostNs;
        waiting_ = Waiting{std::move(topic), std::move(message)};
    }
    lane_.post([this] { makeScan(); });
}

void LiveCloud::finish() {
    lane_.end();
    makeScan();
    const std::lock_guard lock(mutex_);
    growing_ = false;
}

Result<Scan> LiveCloud::scanOf(const Waiting& newest) const {
    RosBag bag;
    bag.topics.push_back(newest.topic);
    bag.messages.push_back({0, newest.message->hostNs, newest.message->payload});
    ReadingOptions options;
    options.topic = newest.topic.name;
    options.progress = [this](const char*, double) { return !ending_; };
    const files::Source source{newest.topic.name, {}, &options, true};
    try {
        auto table = cloudOfBag(bag, {0, TopicGives::Clouds, 1, 0, newest.message->payload.size()}, source);
        if (!table) return table.error();
        return files::scanOfReading(files::Reading(std::move(*table)), source, false);
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for this cloud", newest.topic.name, "close other programs"};
    }
}

void LiveCloud::makeScan() {
    std::optional<Waiting> newest;
    {
        const std::lock_guard lock(mutex_);
        newest = std::exchange(waiting_, std::nullopt);
    }
    if (!newest) return;
    auto scan = scanOf(*newest);
    {
        const std::lock_guard lock(mutex_);
        if (!scan) {
            ++unusable_;
            why_ = scan.error();
        } else {
            scan->name = newest->topic.name;
            scanner::SweepProgress& progress = newest_.progress;
            progress.lines = progress.received = progress.expected = scan->lines();
            progress.cells = countCells(*scan);
            progress.newestNs = newest->message->hostNs;
            ++progress.account.sweeps;
            progress.account.lines += scan->lines();
            progress.account.cells += static_cast<std::int64_t>(scan->cells());
            newest_.scan = std::make_shared<const Scan>(std::move(*scan));
        }
    }
    changed_();
}

scanner::SweepState LiveCloud::newest() const {
    const std::lock_guard lock(mutex_);
    scanner::SweepState state = newest_;
    state.progress.growing = growing_;
    return state;
}

scanner::SweepProgress LiveCloud::progress() const {
    const std::lock_guard lock(mutex_);
    scanner::SweepProgress progress = newest_.progress;
    progress.growing = growing_;
    progress.newestNs = arrivedNs_;
    progress.account.telegrams = messages_;
    progress.account.unusable = unusable_;
    progress.account.placed = messages_ - unusable_;
    return progress;
}

std::int64_t LiveCloud::unusable() const {
    const std::lock_guard lock(mutex_);
    return unusable_;
}

std::optional<Error> LiveCloud::whyUnusable() const {
    const std::lock_guard lock(mutex_);
    return why_;
}

} // namespace edgescan::robots
