// Classes of edges: the effect of each switch; the rim of an open void is not an edge of a rock (docs/reference/rules.md, "S3").
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/exports/provenance.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace edgescan::edges {
namespace {

// A wall with a rectangular hole of 20 x 40 cells.
std::shared_ptr<const Scan> wallWithHole() {
    const PolarGeometry polar = test::regularAngles(100, 160);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 6.0);
    return std::make_shared<const Scan>(test::makeScan(100, 160, [&](int i, int j) {
        const bool hole = i >= 40 && i < 60 && j >= 50 && j < 90;
        return hole ? 0.0 : test::wallRangeMm(polar, i, j, 5000.0) + std::round(noise(random));
    }));
}

TEST(EdgeClasses, TheRimOfAnOpeningIsAClassOfItsOwnAndNoEdgeOfARock) {
    const auto wall = wallWithHole();
    Settings settings;
    const auto usual = detectEdges(wall, settings);
    EXPECT_EQ(usual->edges->size(), 2U * (20 + 40)); // the cells that share a side with the opening
    EXPECT_EQ(countClasses(*usual)[static_cast<std::size_t>(DepthEdge::VoidRim)], usual->edges->size());
    for (const std::uint32_t k : *usual->edges) EXPECT_EQ(wall->state[k], CellState::Valid);
    settings.classes = kClassRock;
    EXPECT_TRUE(detectEdges(wall, settings)->edges->empty());
    settings.classes = kClassRock | kClassBorder;
    const auto border = detectEdges(wall, settings);
    EXPECT_EQ(*border->edges, *usual->edges);
    EXPECT_EQ(countClasses(*border)[static_cast<std::size_t>(DepthEdge::Border)], border->edges->size());
}

TEST(EdgeClasses, EachSwitchTakesItsOwnClassAway) {
    const auto boxes = std::make_shared<const Scan>(test::boxesScan(120, 160, 4));
    Settings settings;
    const auto all = countClasses(*detectEdges(boxes, settings));
    EXPECT_GT(all[1], 100U);
    for (const auto& [bit, kind] : {std::pair{kClassJump, 1U}, {kClassConvex, 2U}, {kClassConcave, 3U}}) {
        settings.classes = bit;
        const auto detection = detectEdges(boxes, settings);
        const auto counts = countClasses(*detection);
        EXPECT_EQ(counts[kind], detection->edges->size());
        settings.classes = kClassRock & ~bit;
        EXPECT_EQ(countClasses(*detectEdges(boxes, settings))[kind], 0U);
    }
}

TEST(EdgeClasses, OutlinesAndJumpsAreClassesOfTheSameEdges) {
    const auto boxes = std::make_shared<const Scan>(test::boxesScan(120, 160, 4));
    Settings named;
    Settings chosen;
    named.method = Method::Outlines;
    chosen.classes = kClassJump | kClassConcave;
    EXPECT_EQ(*detectEdges(boxes, named)->mask, *detectEdges(boxes, chosen)->mask);
    named.method = Method::Jumps;
    chosen.classes = kClassJump;
    EXPECT_EQ(*detectEdges(boxes, named)->mask, *detectEdges(boxes, chosen)->mask);
}

TEST(EdgeClasses, ExportsHoldTheClassOfEveryPoint) {
    const auto boxes = std::make_shared<const Scan>(test::boxesScan(60, 80, 4));
    const auto detection = detectEdges(boxes, Settings{});
    for (const exports::ExportContent content : {exports::ExportContent::EdgeCloud, exports::ExportContent::FullCloud}) {
        const auto files = exports::exportFiles(content, *detection, "cloud.csv", "", {});
        ASSERT_TRUE(files) << files.error().sentence();
        std::istringstream rows(files->front().bytes);
        std::string header;
        while (std::getline(rows, header) && header.starts_with('#')) {
        }
        ASSERT_TRUE(header.ends_with(",class")) << header;
        const bool hasEdge = header.find(",edge,") != std::string::npos;
        std::size_t points = 0;
        for (std::string row; std::getline(rows, row); ++points) {
            std::vector<std::string> fields;
            std::istringstream cut(row);
            for (std::string field; std::getline(cut, field, ',');) fields.push_back(field);
            const auto k = boxes->rangeMm.index(std::stoi(fields[3]), std::stoi(fields[4]));
            ASSERT_EQ(std::stoi(fields.back()), static_cast<int>((*detection->classes)[k])) << row;
            if (hasEdge) {
                ASSERT_EQ(fields[6] == "255", fields.back() != "0") << row;
            }
        }
        EXPECT_EQ(points, content == exports::ExportContent::EdgeCloud ? detection->edges->size()
                                                                       : countCells(*boxes)[static_cast<std::size_t>(CellState::Valid)]);
    }
    const auto gray = exports::exportFiles(exports::ExportContent::EdgeCloud, *detectEdges(boxes, cannySettings()), "cloud.csv", "", {});
    EXPECT_EQ(gray->front().bytes.find("class"), std::string::npos); // Canny has no classes
}

} // namespace
} // namespace edgescan::edges
