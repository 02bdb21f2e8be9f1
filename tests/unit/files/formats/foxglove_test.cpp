// Clouds for Foxglove: the content of the messages, read without the reader of the format.
#include "core/base/base64.h"
#include "core/base/utc_time.h"
#include "core/containers/mcap/reader.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/cloud_columns.h"
#include "core/scan/grid/acquisition.h"
#include "tests/support/bytes.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct Message {
    std::string topic, schema;
    std::uint64_t ns = 0;
    nlohmann::json content;
};

std::vector<Message> messagesOf(const std::string& file) {
    const auto content = containers::readMcap({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, "test");
    EXPECT_TRUE(content) << content.error().sentence();
    EXPECT_TRUE(content->clean);
    std::vector<Message> messages;
    for (const containers::McapMessage& message : content->messages) {
        const containers::McapChannel& channel = *containers::channelOf(*content, message);
        messages.push_back({channel.topic, content->schemas.at(channel.schema).name, message.logNs,
                            nlohmann::json::parse(message.payload.begin(), message.payload.end())});
    }
    return messages;
}

std::size_t pointsIn(const Message& message) {
    return bytesOfBase64(message.content["data"].get<std::string>())->size() / message.content["point_stride"].get<std::size_t>();
}

template <class T>
T numberIn(const Message& message, std::size_t point, const char* name) {
    const std::string bytes = *bytesOfBase64(message.content["data"].get<std::string>());
    for (const auto& field : message.content["fields"]) {
        if (field["name"] == name)
            return test::valueAt<T>(bytes, point * message.content["point_stride"].get<std::size_t>() + field["offset"].get<std::size_t>());
    }
    ADD_FAILURE() << "no field " << name;
    return {};
}

Scan timedScan() {
    Scan scan = makeScan({.lines = 12, .beams = 40, .noReturns = 0.2, .seed = 3});
    Acquisition acquisition;
    for (int line = 0; line < scan.lines(); ++line) acquisition.lineTimesS.push_back(1.75e9 + 0.04 * line);
    scan.acquisition = std::make_shared<const Acquisition>(acquisition);
    return scan;
}

} // namespace

TEST(Base64, EveryLengthComesBackAndOtherTextIsRefused) {
    std::string bytes;
    for (int n = 0; n < 300; ++n) {
        EXPECT_EQ(bytesOfBase64(base64(bytes)), bytes);
        bytes += static_cast<char>(n * 37);
    }
    EXPECT_EQ(base64("Man"), "TWFu");
    EXPECT_EQ(base64("Ma"), "TWE=");
    EXPECT_EQ(base64("M"), "TQ==");
    for (const char* wrong : {"TQ=", "T", "TQ\n=", "T===", "TQ==TQ==", "\xff\xff\xff\xff"}) EXPECT_FALSE(bytesOfBase64(wrong)) << wrong;
}

TEST(Foxglove, LinesComeAtTheirTimesAndTheCloudAtTheEnd) {
    const Scan scan = timedScan();
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    std::size_t edges = 0;
    for (std::size_t k = 0; k < mask.size(); k += 5) {
        mask[k] = 255;
        edges += scan.state[k] == CellState::Valid ? 1 : 0;
    }
    const auto bytes = cloudBytes(scan, "cloud.foxglove.mcap", &mask);
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    std::size_t ofLines = 0, lines = 0;
    for (const Message& message : messagesOf(*bytes)) {
        EXPECT_EQ(message.schema, "foxglove.PointCloud");
        EXPECT_EQ(message.content["frame_id"], "scanner");
        EXPECT_EQ(message.content["timestamp"]["sec"].get<std::uint64_t>() * 1'000'000'000 +
                      message.content["timestamp"]["nsec"].get<std::uint64_t>(),
                  message.ns);
        if (message.topic == "/edgescan/lines") {
            ++lines;
            ofLines += pointsIn(message);
            const auto line = numberIn<std::uint32_t>(message, 0, "line");
            EXPECT_EQ(numberIn<std::uint32_t>(message, pointsIn(message) - 1, "line"), line);
            EXPECT_NEAR(static_cast<double>(message.ns) * 1e-9, scan.acquisition->lineTimesS[line], 1e-6);
        } else {
            EXPECT_NEAR(static_cast<double>(message.ns) * 1e-9, scan.acquisition->lineTimesS.back(), 1e-6);
            EXPECT_EQ(pointsIn(message), message.topic == "/edgescan/edges" ? edges : countCells(scan)[0]);
        }
    }
    EXPECT_EQ(lines, 12U);
    EXPECT_EQ(ofLines, countCells(scan)[0]);
}

