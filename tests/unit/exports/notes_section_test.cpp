// The operator's targets in a report: their places by the pose that the scan has now.
#include "core/base/number_text.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/html/html.h"
#include "core/exports/html/notes_section.h"
#include "core/exports/html/scan_pictures.h"
#include "core/inspect/measure/cell_target.h"
#include "core/inspect/measure/click_remarks.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace edgescan::exports {
namespace {

TEST(NotebookSection, SaysWhereTargetsAreByThePoseOfNow) {
    Scan scan = test::boxesScan(60, 90, 4, 0.0);
    const std::uint32_t cell = 25 * 90 + 40;
    inspect::Notebook notebook;
    notebook.targets.push_back(
        {.number = 1,
         .name = {},
         .cell = cell,
         .pinnedUtc = "2026-11-21T08:00:00Z",
         .asPinned = {{"E, N, RL", "▲ no pose"}, {inspect::kRockRow, "2.78 × 2.09 ± 0.02 m"}, {"Resolves", "31 mm"}}});
    const auto section = [&notebook](const Scan& of) {
        return notebookSection(*edges::detectEdges(std::make_shared<const Scan>(of), edges::Settings{}), notebook, 900);
    };
    const std::string without = section(scan);
    EXPECT_NE(without.find("E, N, RL: ▲ no pose"), std::string::npos) << without;
    EXPECT_EQ(without.find("E, N, RL"), without.rfind("E, N, RL")); // what is the same is written once
    EXPECT_NE(without.find("Edge: no edge, strength "), std::string::npos) << without;
    EXPECT_NE(without.find("Targets and measures on gray levels"), std::string::npos);
    EXPECT_NE(without.find("<circle cx=\"40.5\" cy=\"25.5\""), std::string::npos) << "its dot is where it is";
    EXPECT_NE(without.find(">1</text>"), std::string::npos);
    EXPECT_EQ(groupedText(999) + " " + groupedText(6518) + " " + groupedText(1136154), "999 6,518 1,136,154");

    scan.placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
    const auto placed = edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{});
    const auto now = inspect::targetAt(*placed, {}, cell).probe.mineM;
    ASSERT_TRUE(now);
    const std::string text = section(scan);
    const std::size_t at = text.find("E, N, RL: " + fixedText(now->x(), 3) + ", " + fixedText(now->y(), 3) + ", " + fixedText(now->z(), 3));
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_EQ(text.find("▲ no pose"), std::string::npos) << "the scan has one now";
    EXPECT_NE(text.find("Resolves: 31 mm"), std::string::npos);

    // The picture has the name of the target, and a measurement as a line with its value.
    notebook.targets[0].name = "A < B";
    notebook.measures.push_back({.kind = inspect::MeasureKind::Distance, .cells = {10 * 90 + 20, 30 * 90 + 60}, .number = 2});
    const std::string both = section(scan);
    EXPECT_NE(both.find(">1 A &lt; B</text>"), std::string::npos);
    EXPECT_NE(both.find("<line x1=\"20.5\" y1=\"10.5\" x2=\"60.5\" y2=\"30.5\" stroke"), std::string::npos);
    const auto length = inspect::measureStored(scan, inspect::noiseOf(*placed), notebook.measures[0]);
    ASSERT_TRUE(length);
    // The same remarks as on its card.
    const auto remarks = inspect::clickRemarks(scan, *placed->mask, notebook.measures[0]);
    ASSERT_EQ(remarks, std::vector<std::string>{"end 2 not on an edge"});
    EXPECT_NE(both.find("; end 2 not on an edge</td>"), std::string::npos) << both;
    EXPECT_NE(both.find("x=\"40.5\" y=\"20.5\" class=\"small\">" + std::string(length->isWarned() ? "▲ " : "") + "M2 " +
                        inspect::measureText(*length)),
              std::string::npos);

    notebook.targets[0].cell = 60 * 90; // no cell of this scan
    EXPECT_NE(section(scan).find("no cell of this scan"), std::string::npos);
}

// A cloud that is not as long on both sides of the line of sight: all of it is in the picture, and it fills it.
TEST(CloudPicture, IsCutAtNoSide) {
    const Scan whole = test::boxesScan(60, 90, 4, 0.0);
    for (const int firstBeam : {0, 45, 70}) {
        Scan part = whole;
        for (std::size_t k = 0; k < part.cells(); ++k) {
            if (static_cast<int>(k % 90) >= firstBeam) continue;
            part.rangeMm[k] = 0.0F;
            part.state[k] = CellState::NoReturn;
        }
        const auto detection = edges::detectEdges(std::make_shared<const Scan>(part), edges::Settings{});
        std::vector<std::size_t> cells;
        for (std::size_t k = 0; k < part.cells(); ++k) {
            if (part.state[k] == CellState::Valid) cells.push_back(k);
        }
        const CloudPicture picture = cloudPicture(*detection, 400, 300, nullptr, cells);
        double left = 400, right = 0, top = 300, bottom = 0;
        for (const auto& place : picture.places) {
            ASSERT_TRUE(place) << "a point is outside";
            left = std::min(left, place->x());
            right = std::max(right, place->x());
            top = std::min(top, place->y());
            bottom = std::max(bottom, place->y());
        }
        EXPECT_NEAR(left + right, 400, 1.0);
        EXPECT_NEAR(top + bottom, 300, 1.0);
        EXPECT_GT(std::max((right - left) / 400, (bottom - top) / 300), 0.9);
    }
}

// A number at the border of the picture is whole, and one over a dot is not on the dot.
TEST(PictureNumbers, AreWholeAtTheBorder) {
    constexpr double kSide = 580, kHigh = 10; // of the picture and of a number
    for (const bool dot : {false, true}) {
        for (const auto& [x, y] : {std::pair(0.5, 0.5), {579.5, 0.5}, {0.5, 579.5}, {579.5, 579.5}}) {
            std::size_t leftOut = 0;
            const std::string svg = pictureNumbers(580, 580, {{"147", x, y, true, dot}}, leftOut);
            const auto number = [&](const std::string& name, std::size_t from) {
                const std::size_t at = svg.find(" " + name + "=\"", from) + name.size() + 3;
                return std::stod(svg.substr(at, svg.find('"', at) - at));
            };
            const std::size_t text = svg.find("<text");
            const double atX = number("x", text), atY = number("y", text), half = 3 * 0.62 * kHigh / 2 + 1;
            EXPECT_GE(atX, half) << svg;
            EXPECT_LE(atX, kSide - half) << svg;
            EXPECT_GE(atY, kHigh / 2 + 1) << svg;
            EXPECT_LE(atY, kSide - kHigh / 2 - 1) << svg;
            if (dot) EXPECT_GE(std::abs(atY - number("cy", 0)), 0.9 * kHigh) << svg;
        }
    }
}

} // namespace
} // namespace edgescan::exports
