// Sweeps through ROS bags: the same ranges, cells and angles as the grid that was sent, for both mountings, both directions, every source
// of the angle.
#include "core/containers/ros/bag.h"
#include "core/files/open_save/open_scan.h"
#include "tests/support/ros_bags.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace edgescan;
using namespace edgescan::containers;
using namespace edgescan::test;

namespace {

constexpr std::int64_t kStartNs = 1'700'000'000'250'000'000;
constexpr std::int64_t kLineNs = 40'000'000;
constexpr double kRadian = std::numbers::pi / 180;

enum class AngleFrom { Transform, Joint };

struct Sent {
    Axis axis = Axis::Sweep;
    AngleFrom from = AngleFrom::Transform;
    bool clockwise = false; ///< beams from the largest angle down
    double lineStepDeg = 0.5;
    double shiftDeg = 0;     ///< the laser is turned on its mount, in the plane of its fan
    std::vector<int> left{}; ///< lines that are not sent
};

constexpr const char* kRos1Header = "===\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

std::string ros1Definition(std::string_view type) {
    std::string text(commonRosDefinition(type));
    const std::size_t header = text.find("===\nMSG: std_msgs/Header\n");
    const std::size_t end = text.find("===", header + 3);
    return text.replace(header, (end == std::string::npos ? text.size() : end) - header, kRos1Header);
}

RosWriter& header(RosWriter& to, std::int64_t ns, std::string_view frame) { return to.put(std::uint32_t{0}).stamp(ns).text(frame); }

Bytes laserScan(const Scan& scan, const std::vector<double>& beamDeg, int line, const Sent& sent) {
    std::vector<float> ranges;
    for (int j = 0; j < scan.beams(); ++j) {
        const std::size_t k = scan.rangeMm.index(line, j);
        ranges.push_back(scan.state[k] == CellState::Valid ? static_cast<float>(static_cast<double>(scan.rangeMm[k]) / 1000)
                         : j % 2 == 0                      ? std::numeric_limits<float>::infinity()
                                                           : std::numeric_limits<float>::quiet_NaN());
    }
    double from = (beamDeg.front() + sent.shiftDeg) * kRadian, to = (beamDeg.back() + sent.shiftDeg) * kRadian;
    if (sent.clockwise) {
        std::ranges::reverse(ranges);
        std::swap(from, to);
    }
    RosWriter message(Wire::Ros1);
    header(message, kStartNs + line * kLineNs, "/robot/laser").put(static_cast<float>(from)).put(static_cast<float>(to));
    message.put(static_cast<float>((to - from) / (scan.beams() - 1))).put(0.0F).put(0.04F).put(0.01F).put(80.0F);
    return message.array(ranges).put(std::uint32_t{0}).bytes();
}

Bytes transform(double deg, std::int64_t ns, const Sent& sent) {
    const double half = deg * kRadian / 2, shift = sent.shiftDeg * kRadian;
    // The axis in the laser's frame: its beam at 0 degrees (sweep) or at 90 degrees (spin), before the laser was turned on its mount.
    const double along = sent.axis == Axis::Sweep ? shift : shift + std::numbers::pi / 2;
    RosWriter message(Wire::Ros1);
    message.put(std::uint32_t{1});
    header(message, ns, "mast").text("robot/laser").put(0.0).put(0.0).put(0.0);
    return message.put(std::cos(along) * std::sin(half)).put(std::sin(along) * std::sin(half)).put(0.0).put(std::cos(half)).bytes();
}

Bytes joint(double deg, std::int64_t ns) {
    RosWriter message(Wire::Ros1);
    header(message, ns, "").put(std::uint32_t{2}).text("wheel").text("arm/tilt").array<double>({0.1, deg * kRadian});
    return message.put(std::uint32_t{0}).put(std::uint32_t{0}).bytes();
}

Bytes bagOf(const Scan& scan, const std::vector<double>& beamDeg, const Sent& sent) {
    BagWriter bag;
    const auto lines = bag.topic("/robot/scan", "sensor_msgs/LaserScan", ros1Definition("sensor_msgs/LaserScan"));
    const bool byTransform = sent.from == AngleFrom::Transform;
    const char* type = byTransform ? "tf2_msgs/TFMessage" : "sensor_msgs/JointState";
    const auto angles = bag.topic(byTransform ? "/tf" : "/joint_states", type, ros1Definition(type));
    for (int i = -3; i < 2 * scan.lines() + 3; ++i) {
        const std::int64_t ns = kStartNs + i * kLineNs / 2;
        const double deg = -20 + sent.lineStepDeg * i / 2;
        bag.message(angles, ns, byTransform ? transform(deg, ns, sent) : joint(deg, ns));
    }
    for (int i = 0; i < scan.lines(); ++i) {
        if (std::ranges::find(sent.left, i) == sent.left.end())
            bag.message(lines, kStartNs + i * kLineNs + 3'000'000, laserScan(scan, beamDeg, i, sent));
    }
    return bag.bag();
}

Result<Scan> opened(const Bytes& bytes, const ReadingOptions& options = {}) {
    return files::readScanBytes(std::as_bytes(std::span(bytes)), ".bag", options);
}

std::vector<double> usualBeams(int beams) {
    std::vector<double> deg;
    for (int j = 0; j < beams; ++j) deg.push_back(-45 + 0.5 * j);
    return deg;
}

} // namespace

