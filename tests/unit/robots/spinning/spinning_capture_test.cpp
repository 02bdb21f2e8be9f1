// Captures of scanners that turn all round: points of the data sheets' equations, computed in Python, and damage.
#include "core/files/open_save/open_scan.h"
#include "core/robots/spinning/os_packet.h"
#include "core/robots/spinning/vlp16.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/folders.h"
#include "tests/support/python_peer.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <tuple>

using namespace edgescan;
using namespace edgescan::test;

namespace {

struct Point {
    int line = 0;
    double elevationDeg = 0;
    Eigen::Vector3d atM;
    double rangeMm = 0;
};

std::vector<Point> pointsIn(const std::filesystem::path& path) {
    std::vector<Point> points;
    std::ifstream file(path);
    for (std::string row; std::getline(file, row);) {
        std::ranges::replace(row, ',', ' ');
        std::istringstream words(row);
        double line = 0;
        Point point;
        words >> line >> point.elevationDeg >> point.atM.x() >> point.atM.y() >> point.atM.z() >> point.rangeMm;
        point.line = static_cast<int>(line);
        points.push_back(point);
    }
    return points;
}

bool warns(const Scan& scan, std::string_view words) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

class SpinningCapture : public testing::Test {
protected:
    void SetUp() override {
        if (!pythonIsThere()) GTEST_SKIP() << "needs python3";
        const std::string command = "python3 " + (ownData() / "spinning/make_captures.py").string() + " " + at("").string();
        ASSERT_EQ(std::system(command.c_str()), 0);
    }
    void expectPoints(const Scan& scan, const std::string& name) const {
        const std::vector<Point> points = pointsIn(at(name + ".csv"));
        ASSERT_GT(points.size(), 1000U);
        EXPECT_EQ(countCells(scan)[static_cast<std::size_t>(CellState::Valid)], points.size());
        const auto& polar = std::get<PolarGeometry>(scan.geometry);
        for (const Point& point : points) {
            const auto beam = std::ranges::find_if(polar.beamDeg, [&](double deg) { return std::abs(deg - point.elevationDeg) < 1e-6; });
            ASSERT_NE(beam, polar.beamDeg.end()) << point.elevationDeg;
            const auto j = static_cast<int>(beam - polar.beamDeg.begin());
            ASSERT_EQ(scan.rangeMm.at(point.line, j), static_cast<float>(point.rangeMm)) << name << ' ' << point.line << ' ' << j;
            const Eigen::Vector3d found = pointOfCell(scan, scan.rangeMm.index(point.line, j));
            ASSERT_LT((found - point.atM).norm(), 2e-4) << name << ' ' << point.line << ' ' << j;
        }
    }
    static constexpr std::size_t kHead = 24, kRecordHead = 16, kEthernet = 14, kIp = 20;
    /// The records of a capture of VLP-16 packets, each with its head.
    [[nodiscard]] std::vector<std::string> recordsOf(const std::string& name) const {
        const std::string all = bytesOf(name);
        constexpr std::size_t kRecord = kRecordHead + kEthernet + kIp + 8 + 1206;
        std::vector<std::string> records;
        for (std::size_t from = kHead; from + kRecord <= all.size(); from += kRecord) records.push_back(all.substr(from, kRecord));
        return records;
    }
    [[nodiscard]] Result<Scan> written(const std::vector<std::string>& records) const {
        std::string all = bytesOf("vlp16.pcap").substr(0, kHead);
        for (const std::string& record : records) all += record;
        std::ofstream(at("other.pcap"), std::ios::binary) << all;
        return files::openScan(at("other.pcap"), {});
    }
    /// A piece of the IP packet in a record, from `offset` on, as a record of its own.
    static std::string pieceOf(const std::string& record, unsigned id, std::size_t offset, std::size_t bytes, bool more) {
        constexpr std::size_t kHeads = kRecordHead + kEthernet + kIp;
        std::string piece = record.substr(0, kHeads) + record.substr(kHeads + offset, bytes);
        const auto big = [&](std::size_t place, std::size_t value) {
            piece[kRecordHead + kEthernet + place] = static_cast<char>(value >> 8U);
            piece[kRecordHead + kEthernet + place + 1] = static_cast<char>(value);
        };
        big(2, piece.size() - kRecordHead - kEthernet);
        big(4, id);
        big(6, (more ? 0x2000U : 0U) | offset / 8);
        const auto length = static_cast<std::uint32_t>(piece.size() - kRecordHead);
        for (const std::size_t place : {8U, 12U}) std::memcpy(piece.data() + place, &length, sizeof length);
        return piece;
    }
    static void setSeconds(std::string& record, int later) {
        std::uint32_t seconds = 0;
        std::memcpy(&seconds, record.data(), sizeof seconds);
        seconds += static_cast<std::uint32_t>(later);
        std::memcpy(record.data(), &seconds, sizeof seconds);
    }
    [[nodiscard]] std::string bytesOf(const std::string& name) const {
        std::ifstream in(at(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_ / name; }
    TemporaryFolder folder_;
};

TEST_F(SpinningCapture, AVlp16HasItsBeamsWhereTheDataSheetPutsThem) {
    const auto scan = files::openScan(at("vlp16.pcap"), {});
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->beams(), 16);
    EXPECT_EQ(scan->lines(), 1800);
    ASSERT_TRUE(scan->acquisition);
    EXPECT_EQ(scan->acquisition->model, "VLP-16");
    EXPECT_TRUE(warns(*scan, "2 turns of the scanner; turn 0"));
    expectPoints(*scan, "vlp16");
    ReadingOptions second;
    second.scanIndex = 1;
    const auto rest = files::openScan(at("vlp16.pcap"), second);
    ASSERT_TRUE(rest) << rest.error().sentence();
    EXPECT_EQ(rest->lines(), 888);
}

TEST_F(SpinningCapture, OfTwoReturnsTheStrongestIsTaken) {
    const auto scan = files::openScan(at("vlp16-dual.pcap"), {});
    ASSERT_TRUE(scan) << scan.error().sentence();
    expectPoints(*scan, "vlp16-dual");
    EXPECT_TRUE(warns(*scan, "two returns for each beam"));
}

TEST_F(SpinningCapture, AnOusterHasTheAnglesOfItsMetadata) {
    for (const std::string name : {"os", "os-single"}) {
        const auto scan = files::openScan(at(name + ".pcap"), {});
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->beams(), 16);
        EXPECT_EQ(scan->lines(), 512);
        EXPECT_EQ(scan->state.at(100, 3), CellState::Lost) << "its status is not good";
        EXPECT_TRUE(warns(*scan, "1 line of the turn is missing"));
        expectPoints(*scan, name);
    }
    std::filesystem::remove(at("os.json"));
    EXPECT_NE(files::openScan(at("os.pcap"), {}).error().sentence().find("os.json"), std::string::npos);
}

TEST_F(SpinningCapture, PacketsThatAreMissingAreLostLines) {
    // Every tenth record of the capture is left out.
    const std::vector<std::string> records = recordsOf("vlp16.pcap");
    std::string some = bytesOf("vlp16.pcap").substr(0, kHead);
    for (std::size_t n = 0; n < records.size(); ++n) {
        if (n % 10 != 5) some += records[n];
    }
    std::ofstream(at("some.pcap"), std::ios::binary) << some;
    const auto scan = files::openScan(at("some.pcap"), {});
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), 1800);
    EXPECT_TRUE(warns(*scan, "lines of the turn are missing"));
    EXPECT_EQ(scan->state.at(5 * 24 + 3, 0), CellState::Lost);
    EXPECT_EQ(countCells(*scan)[static_cast<std::size_t>(CellState::Lost)] % 16, 0U);
}

