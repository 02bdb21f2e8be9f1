// Lanes of a pool: one at a time, the newest wins, urgent work passes slow work, and nothing runs on when a lane is gone.
#include "core/base/work_pool.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace edgescan;
using namespace edgescan::test;

namespace {

/// Work that begins, and ends when it may: at the end of the test at the latest.
class Held {
public:
    Held(WorkPool& pool, Urgency urgency) : lane_(pool, urgency) {
        lane_.post([this] {
            began = true;
            while (!mayEnd) std::this_thread::yield();
        });
    }
    ~Held() { mayEnd = true; }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;

    std::atomic<bool> began{false}, mayEnd{false};
    [[nodiscard]] Lane& lane() { return lane_; }

private:
    Lane lane_;
};

} // namespace

TEST(WorkPool, TheNewestOfManyPostsIsDone) {
    WorkPool pool;
    std::atomic<int> last{0};
    Lane lane(pool, Urgency::Now);
    std::vector<std::thread> posters;
    for (int p = 0; p < 4; ++p) {
        posters.emplace_back([&, p] {
            for (int n = 0; n < 2000; ++n) lane.post([&last, value = 4 * n + p] { last = value; });
        });
    }
    for (std::thread& poster : posters) poster.join();
    lane.post([&] { last = -1; });
    EXPECT_TRUE(waitUntil([&] { return last == -1; }));
}

TEST(WorkPool, ALaneRunsOneAtATimeAndWhatWaitsIsReplaced) {
    WorkPool pool;
    std::vector<int> ran; // without a lock: a lane orders what it runs
    std::atomic<bool> done{false};
    Held first(pool, Urgency::Soon);
    ASSERT_TRUE(waitUntil([&] { return first.began.load(); }));
    for (int n = 0; n < 10; ++n)
        first.lane().post([&ran, &done, n] {
            ran.push_back(n);
            done = n == 9;
        });
    first.mayEnd = true;
    ASSERT_TRUE(waitUntil([&] { return done.load(); }));
    EXPECT_EQ(ran, std::vector<int>{9});
}

TEST(WorkPool, SlowWorkKeepsNoThreadFromWhatIsMoreUrgent) {
    WorkPool pool;
    Held minutes(pool, Urgency::Later), more(pool, Urgency::Later);
    ASSERT_TRUE(waitUntil([&] { return minutes.began && more.began; })) << "two pieces of one urgency run at a time";
    Held stillMore(pool, Urgency::Later), seconds(pool, Urgency::Soon), rocks(pool, Urgency::Soon);
    ASSERT_TRUE(waitUntil([&] { return seconds.began && rocks.began; })) << "work of minutes has two threads";
    Held opening(pool, Urgency::Soon);
    std::atomic<bool> answered{false};
    Lane picture(pool, Urgency::Now);
    picture.post([&] { answered = true; });
    EXPECT_TRUE(waitUntil([&] { return answered.load(); })) << "work of seconds has four";
    EXPECT_FALSE(stillMore.began || opening.began);
    for (Held* held : {&minutes, &more, &stillMore, &seconds, &rocks, &opening}) held->mayEnd = true;
    EXPECT_TRUE(waitUntil([&] { return stillMore.began && opening.began; }));
}

TEST(WorkPool, ALaneThatGoesWaitsForItsWork) {
    WorkPool pool;
    for (int round = 0; round < 100; ++round) {
        auto used = std::make_unique<std::atomic<int>>(0);
        {
            Lane lane(pool, Urgency::Later);
            for (int n = 0; n < 3; ++n) lane.post([&count = *used] { ++count; });
        }
        const int after = *used;
        EXPECT_LE(after, 3);
        std::this_thread::yield();
        EXPECT_EQ(*used, after);
    }
}

TEST(WorkPool, WhatIsDroppedDoesNotStart) {
    WorkPool pool;
    std::atomic<bool> ran{false}, next{false};
    Held first(pool, Urgency::Now);
    ASSERT_TRUE(waitUntil([&] { return first.began.load(); }));
    first.lane().post([&] { ran = true; });
    first.lane().drop();
    first.mayEnd = true;
    first.lane().post([&] { next = true; });
    EXPECT_TRUE(waitUntil([&] { return next.load(); }));
    EXPECT_FALSE(ran);
}

// As Derived does it: what work throws is caught in it. Many lanes on few threads, dropped and ended while others post.
TEST(WorkPool, WorkThatThrowsUnderContentionEndsNoOther) {
    constexpr int kLanes = 24, kPosts = 300;
    WorkPool pool;
    struct Busy {
        std::atomic<int> inside{0}, most{0}, thrown{0}, held{0};
        std::atomic<bool> last{false};
    };
    std::vector<Busy> busy(kLanes);
    std::vector<std::unique_ptr<Lane>> lanes;
    for (int n = 0; n < kLanes; ++n) lanes.push_back(std::make_unique<Lane>(pool, static_cast<Urgency>(n % static_cast<int>(kUrgencies))));
    const auto throwing = [](Busy& of, int number) {
        ++of.held;
        const std::shared_ptr<Busy> counted(&of, [](Busy* b) { --b->held; });
        return [&of, number, counted] {
            of.most = std::max(of.most.load(), ++of.inside);
            try {
                if (number % 3 == 0) throw std::runtime_error("no");
                if (number % 3 == 1) throw std::bad_alloc();
                throw number;
            } catch (...) {
                ++of.thrown;
            }
            --of.inside;
        };
    };
    std::vector<std::thread> posters;
    for (int p = 0; p < 4; ++p) {
        posters.emplace_back([&, p] {
            std::mt19937 random(static_cast<unsigned>(p));
            for (int n = 0; n < kPosts; ++n) {
                const std::size_t at = random() % kLanes;
                lanes[at]->post(throwing(busy[at], n));
                if (random() % 16 == 0) lanes[at]->drop();
                if (random() % 64 == 0) lanes[at]->end();
            }
        });
    }
    for (std::thread& poster : posters) poster.join();
    std::vector<int> before; // on a busy machine the posts above may have replaced each other
    for (std::size_t n = 0; n < busy.size(); ++n) {
        lanes[n]->end();
        before.push_back(busy[n].thrown);
        lanes[n]->post(throwing(busy[n], static_cast<int>(n)));
    }
    for (std::size_t n = 0; n < busy.size(); ++n) EXPECT_TRUE(waitUntil([&] { return busy[n].thrown > before[n]; }));
    for (std::size_t n = 0; n < busy.size(); ++n) lanes[n]->post([&of = busy[n]] { of.last = true; });
    for (const Busy& each : busy) EXPECT_TRUE(waitUntil([&] { return each.last.load(); }));
    lanes.clear();
    for (const Busy& each : busy) {
        EXPECT_EQ(each.inside, 0);
        EXPECT_LE(each.most, 1) << "of each lane one at a time";
        EXPECT_EQ(each.held, 0) << "what work holds is freed with it";
    }
}
