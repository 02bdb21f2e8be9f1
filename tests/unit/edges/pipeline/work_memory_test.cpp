// Work on a scan is refused before the memory runs out.
#include "core/edges/pipeline/work_memory.h"

#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

namespace edgescan::edges {
namespace {

TEST(WorkMemory, IsAskedAgainstTheLimitThatHolds) {
    Scan scan;
    scan.path = "large.pcd";
    scan.rangeMm = Grid<float>(1000, 2000);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
    const std::uint64_t used = std::stoull(test::readText("/proc/self/statm")) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    rlimit tight = before;
    tight.rlim_cur = used + (std::uint64_t{200} << 20U); // two million cells: 52 MB to detect, 300 MB to explain
    if (before.rlim_cur != RLIM_INFINITY && before.rlim_cur < tight.rlim_cur) GTEST_SKIP() << "the limit is tighter already";
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &tight), 0);
    const auto detect = checkMemoryFor(Work::Detect, scan);
    const auto explain = checkMemoryFor(Work::Explain, scan);
    ::setrlimit(RLIMIT_AS, &before);
    EXPECT_TRUE(detect);
    ASSERT_FALSE(explain);
    EXPECT_NE(explain.error().sentence().find("large.pcd: needs 300.0 MB of memory, "), std::string::npos) << explain.error().sentence();
}

} // namespace
} // namespace edgescan::edges