TEST(RosBagSweep, IsTheGridThatWasSent) {
    const Scan scan = boxesScan(40, 120, 3, 0.05);
    const std::vector<double> beamDeg = usualBeams(scan.beams());
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint}) {
            for (const bool clockwise : {false, true}) {
                for (const double step : {0.5, -0.25}) {
                    for (const double shift : {0.0, 10.0}) {
                        if (shift != 0 && from == AngleFrom::Joint) continue; // a joint does not say how the laser is mounted
                        const Sent sent{axis, from, clockwise, step, shift};
                        ReadingOptions options;
                        if (from == AngleFrom::Joint) options.axis = axis;
                        const auto back = opened(bagOf(scan, beamDeg, sent), options);
                        ASSERT_TRUE(back) << back.error().sentence();
                        EXPECT_EQ(back->rangeMm, scan.rangeMm);
                        EXPECT_EQ(back->state, scan.state);
                        const auto& polar = std::get<PolarGeometry>(back->geometry);
                        EXPECT_EQ(polar.axis, axis);
                        for (int j = 0; j < scan.beams(); ++j)
                            ASSERT_NEAR(polar.beamDeg[static_cast<std::size_t>(j)], beamDeg[static_cast<std::size_t>(j)], 1e-4);
                        for (int i = 1; i < scan.lines(); ++i)
                            ASSERT_NEAR(polar.lineDeg[static_cast<std::size_t>(i)] - polar.lineDeg[static_cast<std::size_t>(i) - 1], step,
                                        1e-9);
                    }
                }
            }
        }
    }
}

TEST(RosBagSweep, LinesThatAreMissingAreLost) {
    const Scan scan = boxesScan(30, 50, 4);
    const auto back = opened(bagOf(scan, usualBeams(50), {.left = {7, 8, 20}}));
    ASSERT_TRUE(back) << back.error().sentence();
    ASSERT_EQ(back->lines(), 30);
    for (int j = 0; j < 50; ++j) EXPECT_EQ(back->state.at(8, j), CellState::Lost);
    EXPECT_TRUE(std::ranges::any_of(back->warnings, [](const std::string& w) {
        return w.find("7 and 8") != std::string::npos || w.find("7 to 8") != std::string::npos;
    }));
}

TEST(RosBagSweep, WithoutAnAngleItIsRefusedAndTheStepOpensIt) {
    const Scan scan = boxesScan(30, 50, 4);
    BagWriter bag;
    const auto lines = bag.topic("/scan", "sensor_msgs/LaserScan", ros1Definition("sensor_msgs/LaserScan"));
    for (int i = 0; i < scan.lines(); ++i) bag.message(lines, kStartNs + i * kLineNs, laserScan(scan, usualBeams(50), i, {}));
    const auto refused = opened(bag.bag());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().hint.find("step from line to line"), std::string::npos);
    ReadingOptions options;
    options.lineStepDeg = 0.5;
    options.axis = Axis::Spin;
    const auto back = opened(bag.bag(), options);
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->rangeMm, scan.rangeMm);
}
