// Definitions of ROS messages: which fields a message has, as the text in a bag says it (ROS 1 .msg, ROS 2 .msg; wiki.ros.org/msg,
// docs.ros.org, "About ROS 2 interfaces").
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::robots {

enum class RosScalar : std::uint8_t {
    Bool,
    Int8,
    Uint8,
    Int16,
    Uint16,
    Int32,
    Uint32,
    Int64,
    Uint64,
    Float32,
    Float64,
    String,
    Time,
    Message
};

/// Bytes of a number; 8 for Time (two numbers of 4 bytes), 0 for String and Message.
[[nodiscard]] std::size_t bytesOf(RosScalar scalar);

enum class RosLength : std::uint8_t { One, Fixed, Counted }; ///< T, T[N], T[] or T[<=N]

struct RosField {
    std::string name;
    RosScalar scalar = RosScalar::Message;
    std::size_t type = 0; ///< of a Message: index in RosDefinition::types
    RosLength length = RosLength::One;
    std::uint32_t count = 1; ///< of Fixed
};

struct RosType {
    std::string name; ///< "sensor_msgs/LaserScan": without "msg/"
    std::vector<RosField> fields;
};

/// A message type with all types that it contains; types[0] is the message itself.
struct RosDefinition {
    std::vector<RosType> types;
};

/// "sensor_msgs/msg/LaserScan" -> "sensor_msgs/LaserScan".
[[nodiscard]] std::string rosTypeName(std::string_view name);

/// The text of a definition: the message's own lines, then for each other type a line of "=", "MSG: package/Type" and its lines. A line of
/// "time" or "duration" is a Time of ROS 1. Error: a line that is not understood, a type that is not there, a type that contains itself.
Result<RosDefinition> rosDefinition(const std::string& typeName, std::string_view text, const std::string& where);

} // namespace edgescan::robots
