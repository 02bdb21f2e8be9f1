// The threads of a pool, and what they take next.
#include "core/base/work_pool.h"

#include <algorithm>
#include <utility>

namespace edgescan {
namespace {

constexpr std::size_t kThreadsEach = 2; // of each urgency

} // namespace

WorkPool::WorkPool() {
    threads_.reserve(kThreadsEach * kUrgencies);
    for (std::size_t n = 0; n < kThreadsEach * kUrgencies; ++n) threads_.emplace_back([this, n] { loop(n / kThreadsEach); });
}

WorkPool::~WorkPool() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

WorkPool& WorkPool::shared() {
    static WorkPool pool;
    return pool;
}

Lane* WorkPool::next(std::size_t slowest) {
    for (std::size_t n = 0; n <= slowest; ++n) {
        if (ready_[n].empty()) continue;
        Lane* lane = ready_[n].front();
        ready_[n].pop_front();
        lane->ready_ = false;
        return lane;
    }
    return nullptr;
}

void WorkPool::loop(std::size_t slowest) {
    std::unique_lock lock(mutex_);
    while (true) {
        Lane* lane = nullptr;
        wake_.wait(lock, [&] { return stop_ || (lane = next(slowest)) != nullptr; });
        if (lane == nullptr) return;
        runWork(*lane, lock);
    }
}

void WorkPool::runWork(Lane& lane, std::unique_lock<std::mutex>& lock) {
    Lane::Work work = std::exchange(lane.waiting_, nullptr);
    lane.running_ = true;
    lock.unlock();
    work();
    work = nullptr; // what it holds may be large: it is freed while the lock is free
    lock.lock();
    lane.running_ = false;
    if (lane.waiting_) {
        lane.ready_ = true;
        ready_[static_cast<std::size_t>(lane.urgency_)].push_back(&lane);
        wake_.notify_all(); // this thread may be meant for something slower
    }
    idle_.notify_all();
}

Lane::~Lane() { end(); }

void Lane::end() {
    drop();
    std::unique_lock lock(pool_.mutex_);
    pool_.idle_.wait(lock, [this] { return !running_; });
}

void Lane::post(Work work) {
    {
        const std::lock_guard lock(pool_.mutex_);
        std::swap(waiting_, work); // the one before is freed below, without the lock
        if (!running_ && !ready_) {
            ready_ = true;
            pool_.ready_[static_cast<std::size_t>(urgency_)].push_back(this);
        }
    }
    pool_.wake_.notify_all();
}

void Lane::drop() {
    Work dropped;
    const std::lock_guard lock(pool_.mutex_);
    std::swap(waiting_, dropped);
    if (std::exchange(ready_, false)) std::erase(pool_.ready_[static_cast<std::size_t>(urgency_)], this);
}

} // namespace edgescan
