// Definitions and messages of ROS, in every serialization; texts and bytes of any kind.
#include "core/robots/bags/bag.h"
#include "tests/support/ros_bags.h"

#include <gtest/gtest.h>

#include <random>

using namespace edgescan;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

constexpr const char* kDefinition = R"(# a comment
uint8 KIND_A=1
string NAME="a # b"   # behind
Header header
uint8 kind
float64 angle # radians
int16[3] three
Part[] parts
string[] names
float32[] values
uint8 tail 7
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: my_msgs/Part
int64 number
bool flag
)";

Bytes written(Wire wire) {
    RosWriter to(wire);
    to.put(std::uint32_t{9}).stamp(5'000'000'007).text("/laser").put(std::uint8_t{2}).put(-1.5);
    for (const int n : {1, -2, 3}) to.put(static_cast<std::int16_t>(n));
    if (to.delimits()) to.put(std::uint32_t{0}); // the length in bytes is not used
    to.put(std::uint32_t{2});
    for (const std::int64_t n : {-7, 8}) to.put(n).put(static_cast<std::uint8_t>(n > 0));
    if (to.delimits()) to.put(std::uint32_t{0});
    to.put(std::uint32_t{2}).text("tilt").text("");
    to.array<float>({0.25F, 1e9F});
    return to.put(std::uint8_t{77}).bytes();
}

} // namespace