TEST_F(SpinningCapture, RepeatedAndLatePacketsAreTheSameScan) {
    using Records = std::vector<std::string>;
    constexpr std::size_t kAddress = kRecordHead + kEthernet + 12, kPort = kRecordHead + kEthernet + kIp;
    const Records records = recordsOf("vlp16.pcap");
    const auto expected = files::openScan(at("vlp16.pcap"), {});
    ASSERT_TRUE(expected);
    const auto changed = [](std::string record, std::size_t place, std::size_t to) {
        record[place] = static_cast<char>(to);
        return record;
    };
    Records twice, late = records, ports, mirrored, overtaken, fragments, behind = records, backwards(records.rbegin(), records.rend());
    Records shuffled = records;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
    for (std::size_t n = 0; n < records.size(); ++n) {
        twice.insert(twice.end(), 2, records[n]);
        for (const std::size_t port : {n, n + 100}) ports.push_back(changed(records[n], kPort, port));
        Records both{records[n], changed(records[n], kAddress + 3, 77)};
        mirrored.insert(mirrored.end(), both.begin(), both.end());
        if (n % 2 == 1) std::swap(both[0], both[1]);
        overtaken.insert(overtaken.end(), both.begin(), both.end());
        for (const std::size_t from : {0U, 0U, 800U, 800U})
            fragments.push_back(pieceOf(records[n], static_cast<unsigned>(n), from, from == 0 ? 800 : std::string::npos, from == 0));
        behind.push_back(changed(records[n], kAddress + 3, 77)); // a second capture, joined
    }
    for (std::size_t n = 3; n + 2 < late.size(); n += 9) std::swap(late[n], late[n + 2]);
    const char *const kTwice = "packets are in the capture twice", *const kOrder = "came out of order";
    const std::vector<std::tuple<const char*, Records, const char*>> kinds{
        {"twice", twice, kTwice},       {"late", late, kOrder},           {"other ports", ports, kTwice},
        {"mirrored", mirrored, kTwice}, {"overtaken", overtaken, kTwice}, {"fragments", fragments, kTwice},
        {"joined", behind, kTwice},     {"backwards", backwards, kOrder}, {"shuffled", shuffled, kOrder}};
    for (const auto& [name, all, words] : kinds) {
        SCOPED_TRACE(name);
        const auto scan = written(all);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected->rangeMm);
        EXPECT_EQ(scan->state, expected->state);
        EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected->geometry));
        EXPECT_TRUE(warns(*scan, words));
        EXPECT_FALSE(warns(*scan, "lost") || warns(*scan, "missing in part") || warns(*scan, "2 scanners"));
    }
}

