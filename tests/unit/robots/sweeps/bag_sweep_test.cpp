// Sweeps through ROS bags: the same ranges, cells and angles as the grid that was sent, for both mountings, both directions, every source
// of the angle, every container and serialization.
#include "core/files/open_save/open_scan.h"
#include "core/robots/bags/bag.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/placement.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace edgescan;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

Result<Scan> opened(const Bytes& bytes, const ReadingOptions& options = {}) {
    return files::readScanBytes(std::as_bytes(std::span(bytes)), ".bag", options);
}

bool warns(const Scan& scan, std::string_view words) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

Scan boxes(int lines, int beams, double lineStepDeg = 0.5, Axis axis = Axis::Sweep) {
    Scan scan = boxesScan(lines, beams, 3, 0.05);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = axis;
    for (int i = 0; i < lines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -20 + lineStepDeg * i;
    return scan;
}

void expectSame(const Scan& back, const Scan& sent) {
    EXPECT_EQ(back.rangeMm, sent.rangeMm);
    EXPECT_EQ(back.state, sent.state);
    const auto &was = std::get<PolarGeometry>(sent.geometry), &is = std::get<PolarGeometry>(back.geometry);
    EXPECT_EQ(is.axis, was.axis);
    ASSERT_EQ(is.beamDeg.size(), was.beamDeg.size());
    ASSERT_EQ(is.lineDeg.size(), was.lineDeg.size());
    for (std::size_t j = 0; j < was.beamDeg.size(); ++j) ASSERT_NEAR(is.beamDeg[j], was.beamDeg[j], 1e-5);
}

} // namespace

TEST(RosBagSweep, IsTheGridThatWasSent) {
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint}) {
            for (const bool clockwise : {false, true}) {
                for (const double step : {0.5, -0.25}) {
                    for (const double shift : {0.0, 10.0}) {
                        if (shift != 0 && from == AngleFrom::Joint) continue; // a joint does not say how the laser is mounted
                        const Scan scan = boxes(40, 120, step, axis);
                        const RosSweep sent{.axis = axis, .from = from, .clockwise = clockwise, .shiftDeg = shift};
                        ReadingOptions options;
                        if (from == AngleFrom::Joint) options.axis = axis;
                        const auto back = opened(bag1Of(rosMessagesOf(scan, sent)), options);
                        ASSERT_TRUE(back) << back.error().sentence();
                        expectSame(*back, scan);
                        const auto& polar = std::get<PolarGeometry>(back->geometry);
                        for (int i = 0; i < scan.lines(); ++i) // the line was measured 3 ms behind the angle that it was made with
                            ASSERT_NEAR(polar.lineDeg[static_cast<std::size_t>(i)], -20 + step * i, 1e-9);
                    }
                }
            }
        }
    }
}

TEST(RosBagSweep, IsTheSameInEveryContainerAndSerialization) {
    const Scan scan = boxes(30, 80);
    for (const Wire wire : {Wire::CdrLittle, Wire::CdrBig, Wire::Cdr2Little, Wire::Cdr2Big}) {
        const RosMessages messages = rosMessagesOf(scan, {.intensities = true, .wire = wire});
        std::vector<Bytes> bags{mcapOf(messages)};
#ifdef EDGESCAN_TESTS_SQLITE
        bags.push_back(databaseOf(messages));
        bags.push_back(databaseOf(messages, false));
#endif
        for (const Bytes& bag : bags) {
            const auto back = opened(bag);
            ASSERT_TRUE(back) << back.error().sentence();
            expectSame(*back, scan);
            EXPECT_EQ(back->intensity.at(7, 3), 7.0F);
            EXPECT_TRUE(back->format.starts_with("ROS 2 bag")) << back->format;
        }
    }
    const auto plain = opened(bag1Of(rosMessagesOf(scan)));
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->intensity.size(), 0U);
    EXPECT_EQ(plain->format, "ROS 1 bag");
}

TEST(RosBagSweep, LinesThatAreMissingAreLost) {
    const Scan scan = boxes(60, 50);
    const auto back = opened(bag1Of(rosMessagesOf(scan, {.left = {7, 8, 20}})));
    ASSERT_TRUE(back) << back.error().sentence();
    ASSERT_EQ(back->lines(), 60);
    for (int j = 0; j < 50; ++j) EXPECT_EQ(back->state.at(8, j), CellState::Lost);
    EXPECT_TRUE(warns(*back, "lines 7 to 8, 20"));
}

TEST(RosBagSweep, StampsThatJitterLoseNothing) {
    const Scan scan = boxes(60, 50);
    const std::vector<std::int64_t> jitter{0, 24'000'000, 3'000'000, -9'000'000, 30'000'000, 0, 11'000'000};
    const auto back = opened(bag1Of(rosMessagesOf(scan, {.jitterNs = jitter})));
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->lines(), 60);
    EXPECT_EQ(back->rangeMm, scan.rangeMm);
    EXPECT_FALSE(warns(*back, "lost"));
}

