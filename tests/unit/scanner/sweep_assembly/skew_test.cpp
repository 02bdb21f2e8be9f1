// The stepper moves while the mirror sweeps the fan: each beam has its own line angle.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

Scan skewedScan(Axis axis, double direction) {
    Scan scan = makeScan({.axis = axis, .lines = 12, .beams = 30, .seed = 5});
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.lineDirection = direction;
    for (int j = 0; j < 30; ++j) polar.lineSkewDeg.push_back(0.18 * (j * 0.5 + 144) / 360);
    return scan;
}

} // namespace

TEST(LineSkew, EachBeamTurnsByItsOwnAngle) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const double direction : {1.0, -1.0}) {
            const Scan skewed = skewedScan(axis, direction);
            const CartesianTables tables(skewed);
            const auto& skew = std::get<PolarGeometry>(skewed.geometry).lineSkewDeg;
            for (int beam = 0; beam < skewed.beams(); ++beam) {
                Scan plain = skewed; // with this beam's skew in the line angles
                auto& polar = std::get<PolarGeometry>(plain.geometry);
                polar.lineSkewDeg.clear();
                for (double& line : polar.lineDeg) line += skew[static_cast<std::size_t>(beam)];
                const CartesianTables expected(plain);
                for (int line = 0; line < skewed.lines(); ++line) {
                    EXPECT_LT((tables.direction(line, beam) - expected.direction(line, beam)).norm(), 1e-14);
                    const std::size_t k = skewed.rangeMm.index(line, beam);
                    if (skewed.state[k] != CellState::Valid) continue;
                    EXPECT_LT((pointOfCell(skewed, k) - tables.point(k)).norm(), 1e-12);
                }
            }
        }
    }
}

TEST(LineSkew, SurvivesEveryFormat) {
    const Folder folder;
    const Scan scan = skewedScan(Axis::Spin, 1.0);
    for (const char* name : {"a.json", "a.pcd", "a.ply", "a.csv", "a.xyz"}) {
        ASSERT_TRUE(files::saveScan(scan, folder / name, {.choices = {.comments = true}})) << name;
        const auto opened = files::openScan(folder / name);
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(std::get<PolarGeometry>(opened->geometry), std::get<PolarGeometry>(scan.geometry)) << name;
    }
}
