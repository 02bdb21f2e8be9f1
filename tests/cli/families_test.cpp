// edgescan-lab families from outside: usage, and exit codes of a comparison.
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace edgescan {
namespace {

using test::runLab;

TEST(LabFamilies, WrongUsageIsNamed) {
    for (const char* flags : {"--family nothing", "--with nothing", "--with a=--nothing", "--with default --with default",
                              "--against nothing", "--named walls", "--scenes 0"}) {
        const auto run = runLab(std::string("families ") + flags);
        EXPECT_EQ(run.code, 2) << flags;
        EXPECT_FALSE(run.err.empty()) << flags;
    }
}

TEST(LabFamilies, AChangeThatFallsDoesNotPass) {
    const test::TemporaryFolder folder;
    const std::string flags = "families --family staircase --scenes 1 --store " + (folder / "store").string();
    const std::string earlier = (folder / "earlier.json").string();
    const auto first = runLab(flags + " --draw words --with default --json " + earlier + " --pictures " + (folder / "pictures").string());
    ASSERT_EQ(first.code, 0) << first.err;
    std::filesystem::directory_iterator pictures(folder / "pictures");
    ASSERT_NE(pictures, std::filesystem::directory_iterator()) << "a picture of its only scene";
    EXPECT_EQ(pictures->path().extension(), ".png");
    EXPECT_TRUE(test::fileText(pictures->path()).starts_with("\x89PNG"));
    EXPECT_EQ(runLab(flags + " --with default --against " + earlier).code, 0); // the draw is that of the file
    const auto worse = runLab(flags + " --with 'default=--sensitivity 2.5' --against " + earlier);
    EXPECT_EQ(worse.code, 3) << worse.out << worse.err;
    EXPECT_NE(worse.out.find("The change does not pass."), std::string::npos) << worse.out;
    const auto other = runLab(flags + " --draw other --with default --against " + earlier);
    EXPECT_EQ(other.code, 3) << other.out; // no scene is in both
}

} // namespace
} // namespace edgescan
