// Mine coordinates are preserved in every format; without a pose they are refused.
#include "core/files/formats/formats.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/placement_json.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

Scan placedScan(unsigned seed) {
    const Axis axis = seed % 2 == 0 ? Axis::Sweep : Axis::Spin;
    Scan scan = makeScan({.axis = axis, .lines = 9, .beams = 13, .fraction = 1.0, .seed = seed});
    scan.placement = randomPlacement(seed, seed % 4 == 0 ? scan.lines() : 1, axis == Axis::Sweep);
    return scan;
}

/// The same points as an organised cloud without angles.
Scan asPoints(const Scan& scan) {
    Scan cloud = scan;
    const CartesianTables tables(scan);
    PointGeometry geometry{Grid<Eigen::Vector3d>(scan.lines(), scan.beams(), Eigen::Vector3d::Zero()), Eigen::Vector3d(0.1, 0.2, 0.3)};
    for (std::size_t k = 0; k < scan.cells(); ++k) geometry.pointsM[k] = tables.point(k);
    cloud.geometry = geometry;
    return cloud;
}

/// Rows of numbers of one of our text files, without comments and names.
std::vector<std::vector<double>> rowsOf(const std::string& text) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#' || line.find("_m") != std::string::npos) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        rows.emplace_back();
        for (std::string word; words >> word;) rows.back().push_back(std::strtod(word.c_str(), nullptr));
    }
    return rows;
}

} // namespace

TEST(MineExport, APlacedScanComesBackTheSameFromEveryFormatAndFrame) {
    const Folder folder;
    for (unsigned round = 0; round < 120; ++round) {
        // Every combination of the first four, each with its own placement.
        const char* extension = std::array{".pcd", ".ply", ".xyz", ".csv"}[round % 4];
        const auto frame = std::array{CoordinateFrame::Scanner, CoordinateFrame::MineLocal, CoordinateFrame::Mine}[round / 5 % 3];
        const bool ascii = round / 15 % 2 == 0;
        const bool points = round / 30 % 2 == 0;
        SCOPED_TRACE(std::string(extension) + (points ? " points " : " polar ") + (ascii ? "ascii " : "") + std::to_string(round));
        const Scan scan = points ? asPoints(placedScan(round)) : placedScan(round);
        const auto path = folder / (std::string("scan") + extension);
        const auto saved = saveScan(scan, path, {.ascii = ascii, .frame = frame, .choices = {.comments = true}});
        ASSERT_TRUE(saved) << saved.error().sentence();
        const auto back = openScan(path);
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_EQ(back->rangeMm, scan.rangeMm);
        EXPECT_EQ(back->state, scan.state);
        ASSERT_TRUE(back->placement);
        EXPECT_EQ(placementToJson(*back->placement).dump(), placementToJson(*scan.placement).dump());
        const CartesianTables before(scan);
        const CartesianTables after(*back);
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] != CellState::Valid) continue;
            EXPECT_EQ(before.point(k), after.point(k));
            EXPECT_EQ(minePoint(scan, k).enhM, minePoint(*back, k).enhM);
        }
    }
}

TEST(MineExport, TheNumbersInTheFileAreTheMineCoordinatesToAMillimetre) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Scan scan = placedScan(seed);
        std::vector<Eigen::Vector3d> expected;
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] == CellState::Valid) expected.push_back(minePoint(scan, k).enhM);
        }
        for (const char* extension : {".csv", ".xyz"}) {
            for (const auto frame : {CoordinateFrame::Mine, CoordinateFrame::MineLocal}) {
                const auto path = folder / (std::string("cloud") + extension);
                ASSERT_TRUE(saveCloud(scan, path, nullptr, {.frame = frame, .choices = {.comments = true}}));
                const std::string text = readText(path);
                const auto rows = rowsOf(text);
                ASSERT_EQ(rows.size(), expected.size());
                Eigen::Vector3d origin = Eigen::Vector3d::Zero();
                if (frame == CoordinateFrame::MineLocal) {
                    EXPECT_NE(text.find("origin E 620000.000 N 6200000.000 El 250.000"), std::string::npos);
                    origin = scan.placement->originEnhM;
                }
                for (std::size_t i = 0; i < rows.size(); ++i)
                    EXPECT_LT((origin + Eigen::Vector3d(rows[i][0], rows[i][1], rows[i][2]) - expected[i]).norm(), 1e-4);
            }
        }
    }
}

