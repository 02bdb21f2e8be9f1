// Messages and bags of ROS made in memory, for tests: ROS 1 serialization and CDR in both byte orders.
#pragma once

#include "core/base/bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::test {

enum class Wire { Ros1, CdrLittle, CdrBig, Cdr2Little, Cdr2Big };

/// Writes the values of a message one behind the other.
class RosWriter {
public:
    explicit RosWriter(Wire wire) : wire_(wire) {
        if (wire == Wire::Ros1) return;
        const std::uint8_t kind = wire == Wire::CdrBig ? 0 : wire == Wire::CdrLittle ? 1 : wire == Wire::Cdr2Big ? 6 : 7;
        bytes_ = {0, kind, 0, 0};
    }
    template <class T>
    RosWriter& put(T value) {
        std::array<std::uint8_t, sizeof(T)> raw = std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(value);
        if (big()) std::ranges::reverse(raw);
        align(sizeof(T));
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
        return *this;
    }
    RosWriter& text(std::string_view text) {
        const bool ends = wire_ != Wire::Ros1;
        put(static_cast<std::uint32_t>(text.size() + (ends ? 1 : 0)));
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        if (ends) bytes_.push_back(0);
        return *this;
    }
    /// The stamp of a header: sec and nanosec.
    RosWriter& stamp(std::int64_t ns) {
        return put(static_cast<std::uint32_t>(ns / 1'000'000'000)).put(static_cast<std::uint32_t>(ns % 1'000'000'000));
    }
    template <class T>
    RosWriter& array(const std::vector<T>& values) {
        put(static_cast<std::uint32_t>(values.size()));
        for (const T value : values) put(value);
        return *this;
    }
    [[nodiscard]] bool delimits() const { return wire_ == Wire::Cdr2Little || wire_ == Wire::Cdr2Big; }
    [[nodiscard]] const Bytes& bytes() const { return bytes_; }

private:
    [[nodiscard]] bool big() const { return wire_ == Wire::CdrBig || wire_ == Wire::Cdr2Big; }
    void align(std::size_t size) {
        if (wire_ == Wire::Ros1) return;
        const std::size_t to = std::min<std::size_t>(size, delimits() ? 4 : 8);
        while ((bytes_.size() - 4) % to != 0) bytes_.push_back(0);
    }
    Wire wire_;
    Bytes bytes_;
};

/// A bag of ROS 1 with one plain chunk.
class BagWriter {
public:
    /// The number of the connection.
    std::uint32_t topic(const std::string& name, const std::string& type, const std::string& definition) {
        const std::uint32_t id = topics_++;
        record(chunk_, {{"op", "\x07"}, {"conn", number(id)}, {"topic", name}},
               fields({{"topic", name}, {"type", type}, {"message_definition", definition}}));
        return id;
    }
    void message(std::uint32_t topic, std::int64_t ns, const Bytes& bytes) {
        record(chunk_,
               {{"op", "\x02"},
                {"conn", number(topic)},
                {"time", number(static_cast<std::uint32_t>(ns / 1'000'000'000)) + number(static_cast<std::uint32_t>(ns % 1'000'000'000))}},
               std::string(bytes.begin(), bytes.end()));
    }
    [[nodiscard]] Bytes bag() const {
        std::string all = "#ROSBAG V2.0\n";
        record(all, {{"op", "\x03"}}, std::string(64, ' '));
        record(all, {{"op", "\x05"}, {"compression", "none"}, {"size", number(static_cast<std::uint32_t>(chunk_.size()))}}, chunk_);
        return Bytes(all.begin(), all.end());
    }

private:
    using Fields = std::vector<std::pair<std::string, std::string>>;
    static std::string number(std::uint32_t value) { return {reinterpret_cast<const char*>(&value), 4}; }
    static std::string fields(const Fields& all) {
        std::string text;
        for (const auto& [name, value] : all)
            text += number(static_cast<std::uint32_t>(name.size() + 1 + value.size())) + name + '=' + value;
        return text;
    }
    static void record(std::string& to, const Fields& header, const std::string& data) {
        const std::string head = fields(header);
        to += number(static_cast<std::uint32_t>(head.size())) + head + number(static_cast<std::uint32_t>(data.size())) + data;
    }
    std::string chunk_;
    std::uint32_t topics_ = 0;
};

} // namespace edgescan::test
