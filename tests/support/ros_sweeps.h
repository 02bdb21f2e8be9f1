// A scan as a laser on ROS would send it: one message of LaserScan for each line, and transforms or a joint for the angle.
#pragma once

#include "core/scan/grid/scan.h"
#include "tests/support/ros_bags.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace edgescan::test {

inline constexpr std::int64_t kRosStartNs = 1'700'000'000'250'000'000;
inline constexpr std::int64_t kRosLineNs = 40'000'000;
inline constexpr double kRadian = std::numbers::pi / 180;

enum class AngleFrom { Transform, Joint, Nothing };

struct RosSweep {
    Axis axis = Axis::Sweep;
    AngleFrom from = AngleFrom::Transform;
    bool clockwise = false;               ///< beams from the largest angle down
    std::vector<double> lineDeg{};        ///< by line; empty: those of the scan
    double shiftDeg = 0;                  ///< the laser is turned on its mount, in the plane of its fan
    std::vector<int> left{};              ///< lines that are not sent
    bool intensities = false;             ///< the line's number for each beam
    double beamS = 0;                     ///< time_increment
    std::vector<std::int64_t> jitterNs{}; ///< of the stamps, over and over
    std::string scanTopic = "/robot/scan", frame = "/robot/laser", joint = "arm/tilt";
    Wire wire = Wire::Ros1;
};

inline Bytes rosLaserScan(const Scan& scan, const std::vector<double>& beamDeg, int line, const RosSweep& sent) {
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
    const std::int64_t jitter = sent.jitterNs.empty() ? 0 : sent.jitterNs[static_cast<std::size_t>(line) % sent.jitterNs.size()];
    RosWriter message(sent.wire);
    message.header(kRosStartNs + line * kRosLineNs + jitter, sent.frame).put(static_cast<float>(from)).put(static_cast<float>(to));
    message.put(static_cast<float>((to - from) / (scan.beams() - 1))).put(static_cast<float>(sent.beamS));
    message.put(0.04F).put(0.01F).put(80.0F).array(ranges);
    const std::vector<float> strengths(sent.intensities ? ranges.size() : 0, static_cast<float>(line));
    return message.array(strengths).bytes();
}

inline Bytes rosTransform(double deg, std::int64_t ns, const RosSweep& sent) {
    const double half = deg * kRadian / 2, shift = sent.shiftDeg * kRadian;
    // The axis in the laser's frame: its beam at 0 degrees (sweep) or at 90 degrees (spin), before the laser was turned on its mount.
    const double along = sent.axis == Axis::Sweep ? shift : shift + std::numbers::pi / 2;
    const std::string_view child = std::string_view(sent.frame).substr(sent.frame.starts_with('/') ? 1 : 0);
    RosWriter message(sent.wire);
    message.count(1).header(ns, "mast").text(child).put(0.0).put(0.0).put(0.0);
    return message.put(std::cos(along) * std::sin(half)).put(std::sin(along) * std::sin(half)).put(0.0).put(std::cos(half)).bytes();
}

inline Bytes rosJoint(double deg, std::int64_t ns, const RosSweep& sent) {
    RosWriter message(sent.wire);
    message.header(ns, "").count(2).text("wheel").text(sent.joint).array<double>({0.1, deg * kRadian});
    return message.put(std::uint32_t{0}).put(std::uint32_t{0}).bytes();
}

/// Two angles for each line, from three before the first line on, and the lines 3 ms behind their stamps.
inline RosMessages rosMessagesOf(const Scan& scan, const RosSweep& sent = {}) {
    const auto& polar = std::get<PolarGeometry>(scan.geometry);
    const std::vector<double>& lineDeg = sent.lineDeg.empty() ? polar.lineDeg : sent.lineDeg;
    const int last = scan.lines() - 1;
    const auto degAt = [&](double line) {
        const int row = std::clamp(static_cast<int>(std::floor(line)), 0, std::max(0, last - 1));
        const auto at = [&](int n) { return lineDeg[static_cast<std::size_t>(std::min(n, last))]; };
        return at(row) + (at(row + 1) - at(row)) * (line - row);
    };
    RosMessages bag;
    const auto lines = bag.topic(sent.scanTopic, "sensor_msgs/LaserScan", sent.wire);
    const bool byTransform = sent.from == AngleFrom::Transform;
    const auto angles = sent.from == AngleFrom::Nothing ? lines
                        : byTransform                   ? bag.topic("/tf", "tf2_msgs/TFMessage", sent.wire)
                                                        : bag.topic("/joint_states", "sensor_msgs/JointState", sent.wire);
    for (int i = -3; i < 2 * scan.lines() + 3 && sent.from != AngleFrom::Nothing; ++i) {
        const std::int64_t ns = kRosStartNs + i * kRosLineNs / 2;
        bag.message(angles, ns, byTransform ? rosTransform(degAt(i / 2.0), ns, sent) : rosJoint(degAt(i / 2.0), ns, sent));
    }
    for (int i = 0; i < scan.lines(); ++i) {
        if (std::ranges::find(sent.left, i) == sent.left.end())
            bag.message(lines, kRosStartNs + i * kRosLineNs + 3'000'000, rosLaserScan(scan, polar.beamDeg, i, sent));
    }
    return bag;
}

} // namespace edgescan::test
