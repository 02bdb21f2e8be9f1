// A robot's bridge as the source of a live scan: its topics, the lines of its laser, or its whole clouds.
#pragma once

#include "core/base/result.h"
#include "core/base/work_pool.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/recording/layout.h"
#include "core/robots/bags/bag.h"
#include "core/robots/bridge/bridge_connection.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// Any thread. A cloud takes longer to be put onto its grid than to arrive: this happens on a thread of the pool, only the newest message
/// waits, and those before it are left out of the picture.
class LiveCloud {
public:
    /// `changed` is called on a thread of the pool after each scan.
    explicit LiveCloud(std::function<void()> changed, bool keepRepeated = false)
        : changed_(std::move(changed)), keepRepeated_(keepRepeated) {}
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
    const bool keepRepeated_;
    std::atomic<bool> ending_{false};
    mutable std::mutex mutex_; // of all that follows, but not of the lane
    std::optional<Waiting> waiting_;
    scanner::SweepState newest_;
    std::int64_t messages_ = 0, unusable_ = 0, arrivedNs_ = 0;
    std::optional<Error> why_;
    bool growing_ = true;
    Lane lane_{WorkPool::shared(), Urgency::Soon}; // last: its work uses all of the above
};

/// Each message is a whole cloud.
[[nodiscard]] bool isCloud(const BridgeChannel& channel);

/// The laser `topic`, or without a name one whose name says that it is turned, else the first one by name, and the topics of transforms and
/// joints that give the angles of its lines; nothing else. Where there is no topic of lines, one of clouds, alone. Error: there is no
/// laser, or `topic` is not one; the hint lists those there are.
Result<BridgeChoice> chooseTopics(const std::vector<BridgeChannelPtr>& offered, const std::string& topic, const std::string& where);

/// As Addon::live.
std::unique_ptr<files::LiveSource> liveRobot(const scanner::ConnectionSettings& asked, const scanner::SweepSettings& sweep,
                                             std::function<void()> changed, std::mutex& mutex);

} // namespace edgescan::robots
