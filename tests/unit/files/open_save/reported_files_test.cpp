// Files as other programs and robots send them, each with one peculiarity: they open as the scan that they are.
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/placement.h"
#include "tests/support/bytes.h"
#include "tests/support/point_files.h"
#include "tests/support/point_lists.h"
#include "tests/support/ros_bags.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/typed_angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <functional>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

bool warns(const Scan& scan, std::string_view words) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

class ReportedFiles : public testing::Test {
protected:
    void expectSame(const Result<Scan>& scan, std::string_view warning = {}) {
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected_.rangeMm);
        EXPECT_EQ(scan->state, expected_.state);
        EXPECT_TRUE(warning.empty() || warns(*scan, warning)) << warning;
    }
    static void expectRefused(const Result<Scan>& scan, std::string_view words) {
        ASSERT_FALSE(scan);
        EXPECT_NE(scan.error().sentence().find(words), std::string::npos) << scan.error().sentence();
    }
    /// The points, with `mark` in place of cells without a return.
    [[nodiscard]] std::vector<Eigen::Vector3d> marked(const Eigen::Vector3d& mark) const {
        auto points = points_;
        for (Eigen::Vector3d& p : points) p = p.isZero(0.0) ? mark : p;
        return points;
    }
    [[nodiscard]] std::string list(const std::vector<Eigen::Vector3d>& points) const { return textOf(points, {.format = "%.6f"}); }

    const Scan expected_ = makeScan({.lines = 24, .beams = 28});
    const std::vector<Eigen::Vector3d> points_ = listOf(expected_, {});
};

std::string utf16Of(const std::string& text, bool big, bool mark) {
    std::string wide = !mark ? "" : big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : text) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    return wide;
}

std::string ptxHead(std::size_t columns, std::size_t rows, const std::string& place = "0 0 0",
                    const std::string& matrix = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") {
    return std::to_string(columns) + "\n" + std::to_string(rows) + "\n" + place + "\n1 0 0\n0 1 0\n0 0 1\n" + matrix;
}

TEST_F(ReportedFiles, TextInOtherBytes) {
    const std::string plain = list(points_);
    for (const bool big : {false, true}) {
        for (const bool mark : {false, true}) expectSame(readBytes(utf16Of(plain, big, mark), ".xyz"), "UTF-16");
    }
    expectSame(readBytes("\xEF\xBB\xBF" + plain, ".xyz"));
    expectSame(readBytes(plain + std::string(2000, '\0'), ".xyz"), "2000 bytes of zero (NUL)");
    expectSame(readBytes(plain + "\x1A", ".xyz"));
    std::string wide("\xFF\xFE\0\0", 4);
    for (const char c : plain) wide += std::string{c, '\0', '\0', '\0'};
    expectSame(readBytes(wide, ".xyz"), "UTF-32");
    expectRefused(readBytes(std::string(4096, '\0'), ".xyz"), "only zeros");
    std::string cr = plain;
    std::ranges::replace(cr, '\n', '\r');
    expectSame(readBytes(cr, ".xyz"));
    expectRefused(readBytes("abc\n" + std::string(200, '\0'), ".xyz"), "");
}

TEST_F(ReportedFiles, OnePointForNoReturn) {
    for (const Eigen::Vector3d& mark : {Eigen::Vector3d(-9999, -9999, -9999), Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(0, 0, -9999)}) {
        const std::string text = list(marked(mark));
        expectSame(readBytes(text, ".xyz"), "repeats exactly");
        expectSame(readBytes(ptxHead(24, 28) + textOf(marked(mark), {.format = "%.6f", .lineEnd = " 0.5\n"}), ".ptx"), "repeats exactly");
        const std::string pcd =
            "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 28\nHEIGHT 24\nPOINTS 672\nDATA ascii\n";
        expectSame(readBytes(pcd + text, ".pcd"), "repeats exactly");
        ReadingOptions keep;
        keep.keepRepeated = true;
        const auto kept = readBytes(pcd + text, ".pcd", keep);
        EXPECT_TRUE(!kept || kept->state != expected_.state);
    }
}

