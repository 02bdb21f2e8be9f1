// Edge confidence compared with single runs, and with the scan: a high step is an edge at every setting, one near the threshold is not.
#include "core/edges/settings/parameters.h"
#include "core/edges/tuning/confidence.h"

#include "core/edges/pipeline/pipeline.h"
#include "core/exports/provenance.h"
#include "core/files/open_save/open_scan.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace edgescan::edges {
namespace {

std::shared_ptr<const Scan> boxes() { return std::make_shared<const Scan>(test::boxesScan(80, 100, 3, 0.02)); }

// Cell by cell, every setting from scratch.
int slowPercent(const std::vector<Grid<std::uint8_t>>& masks, int line, int beam) {
    int hits = 0;
    for (const auto& mask : masks) {
        bool near = false;
        for (int i = line - 1; i <= line + 1; ++i) {
            for (int j = beam - 1; j <= beam + 1; ++j) near = near || (mask.contains(i, j) && mask.at(i, j) != 0);
        }
        hits += near ? 1 : 0;
    }
    return 100 * hits / static_cast<int>(masks.size());
}

} // namespace

TEST(EdgeConfidence, IsTheShareOfNearbySettingsOfEveryMethod) {
    const auto scan = boxes();
    for (const Method method : {Method::EdgeScanPlus, Method::Jumps, Method::Canny, Method::LogRange, Method::Sobel, Method::Log}) {
        Settings settings;
        settings.method = method;
        const auto detection = detectEdges(scan, settings);
        const std::vector<Settings> tried = nearbySettings(*detection);
        ASSERT_GE(tried.size(), 3u);
        EXPECT_TRUE(tried.front() == settings);
        std::vector<Grid<std::uint8_t>> masks;
        for (const Settings& each : tried) {
            EXPECT_TRUE(checkSettings(each));
            EXPECT_EQ(each.method, method);
            EXPECT_EQ(std::ranges::count_if(tried, [&](const Settings& other) { return other == each; }), 1);
            masks.push_back(*detectEdges(scan, each)->mask);
        }
        const auto made = edgeConfidence(*detection);
        ASSERT_TRUE(made);
        EXPECT_EQ(made->settings, static_cast<int>(tried.size()));
        for (int i = 0; i < scan->lines(); ++i) {
            for (int j = 0; j < scan->beams(); ++j) {
                const int expected = detection->mask->at(i, j) != 0 ? slowPercent(masks, i, j) : 0;
                ASSERT_EQ(made->percent.at(i, j), expected) << i << " " << j;
            }
        }
    }
}

TEST(EdgeConfidence, AStepNearTheThresholdIsLessSureThanATallOne) {
    // A wall with two boards on it: one 800 mm thick, the other just thick enough for an edge.
    Settings settings;
    settings.method = Method::Jumps;
    Scan scan = test::boxesScan(60, 120, 3, 0.0);
    std::shared_ptr<const Detection> detection;
    const auto isOfThin = [](std::uint32_t k) { return k % 120 >= 60; };
    for (float thin = 40.0F; !detection || std::ranges::none_of(*detection->edges, isOfThin); thin += 1.0F) {
        ASSERT_LT(thin, 200.0F);
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            const auto beam = k % 120;
            scan.state[k] = CellState::Valid;
            scan.rangeMm[k] = 5000.0F - (beam >= 20 && beam < 50 ? 800.0F : 0.0F) - (beam >= 70 && beam < 100 ? thin : 0.0F);
        }
        detection = detectEdges(std::make_shared<const Scan>(scan), settings);
    }
    const auto made = edgeConfidence(*detection);
    ASSERT_TRUE(made);
    std::size_t thick = 0;
    for (const std::uint32_t k : *detection->edges) {
        thick += isOfThin(k) ? 0 : 1;
        if (isOfThin(k))
            EXPECT_LE(made->percent[k], 70);
        else
            EXPECT_EQ(made->percent[k], 100);
    }
    EXPECT_GT(thick, 0u);
}

TEST(EdgeConfidence, IsGivenUpWhenNobodyWantsIt) {
    const auto detection = detectEdges(boxes(), Settings{});
    double last = -1.0;
    const auto made = edgeConfidence(*detection, [&](double done) {
        EXPECT_GT(done, last);
        last = done;
        return done < 0.3;
    });
    EXPECT_FALSE(made);
    EXPECT_LT(last, 0.7);
}

TEST(EdgeConfidence, BandsHoldEveryPercentageOnce) {
    for (int percent = 0; percent <= 100; ++percent) {
        const std::size_t band = confidenceBand(percent);
        ASSERT_LT(band, kConfidenceBands.size());
        EXPECT_GE(percent, kConfidenceBands[band]);
        if (band > 0) {
            EXPECT_LT(percent, kConfidenceBands[band - 1]);
        }
    }
}

TEST(EdgeConfidence, IsAFieldOfAnExportAndOtherFormatsRefuse) {
    const test::TemporaryFolder folder;
    const auto scan = boxes();
    const auto detection = detectEdges(scan, Settings{});
    const auto made = edgeConfidence(*detection);
    ASSERT_TRUE(made);
    exports::ExportOptions options;
    options.choices.confidence = true;
    options.ascii = true;
    const auto written = exports::exportWithProvenance(exports::ExportContent::EdgeCloud, *detection, folder / "edges.pcd", options);
    ASSERT_TRUE(written) << written.error().sentence();
    std::ifstream file(folder / "edges.pcd");
    std::string line;
    std::vector<std::string> fields;
    std::size_t points = 0;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        if (line.starts_with("FIELDS ")) {
            std::string word;
            words >> word;
            while (words >> word) fields.push_back(word);
        }
        if (line.starts_with('#') || (line.front() >= 'A' && line.front() <= 'Z')) continue;
        std::vector<double> values;
        for (double value = 0; words >> value;) values.push_back(value);
        ASSERT_EQ(values.size(), fields.size());
        const auto of = [&](const char* name) {
            return values[static_cast<std::size_t>(std::ranges::find(fields, name) - fields.begin())];
        };
        EXPECT_EQ(of("confidence"), made->percent.at(static_cast<int>(of("line")), static_cast<int>(of("beam"))));
        ++points;
    }
    EXPECT_EQ(points, written->count);
    EXPECT_EQ(points, detection->edges->size());
    const auto again = files::openScan(folder / "edges.pcd"); // the field is neither a range nor an intensity
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_EQ(again->intensity.size(), scan->intensity.size());
    const auto refused = exports::exportWithProvenance(exports::ExportContent::EdgeCloud, *detection, folder / "edges.las", options);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("--with-confidence"), std::string::npos);
}

} // namespace edgescan::edges
