// The operator's targets in a report: their places by the pose that the scan has now.
#include "core/base/number_text.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/html/notes_section.h"
#include "core/inspect/measure/cell_target.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <string>

namespace edgescan::exports {
namespace {

TEST(NotebookSection, SaysWhereTargetsAreByThePoseOfNow) {
    Scan scan = test::boxesScan(60, 90, 4, 0.0);
    const std::uint32_t cell = 25 * 90 + 40;
    inspect::Notebook notebook;
    notebook.targets.push_back({.number = 1,
                                .name = {},
                                .cell = cell,
                                .pinnedUtc = "2026-11-21T08:00:00Z",
                                .asPinned = {{"E, N, RL", "▲ no pose"}, {"Resolves", "31 mm"}}});
    const auto section = [&notebook](const Scan& of) {
        return notebookSection(*edges::detectEdges(std::make_shared<const Scan>(of), edges::Settings{}), notebook, 900);
    };
    const std::string without = section(scan);
    EXPECT_NE(without.find("E, N, RL: ▲ no pose"), std::string::npos) << without;
    EXPECT_EQ(without.find("E, N, RL"), without.rfind("E, N, RL")); // what is the same is written once
    EXPECT_NE(without.find("Targets on gray levels"), std::string::npos);
    EXPECT_NE(without.find("<text x=\"40.5\" y=\"25.5\">1</text>"), std::string::npos) << "its number is where it is";

    scan.placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
    const auto placed = edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{});
    const auto now = inspect::targetAt(*placed, {}, cell).probe.mineM;
    ASSERT_TRUE(now);
    const std::string text = section(scan);
    const std::size_t at = text.find("E, N, RL: " + fixedText(now->x(), 3) + ", " + fixedText(now->y(), 3) + ", " + fixedText(now->z(), 3));
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_GT(text.find("E, N, RL: ▲ no pose"), at); // the value of then is the remark
    EXPECT_EQ(text.find("Dip / direction: ▲ no pose"), std::string::npos);
    EXPECT_NE(text.find("Resolves: 31 mm"), std::string::npos);

    notebook.targets[0].cell = 60 * 90; // no cell of this scan
    EXPECT_NE(section(scan).find("no cell of this scan"), std::string::npos);
}

} // namespace
} // namespace edgescan::exports
