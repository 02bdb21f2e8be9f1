// The newest-wins worker with many posters: a result is never older than the one before, and the last request is always done.
#include "core/base/worker.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace edgescan;
using namespace edgescan::test;

TEST(Worker, TheNewestOfManyPostsIsDone) {
    std::atomic<int> told{0};
    std::atomic<bool> newest{false};
    Worker<int, int> worker(
        [](const int& request) {
            if (request % 7 == 3) throw std::runtime_error("refused " + std::to_string(request));
            return request;
        },
        [&] { ++told; });
    std::vector<std::thread> posters;
    constexpr int kPosters = 4, kEach = 2000;
    posters.reserve(kPosters);
    for (int p = 0; p < kPosters; ++p) {
        posters.emplace_back([&worker, p] {
            for (int i = 0; i < kEach; ++i) worker.post(1 + i * kPosters + p);
        });
    }
    std::thread taker([&] { // acts as the GUI thread
        while (!newest) {
            static_cast<void>(worker.take());
            static_cast<void>(worker.takeFailure());
            std::this_thread::yield();
        }
    });
    for (std::thread& poster : posters) poster.join();
    newest = true;
    taker.join();
    constexpr int kLast = 7 * 10'000;
    worker.post(kLast);
    EXPECT_TRUE(waitUntil([&] { return worker.take() == kLast; }));
    EXPECT_TRUE(waitUntil([&] { return !worker.busy(); }));
    EXPECT_GT(told, 0);
}