TEST_F(ReportedFiles, PtxHeaders) {
    const std::string rows = textOf(points_, {.format = "%.6f", .lineEnd = " 0.5\n"});
    expectSame(readBytes("\xEF\xBB\xBF" + ptxHead(24, 28) + rows, ".ptx"));
    expectSame(readBytes("\n# a comment\n" + ptxHead(24, 28) + rows, ".ptx"));
    expectSame(readBytes("24 28" + ptxHead(24, 28).substr(5) + rows, ".ptx"));
    expectSame(readBytes(ptxHead(28, 24) + rows, ".ptx"), "exchanged");
    const std::string empty = ptxHead(2, 2) + "0 0 0 0.5\n0 0 0 0.5\n0 0 0 0.5\n0 0 0 0.5\n";
    expectSame(readBytes(empty + ptxHead(24, 28) + rows, ".ptx"), "hold no point with a return");
    expectSame(readBytes(ptxHead(0, 0) + ptxHead(24, 28) + rows, ".ptx"), "hold no point with a return");
    const auto byColumns =
        readBytes(ptxHead(24, 28, "1000.5 2000.25 300.125", "1 0 0 1000.5\n0 1 0 2000.25\n0 0 1 300.125\n0 0 0 1\n") + rows, ".ptx");
    expectSame(byColumns, "read by columns");
    ASSERT_TRUE(byColumns && byColumns->placement);
    EXPECT_NEAR(byColumns->placement->originEnhM.y(), 2000.25, 2000); // the origin is a round place near it
    expectSame(readBytes(ptxHead(24, 28, "1000 2000 300") + rows, ".ptx"), "Line 3 of the header");
    const std::string turned = "24\n28\n0 0 0\n0 1 0\n-1 0 0\n0 0 1\n";
    expectSame(readBytes(turned + "0.6 0.8 0 0\n-0.8 0.6 0 0\n0 0 1 0\n0 0 0 1\n" + rows, ".ptx"), "Lines 4 to 6 of the header");
    const auto same = readBytes(turned + "0 1 0 0\n-1 0 0 0\n0 0 1 0\n0 0 0 1\n" + rows, ".ptx");
    expectSame(same);
    EXPECT_FALSE(warns(*same, "Lines 4 to 6"));
}

TEST_F(ReportedFiles, RowsThatAreBeams) {
    const Scan turned = makeScan({.lines = 24, .beams = 28, .noReturns = 0.02});
    std::vector<Eigen::Vector3d> rows(672);
    const auto lines = listOf(turned, {});
    for (std::size_t k = 0; k < 672; ++k)
        rows[k % 28 * 24 + k / 28] = lines[k].isZero(0.0) ? lines[k] : Eigen::Vector3d(lines[k] + Eigen::Vector3d(0.4, 0, 1.2));
    const std::string pcd = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 24\nHEIGHT 28\nPOINTS 672\nDATA ascii\n";
    const auto scan = readBytes(pcd + list(rows), ".pcd");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), 24);
    EXPECT_EQ(countCells(*scan)[0], countCells(turned)[0]);
}

TEST_F(ReportedFiles, PcdWithPaddingThatTakesNoBytes) {
    std::string pcd =
        "VERSION .7\nFIELDS x _ y z _\nSIZE 4 0 4 4 1\nTYPE F U F F U\nCOUNT 1 0 1 1 3\nWIDTH 28\nHEIGHT 24\nPOINTS 672\nDATA binary\n";
    for (const Eigen::Vector3d& p : points_) {
        for (int axis = 0; axis < 3; ++axis) appendValue(pcd, static_cast<float>(p[axis]));
        pcd += std::string(3, '\0');
    }
    expectSame(readBytes(pcd, ".pcd"));
    const std::size_t record = 15, lost = 200;
    const auto cut = readBytes(pcd.substr(0, pcd.size() - lost * record) + std::string(lost * record, '\0'), ".pcd");
    EXPECT_TRUE(cut && warns(*cut, "The last 200 of 672 points hold zeros"));
}

