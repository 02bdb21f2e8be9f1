// A wish to stop: a file whose writing was cancelled does not appear, and what it would have replaced stays.
#include "core/base/stop.h"
#include "core/base/whole_file.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <thread>

using namespace edgescan;

TEST(Stop, NoFileAppearsAndTheOldOneStays) {
    const test::TemporaryFolder folder;
    const auto path = folder / "file.txt";
    std::atomic<bool> wish{false};
    {
        const BindStop bound(wish);
        EXPECT_FALSE(isStopWished());
        ASSERT_TRUE(writeWholeFile(path, "before"));
        wish = true;
        EXPECT_TRUE(isStopWished());
        const auto refused = writeWholeFile(path, "after");
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().what.find("cancelled"), std::string::npos);
        EXPECT_FALSE(writeWholeFile(folder / "other.txt", "other"));
        std::thread([] { EXPECT_FALSE(isStopWished()); }).join(); // another thread is not bound
    }
    EXPECT_FALSE(isStopWished());
    EXPECT_EQ(textOf(*readWholeFile(path)), "before");
    std::size_t files = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder.path())) files += each.exists() ? 1 : 0;
    EXPECT_EQ(files, 1U);
}
