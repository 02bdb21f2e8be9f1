// edgescan-lab stones: its files are a scan and the truth that `evaluate` reads.
#include "tests/support/cube_stones.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

namespace edgescan {
namespace {

TEST(Stones, TheirScanIsEvaluatedAgainstTheirTruth) {
    const test::TemporaryFolder folder;
    test::writeCubeStones(folder / "stones");
    test::writeCubeHeap(folder / "heaps");
    const auto path = [&](const char* name) { return (folder / name).string(); };
    const auto made = test::runLab("stones --stones " + path("stones") + " --settled " + path("heaps") + " -o " + path("HEAP.json") +
                                   " --truth " + path("truth"));
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.out.find("bench-free-seed1-view0: 400 lines x 500 beams"), std::string::npos) << made.out;
    const auto scored = test::runLab("evaluate " + path("HEAP.json") + " --truth " + path("truth"));
    EXPECT_EQ(scored.code, 0) << scored.err;
    EXPECT_NE(scored.out.find("occluding"), std::string::npos) << scored.out;
    const auto rocks = test::runLab("evaluate --rocks " + path("HEAP.json") + " --truth " + path("truth"));
    EXPECT_EQ(rocks.code, 0) << rocks.err;
    EXPECT_NE(rocks.out.find("2 rocks"), std::string::npos) << rocks.out;
    EXPECT_EQ(test::runLab("stones --stones " + path("nowhere") + " -o " + path("HEAP.json")).code, 1);
}

} // namespace
} // namespace edgescan
