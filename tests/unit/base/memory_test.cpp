// Sizes and memory: nothing overflows, and the lowest limit counts.
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <random>

using namespace edgescan;
using namespace edgescan::test;

TEST(CheckedSize, AgreesWithWideArithmetic) {
    std::mt19937_64 random(3);
    const auto any = [&] { return random() >> (random() % 64); };
    for (int round = 0; round < 20000; ++round) {
        const std::uint64_t a = any(), b = any(), c = any();
        const bool fits = !__builtin_mul_overflow_p(a, b, std::uint64_t{}) && !__builtin_mul_overflow_p(a * b, c, std::uint64_t{});
        EXPECT_EQ(productOf({a, b, c}), a == 0 || b == 0 || c == 0 ? 0 : fits ? a * b * c : kTooLarge);
        EXPECT_EQ(sumOf({a, b}), __builtin_add_overflow_p(a, b, std::uint64_t{}) ? kTooLarge : a + b);
    }
    EXPECT_EQ(productOf({1ULL << 30U, 1ULL << 30U, 32}), kTooLarge);
    EXPECT_EQ(mostUnpackedBytes(kTooLarge), kTooLarge);
    EXPECT_EQ(mostUnpackedBytes(0), 8U << 20U);
}

TEST(Memory, EveryControlGroupOnTheWayCounts) {
    const Folder folder;
    const auto limit = [&](const char* path, const char* most, const char* used) {
        std::filesystem::create_directories(folder / path);
        writeText((folder / path) / "memory.max", most);
        writeText((folder / path) / "memory.current", used);
    };
    limit("", "max", "1000");
    limit("outer", "5000", "1000");
    limit("outer/inner", "max", "500");
    limit("outer/inner/own", "9000", "400");
    EXPECT_EQ(memoryLeftInGroups("0::/outer/inner/own\n", folder.path()), 4000U); // the outer limit is lower
    limit("outer/inner", "700", "500");
    EXPECT_EQ(memoryLeftInGroups("0::/outer/inner/own\n", folder.path()), 200U);
    writeText((folder / "outer/inner") / "memory.stat", "anon 100\ninactive_file 300\n");
    EXPECT_EQ(memoryLeftInGroups("0::/outer/inner/own\n", folder.path()), 500U); // cached files are released
    EXPECT_EQ(memoryLeftInGroups("0::/outer\n", folder.path()), 4000U);
    EXPECT_EQ(memoryLeftInGroups("0::/gone/elsewhere\n", folder.path()), UINT64_MAX);
    EXPECT_EQ(memoryLeftInGroups("0::/../beside\n", folder.path()), UINT64_MAX);
    EXPECT_EQ(memoryLeftInGroups("", folder.path()), UINT64_MAX);
    limit("", "100", "300"); // over its limit
    EXPECT_EQ(memoryLeftInGroups("0::/\n", folder.path()), 0U);
    // Version 1: a separate hierarchy for memory.
    std::filesystem::create_directories(folder / "memory/job");
    writeText((folder / "memory/job") / "memory.limit_in_bytes", "8000\n");
    writeText((folder / "memory/job") / "memory.usage_in_bytes", "7000\n");
    EXPECT_EQ(memoryLeftInGroups("5:devices:/\n4:cpu,memory:/job\n", folder.path()), 1000U);
    EXPECT_EQ(memoryLeftInGroups("5:memoryless:/job\n", folder.path()), UINT64_MAX);
}

TEST(Memory, TheAddressSpaceCountsToo) {
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
    const std::uint64_t room = std::uint64_t{1} << 33U; // in addition to the memory in use, which is terabytes with a sanitizer
    const std::uint64_t used = std::stoull(readText("/proc/self/statm")) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    rlimit tight = before;
    tight.rlim_cur = used + room;
    if (before.rlim_cur != RLIM_INFINITY && before.rlim_cur < tight.rlim_cur) GTEST_SKIP() << "the limit is tighter already";
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &tight), 0);
    const std::uint64_t left = availableMemoryBytes();
    ::setrlimit(RLIMIT_AS, &before);
    EXPECT_LE(left, room + (std::uint64_t{1} << 20U)); // memory in use at the first reading may be free by now
}
