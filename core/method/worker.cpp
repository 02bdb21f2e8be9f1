// The thread that runs the method.
#include "core/method/worker.h"

#include "core/method/pipeline.h"

#include <exception>
#include <utility>

namespace edgescan {

namespace {

Worker::Run wholeMethod() {
    auto pipeline = std::make_shared<Pipeline>();
    return [pipeline](const std::shared_ptr<const Scan>& scan, const Settings& settings) {
        try {
            return pipeline->run(scan, settings);
        } catch (...) {
            *pipeline = Pipeline();
            throw;
        }
    };
}

} // namespace

Worker::Worker(std::function<void()> ready) : Worker(std::move(ready), wholeMethod()) {}

Worker::Worker(std::function<void()> ready, Run run) : ready_(std::move(ready)), run_(std::move(run)), thread_([this] { loop(); }) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Worker::post(std::shared_ptr<const Scan> scan) {
    {
        const std::lock_guard lock(mutex_);
        scan_ = std::move(scan);
        posted_ = true;
    }
    wake_.notify_one();
}

void Worker::post(const Settings& settings) {
    {
        const std::lock_guard lock(mutex_);
        settings_ = settings;
        posted_ = scan_ != nullptr;
    }
    wake_.notify_one();
}

std::shared_ptr<const Detection> Worker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(unread_, nullptr);
}

std::string Worker::takeFailure() {
    const std::lock_guard lock(mutex_);
    return std::exchange(failure_, {});
}

bool Worker::busy() const {
    const std::lock_guard lock(mutex_);
    return posted_ || running_;
}

void Worker::loop() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return posted_ || stop_; });
        if (stop_) return;
        posted_ = false;
        running_ = true;
        const std::shared_ptr<const Scan> scan = scan_;
        const Settings settings = settings_;
        lock.unlock();
        std::shared_ptr<const Detection> detection;
        std::string failure;
        try {
            if (scan) detection = run_(scan, settings);
        } catch (const std::exception& error) {
            // The detection before stays on the screen; OpenCV reports a lack of memory in its own words.
            failure = std::string("the edges could not be computed (") + error.what() + "); close other programs or open a smaller scan.";
        }
        lock.lock();
        running_ = false;
        failure_ = failure;
        if (!detection && failure.empty()) continue;
        if (detection) unread_ = std::move(detection);
        lock.unlock();
        ready_();
        lock.lock();
    }
}

} // namespace edgescan