TEST_F(SpinningCapture, PiecesOfAnOlderPacketWithTheSameNumberAreNotUsed) {
    const std::vector<std::string> records = recordsOf("vlp16.pcap");
    const auto expected = files::openScan(at("vlp16.pcap"), {});
    ASSERT_TRUE(expected);
    for (const int secondsBefore : {88, 0}) {
        std::vector<std::string> all;
        std::string stale = pieceOf(records[40], 7, 0, 800, true);
        setSeconds(stale, -secondsBefore);
        all.push_back(stale);
        for (std::size_t n = 0; n < records.size(); ++n) {
            const auto id = static_cast<unsigned>(n == 20 ? 7 : 1000 + n);
            all.push_back(pieceOf(records[n], id, 0, 800, true));
            all.push_back(pieceOf(records[n], id, 800, std::string::npos, false));
        }
        const auto scan = written(all);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected->rangeMm) << secondsBefore;
        EXPECT_TRUE(warns(*scan, "1 packet is missing in part"));
    }
}

TEST(SpinningPackets, WhatIsNoPacketIsNoPacket) {
    EXPECT_FALSE(robots::decodeVlp16(Bytes(100)));
    EXPECT_FALSE(robots::decodeVlp16(Bytes(robots::kVlp16PacketBytes)));
    EXPECT_FALSE(robots::osSensor("[]", "x.json"));
    EXPECT_FALSE(robots::osSensor(R"({"beam_altitude_angles":[1,2],"beam_azimuth_angles":[0],"lidar_mode":"512x10"})", "x.json"));
    const auto sensor = robots::osSensor(R"({"beam_altitude_angles":[1],"beam_azimuth_angles":[0],"lidar_mode":"512x10"})", "x.json");
    ASSERT_TRUE(sensor);
    EXPECT_FALSE(robots::decodeOs(Bytes(77), *sensor, 0));
    const auto columns = robots::decodeOs(Bytes(16 * 32), *sensor, 0);
    ASSERT_TRUE(columns);
    EXPECT_TRUE(columns->empty()) << "their status is not good";
}

} // namespace