TEST_F(ReportedFiles, PlyWithListsAndOtherElements) {
    const std::string vertex = "element vertex 672\nproperty float x\nproperty float y\nproperty list uchar int rings\nproperty float z\n";
    const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
    for (const bool first : {false, true}) {
        for (const bool binary : {false, true}) {
            std::string bytes = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") + " 1.0\n";
            bytes += (first ? faces + vertex : vertex + faces) + "end_header\n";
            const auto addFaces = [&] {
                for (int n = 0; n < 2; ++n) {
                    if (!binary) bytes += "3 0 1 2\n";
                    if (binary) bytes += '\3';
                    for (int i = 0; i < 3 && binary; ++i) appendValue(bytes, std::int32_t{i});
                }
            };
            if (first) addFaces();
            for (std::size_t n = 0; n < points_.size(); ++n) {
                const std::size_t items = n % 3;
                if (!binary) {
                    bytes += numberText("%.6f ", points_[n].x()) + numberText("%.6f ", points_[n].y()) + std::to_string(items);
                    for (std::size_t i = 0; i < items; ++i) bytes += " 7";
                    bytes += numberText(" %.6f\n", points_[n].z());
                    continue;
                }
                appendValue(bytes, static_cast<float>(points_[n].x()));
                appendValue(bytes, static_cast<float>(points_[n].y()));
                bytes += static_cast<char>(items);
                for (std::size_t i = 0; i < items; ++i) appendValue(bytes, std::int32_t{7});
                appendValue(bytes, static_cast<float>(points_[n].z()));
            }
            if (!first) addFaces();
            SCOPED_TRACE(std::to_string(first) + std::to_string(binary));
            expectSame(readBytes(bytes, ".ply"), "lists");
            expectRefused(readBytes(bytes.substr(0, bytes.size() / 2), ".ply"), "");
        }
    }
    std::string cr =
        "ply\nformat ascii 1.0\nelement vertex 672\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + list(points_);
    std::ranges::replace(cr, '\n', '\r');
    expectSame(readBytes(cr, ".ply"));
}

TEST_F(ReportedFiles, LasUnitsAndReturns) {
    const auto withRecord = [](std::string las, std::uint16_t id, const std::string& content) {
        std::string record(54, '\0');
        std::memcpy(record.data() + 2, "LASF_Projection", 15);
        const auto put = [](std::string& to, std::size_t at, auto value) { std::memcpy(to.data() + at, &value, sizeof value); };
        put(record, 18, id);
        put(record, 20, static_cast<std::uint16_t>(content.size()));
        put(las, 96, static_cast<std::uint32_t>(227 + record.size() + content.size()));
        put(las, 100, std::uint32_t{1});
        return las.insert(227, record + content);
    };
    std::vector<Eigen::Vector3d> feet;
    for (const Eigen::Vector3d& p : points_) feet.emplace_back(p / (1200.0 / 3937.0));
    const std::string las = pointLas(feet, 0.00001);
    const std::string geographic =
        R"(GEOGCS["WGS 84",DATUM["D",SPHEROID["S",6378137,298.25]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
    const std::string wkt = "PROJCS[\"State Plane\"," + geographic + R"(,PROJECTION["Lambert"],UNIT["US survey foot",0.304800609601219]])";
    const auto keys = [](std::initializer_list<int> values) {
        std::string bytes;
        for (const int value : values) appendValue(bytes, static_cast<std::uint16_t>(value));
        return bytes;
    };
    std::vector<std::pair<std::uint16_t, std::string>> records{{2112, wkt}, {34735, keys({1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, 9003})}};
#ifdef EDGESCAN_WITH_PROJ // the system by its number only: Texas Central, alone and with heights
    records.emplace_back(34735, keys({1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 2277}));
    records.emplace_back(34735, keys({1, 1, 0, 3, 1024, 0, 1, 1, 3072, 0, 1, 2277, 4096, 0, 1, 6360}));
    records.emplace_back(34735, keys({1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 6584}));
#endif
    for (const auto& [id, content] : records) {
        const auto scan = readBytes(withRecord(las, id, content), ".las");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->state, expected_.state);
        for (std::size_t k = 0; k < scan->cells(); ++k) EXPECT_NEAR(scan->rangeMm[k], expected_.rangeMm[k], 0.1);
        EXPECT_TRUE(warns(*scan, "converted"));
    }
    expectRefused(readBytes(withRecord(las, 2112, geographic), ".las"), "degrees of longitude and latitude");
}

TEST_F(ReportedFiles, LaterReturnsAreAttached) {
    std::string csv = "x,y,z,return_number\n";
    std::size_t later = 0;
    for (std::size_t n = 0; n < points_.size(); ++n) {
        if (points_[n].isZero(0.0)) continue;
        csv += textOf({points_[n]}, {.format = "%.6f", .separator = ",", .lineEnd = ",1\n"});
        if (n % 5 != 0) continue;
        csv += textOf({points_[n] * 1.2}, {.format = "%.6f", .separator = ",", .lineEnd = ",2\n"});
        ++later;
    }
    const auto scan = readBytes(csv, ".csv");
    expectSame(scan, "later returns");
    EXPECT_EQ(scan->attached.size(), later);
}

