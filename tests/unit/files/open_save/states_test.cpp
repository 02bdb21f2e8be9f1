// With any losses in a scan, every cell is accounted for in every format that stores cells, and no index changes.
#include "core/containers/png/png.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/range_image.h"
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

enum class Loss { NoReturn, Isolated, Lines, EveryState };

/// Removes cells: random ones, all but single ones, whole lines and beams, or into every state.
Scan withLoss(Loss loss, unsigned seed) {
    ScanShape shape;
    shape.lines = 24 + static_cast<int>(seed % 5);
    shape.beams = 33 + static_cast<int>(seed % 7);
    shape.noReturns = 0;
    shape.seed = seed;
    shape.axis = seed % 2 == 0 ? Axis::Sweep : Axis::Spin;
    Scan scan = makeScan(shape);
    std::mt19937 random(seed * 77 + static_cast<unsigned>(loss));
    scan.statusCodes = {65000};
    const auto drop = [&](std::size_t k, CellState state) {
        scan.state[k] = state;
        scan.rangeMm[k] = state == CellState::DeviceStatus ? 65000.0F : 0.0F;
    };
    const auto beams = static_cast<std::size_t>(scan.beams());
    const int share = 1 + static_cast<int>(random() % 80);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const bool hit = static_cast<int>(random() % 100) < share;
        const auto other = static_cast<CellState>(random() % kCellStates);
        if (loss == Loss::NoReturn && hit) drop(k, CellState::NoReturn);
        if (loss == Loss::Isolated && !((k / beams) % 3 == 1 && (k % beams) % 3 == 1)) drop(k, CellState::NoReturn);
        if (loss == Loss::Lines && ((k / beams) % 5 == 2 || k % beams == 0)) drop(k, CellState::NoReturn);
        if (loss == Loss::EveryState && hit && other != CellState::Valid) drop(k, other);
    }
    return scan;
}

void expectAccounted(const Scan& scan, const Scan& found) {
    const auto counts = countCells(found);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), found.cells());
    ASSERT_EQ(found.lines(), scan.lines());
    ASSERT_EQ(found.beams(), scan.beams());
    EXPECT_EQ(counts, countCells(scan));
    EXPECT_EQ(found.state, scan.state) << "a cell moved or changed its state";
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        ASSERT_EQ(found.rangeMm[k], scan.rangeMm[k]) << k;
    }
}

} // namespace

TEST(CellsAccountedFor, ScansSavedInEveryFormatWithCells) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        for (const Loss loss : {Loss::NoReturn, Loss::Isolated, Loss::Lines, Loss::EveryState}) {
            const Scan scan = withLoss(loss, seed);
            for (const char* name : {"s.json", "s.pcd", "s.ply", "s.csv", "s.xyz", "s.las", "s.mcap"}) {
                for (const bool ascii : {false, true}) {
                    SCOPED_TRACE(std::string(name) + " loss " + std::to_string(static_cast<int>(loss)) + " seed " + std::to_string(seed));
                    const auto saved = saveScan(scan, folder / name, {.ascii = ascii, .choices = {.comments = true}});
                    ASSERT_TRUE(saved) << saved.error().sentence();
                    const auto found = openScan(folder / name);
                    ASSERT_TRUE(found) << found.error().sentence();
                    expectAccounted(scan, *found);
                }
            }
        }
    }
}

TEST(CellsAccountedFor, PtxAndPicturesKnowNoReturnOnly) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        for (const Loss loss : {Loss::NoReturn, Loss::Isolated, Loss::Lines, Loss::EveryState}) {
            SCOPED_TRACE(std::to_string(static_cast<int>(loss)) + " seed " + std::to_string(seed));
            Scan scan = withLoss(loss, seed);
            const Scan whole = scan;
            for (CellState& state : scan.state.cells) state = state == CellState::Valid ? state : CellState::NoReturn;
            ASSERT_TRUE(saveScan(whole, folder / "s.ptx"));
            EXPECT_EQ(lostOnSaving(whole, folder / "s.ptx").empty(), loss != Loss::EveryState);
            ReadingOptions angles;
            const auto& polar = std::get<PolarGeometry>(scan.geometry);
            angles.axis = polar.axis;
            const auto ptx = openScan(folder / "s.ptx", angles);
            ASSERT_TRUE(ptx) << ptx.error().sentence();
            expectAccounted(scan, *ptx);
            ASSERT_TRUE(containers::savePng16(rangePicture(scan), folder / "s.png"));
            angles.beamStartDeg = polar.beamDeg[0];
            angles.beamStepDeg = polar.beamDeg[1] - polar.beamDeg[0];
            angles.lineStartDeg = polar.lineDeg[0];
            angles.lineStepDeg = polar.lineDeg[1] - polar.lineDeg[0];
            const auto png = openScan(folder / "s.png", angles);
            ASSERT_TRUE(png) << png.error().sentence();
            expectAccounted(scan, *png);
            std::string csv;
            for (std::size_t k = 0; k < scan.cells(); ++k) {
                csv += scan.state[k] == CellState::Valid ? std::to_string(static_cast<int>(scan.rangeMm[k])) : std::string("0");
                csv += (k + 1) % static_cast<std::size_t>(scan.beams()) == 0 ? '\n' : ',';
            }
            const auto table = readBytes(csv, ".csv", angles);
            ASSERT_TRUE(table) << table.error().sentence();
            expectAccounted(scan, *table);
        }
    }
}

TEST(CellsAccountedFor, PointsOfOtherProgramsWithZerosAndNaN) {
    // Cell by cell, as drivers write it: missing cells as 0 0 0, as nan, or left out of a list.
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Scan scan = withLoss(Loss::NoReturn, seed);
        for (const bool nan : {false, true}) {
            SCOPED_TRACE(std::to_string(seed) + (nan ? " nan" : " zero"));
            std::string rows;
            const CartesianTables tables(scan);
            for (std::size_t k = 0; k < scan.cells(); ++k) {
                const Eigen::Vector3d p = tables.point(k);
                if (!p.allFinite())
                    rows += nan ? "nan nan nan\n" : "0 0 0\n";
                else
                    rows += numberText("%.7g ", p.x()) + numberText("%.7g ", p.y()) + numberText("%.7g\n", p.z());
            }
            const std::string size = std::to_string(scan.cells());
            const std::string pcd = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                                    std::to_string(scan.beams()) + "\nHEIGHT " + std::to_string(scan.lines()) + "\nPOINTS " + size +
                                    "\nDATA ascii\n" + rows;
            const std::string ply = "ply\nformat ascii 1.0\nelement vertex " + size +
                                    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + rows;
            for (const auto& [text, extension] : {std::pair(pcd, ".pcd"), std::pair(ply, ".ply"), std::pair(rows, ".xyz")}) {
                const auto found = readBytes(text, extension);
                ASSERT_TRUE(found) << extension << found.error().sentence();
                const auto counts = countCells(*found);
                EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), found->cells()) << extension;
                EXPECT_EQ(counts[0], countCells(scan)[0]) << extension << ": no point is lost and none is invented";
                if (found->cells() == scan.cells()) expectAccounted(scan, *found);
            }
        }
    }
}