TEST(RosMessage, FieldsAreFoundByNameInEverySerialization) {
    const auto definition = rosDefinition("my_msgs/msg/Thing", kDefinition, "test");
    ASSERT_TRUE(definition) << definition.error().sentence();
    for (const Wire wire : {Wire::Ros1, Wire::CdrLittle, Wire::CdrBig, Wire::Cdr2Little, Wire::Cdr2Big}) {
        const Bytes bytes = written(wire);
        const auto message = rosMessage(*definition, wire == Wire::Ros1 ? RosEncoding::Ros1 : RosEncoding::Cdr, bytes, "test");
        ASSERT_TRUE(message) << message.error().sentence();
        EXPECT_EQ(stampNs(*message, "header.stamp"), 5'000'000'007);
        EXPECT_EQ(message->text("header.frame_id"), "/laser");
        EXPECT_EQ(message->number("kind"), 2.0);
        EXPECT_EQ(message->number("angle"), -1.5);
        EXPECT_EQ(message->numbers("three"), (std::vector<double>{1, -2, 3}));
        ASSERT_EQ(message->at("parts")->inside.size(), 2U);
        EXPECT_EQ(message->at("parts")->inside[0].number("number"), -7.0);
        EXPECT_EQ(message->at("parts")->inside[1].number("flag"), 1.0);
        ASSERT_EQ(message->at("names")->inside.size(), 2U);
        EXPECT_EQ(message->at("names")->inside[0].bytes.size(), 4U);
        EXPECT_EQ(message->numbers("values"), (std::vector<double>{0.25, 1e9F}));
        EXPECT_EQ(message->number("tail"), 77.0);
        EXPECT_EQ(message->at("no.such"), nullptr);
        EXPECT_FALSE(message->number("values"));
        for (std::size_t length = 0; length < bytes.size(); ++length)
            EXPECT_FALSE(
                rosMessage(*definition, wire == Wire::Ros1 ? RosEncoding::Ros1 : RosEncoding::Cdr, ByteView(bytes).first(length), "test"))
                << length;
    }
}

TEST(RosMessage, DamagedMessagesCostNoMoreThanTheirBytes) {
    const auto definition = rosDefinition("my_msgs/Thing", kDefinition, "test");
    ASSERT_TRUE(definition);
    std::mt19937 random(5);
    for (int round = 0; round < 20000; ++round) {
        const Wire wire = static_cast<Wire>(round % 5);
        Bytes bytes = written(wire);
        for (int n = 0; n < 3; ++n)
            bytes[4 + random() % (bytes.size() - 4)] = static_cast<std::uint8_t>(random() % 2 == 0 ? 0xFF : random());
        const auto message = rosMessage(*definition, wire == Wire::Ros1 ? RosEncoding::Ros1 : RosEncoding::Cdr, bytes, "test");
        if (message) {
            EXPECT_LE(message->at("parts")->inside.size() + message->at("names")->inside.size(), bytes.size());
            EXPECT_LE(message->numbers("values").size() * 4, bytes.size());
        }
    }
}

TEST(RosMessage, DefinitionsThatCannotBeAreRefused) {
    for (const char* text : {"Part part", "Loop a\n===\nMSG: my_msgs/Loop\nThing b\n===\nMSG: my_msgs/Thing\nLoop a", "float32",
                             "int8[x] a", "===\nfloat32 a", "Thing a"})
        EXPECT_FALSE(rosDefinition("my_msgs/Thing", text, "test")) << text;
    std::string deep = "T1 a\n";
    for (int n = 1; n < 60; ++n) deep += "===\nMSG: my_msgs/T" + std::to_string(n) + "\nT" + std::to_string(n + 1) + " a\n";
    EXPECT_FALSE(rosDefinition("my_msgs/Thing", deep + "===\nMSG: my_msgs/T60\nint8 a\n", "test"));
    EXPECT_TRUE(rosDefinition("my_msgs/Thing", "", "test"));
}

TEST(RosMessage, CommonDefinitionsAreWhole) {
    for (const char* type : {"sensor_msgs/LaserScan", "sensor_msgs/MultiEchoLaserScan", "sensor_msgs/PointCloud2", "sensor_msgs/JointState",
                             "sensor_msgs/Imu", "tf2_msgs/TFMessage", "geometry_msgs/PoseStamped"}) {
        const auto definition = rosDefinition(type, commonRosDefinition(type), "test");
        ASSERT_TRUE(definition) << definition.error().sentence();
        EXPECT_FALSE(definition->types.front().fields.empty());
    }
    EXPECT_TRUE(commonRosDefinition("my_msgs/Thing").empty());
}

TEST(RosBag, CutAndDamagedBagsGiveWhatIsWhole) {
    BagWriter writer;
    const auto topic = writer.topic("/numbers", "std_msgs/UInt32", "uint32 data");
    for (std::uint32_t n = 0; n < 50; ++n) writer.message(topic, n, RosWriter(Wire::Ros1).put(n).bytes());
    const Bytes whole = writer.bag();
    const auto all = readRosBag(whole, "test");
    ASSERT_TRUE(all);
    EXPECT_EQ(all->messages.size(), 50U);
    EXPECT_TRUE(all->warnings.empty());
    std::size_t most = 0;
    for (std::size_t length = 13; length < whole.size(); ++length) {
        const auto cut = readRosBag(ByteView(whole).first(length), "test");
        ASSERT_TRUE(cut) << length;
        EXPECT_GE(cut->messages.size(), most); // never fewer with more bytes
        most = cut->messages.size();
    }
    EXPECT_EQ(most, 49U);
    std::mt19937 random(8);
    for (int round = 0; round < 3000; ++round) {
        Bytes damaged = whole;
        for (int n = 0; n < 4; ++n) damaged[13 + random() % (damaged.size() - 13)] = static_cast<std::uint8_t>(random());
        const auto read = readRosBag(damaged, "test");
        ASSERT_TRUE(read);
        EXPECT_LE(read->messages.size(), damaged.size());
    }
}

#ifdef EDGESCAN_TESTS_SQLITE
TEST(RosBag, CutDatabasesGiveWhatIsWhole) {
    RosMessages all;
    all.topics.push_back({"/numbers", "std_msgs/UInt32", "uint32 data"});
    for (std::uint32_t n = 0; n < 300; ++n) all.message(0, n, RosWriter(Wire::CdrLittle).put(n).bytes());
    const Bytes whole = databaseOf(all);
    const auto read = readRosDatabase(whole, "test");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->messages.size(), 300U);
    EXPECT_TRUE(read->warnings.empty());
    const auto cut = readRosDatabase(ByteView(whole).first(whole.size() * 2 / 3), "test");
    ASSERT_TRUE(cut) << cut.error().sentence();
    EXPECT_GT(cut->messages.size(), 100U);
    ASSERT_EQ(cut->warnings.size(), 1U);
    EXPECT_NE(cut->warnings[0].find("cut off or damaged"), std::string::npos);
}
#endif
