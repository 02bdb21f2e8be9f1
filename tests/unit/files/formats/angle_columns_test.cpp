// Tables of azimuth, elevation and range, in other programs' words and units: the same scan results.
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct AngleTable {
    const char* names;
    const char* row; ///< a and e are replaced by the angles, r by the range, n by the row's number
    double perDegree = 1, perMetre = 1;
    bool surveyed = false; ///< azimuth clockwise from north, height from the zenith
    const char* warning = "";
};

class AngleColumnsTest : public testing::Test {
protected:
    AngleColumnsTest() {
        scan_.rangeMm.at(0, 3) = 0;
        scan_.state.at(0, 3) = CellState::NoReturn;
    }
    std::string textOf(const AngleTable& table, const std::function<double(int line, int beam)>& offDeg, bool beamsOutside) const {
        const auto& polar = std::get<PolarGeometry>(scan_.geometry);
        std::string text = std::string(table.names) + "\n";
        for (int n = 0; n < scan_.lines() * scan_.beams(); ++n) {
            const int line = beamsOutside ? n % scan_.lines() : n / scan_.beams();
            const int beam = beamsOutside ? n / scan_.lines() : n % scan_.beams();
            const double azimuth = polar.lineDeg[static_cast<std::size_t>(line)] + offDeg(line, beam);
            const double elevation = polar.beamDeg[static_cast<std::size_t>(beam)];
            for (const char* c = table.row; *c != '\0'; ++c) {
                if (*c == 'a')
                    text += numberText("%.9f", (table.surveyed ? 90 - azimuth : azimuth) * table.perDegree);
                else if (*c == 'e')
                    text += numberText("%.9f", (table.surveyed ? 90 - elevation : elevation) * table.perDegree);
                else if (*c == 'r')
                    text += numberText("%.6f", static_cast<double>(scan_.rangeMm.at(line, beam)) * 1e-3 * table.perMetre);
                else if (*c == 'n')
                    text += std::to_string(n);
                else
                    text += *c;
            }
            text += '\n';
        }
        return text;
    }
    Result<Scan> opened(
        const AngleTable& table, const std::function<double(int, int)>& offDeg = [](int, int) { return 0.0; }, bool beamsOutside = false) {
        writeText(folder_ / "list.csv", textOf(table, offDeg, beamsOutside));
        return openScan(folder_ / "list.csv");
    }
    void expectSame(const Scan& scan) {
        EXPECT_EQ(scan.rangeMm, scan_.rangeMm);
        EXPECT_EQ(scan.state, scan_.state);
    }

    const Folder folder_;
    Scan scan_ = makeScan({.axis = Axis::Spin, .lineStep = 0.5});
};

constexpr double kGon = 1 / 0.9, kRad = 3.14159265358979323846 / 180;

TEST_F(AngleColumnsTest, InManyWordsAndUnits) {
    for (const AngleTable& table : std::initializer_list<AngleTable>{
             {"azimuth_deg,elevation_deg,range_m", "a,e,r"},
             {"id,azimuth,elevation,distance_mm", "n,a,e,r", 1, 1000, false, "taken as degrees"},
             {"range;azimuth [rad];elevation [rad]", "r;a;e", kRad},
             {"Azimuth(°),Elevation(°),Range(cm)", "a,e,r", 1, 100},
             {"time,az,el,r", "12:00:0n,a,e,r"},
             {"Hz [gon]\tV [gon]\tSchrägdistanz [m]", "a\te\tr", kGon, 1, true, "clockwise from y"},
             {"Azimut (gon);Zenitwinkel (gon);Entfernung (m)", "a;e;r", kGon, 1, true},
             {"acimut_grados,elevacion_grados,distancia_m", "a,e,r"},
             {"Азимут,Угол места,Дальность", "a,e,r"},
             {"方位角,仰角,距离", "a,e,r"},
             {"rango,azimuth_mdeg,elevation_mdeg", "r,a,e", 1000},
             {"azimuth (0.01 deg),elevation (0.01 deg),distance (2 mm)", "a,e,r", 100, 500},
             {"Azimuth [1/100 °],Elevation [1/100 °],Range (0.1 m)", "a,e,r", 100, 10},
             {"azimuth,elevation,range_m", "a,e,r", 100, 1, false, "hundredths of a degree"},
         }) {
        SCOPED_TRACE(table.names);
        const auto scan = opened(table);
        ASSERT_TRUE(scan) << scan.error().sentence();
        expectSame(*scan);
        EXPECT_TRUE(std::ranges::any_of(scan->warnings, [&](const std::string& w) { return w.find(table.warning) != w.npos; }));
    }
}

TEST_F(AngleColumnsTest, ColumnsOfBeamsAreLinesOfOneAzimuth) {
    const auto scan = opened(
        {"azimuth_deg,elevation_deg,range_m", "a,e,r"}, [](int, int) { return 0.0; }, true);
    ASSERT_TRUE(scan) << scan.error().sentence();
    expectSame(*scan);
}

TEST_F(AngleColumnsTest, PointsAreExact) {
    const auto scan = opened({"azimuth_deg,elevation_deg,range_m", "a,e,r"});
    ASSERT_TRUE(scan);
    const CartesianTables expected(scan_), found(*scan);
    for (int line = 0; line < scan_.lines(); ++line)
        for (int beam = 0; beam < scan_.beams(); ++beam)
            EXPECT_NEAR((expected.direction(line, beam) - found.direction(line, beam)).norm(), 0, 1e-9);
}

TEST_F(AngleColumnsTest, BesidesPointsTheyNameTheCells) {
    // Coordinates of whole centimetres show no grid; the angles next to them do.
    std::string text = "range,azimuth_deg,elevation_deg,x,y,z\n";
    const auto& polar = std::get<PolarGeometry>(scan_.geometry);
    const CartesianTables tables(scan_);
    for (int line = 0; line < scan_.lines(); ++line) {
        for (int beam = 0; beam < scan_.beams(); ++beam) {
            if (scan_.state.at(line, beam) != CellState::Valid) continue;
            const double range = static_cast<double>(scan_.rangeMm.at(line, beam)) * 1e-3;
            const Eigen::Vector3d p = tables.direction(line, beam) * range;
            text += numberText("%.3f", range) + "," + numberText("%.3f", polar.lineDeg[static_cast<std::size_t>(line)]) + "," +
                    numberText("%.3f", polar.beamDeg[static_cast<std::size_t>(beam)]);
            for (int axis = 0; axis < 3; ++axis) text += "," + numberText("%.2f", p[axis]);
            text += "\n";
        }
    }
    writeText(folder_ / "list.csv", text);
    const auto scan = openScan(folder_ / "list.csv");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), scan_.lines());
    EXPECT_EQ(scan->beams(), scan_.beams());
    EXPECT_EQ(scan->state, scan_.state);
}

} // namespace