TEST(MineExport, MineCoordinatesAreNeverFourByteFloats) {
    const Scan scan = placedScan(3);
    for (const auto& cloud : {everyCell(scan, CoordinateFrame::Mine), validPoints(scan, nullptr, CoordinateFrame::Mine)}) {
        for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::holds_alternative<std::vector<double>>(cloud.columns[i].values));
    }
    const CloudColumns local = everyCell(scan, CoordinateFrame::MineLocal);
    EXPECT_TRUE(std::holds_alternative<std::vector<float>>(local.columns[0].values));
    EXPECT_EQ(local.originM, scan.placement->originEnhM);
    CloudColumns asked = validPoints(scan, nullptr, CoordinateFrame::Mine);
    asked.choices.doubles = true;
    const auto pcd = writtenFormat("cloud.pcd")->write(asked, "cloud.pcd", false);
    ASSERT_TRUE(pcd);
    EXPECT_NE(pcd->find("SIZE 8 8 8 4 4 4 1 4\nTYPE F F F U U F U F\n"), std::string::npos);
    // PCL reads only floats: metres from the origin.
    const auto floats = writtenFormat("cloud.pcd")->write(validPoints(scan, nullptr, CoordinateFrame::Mine), "cloud.pcd", false);
    ASSERT_TRUE(floats);
    EXPECT_NE(floats->find("SIZE 4 4 4 4 4 4 1 4\nTYPE F F F U U F U F\n"), std::string::npos);
    EXPECT_NE(floats->find("# edgescan-origin 620000 6200000 250 "), std::string::npos);
    EXPECT_EQ(floats->find("VIEWPOINT 620"), std::string::npos);
    const auto ply = writtenFormat("cloud.ply")->write(validPoints(scan, nullptr, CoordinateFrame::Mine), "cloud.ply", false);
    ASSERT_TRUE(ply);
    EXPECT_NE(ply->find("property double x\nproperty double y\nproperty double z\n"), std::string::npos);
    EXPECT_NE(ply->find("comment EdgeScan, mine grid in metres: x Easting, y Northing, z Elevation\n"), std::string::npos);
    // Large numbers from a file of floats are not written as floats again.
    Scan far = asPoints(placedScan(3));
    for (Eigen::Vector3d& p : std::get<PointGeometry>(far.geometry).pointsM.cells) p += Eigen::Vector3d(500000, 5000000, 0);
    for (Eigen::Vector3d& p : std::get<PointGeometry>(far.geometry).pointsM.cells) p = p.cast<float>().cast<double>();
    EXPECT_TRUE(std::holds_alternative<std::vector<double>>(validPoints(far, nullptr).columns[1].values));
}

TEST(MineExport, WithoutAPoseItIsRefusedWithTheReason) {
    const Folder folder;
    Scan scan = placedScan(1);
    const auto raw = saveScan(placedScan(2), folder / "scan.json", {false, CoordinateFrame::Mine});
    ASSERT_FALSE(raw);
    EXPECT_NE(raw.error().sentence().find("holds ranges and no coordinates"), std::string::npos);
    scan.placement.reset();
    const Grid<std::uint8_t> mask(scan.lines(), scan.beams(), 255);
    for (const auto frame : {CoordinateFrame::Mine, CoordinateFrame::MineLocal}) {
        for (const auto& saved :
             {saveScan(scan, folder / "a.pcd", {false, frame}), saveCloud(scan, folder / "a.ply", nullptr, {false, frame}),
              saveEdges(scan, mask, folder / "a.csv", {false, frame})}) {
            ASSERT_FALSE(saved);
            EXPECT_NE(saved.error().sentence().find("the scan has no pose"), std::string::npos) << saved.error().sentence();
        }
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(MineExport, FormatsOfSurveyAndCadHoldAMillimetreToo) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const Scan scan = placedScan(seed);
        const CartesianTables tables(scan);
        const PlacedPoints placed(scan);
        for (const CoordinateFrame frame : {CoordinateFrame::Mine, CoordinateFrame::MineLocal, CoordinateFrame::Scanner}) {
            std::vector<Eigen::Vector3d> expected;
            for (std::size_t k = 0; k < scan.cells(); ++k) {
                const int line = static_cast<int>(k) / scan.beams();
                const int beam = static_cast<int>(k) % scan.beams();
                if (scan.state[k] == CellState::Valid) expected.push_back(placed.inFrame(frame, line, beam, tables.point(k)));
            }
            for (const char* name : {"c.las", "c.dxf", "c.ptx", "c.obj"}) {
                SCOPED_TRACE(std::string(name) + " " + std::to_string(seed) + " frame " + std::to_string(static_cast<int>(frame)));
                const auto bytes = cloudBytes(scan, name, nullptr, {.frame = frame});
                ASSERT_TRUE(bytes) << bytes.error().sentence();
                const ReadingOptions options;
                const Source source{name, std::as_bytes(std::span(*bytes)), &options};
                const std::vector<Eigen::Vector3d> found = pointsAsWritten(*writtenFormat(name)->read(source));
                ASSERT_EQ(found.size(), expected.size());
                for (std::size_t n = 0; n < found.size(); ++n) EXPECT_LT((found[n] - expected[n]).cwiseAbs().maxCoeff(), 0.00051) << n;
            }
        }
    }
}

TEST(MineExport, ARawGridCarriesThePlace) {
    const Folder folder;
    Scan scan = makeScan({.lines = 6, .beams = 5});
    scan.placement = randomPlacement(8, 6, true);
    ASSERT_TRUE(saveScan(scan, folder / "scan.json"));
    const auto back = openScan(folder / "scan.u16");
    ASSERT_TRUE(back) << back.error().sentence();
    ASSERT_TRUE(back->placement);
    EXPECT_EQ(placementToJson(*back->placement).dump(), placementToJson(*scan.placement).dump());
    std::string json = readText(folder / "scan.json");
    json.replace(json.find("\"direction\": -1") == std::string::npos ? json.find("\"direction\": 1") : json.find("\"direction\": -1"), 14,
                 "\"direction\": 7");
    writeText(folder / "scan.json", json);
    EXPECT_FALSE(openScan(folder / "scan.u16"));
}
