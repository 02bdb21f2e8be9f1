// Actions on opening a scan that happen only on request.
#include "app/lab/sim/simulate.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/angle_correction/straighten_scan.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

namespace edgescan::files {
namespace {

TEST(OpenAsAsked, AnglesAreCorrectedOnlyWhereThatIsAsked) {
    sim::SimulationSettings settings;
    settings.lines = 250;
    settings.beams = 286;
    settings.seed = 3;
    settings.interlaceDeg = 0.36;
    const test::Folder folder;
    const auto path = folder / "interlaced.json";
    ASSERT_TRUE(saveScan(sim::simulate(settings)->scan, path));

    ReadingOptions asked;
    asked.straighten = true;
    const auto bare = openScan(path, asked);
    const auto told = openAsAsked(path);
    const auto straight = openAsAsked(path, asked);
    ASSERT_TRUE(bare && told && straight);
    EXPECT_TRUE(bare->warnings.empty());
    EXPECT_EQ(bare->openedWith, "");
    ASSERT_EQ(told->warnings.size(), 1U);
    EXPECT_TRUE(isDisplacementWarning(told->warnings.front()));
    EXPECT_EQ(std::get<PolarGeometry>(told->geometry), std::get<PolarGeometry>(bare->geometry));
    EXPECT_EQ(straight->openedWith, "{\"straighten\":true}");
    EXPECT_FALSE(std::get<PolarGeometry>(straight->geometry).lineSkewDeg.empty());
    EXPECT_EQ(straight->rangeMm, bare->rangeMm);
    EXPECT_FALSE(openAsAsked(folder / "nowhere.json"));
}

} // namespace
} // namespace edgescan::files