TEST_F(ReportedFiles, AxesByTheirNames) {
    const std::vector<Eigen::Vector3d> points = listOf(expected_, {.keepMissing = false});
    const auto under = [&](const std::string& heading, const char* order, const ReadingOptions& options = {}) {
        std::string csv = heading + "\n";
        for (const Eigen::Vector3d& p : points) {
            for (int n = 0; n < 3; ++n) csv += numberText("%.6f", p[order[n] - 'x']) + (n < 2 ? "," : "\n");
        }
        return readBytes(csv, ".csv", options);
    };
    for (const char* heading : {"grid_north,grid_east,grid_rl",
                                "Norden,Osten,H\xc3\xb6he",
                                "Nord,Ost,H\xf6he",
                                "Norr,\xc3\x96st,H\xc3\xb6jd",
                                "Noord,Oost,Hoogte",
                                "Pohjoinen,It\xc3\xa4,Korkeus",
                                "Nord,Est,Quota",
                                "Y_North,X_East,Z_Up",
                                "UTM_N,UTM_E,Ellipsoidal height",
                                "MGA_N,MGA_E,RL",
                                "Mine North,Mine East,Mine RL",
                                "local_y,local_x,local_z",
                                "YP,XP,ZP",
                                "center_y,center_x,center_z",
                                "Y value,X value,Z value",
                                "Y-Koordinate,X-Koordinate,Z-Koordinate",
                                "\xe5\x8c\x97,\xe4\xb8\x9c,\xe9\xab\x98\xe7\xa8\x8b",
                                "\xd0\xa1\xd0\xb5\xd0\xb2\xd0\xb5\xd1\x80,\xd0\x92\xd0\xbe\xd1\x81\xd1\x82\xd0\xbe\xd0\xba,"
                                "\xd0\x92\xd1\x8b\xd1\x81\xd0\xbe\xd1\x82\xd0\xb0",
                                "mN,mE,mRL",
                                "Norte Mina,Este Mina,Cota Mina",
                                "NORTH_MGA2020,EAST_MGA2020,RL_AHD",
                                "N_SWEREF,E_SWEREF,H_RH2000",
                                "YCOLLAR,XCOLLAR,ZCOLLAR",
                                "midy,midx,midz",
                                "y0,x0,z0",
                                "velodyne_y,velodyne_x,velodyne_z",
                                "y_lidar,x_lidar,z_lidar",
                                "Nordkoordinate,Ostkoordinate,Niveau",
                                "ordonn\xc3\xa9\x65,abscisse,altitude",
                                "Y\xe5\xba\xa7\xe6\xa8\x99,X\xe5\xba\xa7\xe6\xa8\x99,Z\xe5\xba\xa7\xe6\xa8\x99",
                                "X(North),Y(East),Z"}) {
        SCOPED_TRACE(heading);
        expectSame(under(heading, "yxz"));
    }
    for (const char* heading : {"Southing,Westing,RL", "North,Right,Over", "first,second,z", "velocity_y,velocity_x,velocity_z", "ny,nx,nz",
                                "\xce\x92\xce\xbf\xcf\x81,\xce\x91\xce\xbd,\xce\xa5\xcf\x88"}) {
        SCOPED_TRACE(heading);
        expectRefused(under(heading, "yxz"), "--columns");
    }
    for (const char* heading : {"col1,col2,col3", "a,b,c"}) expectSame(under(heading, "xyz"), "were taken for them");
    ReadingOptions asked;
    for (const char* columns : {"2,1,3", "Westing,Southing,RL"}) {
        asked.columns = columns;
        expectSame(under("Southing,Westing,RL", "yxz", asked));
    }
    for (const char* columns : {"2,1", "2,1,1", "2,1,4", "a,b,c", "1,2,3,4", ","}) {
        asked.columns = columns;
        expectRefused(under("Southing,Westing,RL", "yxz", asked), "--columns");
    }
}

