// A robot's scanner that sends whole clouds, live: messages go in one by one, and each becomes a scan of its own by the readers of bags.
#pragma once

#include "core/base/work_pool.h"
#include "core/files/recording/layout.h"
#include "core/robots/bags/bag.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace edgescan::robots {

/// Any thread. A cloud takes longer to be put onto its grid than to arrive: this happens on a thread of the pool, only the newest message
/// waits, and those before it are left out of the picture.
class LiveCloud {
public:
    /// `changed` is called on a thread of the pool after each scan.
    explicit LiveCloud(std::function<void()> changed) : changed_(std::move(changed)) {}
    ~LiveCloud();
    LiveCloud(const LiveCloud&) = delete;
    LiveCloud& operator=(const LiveCloud&) = delete;

    void receive(RosTopic topic, files::RecordingMessagePtr message);
    /// After the last message: makes the scan of the newest one.
    void finish();

    /// The newest scan, null before the first, and what it holds. More clouds come until finish().
    [[nodiscard]] scanner::SweepState newest() const;
    /// The same progress; its time and its number of messages are those of the newest message.
    [[nodiscard]] scanner::SweepProgress progress() const;
    /// Messages that make no scan, and why the last one of them made none.
    [[nodiscard]] std::int64_t unusable() const;
    [[nodiscard]] std::optional<Error> whyUnusable() const;

private:
    struct Waiting {
        RosTopic topic;
        files::RecordingMessagePtr message;
    };
    void makeScan();
    [[nodiscard]] Result<Scan> scanOf(const Waiting& newest) const;

    const std::function<void()> changed_;
    std::atomic<bool> ending_{false};
    mutable std::mutex mutex_; // of all that follows, but not of the lane
    std::optional<Waiting> waiting_;
    scanner::SweepState newest_;
    std::int64_t messages_ = 0, unusable_ = 0, arrivedNs_ = 0;
    std::optional<Error> why_;
    bool growing_ = true;
    Lane lane_{WorkPool::shared(), Urgency::Soon}; // last: its work uses all of the above
};

} // namespace edgescan::robots
