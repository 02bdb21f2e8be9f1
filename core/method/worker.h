// The thread that runs the method. Newest wins, both ways: posting overwrites what waits, an unread detection is overwritten.
#pragma once

#include "core/method/detection.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace edgescan {

class Worker {
public:
    /// `ready` is called on the worker's thread whenever take() or takeFailure() has something new; the next run waits until it
    /// returns.
    explicit Worker(std::function<void()> ready);
    /// `run` is the method, called on the worker's thread; what it throws is told by takeFailure().
    using Run = std::function<std::shared_ptr<const Detection>(const std::shared_ptr<const Scan>&, const Settings&)>;
    Worker(std::function<void()> ready, Run run);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// A scan to work on from now on, from a file, a replay or a scanner alike.
    void post(std::shared_ptr<const Scan> scan);
    void post(const Settings& settings);

    /// The newest detection that nobody took yet, or null.
    [[nodiscard]] std::shared_ptr<const Detection> take();

    /// Why the last run gave no detection (not enough memory ...); empty when it did. Asking clears it.
    [[nodiscard]] std::string takeFailure();

    /// Something was posted whose detection is not ready yet.
    [[nodiscard]] bool busy() const;

private:
    void loop();

    std::function<void()> ready_;
    Run run_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::shared_ptr<const Scan> scan_;
    Settings settings_;
    bool posted_ = false;
    bool running_ = false;
    bool stop_ = false;
    std::shared_ptr<const Detection> unread_;
    std::string failure_;
    std::thread thread_; // last: starts when all the rest is there
};

} // namespace edgescan
