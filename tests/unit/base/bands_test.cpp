// Parallel work: each share is done once, also with several callers at once; exceptions reach the caller.
#include "core/base/bands.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace edgescan {
namespace {

TEST(Shares, EachIsDoneOnceForAllWhoAskAtOnce) {
    constexpr int kAskers = 3, kCalls = 200, kShares = 17;
    std::vector<std::vector<int>> done(kAskers, std::vector<int>(kShares, 0));
    std::vector<std::thread> askers;
    askers.reserve(kAskers);
    for (std::vector<int>& mine : done) {
        askers.emplace_back([&mine] {
            for (int call = 0; call < kCalls; ++call) runInParallel(kShares, [&mine](int n) { ++mine[static_cast<std::size_t>(n)]; });
        });
    }
    for (std::thread& asker : askers) asker.join();
    for (const std::vector<int>& mine : done) EXPECT_EQ(mine, std::vector<int>(kShares, kCalls));
    endSecondThread();
}

TEST(Shares, WhatOneThrowsIsThrownAfterAllAreDone) {
    std::atomic<int> done{0};
    EXPECT_THROW(runInParallel(50,
                               [&done](int n) {
                                   ++done;
                                   if (n % 10 == 3) throw std::runtime_error("no");
                               }),
                 std::runtime_error);
    EXPECT_EQ(done, 50);
    endSecondThread();
    endSecondThread(); // the thread does not exist
    runInParallel(2, [&done](int) { ++done; });
    EXPECT_EQ(done, 52);
    endSecondThread();
}

// As in a batch run from Python: the copy has no second thread, and must not wait for it.
TEST(Shares, ACopyOfTheProcessStartsItsOwn) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "the thread sanitizer starts no thread in a copied process";
#endif
    std::atomic<int> done{0};
    for (int call = 0; call < 20; ++call) {
        runInParallel(4, [&done](int) { ++done; });
        const pid_t child = ::fork();
        if (child == 0) {
            std::atomic<int> here{0};
            for (int again = 0; again < 20; ++again) runInParallel(7, [&here](int) { ++here; });
            ::_exit(here == 140 ? 0 : 1);
        }
        ASSERT_GT(child, 0);
        int status = -1;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(done, 80);
    endSecondThread();
}

TEST(Shares, BandsCoverAllLinesOnce) {
    for (const int lines : {0, 1, 2, 7, 100}) {
        for (const int bands : {0, 1, 2, 3, 1000}) {
            std::vector<std::atomic<int>> seen(static_cast<std::size_t>(lines));
            runInBands(lines, bands, [&seen](int first, int last) {
                for (int i = first; i < last; ++i) ++seen[static_cast<std::size_t>(i)];
            });
            for (const std::atomic<int>& times : seen) EXPECT_EQ(times, 1) << lines << " lines, " << bands << " bands";
        }
    }
    endSecondThread();
}

TEST(Shares, PartsAreInTheOrderOfTheLines) {
    for (const int lines : {0, 1, 7, 1000}) {
        for (const int threads : {1, 2}) {
            const auto parts = madeOfParts(lines, threads, [](int first, int last) {
                std::vector<int> own;
                for (int i = first; i < last; ++i) own.push_back(i);
                return own;
            });
            std::vector<int> all;
            for (const std::vector<int>& part : parts) all.insert(all.end(), part.begin(), part.end());
            EXPECT_EQ(static_cast<int>(all.size()), lines);
            EXPECT_TRUE(std::ranges::is_sorted(all));
            EXPECT_EQ(parts.size(), threads == 1 || lines < 2 ? 1U : static_cast<std::size_t>(std::min(lines, 16)));
        }
    }
    endSecondThread();
}

} // namespace
} // namespace edgescan
