// A few threads that work for many, and lanes: of each lane one piece of work runs at a time, and a newer one replaces the one that waits.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace edgescan {

/// How soon a person expects the answer, most urgent first: in milliseconds, in a second or two, whenever it is ready.
enum class Urgency { Now, Soon, Later };
inline constexpr std::size_t kUrgencies = 3;

class Lane;

/// Two threads for each urgency, which also take more urgent work: slow work never delays urgent work, and one long piece of work does not
/// delay all others of its urgency.
class WorkPool {
public:
    WorkPool();
    /// No lane may be left.
    ~WorkPool();
    WorkPool(const WorkPool&) = delete;
    WorkPool& operator=(const WorkPool&) = delete;

    /// The one that the program's windows share; its threads start with the first lane.
    [[nodiscard]] static WorkPool& shared();

private:
    friend class Lane;
    void loop(std::size_t slowest);
    [[nodiscard]] Lane* next(std::size_t slowest); // with mutex_ locked
    void runWork(Lane& lane, std::unique_lock<std::mutex>& lock);

    std::mutex mutex_;
    std::condition_variable wake_, idle_;
    std::array<std::deque<Lane*>, kUrgencies> ready_; // lanes with work that may start
    bool stop_ = false;
    std::vector<std::thread> threads_; // last: they use the rest
};

/// Any thread. Work that uses the members of an object belongs to a lane that is the last of its members.
class Lane {
public:
    using Work = std::function<void()>; // must not throw

    Lane(WorkPool& pool, Urgency urgency) : pool_(pool), urgency_(urgency) {}
    /// What waits is dropped, what runs is waited for.
    ~Lane();
    Lane(const Lane&) = delete;
    Lane& operator=(const Lane&) = delete;

    /// Starts as soon as the one before has ended and a thread is free; replaces what waits.
    void post(Work work);
    /// What waits does not start any more.
    void drop();
    /// As the destructor: drops what waits, waits for what runs.
    void end();

private:
    friend class WorkPool;
    WorkPool& pool_;
    const Urgency urgency_;
    // With the lock of the pool:
    Work waiting_;
    bool running_ = false, ready_ = false; // ready: it is in the pool's list
};

} // namespace edgescan
