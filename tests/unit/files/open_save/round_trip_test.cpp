// A saved scan opens again with the same ranges, states and angles, in every format.
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// A scan with every state, uneven angles and fractions of a millimetre.
Scan everything(bool wholeCounts, unsigned seed) {
    ScanShape shape{.lines = 7, .beams = 11, .motorJitter = 0.5, .fraction = wholeCounts ? 0.0 : 1.0, .seed = seed};
    Scan scan = makeScan(shape);
    std::mt19937 random(seed);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const auto state = static_cast<CellState>(random() % 12);
        if (static_cast<int>(state) >= kCellStates) continue;
        scan.state[k] = state;
        if (state == CellState::DeviceStatus)
            scan.rangeMm[k] = 32763;
        else if (state == CellState::NoReturn || state == CellState::Lost)
            scan.rangeMm[k] = 0;
        else if (!(scan.rangeMm[k] > 0))
            scan.rangeMm[k] = 1234;
    }
    scan.statusCodes = {32763};
    scan.note = "Stollen 7, \"Süd\": a note  with blanks\nand a line";
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    if (seed % 2 == 0) polar.lineDirection = -1;
    if (seed % 3 == 0) polar.axis = Axis::Spin;
    if (seed % 4 == 0) {
        for (std::size_t j = 0; j < polar.beamDeg.size(); ++j) polar.beamDeg[j] = -5.0 + static_cast<double>(j) * (1.0 / 6.0);
    }
    return scan;
}

void expectSame(const Scan& a, const Scan& b) {
    EXPECT_EQ(a.rangeMm, b.rangeMm);
    EXPECT_EQ(a.state, b.state);
    EXPECT_EQ(a.statusCodes, b.statusCodes);
    EXPECT_EQ(a.noReturnCodes, b.noReturnCodes);
    EXPECT_EQ(a.unitMm, b.unitMm);
    EXPECT_EQ(a.note, b.note);
    ASSERT_TRUE(std::holds_alternative<PolarGeometry>(b.geometry));
    EXPECT_EQ(std::get<PolarGeometry>(a.geometry), std::get<PolarGeometry>(b.geometry));
    const auto counts = countCells(b);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), b.cells());
}

} // namespace

TEST(RoundTrip, EveryFormatGivesTheSameScanBack) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const Scan scan = everything(false, seed);
        for (const char* extension : {".pcd", ".ply", ".xyz", ".csv", ".txt"}) {
            for (const bool ascii : {false, true}) {
                SCOPED_TRACE(std::string(extension) + (ascii ? " ascii " : " ") + std::to_string(seed));
                const auto path = folder / (std::string("scan") + extension);
                const auto saved = saveScan(scan, path, {.ascii = ascii, .choices = {.comments = true}});
                ASSERT_TRUE(saved) << saved.error().sentence();
                const auto opened = openScan(path);
                ASSERT_TRUE(opened) << opened.error().sentence();
                expectSame(scan, *opened);
                EXPECT_TRUE(opened->warnings.empty());
                EXPECT_EQ(opened->sha256, *sha256OfFile(path));
            }
        }
    }
}

TEST(RoundTrip, RawGridKeepsEveryStateAndOpensByEitherFile) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const Scan scan = everything(true, seed);
        const auto saved = saveScan(scan, folder / "pair.json");
        ASSERT_TRUE(saved) << saved.error().sentence();
        for (const char* name : {"pair.json", "pair.u16"}) {
            const auto opened = openScan(folder / name);
            ASSERT_TRUE(opened) << opened.error().sentence();
            expectSame(scan, *opened);
            EXPECT_EQ(opened->sha256, *sha256OfFile(folder / "pair.u16"));
        }
    }
}

TEST(RoundTrip, RawGridRefusesWhatItCannotCarryAndLeavesTheOldFiles) {
    const Folder folder;
    ASSERT_TRUE(saveScan(everything(true, 1), folder / "pair.json"));
    const std::string json = readText(folder / "pair.json");
    const auto fractions = saveScan(everything(false, 2), folder / "pair.json");
    ASSERT_FALSE(fractions);
    EXPECT_NE(fractions.error().sentence().find("whole counts"), std::string::npos);
    Scan far = everything(true, 3);
    far.state[0] = CellState::Valid;
    far.rangeMm[0] = 70000;
    EXPECT_FALSE(saveScan(far, folder / "pair.u16"));
    EXPECT_EQ(readText(folder / "pair.json"), json);
}