TEST(RosBagSweep, WithoutAnAngleItIsRefusedAndTheStepOpensIt) {
    const Scan scan = boxes(30, 50);
    const Bytes bag = bag1Of(rosMessagesOf(scan, {.from = AngleFrom::Nothing}));
    const auto refused = opened(bag);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().hint.find("--line-step"), std::string::npos) << refused.error().sentence();
    ReadingOptions options;
    options.lineStepDeg = 0.5;
    options.axis = Axis::Sweep;
    const auto back = opened(bag, options);
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->rangeMm, scan.rangeMm);
}

TEST(RosBagSweep, SweepsUpAndDownAreSeveralAndEachIsItself) {
    const int half = 40;
    Scan scan = boxes(2 * half, 60);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (int i = 0; i < 2 * half; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = 0.5 * (i < half ? i : 2 * half - 1 - i);
    for (const std::size_t number : {std::size_t{0}, std::size_t{1}}) {
        ReadingOptions options;
        options.scanIndex = number;
        const auto back = opened(bag1Of(rosMessagesOf(scan)), options);
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_NEAR(back->lines(), half, 1);
        const auto& found = std::get<PolarGeometry>(back->geometry);
        EXPECT_EQ(found.lineDeg[20] > found.lineDeg[10], number == 0);
        EXPECT_TRUE(warns(*back, "2 sweeps"));
    }
}

TEST(RosBagSweep, BeamsThatWereMeasuredLaterAreFurtherOn) {
    const Scan scan = boxes(40, 61);
    for (const bool clockwise : {false, true}) {
        const auto back = opened(bag1Of(rosMessagesOf(scan, {.clockwise = clockwise, .beamS = 1e-4})));
        ASSERT_TRUE(back) << back.error().sentence();
        const auto& skew = std::get<PolarGeometry>(back->geometry).lineSkewDeg;
        ASSERT_EQ(skew.size(), 61U);
        // The stepper turns 0.5 degrees in 40 ms, and a fan of 61 beams takes 6 ms.
        EXPECT_NEAR(skew[clockwise ? 60 : 0], 0, 1e-6);
        EXPECT_NEAR(skew[clockwise ? 0 : 60], 0.5 * 6 / 40, 1e-6);
    }
}

TEST(RosBagSweep, PointsAreThoseOfTheTransforms) {
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        const Scan scan = boxes(20, 40, 3, axis);
        const auto back = opened(bag1Of(rosMessagesOf(scan, {.axis = axis, .shiftDeg = 7})));
        ASSERT_TRUE(back) << back.error().sentence();
        const CartesianTables was(scan), is(*back);
        for (const auto& [line, beam] : {std::pair{0, 0}, {19, 39}, {7, 20}})
            EXPECT_LT((was.point(line, beam) - is.point(line, beam)).norm(), 1e-5);
    }
}

TEST(RosBagSweep, TransformsToAMapPlaceIt) {
    const Eigen::Vector3d mast(498765.25, 5150123.5, -287.75);
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        for (const double shift : {7.0, 173.0, -90.0}) { // the second turns the axis round, the third is usual on ROS
            const Scan scan = boxes(20, 40, 3, axis);
            const RosSweep sent{.axis = axis, .shiftDeg = shift};
            RosMessages messages = rosMessagesOf(scan, sent);
            const auto fixed = messages.topic("/tf_static", "tf2_msgs/TFMessage", Wire::Ros1);
            RosWriter link(Wire::Ros1);
            link.count(1).header(kRosStartNs, "map").text("mast").put(mast.x()).put(mast.y()).put(mast.z());
            link.put(0.0).put(0.0).put(std::sin(15 * kRadian)).put(std::cos(15 * kRadian)); // 30 degrees about up
            messages.message(fixed, kRosStartNs, link.bytes());
            const auto back = opened(bag1Of(messages));
            ASSERT_TRUE(back) << back.error().sentence();
            ASSERT_TRUE(back->placement);
            expectSame(*back, scan);
            ASSERT_EQ(back->placement->warnings.size(), 1U);
            EXPECT_TRUE(back->placement->warnings[0].starts_with("GUESS: the frame map"));
            EXPECT_EQ(back->placement->poses.size(), 1U);
            const auto& polar = std::get<PolarGeometry>(scan.geometry);
            for (const auto& [line, beam] : {std::pair{0, 5}, {19, 39}, {7, 20}}) {
                const std::size_t k = scan.rangeMm.index(line, beam);
                if (scan.state[k] != CellState::Valid) continue;
                const double along = (axis == Axis::Sweep ? shift : shift + 90) * kRadian;
                const Eigen::AngleAxisd turn(polar.lineDeg[static_cast<std::size_t>(line)] * kRadian,
                                             Eigen::Vector3d(std::cos(along), std::sin(along), 0));
                const double a = (polar.beamDeg[static_cast<std::size_t>(beam)] + shift) * kRadian;
                const double r = static_cast<double>(scan.rangeMm[k]) / 1000;
                const Eigen::Vector3d expected = mast + Eigen::AngleAxisd(30 * kRadian, Eigen::Vector3d::UnitZ()) *
                                                            (turn * Eigen::Vector3d(r * std::cos(a), r * std::sin(a), 0));
                EXPECT_LT((minePoint(*back, k).enhM - expected).norm(), 1e-5) << line << ' ' << beam << ' ' << shift;
            }
        }
    }
}

