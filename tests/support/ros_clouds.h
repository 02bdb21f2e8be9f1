// Clouds as scanners of several beams on ROS send them.
#pragma once

#include "tests/support/ros_sweeps.h"

#include <algorithm>
#include <cmath>

namespace edgescan::test {

inline constexpr int kRings = 16, kFirings = 360;

struct RosPoint {
    float x = 0, y = 0, z = 0, intensity = 0;
    std::uint16_t ring = 0;
    float time = 0;
};

/// A room of 8 x 6 x 5 m around a scanner of 16 rings from -15 to 15 degrees.
inline RosPoint pointOf(int ring, int firing, double offsetDeg = 0) {
    const double up = (2 * ring - 15) * kRadian, round = (firing + offsetDeg) * kRadian;
    const double x = std::cos(up) * std::cos(round), y = std::cos(up) * std::sin(round), z = std::sin(up);
    const double range = std::min({4 / std::abs(x), 3 / std::abs(y), 2.5 / std::abs(z)});
    return {static_cast<float>(range * x), static_cast<float>(range * y),    static_cast<float>(range * z),
            static_cast<float>(ring),      static_cast<std::uint16_t>(ring), static_cast<float>(firing * 55.296e-6 + ring * 2.304e-6)};
}

inline bool isMissing(int ring, int firing) { return (firing * 7 + ring * 3) % 23 == 0; }

/// sensor_msgs/PointCloud2. `height`: 1 is a list of points.
inline Bytes cloudOf(const std::vector<RosPoint>& points, std::uint32_t height, Wire wire) {
    RosWriter message(wire);
    message.header(kRosStartNs, "lidar").put(height).put(static_cast<std::uint32_t>(points.size()) / height).count(6);
    std::uint32_t offset = 0;
    for (const auto& [name, type, bytes] :
         {std::tuple("x", 7, 4U), {"y", 7, 4U}, {"z", 7, 4U}, {"intensity", 7, 4U}, {"ring", 4, 2U}, {"time", 7, 4U}}) {
        message.text(name).put(offset).put(static_cast<std::uint8_t>(type)).put(std::uint32_t{1});
        offset += bytes;
    }
    const std::uint32_t step = offset + 3; // bytes that belong to no field
    message.put(std::uint8_t{0}).put(step).put(step * static_cast<std::uint32_t>(points.size()) / height);
    std::vector<std::uint8_t> data;
    const auto add = [&](const auto& value) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
        data.insert(data.end(), first, first + sizeof value);
    };
    for (const RosPoint& point : points) {
        add(point.x), add(point.y), add(point.z), add(point.intensity), add(point.ring), add(point.time);
        data.resize(data.size() + 3, 0xFF);
    }
    return message.array(data).put(std::uint8_t{1}).bytes();
}

} // namespace edgescan::test