TEST(RoundTrip, ListsOfPointsHaveNoDigitsOfArithmetic) {
    Scan scan;
    scan.rangeMm = Grid<float>(1, 2);
    scan.state = Grid<CellState>(1, 2, CellState::Valid);
    PointGeometry geometry{Grid<Eigen::Vector3d>(1, 2, Eigen::Vector3d::Zero()), Eigen::Vector3d::Zero()};
    geometry.pointsM[0] = {-319.3588 * 0.01, 0.1 + 0.2, 100.0 - 1e-13}; // as centimetres become metres
    geometry.pointsM[1] = {1.0 / 3.0, -1e-12, 2.5};
    for (std::size_t k = 0; k < 2; ++k) scan.rangeMm[k] = static_cast<float>(geometry.pointsM[k].norm() * 1000);
    scan.geometry = geometry;
    const auto list = scanFiles(scan, "list.xyz");
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->front().bytes, "-3.193588 0.3 100\n0.333333333 0 2.5\n");
    const auto table = scanFiles(scan, "table.csv");
    ASSERT_TRUE(table) << table.error().sentence();
    EXPECT_NE(table->front().bytes.find("\n-3.193588,0.3,100,0,0,"), std::string::npos) << table->front().bytes;
}

TEST(RoundTrip, LinkToARawGridOpensIt) {
    const Folder folder;
    const Scan scan = everything(true, 1);
    std::filesystem::create_directory(folder / "scans");
    ASSERT_TRUE(saveScan(scan, folder / "scans/pair.json"));
    for (const char* extension : {".json", ".u16"}) {
        const auto link = folder / (std::string("link") + extension);
        std::filesystem::create_symlink(folder / (std::string("scans/pair") + extension), link);
        const auto opened = openScan(link);
        ASSERT_TRUE(opened) << opened.error().sentence();
        expectSame(scan, *opened);
        std::filesystem::remove(link);
    }
    std::filesystem::create_symlink("scans/pair.json", folder / "relative.json");
    EXPECT_TRUE(openScan(folder / "relative.json"));
    std::filesystem::create_symlink("nowhere.json", folder / "dangling.json");
    EXPECT_FALSE(openScan(folder / "dangling.json"));
}

TEST(RoundTrip, OrganisedCloudKeepsItsPointsExactly) {
    const Folder folder;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const bool mine : {false, true}) {
        Scan scan;
        PointGeometry geometry{Grid<Eigen::Vector3d>(5, 8, Eigen::Vector3d::Zero()),
                               mine ? Eigen::Vector3d(620000.125, 6200000.0625, 250.1) : Eigen::Vector3d(0.25, -1, 2)};
        scan.rangeMm = Grid<float>(5, 8);
        scan.state = Grid<CellState>(5, 8, CellState::Valid);
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            const double t = static_cast<double>(k);
            geometry.pointsM[k] = geometry.sensorM + (mine ? Eigen::Vector3d(2 + 0.001 * t, 0.01 * t * t, 1.0 / 3.0)
                                                           : Eigen::Vector3d(2 + 0.125 * t, 0.5 * t, 1));
            scan.rangeMm[k] = static_cast<float>((geometry.pointsM[k] - geometry.sensorM).norm() * 1000);
            if (k % 7 != 3) continue;
            scan.state[k] = CellState::NoReturn;
            scan.rangeMm[k] = 0;
            geometry.pointsM[k] = Eigen::Vector3d(nan, nan, nan);
        }
        scan.geometry = geometry;
        for (const char* extension : {".pcd", ".ply", ".xyz", ".csv"}) {
            SCOPED_TRACE(extension);
            const auto path = folder / (std::string("cloud") + extension);
            ASSERT_TRUE(saveScan(scan, path, {.choices = {.comments = true}}));
            const auto opened = openScan(path);
            ASSERT_TRUE(opened) << opened.error().sentence();
            EXPECT_EQ(opened->rangeMm, scan.rangeMm);
            EXPECT_EQ(opened->state, scan.state);
            const auto& back = std::get<PointGeometry>(opened->geometry);
            EXPECT_EQ(back.sensorM, geometry.sensorM);
            for (std::size_t k = 0; k < scan.cells(); ++k) {
                if (scan.state[k] == CellState::Valid) {
                    EXPECT_EQ(back.pointsM[k], geometry.pointsM[k]);
                }
            }
        }
        EXPECT_FALSE(saveScan(scan, folder / "cloud.json"));
    }
}

