// A thread that works on the newest request. A new request replaces the one that waits; a new result replaces an unread one.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace edgescan {

template <class Request, class Result>
class Worker {
public:
    /// Both functions are called on the worker's thread: `run` with the newest request; `ready` when take() or takeFailure() has something
    /// new. The next run waits until `ready` returns.
    Worker(std::function<Result(const Request&)> run, std::function<void()> ready)
        : run_(std::move(run)), ready_(std::move(ready)), thread_([this] { loop(); }) {}
    ~Worker() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_one();
        thread_.join();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void post(Request request) {
        {
            const std::lock_guard lock(mutex_);
            waiting_ = std::move(request);
        }
        wake_.notify_one();
    }

    /// The newest result that was not taken yet.
    [[nodiscard]] std::optional<Result> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(unread_, std::nullopt);
    }

    /// The exception text of the last run; empty if the run gave a result. The call clears it.
    [[nodiscard]] std::string takeFailure() {
        const std::lock_guard lock(mutex_);
        return std::exchange(failure_, {});
    }

    /// A request was posted whose result is not ready yet.
    [[nodiscard]] bool busy() const {
        const std::lock_guard lock(mutex_);
        return waiting_ || running_;
    }

private:
    void loop() {
        std::unique_lock lock(mutex_);
        while (true) {
            wake_.wait(lock, [this] { return waiting_ || stop_; });
            if (stop_) return;
            std::optional<Request> request = std::exchange(waiting_, std::nullopt);
            running_ = true;
            lock.unlock();
            std::optional<Result> result;
            std::string failure;
            try {
                result = run_(*request);
            } catch (const std::exception& error) {
                failure = error.what();
            }
            request.reset(); // large objects are freed while the lock is not held; the same applies to the results below
            lock.lock();
            running_ = false;
            failure_ = std::move(failure);
            if (result) std::swap(unread_, result);
            lock.unlock();
            result.reset();
            ready_();
            lock.lock();
        }
    }

    std::function<Result(const Request&)> run_;
    std::function<void()> ready_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Request> waiting_;
    std::optional<Result> unread_;
    std::string failure_;
    bool running_ = false;
    bool stop_ = false;
    std::thread thread_; // last member: the thread starts when all the others exist
};

} // namespace edgescan
