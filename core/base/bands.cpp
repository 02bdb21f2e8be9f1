// The second thread. It is started when it is first needed and then reused: starting a thread takes longer than many of the stages.
#include "core/base/bands.h"

#include <pthread.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

namespace edgescan {
namespace {

// Work that is divided into shares. It may outlive the call: a thread that comes late finds that all shares are taken.
class Shares {
public:
    Shares(int count, const std::function<void(int)>& work) : count_(count), work_(&work) {}

    /// Takes shares until all are taken.
    void work() {
        for (int n = next_++; n < count_; n = next_++) {
            std::exception_ptr failure;
            try {
                (*work_)(n);
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(mutex_);
            if (failure && !failure_) failure_ = failure;
            if (++done_ == count_) allDone_.notify_all();
        }
    }
    /// Waits until all shares are done, on either thread. Throws the first exception that a share threw.
    void wait() {
        std::unique_lock lock(mutex_);
        allDone_.wait(lock, [this] { return done_ == count_; });
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    const int count_;
    const std::function<void(int)>* work_; // not used after all shares are taken
    std::atomic<int> next_{0};
    std::mutex mutex_;
    std::condition_variable allDone_;
    int done_ = 0;
    std::exception_ptr failure_;
};

// A second thread that takes shares of the calling thread's work.
class SecondThread {
public:
    SecondThread() : thread_([this] { loop(); }) {}
    SecondThread(const SecondThread&) = delete;
    SecondThread& operator=(const SecondThread&) = delete;
    ~SecondThread() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_one();
        thread_.join();
    }
    /// While fork() copies the process, only the forking thread may hold the lock. Otherwise the lock would stay locked in the copy.
    std::mutex& mutex() { return mutex_; }

    void ask(std::shared_ptr<Shares> shares) {
        {
            const std::lock_guard lock(mutex_);
            waiting_.push_back(std::move(shares));
        }
        wake_.notify_one();
    }

private:
    void loop() {
        for (;;) {
            std::shared_ptr<Shares> shares;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
                if (stop_) return;
                shares = std::move(waiting_.front());
                waiting_.pop_front();
            }
            shares->work();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::shared_ptr<Shares>> waiting_;
    bool stop_ = false;
    std::thread thread_; // the last member: it uses the others
};

struct Second {
    std::mutex mutex;
    std::unique_ptr<SecondThread> thread;
};
Second& second();

// The copy of a process has no second thread. The copy leaves the old thread's object alone, and the next call starts a new thread.
void beforeFork() {
    second().mutex.lock();
    if (second().thread) second().thread->mutex().lock();
}
void afterForkHere() {
    if (second().thread) second().thread->mutex().unlock();
    second().mutex.unlock();
}
void afterForkInCopy() {
    static_cast<void>(second().thread.release());
    second().mutex.unlock();
}

// Never destroyed: its thread waits until the process ends.
Second& second() {
    static Second* const only = [] {
        auto* const made = new Second;
        static_cast<void>(::pthread_atfork(beforeFork, afterForkHere, afterForkInCopy));
        return made;
    }();
    return *only;
}

// Does nothing if a second thread cannot be started.
void askSecondThread(const std::shared_ptr<Shares>& shares) {
    const std::lock_guard lock(second().mutex);
    try {
        if (!second().thread) second().thread = std::make_unique<SecondThread>();
    } catch (const std::system_error&) {
        return;
    }
    second().thread->ask(shares);
}

} // namespace

void runInParallel(int count, const std::function<void(int)>& work) {
    const auto shares = std::make_shared<Shares>(count, work);
    if (count > 1) askSecondThread(shares);
    shares->work();
    shares->wait();
}

void endSecondThread() {
    const std::lock_guard lock(second().mutex);
    second().thread.reset();
}

} // namespace edgescan
