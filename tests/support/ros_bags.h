// Messages and bags of ROS made in memory, for tests: ROS 1 serialization and CDR in both byte orders; bags of ROS 1, MCAP and databases.
#pragma once

#include "core/base/bytes.h"
#include "core/containers/mcap/writer.h"
#include "core/robots/bags/bag.h"

#ifdef EDGESCAN_TESTS_SQLITE
#include <sqlite3.h>
#endif

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
    RosWriter& header(std::int64_t ns, std::string_view frame) {
        if (wire_ == Wire::Ros1) put(std::uint32_t{0});
        return stamp(ns).text(frame);
    }
    template <class T>
    RosWriter& array(const std::vector<T>& values) {
        put(static_cast<std::uint32_t>(values.size()));
        for (const T value : values) put(value);
        return *this;
    }
    /// The count of an array of messages or texts, which follow.
    RosWriter& count(std::uint32_t elements) {
        if (delimits()) put(std::uint32_t{0}); // the length in bytes is not used
        return put(elements);
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

/// Topics and messages, for any container.
struct RosMessages {
    struct Topic {
        std::string name, type, definition;
    };
    struct Message {
        std::uint32_t topic = 0;
        std::int64_t ns = 0;
        Bytes bytes;
    };
    std::vector<Topic> topics;
    std::vector<Message> messages;

    /// With the common definition, as ROS 1 or ROS 2 has it.
    std::uint32_t topic(const std::string& name, const std::string& type, Wire wire) {
        std::string text(robots::commonRosDefinition(type));
        const std::string header = "===\nMSG: std_msgs/Header\n";
        if (const std::size_t at = text.find(header); wire == Wire::Ros1 && at != std::string::npos) {
            const std::size_t end = std::min(text.find("===", at + 3), text.size());
            text.replace(at, end - at, header + "uint32 seq\ntime stamp\nstring frame_id\n");
        }
        topics.push_back({name, type, text});
        return static_cast<std::uint32_t>(topics.size() - 1);
    }
    void message(std::uint32_t topic, std::int64_t ns, const Bytes& bytes) { messages.push_back({topic, ns, bytes}); }
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

inline Bytes bag1Of(const RosMessages& all) {
    BagWriter bag;
    for (const RosMessages::Topic& topic : all.topics) bag.topic(topic.name, topic.type, topic.definition);
    for (const RosMessages::Message& message : all.messages) bag.message(message.topic, message.ns, message.bytes);
    return bag.bag();
}

/// "sensor_msgs/LaserScan" -> "sensor_msgs/msg/LaserScan".
inline std::string ros2Name(std::string type) { return type.insert(type.find('/'), "/msg"); }

inline Bytes mcapOf(const RosMessages& all) {
    containers::McapEncoder encoder("test");
    for (std::size_t n = 0; n < all.topics.size(); ++n) {
        const auto id = static_cast<std::uint16_t>(n + 1);
        encoder.schema({id, ros2Name(all.topics[n].type), "ros2msg", all.topics[n].definition});
        encoder.channel({id, id, all.topics[n].name, "cdr", {}});
    }
    std::uint32_t sequence = 0;
    for (const RosMessages::Message& message : all.messages) {
        containers::McapMessage to;
        to.channel = static_cast<std::uint16_t>(message.topic + 1);
        to.sequence = sequence++;
        to.logNs = to.publishNs = static_cast<std::uint64_t>(message.ns);
        to.payload = message.bytes;
        encoder.message(to);
    }
    encoder.finish();
    return encoder.popBytes();
}

#ifdef EDGESCAN_TESTS_SQLITE
/// A database as rosbag2 writes it; `definitions`: with the table that it has had since 2023.
inline Bytes databaseOf(const RosMessages& all, bool definitions = true) {
    sqlite3* base = nullptr;
    sqlite3_open(":memory:", &base);
    const auto run = [&](const std::string& sql) { sqlite3_exec(base, sql.c_str(), nullptr, nullptr, nullptr); };
    run("PRAGMA page_size=512");
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL, "
        "offered_qos_profiles TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL)");
    if (definitions)
        run("CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL, "
            "encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL)");
    for (std::size_t n = 0; n < all.topics.size(); ++n) {
        const std::string type = "'" + ros2Name(all.topics[n].type) + "'";
        run("INSERT INTO topics VALUES(" + std::to_string(n + 1) + ", '" + all.topics[n].name + "', " + type + ", 'cdr', '')");
        if (definitions)
            run("INSERT INTO message_definitions VALUES(" + std::to_string(n + 1) + ", " + type + ", 'ros2msg', '" +
                all.topics[n].definition + "', '')");
    }
    run("BEGIN");
    sqlite3_stmt* row = nullptr;
    sqlite3_prepare_v2(base, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", -1, &row, nullptr);
    for (const RosMessages::Message& message : all.messages) {
        sqlite3_bind_int64(row, 1, message.topic + 1);
        sqlite3_bind_int64(row, 2, message.ns);
        sqlite3_bind_blob(row, 3, message.bytes.data(), static_cast<int>(message.bytes.size()), SQLITE_TRANSIENT);
        sqlite3_step(row);
        sqlite3_reset(row);
    }
    sqlite3_finalize(row);
    run("COMMIT");
    sqlite3_int64 size = 0;
    unsigned char* file = sqlite3_serialize(base, "main", &size, 0);
    Bytes bytes(file, file + size);
    sqlite3_free(file);
    sqlite3_close(base);
    return bytes;
}
#endif

} // namespace edgescan::test