TEST(Foxglove, ATimeThatOnlyThePoseStatesIsTheTimeOfTheMessages) {
    Scan scan = makeScan({.lines = 9, .beams = 30, .seed = 3});
    Placement placement = *randomPlacement(3, 1, false);
    const auto beginsAt = [&] {
        scan.placement = std::make_shared<const Placement>(placement);
        std::vector<double> seconds;
        for (const char* name : {"cloud.foxglove.mcap", "cloud.mcap"}) {
            const auto files = scanFiles(scan, name);
            EXPECT_TRUE(files) << files.error().sentence();
            const std::string& bytes = files->front().bytes;
            const auto content = containers::readMcap({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name);
            seconds.push_back(std::floor(static_cast<double>(content->messages.front().logNs) * 1e-9));
        }
        EXPECT_EQ(seconds[0], seconds[1]);
        return seconds[0];
    };
    placement.scanStartUtc = "2026-11-20T10:00:00.000Z";
    EXPECT_EQ(beginsAt(), *parseUtc(placement.scanStartUtc));
    placement.scanStartUtc.clear();
    EXPECT_EQ(beginsAt(), std::floor(*parseUtc(placement.timeUtc)));
    placement.timeUtc.clear();
    EXPECT_EQ(beginsAt(), 1) << "no time is known";
}

TEST(Foxglove, PointsAndTransformsGiveTheMineCoordinates) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Scan scan = makeScan({.lines = 9, .beams = 30, .seed = seed});
        scan.placement = randomPlacement(seed, 1, false);
        const auto bytes = cloudBytes(scan, "cloud.foxglove.mcap", nullptr, {.frame = CoordinateFrame::Mine});
        ASSERT_TRUE(bytes) << bytes.error().sentence();
        const auto messages = messagesOf(*bytes);
        ASSERT_EQ(messages.size(), 3U);
        const auto transformOf = [](const Message& message) {
            const auto& shift = message.content["translation"];
            const auto& turn = message.content["rotation"];
            return Eigen::Translation3d(shift["x"], shift["y"], shift["z"]) *
                   Eigen::Quaterniond(turn["w"], turn["x"], turn["y"], turn["z"]);
        };
        EXPECT_EQ(messages[0].content["parent_frame_id"], "mine");
        EXPECT_EQ(messages[1].content["child_frame_id"], "scanner");
        EXPECT_EQ(messages[2].content["frame_id"], messages[0].content["child_frame_id"]);
        const CloudColumns mine = validPoints(scan, nullptr, CoordinateFrame::Mine);
        const auto& eastings = std::get<std::vector<double>>(mine.columns[0].values);
        const Eigen::Isometry3d toMine(transformOf(messages[0]));
        for (std::size_t n = 0; n < eastings.size(); ++n) {
            const Eigen::Vector3d local(numberIn<float>(messages[2], n, "x"), numberIn<float>(messages[2], n, "y"),
                                        numberIn<float>(messages[2], n, "z"));
            const Eigen::Vector3d there = toMine * local;
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(there[static_cast<Eigen::Index>(axis)], std::get<std::vector<double>>(mine.columns[axis].values)[n], 1e-5);
        }
        // The scanner's own position, through both transforms.
        const Eigen::Vector3d sensor = toMine * (Eigen::Isometry3d(transformOf(messages[1])) * Eigen::Vector3d::Zero());
        EXPECT_LT((sensor - mine.sensorM).norm(), 1e-6);
    }
}

TEST(Foxglove, DamageIsRefused) {
    const Scan scan = timedScan();
    const std::string whole = *cloudBytes(scan, "cloud.foxglove.mcap", nullptr);
    ASSERT_TRUE(readBytes(whole, ".mcap"));
    EXPECT_FALSE(refusalOf(whole.substr(0, whole.size() / 2), ".mcap").empty());
    std::string other = whole;
    const std::size_t at = other.find("width");
    ASSERT_NE(at, std::string::npos);
    other[at + 9] = '9'; // the first digit of the number of points
    EXPECT_NE(refusalOf(other, ".mcap").find("promises"), std::string::npos) << refusalOf(other, ".mcap");
}

TEST(Foxglove, TheLongestExtensionChoosesTheFormat) {
    EXPECT_STREQ(writtenFormat("a.FOXGLOVE.mcap")->title, "Foxglove, Lichtblick");
    EXPECT_STREQ(writtenFormat("foxglove.mcap")->title, "Recording");
    EXPECT_STREQ(writtenFormat("a.mcap")->title, "Recording");
    EXPECT_EQ(writtenFormat(".pcd"), nullptr);
    EXPECT_EQ(writtenFormat("pcd"), nullptr);
}
