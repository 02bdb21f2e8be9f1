// ROS messages from their bytes: ROS 1 serialization, and CDR of ROS 2 (DDS-XTypes 1.3, section 7.4: PLAIN_CDR and PLAIN_CDR2, both byte
// orders). A field that moved in the definition is found by its name.
#pragma once

#include "core/base/bytes.h"
#include "core/robots/bags/definition.h"

#include <optional>
#include <span>

namespace edgescan::robots {

/// A value in a message: a number, a text, numbers in a row, or values with names. It points into the message's bytes.
struct RosValue {
    const RosField* field = nullptr; ///< null: the message itself
    ByteView bytes;                  ///< of a text, a number, or an array of numbers
    std::size_t count = 1;           ///< of an array
    bool bigEndian = false;          ///< of the numbers in `bytes`
    const RosType* type = nullptr;   ///< of a Message
    std::vector<RosValue> inside;    ///< fields of a Message by their order; elements of an array of messages or texts

    /// A field, also of a field: "header.stamp.sec". Null: there is none.
    [[nodiscard]] const RosValue* at(std::string_view path) const;
    /// The number at `path`; empty: there is none, or it is an array.
    [[nodiscard]] std::optional<double> number(std::string_view path) const;
    [[nodiscard]] std::string_view text(std::string_view path) const;
    /// The array of numbers at `path`; empty: there is none.
    [[nodiscard]] std::vector<double> numbers(std::string_view path) const;
    /// Number n of this array.
    [[nodiscard]] double element(std::size_t n) const;
};

enum class RosEncoding : std::uint8_t { Ros1, Cdr };

/// The message in `bytes`. `definition` and `bytes` must outlive the value. Memory is in proportion to the bytes, whatever counts they
/// claim. Error: it ends too early, or its encapsulation is not one of those above.
Result<RosValue> rosMessage(const RosDefinition& definition, RosEncoding encoding, ByteView bytes, const std::string& where);

/// Nanoseconds since 1970 of a stamp: Time of ROS 1, or a message with sec and nanosec. Empty: it is neither.
[[nodiscard]] std::optional<std::int64_t> stampNs(const RosValue& value, std::string_view path);

} // namespace edgescan::robots