TEST_F(ReportedFiles, UnitsInCommentsAndDigitsThatAreLost) {
    std::vector<Eigen::Vector3d> feet;
    for (const Eigen::Vector3d& p : points_) feet.emplace_back(p / 0.3048);
    const std::string rows = textOf(feet, {.format = "%.7f"}), table = textOf(feet, {.format = "%.7f", .separator = ","});
    const std::string header =
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 28\nHEIGHT 24\nPOINTS 672\nDATA ascii\n";
    std::string vertices;
    for (const Eigen::Vector3d& p : feet) vertices += p.isZero(0.0) ? "" : "v " + textOf({p}, {.format = "%.7f"});
    for (const auto& [text, extension] : std::initializer_list<std::pair<std::string, const char*>>{
             {"# exported 2026\n# units: feet\n" + rows, ".xyz"},
             {"Unidad: pies\n" + rows, ".xyz"},
             {"# XYZ [ft]\n" + rows, ".xyz"},
             {"# distances in feet\n" + rows, ".xyz"},
             {"x (pieds),y (pieds),z (pieds)\n" + table, ".csv"},
             {"x in ft,y in ft,z in ft\n" + table, ".csv"},
             {"# units: feet\n" + header + rows, ".pcd"},
             {"ply\nformat ascii 1.0\ncomment units: feet\nelement vertex 672\nproperty float x\nproperty float y\nproperty float z\n"
              "end_header\n" +
                  rows,
              ".ply"},
             {"# units: feet\n" + vertices, ".obj"}}) {
        SCOPED_TRACE(text.substr(0, 40));
        const auto scan = readBytes(text, extension);
        ASSERT_TRUE(scan) << scan.error().sentence();
        ASSERT_EQ(scan->cells(), expected_.cells());
        for (std::size_t k = 0; k < scan->cells(); ++k) EXPECT_NEAR(scan->rangeMm[k], expected_.rangeMm[k], 0.1);
    }
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    for (const auto& [format, words] : std::initializer_list<std::pair<const char*, const char*>>{
             {"%.5E", "rounded to 6 digits"}, {"%.7g", "rounded to 7 digits"}, {"%.1f", "are rounded to 0.1"}}) {
        std::string csv = "Easting,Northing,Elevation\n";
        for (const Eigen::Vector3d& p : points_) {
            if (!p.isZero(0.0)) csv += textOf({turned * p + Eigen::Vector3d(498765, 5150120, 285)}, {.format = format, .separator = ","});
        }
        expectRefused(readBytes(csv, ".csv"), words);
    }
}

TEST_F(ReportedFiles, TablesOfMessages) {
    std::string csv = "%time,field.header.frame_id,field.range_max";
    for (int j = 0; j < 28; ++j) csv += ",field.ranges" + std::to_string(j);
    for (int j = 0; j < 28; ++j) csv += ",field.intensities" + std::to_string(j);
    for (int i = 0; i < 24; ++i) {
        csv += "\n" + std::to_string(i) + ",laser,30.0";
        for (int j = 0; j < 28; ++j)
            csv += expected_.rangeMm.at(i, j) > 0 ? "," + numberText("%.3f", static_cast<double>(expected_.rangeMm.at(i, j)) / 1000)
                                                  : std::string(",inf");
        for (int j = 0; j < 28; ++j) csv += ",100";
    }
    expectSame(readBytes(csv + "\n", ".csv", typedAngles(expected_)));
}

TEST_F(ReportedFiles, BagsWithRepeatsAndALimit) {
    const auto open = [](const RosMessages& messages, const ReadingOptions& options = {}) {
        const Bytes bytes = bag1Of(messages);
        return readScanBytes(std::as_bytes(std::span(bytes)), ".bag", options);
    };
    RosMessages twice = rosMessagesOf(expected_);
    const auto once = twice.messages;
    twice.messages.insert(twice.messages.end(), once.begin(), once.end());
    const auto scan = open(twice);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, open(rosMessagesOf(expected_))->rangeMm);
    for (const char* topic : {"/robot/scan", "/tf"})
        EXPECT_TRUE(warns(*scan, std::string(" messages of the topic ") + topic + " are in the bag twice")) << topic;

    RosMessages relayed = rosMessagesOf(expected_), again = rosMessagesOf(expected_, {.jitterNs = {1000}});
    relayed.messages.insert(relayed.messages.end(), again.messages.begin(), again.messages.end());
    const auto restamped = open(relayed);
    ASSERT_TRUE(restamped) << restamped.error().sentence();
    EXPECT_EQ(restamped->rangeMm, scan->rangeMm);

    Scan limited = expected_;
    std::size_t marks = 0;
    for (std::size_t k = 0; k < limited.cells(); ++k) {
        if (limited.state[k] == CellState::Valid) continue;
        limited.state[k] = CellState::Valid;
        limited.rangeMm[k] = 80000; // range_max of rosLaserScan()
        ++marks;
    }
    const auto without = open(rosMessagesOf(limited));
    ASSERT_TRUE(without) << without.error().sentence();
    EXPECT_EQ(countCells(*without)[0], countCells(expected_)[0]);
    EXPECT_TRUE(warns(*without, std::to_string(marks) + " ranges of the topic"));
    for (const double first : {std::nan(""), HUGE_VAL, 1e30})
        expectRefused(open(rosMessagesOf(expected_, {.from = AngleFrom::Joint, .shiftDeg = first})), "its angle_");
}

} // namespace
