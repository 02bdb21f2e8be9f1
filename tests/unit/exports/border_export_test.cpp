// Borders of rocks in exports: their field in clouds, only them in exports, and verify.
#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/rock_borders/rock_borders.h"
#include "core/exports/provenance.h"
#include "core/exports/report.h"
#include "core/exports/verify.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace edgescan::exports {
namespace {

std::shared_ptr<const edges::Detection> bellIn(const std::filesystem::path& folder, const edges::Settings& settings) {
    EXPECT_TRUE(files::saveScan(sim::simulate({.lines = 90, .beams = 120, .dropouts = 0.02})->scan, folder / "scan.json"));
    return edges::detectEdges(std::make_shared<const Scan>(*files::openScan(folder / "scan.json")), settings);
}

/// The numbers of a field of a PCD file as text.
std::vector<double> fieldOf(const std::filesystem::path& path, const std::string& name) {
    std::ifstream file(path);
    std::vector<double> values;
    std::ptrdiff_t field = 0;
    bool points = false;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        const std::vector<std::string> texts{std::istream_iterator<std::string>(words), {}};
        if (points) values.push_back(std::strtod(texts.at(static_cast<std::size_t>(field)).c_str(), nullptr));
        if (line.starts_with("FIELDS ")) field = std::ranges::find(texts, name) - texts.begin() - 1;
        points = points || line.starts_with("DATA ");
    }
    return values;
}

TEST(BorderExport, TheFieldHasThePercentOfEachEdge) {
    const test::Folder folder;
    const auto detection = bellIn(folder / "", {});
    ExportOptions options;
    options.choices.borders = true;
    options.ascii = true;
    const auto written = exportWithProvenance(ExportContent::FullCloud, *detection, folder / "cloud.pcd", options);
    ASSERT_TRUE(written) << written.error().sentence();
    const std::vector<double> lines = fieldOf(folder / "cloud.pcd", "line"), beams = fieldOf(folder / "cloud.pcd", "beam"),
                              borders = fieldOf(folder / "cloud.pcd", "border");
    ASSERT_EQ(borders.size(), written->count);
    std::size_t known = 0, unknown = 0;
    for (std::size_t n = 0; n < borders.size(); ++n) {
        const auto cell = static_cast<std::uint32_t>(lines[n] * 120 + beams[n]);
        const auto edge = std::ranges::lower_bound(*detection->edges, cell);
        const bool isEdge = edge != detection->edges->end() && *edge == cell;
        const int percent = isEdge ? (*detection->borders)[static_cast<std::size_t>(edge - detection->edges->begin())] : -1;
        if (isEdge && percent != edges::kUnknownBorder) {
            EXPECT_EQ(borders[n], percent);
            ++known;
        } else {
            EXPECT_TRUE(std::isnan(borders[n])) << borders[n];
            ++unknown;
        }
    }
    EXPECT_GT(known, 100U);
    EXPECT_GT(unknown, 100U);
    EXPECT_TRUE(verifyExport(folder / "cloud.pcd")->identical);
    const auto las = exportWithProvenance(ExportContent::EdgeCloud, *detection, folder / "edges.las", options);
    ASSERT_FALSE(las);
    EXPECT_NE(las.error().sentence().find("--with-borders"), std::string::npos);
    edges::Settings canny;
    canny.method = edges::Method::Canny;
    const auto gray = edges::detectEdges(detection->scan, canny);
    EXPECT_FALSE(exportWithProvenance(ExportContent::EdgeCloud, *gray, folder / "gray.csv", options));
    EXPECT_TRUE(detectReport(*gray, 0)["rock_borders"].is_null());
}

TEST(BorderExport, OnlyRockBordersAreExportedIfOnlyTheyAreShown) {
    const test::Folder folder;
    const auto all = bellIn(folder / "", {});
    edges::Settings settings;
    settings.rockBorders = true;
    settings.borderPercent = 60;
    const auto some = edges::detectEdges(all->scan, settings);
    std::vector<std::uint32_t> likely;
    for (std::size_t n = 0; n < all->edges->size(); ++n) {
        if ((*all->borders)[n] >= 60) likely.push_back((*all->edges)[n]); // unknown ones too
    }
    EXPECT_EQ(*some->edges, likely);
    EXPECT_LT(likely.size(), all->edges->size());
    for (const char* name : {"edges.pcd", "edges.csv", "edges.dxf"}) {
        const auto written = exportWithProvenance(ExportContent::EdgeCloud, *some, folder / name, {});
        ASSERT_TRUE(written) << written.error().sentence();
        EXPECT_EQ(written->count, likely.size()) << name;
        const auto verified = verifyExport(folder / name);
        ASSERT_TRUE(verified) << verified.error().sentence();
        EXPECT_TRUE(verified->identical) << verificationText(*verified);
    }
    const auto report = detectReport(*some, 0);
    EXPECT_EQ(report["settings"]["rock-borders"], "on");
    EXPECT_EQ(report["rock_borders"]["folds"], 0);
    std::size_t counted = 0;
    for (const auto& [name, count] : report["rock_borders"].items()) counted += count.get<std::size_t>();
    EXPECT_EQ(counted, likely.size());
}

} // namespace
} // namespace edgescan::exports