TEST(RosBagSweep, PosesInAMapPlaceItWhereNoTransformDoes) {
    const Scan scan = boxes(20, 40, 3);
    RosMessages messages = rosMessagesOf(scan);
    const auto poses = messages.topic("/robot/pose", "geometry_msgs/PoseStamped", Wire::Ros1);
    const auto goals = messages.topic("/camera/pose", "geometry_msgs/PoseStamped", Wire::Ros1);
    const auto pose = [&](std::uint32_t topic, const char* frame, double x) {
        RosWriter writer(Wire::Ros1);
        writer.header(kRosStartNs, frame).put(x).put(200.0).put(30.0).put(0.0).put(0.0).put(0.0).put(1.0);
        messages.message(topic, kRosStartNs, writer.bytes());
    };
    pose(goals, "camera", 5.0); // of another frame
    pose(poses, "/mine", 100.0);
    const auto back = opened(bag1Of(messages));
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_TRUE(warns(*back, "GUESS: the poses of the topic /robot/pose are those of the frame mast"));
    ASSERT_TRUE(back->placement);
    EXPECT_NEAR((back->placement->originEnhM + back->placement->poses[0].translationM).x(), 100.0, 1e-6);
    expectSame(*back, scan);
}

TEST(RosBagSweep, TopicAndJointAreChosenByName) {
    const Scan scan = boxes(30, 50);
    RosMessages messages = rosMessagesOf(scan, {.from = AngleFrom::Joint});
    const auto other = messages.topic("/front scan", "sensor_msgs/LaserScan", Wire::Ros1);
    messages.message(other, kRosStartNs, rosLaserScan(scan, std::get<PolarGeometry>(scan.geometry).beamDeg, 3, {}));
    const auto fixed = messages.topic("/fixed", "sensor_msgs/LaserScan", Wire::Ros1);
    for (int n = 0; n < 300; ++n)
        messages.message(fixed, kRosStartNs + n, rosLaserScan(scan, std::get<PolarGeometry>(scan.geometry).beamDeg, 3, {}));
    ReadingOptions options;
    const auto guessed = opened(bag1Of(messages), options);
    ASSERT_TRUE(guessed) << guessed.error().sentence();
    EXPECT_TRUE(warns(*guessed, "GUESS: the topic /robot/scan"));
    EXPECT_EQ(guessed->rangeMm, scan.rangeMm);
    EXPECT_TRUE(warns(*guessed, "/front scan (sensor_msgs/LaserScan, 1 message)"));
    EXPECT_TRUE(warns(*guessed, "GUESS: the angle of each line comes from the joint arm/tilt"));
    options.topic = "/robot/scan";
    options.joint = "arm/tilt";
    const auto said = opened(bag1Of(messages), options);
    ASSERT_TRUE(said);
    EXPECT_FALSE(warns(*said, "GUESS"));
    options.joint = "elbow";
    EXPECT_NE(opened(bag1Of(messages), options).error().sentence().find("arm/tilt"), std::string::npos);
    options.topic = "/scan";
    EXPECT_NE(opened(bag1Of(messages), options).error().sentence().find("/robot/scan"), std::string::npos);
}

// A robot with a laser at rest, which sends more, and one that tilts: the one that is turned opens, and its axis follows from the name.
TEST(RosBagSweep, OfSeveralLasersTheOneThatIsTurnedOpens) {
    const Scan scan = boxes(40, 60);
    for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint}) {
        const RosSweep sent{.from = from,
                            .scanTopic = "/robot_1/tilt_scan",
                            .frame = "/robot_1/laser_tilt_link",
                            .joint = "robot_1/laser_tilt_mount_joint"};
        RosMessages messages = rosMessagesOf(scan, sent);
        const auto base = messages.topic("/robot_1/base_scan", "sensor_msgs/LaserScan", Wire::Ros1);
        const Scan wall = boxes(2, 200);
        const auto& beamDeg = std::get<PolarGeometry>(wall.geometry).beamDeg;
        for (int n = 0; n < 100; ++n) {
            Bytes line = rosLaserScan(wall, beamDeg, 0, {.frame = "/robot_1/base_laser"});
            const std::int64_t ns = kRosStartNs + n * kRosLineNs / 2;
            const auto sec = static_cast<std::uint32_t>(ns / 1'000'000'000), rest = static_cast<std::uint32_t>(ns % 1'000'000'000);
            std::memcpy(line.data() + 4, &sec, 4);
            std::memcpy(line.data() + 8, &rest, 4);
            messages.message(base, ns, line);
        }
        const auto back = opened(bag1Of(messages));
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_TRUE(warns(*back, "GUESS: the topic /robot_1/tilt_scan"));
        expectSame(*back, scan);
        EXPECT_EQ(warns(*back, "ASSUMED: the axis (sweep, by the name of the joint)"), from == AngleFrom::Joint);
    }
}