TEST(RoundTrip, CloudsAndEdgesHoldTheRightPoints) {
    const Folder folder;
    const Scan scan = everything(false, 5);
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < mask.size(); k += 3) mask[k] = 255;
    ASSERT_TRUE(saveCloud(scan, folder / "cloud.csv", &mask));
    ASSERT_TRUE(saveEdges(scan, mask, folder / "edges.csv"));
    std::size_t edges = 0;
    for (std::size_t k = 0; k < mask.size(); ++k) edges += scan.state[k] == CellState::Valid && mask[k] != 0 ? 1 : 0;
    const std::string cloud = readText(folder / "cloud.csv");
    const std::string edgeText = readText(folder / "edges.csv");
    EXPECT_TRUE(cloud.starts_with("x_m,y_m,z_m,line,beam,range_mm,edge\n"));
    EXPECT_TRUE(edgeText.starts_with("x_m,y_m,z_m,line,beam,range_mm\n"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(cloud.begin(), cloud.end(), '\n')), countCells(scan)[0] + 1);
    EXPECT_EQ(static_cast<std::size_t>(std::count(edgeText.begin(), edgeText.end(), '\n')), edges + 1);
    for (const char* extension : {".pcd", ".ply", ".xyz"}) {
        EXPECT_TRUE(saveCloud(scan, folder / (std::string("c") + extension), nullptr));
        EXPECT_TRUE(saveEdges(scan, mask, folder / (std::string("e") + extension)));
    }
    EXPECT_FALSE(saveEdges(scan, Grid<std::uint8_t>(2, 2), folder / "x.pcd"));
    EXPECT_FALSE(saveEdges(scan, mask, folder / "x.json"));
    EXPECT_FALSE(saveCloud(scan, folder / "x.bin", &mask));
}

TEST(RoundTrip, PngKeepsEveryByte) {
    const Folder folder;
    Grid<std::uint8_t> gray(13, 29);
    Grid<std::uint16_t> deep(13, 29);
    for (std::size_t k = 0; k < gray.size(); ++k) {
        gray[k] = static_cast<std::uint8_t>(k * 7);
        deep[k] = static_cast<std::uint16_t>(k * 173);
    }
    ASSERT_TRUE(containers::savePng8(gray, folder / "gray.png"));
    ASSERT_TRUE(containers::savePng16(deep, folder / "deep.png"));
    const auto back = containers::readPng8(folder / "gray.png");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(*back, gray);
    EXPECT_FALSE(containers::readPng8(folder / "deep.png"));
    EXPECT_FALSE(containers::savePng8({}, folder / "none.png"));
    const std::string whole = readText(folder / "gray.png");
    for (std::size_t cut = 0; cut < whole.size(); ++cut) {
        writeText(folder / "cut.png", whole.substr(0, cut));
        const auto damaged = containers::readPng8(folder / "cut.png");
        if (cut + 12 < whole.size()) {
            EXPECT_FALSE(damaged) << cut;
        } // the last chunk is only a mark
    }
}

TEST(RoundTrip, Sha256OfKnownText) {
    EXPECT_EQ(sha256Hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    const std::string abc = "abc";
    EXPECT_EQ(sha256Hex(std::as_bytes(std::span(abc))), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_FALSE(sha256OfFile("/nonexistent"));
}

TEST(WholeFile, FailureKeepsTheOldFileAndLeavesNoTemporary) {
    const Folder folder;
    const auto path = folder / "kept.txt";
    ASSERT_TRUE(writeWholeFile(path, std::string("old")));
    EXPECT_FALSE(writeWholeFile(folder / "nowhere/file.txt", std::string("new")));
    EXPECT_FALSE(writeWholeFile(folder.path(), std::string("new")));
    std::filesystem::create_directory(folder / "folder.json");
    const std::string text = "new";
    const auto bytes = std::as_bytes(std::span(text));
    EXPECT_FALSE(writeWholeFiles({{path, bytes}, {folder / "folder.json", bytes}}));
    EXPECT_EQ(readText(path), "old");
    std::size_t entries = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) entries += entry.exists() ? 1 : 0;
    EXPECT_EQ(entries, 2U);
}

TEST(WholeFile, FullDiskIsOneSentence) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "/dev/full is absent";
    const auto written = writeWholeFile("/dev/full", std::string("text"));
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().sentence().find("disk is full"), std::string::npos);
    EXPECT_TRUE(writeWholeFile("/dev/null", std::string("text")));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WholeFile, LinksAreFollowedAndModesKept) {
    const Folder folder;
    ASSERT_TRUE(writeWholeFile(folder / "target.txt", std::string("old")));
    std::filesystem::permissions(folder / "target.txt", std::filesystem::perms::owner_all);
    std::filesystem::create_symlink("target.txt", folder / "link.txt");
    ASSERT_TRUE(writeWholeFile(folder / "link.txt", std::string("new")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(readText(folder / "target.txt"), "new");
    EXPECT_EQ(std::filesystem::status(folder / "target.txt").permissions(), std::filesystem::perms::owner_all);
}
