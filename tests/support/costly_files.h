// Files that need as much time or memory as possible for their size, as an attacker would send them. For the cost fuzzer.
#pragma once

#include "core/base/base64.h"
#include "core/containers/mcap/writer.h"
#include "tests/support/seed_files.h"

#include <functional>
#include <random>

namespace edgescan::test {

/// A kind of file that can be made in any size.
struct CostlyKind {
    std::string reader; ///< as in SeedFile
    std::string extension;
    std::string name;
    std::function<std::string(std::size_t bytes)> make; ///< of about this many bytes
};

namespace costly {

inline std::string repeated(std::string_view piece, std::size_t bytes) {
    std::string text;
    while (text.size() < bytes) text += piece;
    return text;
}

inline std::string head(const char* data, std::size_t points, const char* sizes = "4 4 4", const char* types = "F F F") {
    return "VERSION 0.7\nFIELDS x y z\nSIZE " + std::string(sizes) + "\nTYPE " + types + "\nCOUNT 1 1 1\nWIDTH " + std::to_string(points) +
           "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(points) + "\nDATA " + data + "\n";
}

/// Points in all directions, in random order.
inline std::string looseFloats(std::size_t points) {
    std::mt19937 random(4);
    std::normal_distribution<float> normal(0, 5);
    std::string bytes;
    for (std::size_t n = 0; n < 3 * points; ++n) putAt(bytes, bytes.size(), normal(random));
    return bytes;
}

inline std::string looseText(std::size_t bytes, const char* before = "") {
    std::mt19937 random(4);
    std::string text;
    while (text.size() < bytes) {
        text += before;
        for (int axis = 0; axis < 3; ++axis) text += std::to_string(static_cast<int>(random() % 20001) - 10000) + (axis < 2 ? " " : "\n");
    }
    return text;
}

/// E57 points of three bits each; `farApart`: on a grid with almost only empty cells.
inline std::string bitPoints(std::size_t bytes, bool farApart) {
    std::vector<double> bits;
    for (std::size_t n = 0; n < 2 * bytes; ++n) bits.push_back(static_cast<double>(n % 7 % 2));
    E57Part part{{e57Whole("cartesianX", bits), e57Whole("cartesianY", bits), e57Whole("cartesianZ", bits)}, ""};
    part.bytesPerPacket = 4000;
    if (farApart) {
        const double side = std::sqrt(4.0 * static_cast<double>(bytes));
        for (const char* name : {"rowIndex", "columnIndex"}) {
            E57Column column{name, E57Column::As::Scaled, {}};
            column = e57Whole(name, bits);
            column.values.back() = std::floor(side);
            column.maximum = static_cast<std::int64_t>(side);
            part.columns.push_back(column);
        }
    }
    return e57Bytes({part});
}

/// A bag of ROS 1 without its magic bytes: lines, transforms, and messages of a type without fields.
inline std::string rosBag(std::size_t bytes, const std::function<void(RosMessages&, int)>& add) {
    RosMessages all;
    all.topic("/scan", "sensor_msgs/LaserScan", Wire::Ros1);
    all.topic("/tf", "tf2_msgs/TFMessage", Wire::Ros1);
    all.topics.push_back({"/empty", "std_msgs/Empty", ""});
    std::size_t size = 0;
    for (int n = 0; size < bytes; ++n) {
        add(all, n);
        size += all.messages.back().bytes.size() + 60;
    }
    const Bytes bag = bag1Of(all);
    return std::string(bag.begin(), bag.end()).substr(std::string_view("#ROSBAG V2.0\n").size());
}

/// A line of three beams, so many periods behind the one before every 20 lines.
inline void lineOfThree(RosMessages& all, int n, int apart) {
    RosWriter message(Wire::Ros1);
    message.header(kRosStartNs + (n + n / 20 * apart) * kRosLineNs, "laser").put(0.0F).put(0.02F).put(0.01F).put(0.0F).put(0.04F);
    all.message(0, n, message.put(0.01F).put(80.0F).array<float>({1.0F, 2.0F, 3.0F}).array<float>({}).bytes());
}

/// Telegrams of three beams, with `jump` telegrams counted as lost before each.
inline std::string colaTelegrams(std::size_t count, int jump = 0) {
    std::string stream;
    for (std::size_t n = 0; n < count; ++n) {
        const Bytes frame = scanner::framed(
            scanner::encodeScanTelegram(telegramOfLine(static_cast<int>(n) * (1 + jump), {.beams = 3}), scanner::Dialect::B),
            scanner::Dialect::B);
        stream.append(frame.begin(), frame.end());
    }
    return stream;
}

inline std::string withAngles(const std::string& keys, std::size_t lines, std::size_t beams) {
    return R"({"format":"edgescan-raw-grid/1","beam_deg":{"start":0,"step":0.001},"line_deg":{"start":0,"step":0.001},"axis":"spin","lines":)" +
           std::to_string(lines) + R"(,"beams":)" + std::to_string(beams) + keys + "}";
}

inline std::string lzf(std::size_t bytes) { // back references of 264 bytes
    std::string packed(1, '\0');
    packed += '\0';
    while (packed.size() + 3 <= bytes) packed += std::string("\xe0\xff\x00", 3);
    const std::uint64_t size = 1 + (packed.size() - 2) / 3 * 264;
    std::string file = head("binary_compressed", size / 12);
    putAt(file, file.size(), static_cast<std::uint32_t>(packed.size()));
    putAt(file, file.size(), static_cast<std::uint32_t>(size / 12 * 12));
    return file + packed;
}

inline std::string recordingText(const scanner::SweepMetadata& metadata, const std::vector<files::RecordingMessagePtr>& messages) {
    const Bytes bytes = files::recordingBytes(metadata, messages);
    return {bytes.begin() + static_cast<std::ptrdiff_t>(containers::kMcapMagic.size()), bytes.end()};
}

/// Lines whose counters or beams, or both, change so that sweeps of lost lines result.
inline std::string strangeLines(std::size_t bytes, int jump, bool alternate, int expected) {
    std::vector<files::RecordingMessagePtr> messages;
    std::size_t made = 0;
    for (int n = 0; made < bytes; ++n) {
        messages.push_back(lineMessage(n * jump, {.beams = alternate && n % 2 == 1 ? 301 : 300}));
        made += messages.back()->payload.size() + 70;
    }
    scanner::SweepMetadata metadata{{"sweep.reversal_deg", "0"}};
    if (expected > 0) metadata["sweep.lines"] = std::to_string(expected);
    return recordingText(metadata, messages);
}

inline void addRecord(std::string& file, int opcode, const std::string& content) {
    file += static_cast<char>(opcode);
    putAt(file, file.size(), std::uint64_t{content.size()});
    file += content;
}

inline void addText(std::string& content, const std::string& text) {
    putAt(content, content.size(), static_cast<std::uint32_t>(text.size()));
    content += text;
}

/// The head of a chunk that claims this many bytes behind it; `compression`: the claimed length is that of the compression's name instead
/// of the records.
inline void addFalseChunk(std::string& file, std::uint64_t rest, bool longCompression) {
    file += '\6';
    putAt(file, file.size(), rest + 40);
    file.append(16, '\1');
    putAt(file, file.size(), rest);
    putAt(file, file.size(), std::uint32_t{99});
    putAt(file, file.size(), static_cast<std::uint32_t>(longCompression ? rest : 0));
    putAt(file, file.size(), rest);
}

inline void addSoundChunk(std::string& file) {
    const std::string plain = "\5" + std::string(8, '\0'); // an empty message
    std::string chunk(16, '\1');
    putAt(chunk, 16, std::uint64_t{plain.size()});
    putAt(chunk, 24, containers::crc32(Bytes(plain.begin(), plain.end())));
    putAt(chunk, 28, std::uint32_t{0});
    putAt(chunk, 32, std::uint64_t{plain.size()});
    addRecord(file, 6, chunk + plain);
}

/// False starts of chunks that claim almost all of the following bytes; `sound`: with a valid chunk after every 64 of them, so that each is
/// new damage.
inline std::string falseChunks(std::size_t bytes, bool longCompression, bool sound = false) {
    std::string file(20, '\x77');
    for (int n = 0; file.size() < bytes; ++n) {
        addFalseChunk(file, bytes - file.size(), longCompression);
        if (sound && n % 64 == 63) {
            addSoundChunk(file);
            file += std::string(20, '\x77');
        }
    }
    return file + std::string(200, '\x77');
}

/// A large metadata record, damage, and a summary that lists the record many times.
inline std::string namedOverAndOver(std::size_t bytes) {
    std::string file;
    std::string content, map;
    addText(content, "sweep");
    for (std::size_t n = 0; map.size() < bytes / 2; ++n) {
        addText(map, std::to_string(n));
        addText(map, "");
    }
    addText(content, map);
    addRecord(file, 0x0C, content);
    file += std::string(20, '\x77');
    addSoundChunk(file);
    addRecord(file, 0x0F, std::string(4, '\0'));
    for (std::size_t n = 0; file.size() < bytes; ++n) {
        std::string index;
        putAt(index, 0, std::uint64_t{containers::kMcapMagic.size()});
        putAt(index, 8, std::uint64_t{content.size() + 9});
        addText(index, std::to_string(n)); // never the record's own name
        addRecord(file, 0x0D, index);
    }
    return file;
}

inline std::string smallRecords(std::size_t bytes, int opcode, const std::string& content) {
    std::string file;
    while (file.size() < bytes) addRecord(file, opcode, content);
    return file;
}

/// Its size is chosen so that about this many bytes result.
inline std::string blackPng(std::size_t bytes) {
    std::string png;
    for (int side = 512; png.size() < bytes && side <= 8192; side *= 2) {
        const auto larger = containers::png16Bytes(Grid<std::uint16_t>(side, side), "");
        if (larger) png = *larger;
    }
    return png;
}

} // namespace costly

inline std::vector<CostlyKind> costlyKinds() {
    using namespace costly;
    const auto text = [](const char* piece) { return [piece](std::size_t bytes) { return repeated(piece, bytes); }; };
    std::vector<CostlyKind> kinds{
        {"text", ".xyz", "loose points", [](std::size_t b) { return looseText(b); }},
        {"text", ".xyz", "one point over and over", text("1 2 3\n")},
        {"text", ".xyz", "comments", text("# a\n")},
        {"text", ".xyz", "blank lines", text("\n")},
        {"text", ".xyz", "words", text("no number here\n")},
        {"text", ".xyz", "counts", text("7\n")},
        {"text", ".xyz", "one long number", [](std::size_t b) { return "1 2 " + std::string(b, '7') + "\n"; }},
        {"text", ".xyz", "one long row", text("1 ")},
        {"text", ".xyz", "description in pieces",
         [](std::size_t b) { return "# edgescan {\n" + repeated("# edgescan a\n", b) + "1 2 3\n"; }},
        {"text", ".csv", "decimal commas", text("1,5;2,5;3,5\n")},
        {"text", ".3d", "loose points", [](std::size_t b) { return looseText(b); }},
        {"range_csv", ".csv", "commas", [](std::size_t b) { return "1" + std::string(b, ',') + "\n"; }},
        {"range_csv", ".csv", "short rows", text("1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n")},
        {"obj", ".obj", "loose vertices", [](std::size_t b) { return looseText(b, "v "); }},
        {"obj", ".obj", "faces", text("f 1 2 3\n")},
        {"pcd", ".pcd", "loose floats", [](std::size_t b) { return head("binary", b / 12) + looseFloats(b / 12); }},
        {"pcd", ".pcd", "bytes as coordinates",
         [](std::size_t b) {
             return head("binary", b / 3, "1 1 1", "I I I") + looseFloats(b / 12).substr(0, b / 3 * 3) +
                    std::string(b / 3 * 3 - std::min(b / 3 * 3, b / 12 * 12), '\7');
         }},
        {"pcd", ".pcd", "packed repetition", [](std::size_t b) { return lzf(b); }},
        {"pcd", ".pcd", "header lines", text("FIELDS x y z\n")},
        {"pcd", ".pcd", "description in pieces", [](std::size_t b) { return "# .PCD\n# edgescan {\n" + repeated("# edgescan a\n", b); }},
        {"ply", ".ply", "elements", [](std::size_t b) { return "ply\n" + repeated("element a 0\n", b) + "end_header\n"; }},
        {"ply", ".ply", "loose floats",
         [](std::size_t b) {
             return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(b / 12) +
                    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + looseFloats(b / 12);
         }},
        {"las", ".las", "one point over and over",
         [](std::size_t b) { return smallLas(std::vector<Eigen::Vector3d>(b / 20, Eigen::Vector3d(1, 2, 3))); }},
        {"surpac", ".str", "ends of strings",
         [](std::size_t b) { return "a,b,,\n0, 0, 0, 0\n1, 1, 2, 3\n" + repeated("0, 0, 0, 0\n", b) + "0, 0, 0, 0, END\n"; }},
        {"surpac", ".str", "one point over and over",
         [](std::size_t b) { return "a,b,,\n0, 0, 0, 0\n" + repeated("1,2,3,4\n", b) + "0, 0, 0, 0, END\n"; }},
        {"ptx", ".ptx", "many scans", text("1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0\n")},
        {"ptx", ".ptx", "one long column",
         [](std::size_t b) {
             const std::string rows = repeated("1 2 3 0\n", b);
             return "1\n" + std::to_string(rows.size() / 8) + "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" + rows;
         }},
        {"raw_grid", ".json", "overlapping runs",
         [](std::size_t b) {
             const std::size_t cells = b / 8;
             return withAngles(R"(,"state_runs":[["lost",0,1])" +
                                   repeated(R"(,["lost",0,)" + std::to_string(cells / 100 * 100) + "]", b / 2) + "]",
                               100, cells / 100) +
                    '\0' + std::string(cells / 100 * 200, '\7');
         }},
        {"raw_grid", ".json", "empty runs",
         [](std::size_t b) {
             return withAngles(R"(,"state_runs":[["lost",0,0])" + repeated(R"(,["lost",0,0])", b) + "]", 2, 2) + '\0' + "12345678";
         }},
        {"raw_grid", ".json", "status codes",
         [](std::size_t b) {
             std::string codes = "1";
             for (int n = 2; n < 60000 && codes.size() < b / 2; ++n) codes += "," + std::to_string(n);
             return withAngles(",\"status_codes\":[" + codes + "]", 100, b / 400) + '\0' + std::string(b / 400 * 200, '\xff');
         }},
        {"raw_grid", ".json", "nested lists", [](std::size_t b) { return "{\"a\":" + std::string(b, '[') + std::string(b, ']') + "}"; }},
        {"raw_grid", ".json", "empty objects", [](std::size_t b) { return "{\"a\":[{}" + repeated(",{}", b) + "]}"; }},
        {"raw_grid", ".json", "small numbers", [](std::size_t b) { return "{\"a\":[1" + repeated(",1", b) + "]}"; }},
        {"raw_grid", ".json", "keys",
         [](std::size_t b) {
             std::string json = "{\"a\":0";
             for (std::size_t n = 0; json.size() < b; ++n) json += ",\"" + std::to_string(n) + "\":0";
             return json + "}";
         }},
        {"raw_grid", ".json", "a byte per cell",
         [](std::size_t b) { return withAngles("", b / 200, 100) + '\0' + std::string(b / 200 * 200, '\1'); }},
        {"picture", ".png", "black", [](std::size_t b) { return blackPng(b); }},
        {"mcap", "", "false chunks", [](std::size_t b) { return falseChunks(b, false); }},
        {"mcap", "", "false chunks of long compression", [](std::size_t b) { return falseChunks(b, true); }},
        {"mcap", "", "false chunks between sound ones", [](std::size_t b) { return falseChunks(b, false, true); }},
        {"mcap", "", "metadata named over and over", [](std::size_t b) { return namedOverAndOver(b); }},
        {"mcap", "", "empty messages", [](std::size_t b) { return smallRecords(b, 5, std::string(22, '\1')); }},
        {"mcap", "", "empty metadata", [](std::size_t b) { return smallRecords(b, 0x0C, std::string(8, '\0')); }},
        {"mcap", "", "chunks that are none", [](std::size_t b) { return smallRecords(b, 6, std::string(40, '\0')); }},
        {"mcap", "", "alternating beams", [](std::size_t b) { return strangeLines(b, 1, true, 0); }},
        {"mcap", "", "alternating beams of long sweeps", [](std::size_t b) { return strangeLines(b, 1, true, 20000); }},
        {"mcap", "", "jumping counters", [](std::size_t b) { return strangeLines(b, 1900, false, 0); }},
        {"mcap", "", "leaping counters", [](std::size_t b) { return strangeLines(b, 2100, false, 20000); }},
        {"mcap", "", "readings",
         [](std::size_t b) {
             std::vector<files::RecordingMessagePtr> messages{lineMessage(0), lineMessage(1)};
             const std::string reading = R"({"phi_deg":1})";
             for (std::size_t n = 0; n * 60 < b; ++n)
                 messages.push_back(std::make_shared<const files::RecordingMessage>(
                     files::RecordingMessage{n % 2 == 0 ? files::RecordingTopic::Stepper : files::RecordingTopic::Talin, hostNsOfLine(1),
                                             Bytes(reading.begin(), reading.end())}));
             return recordingText({}, messages);
         }},
        {"ros_bag", "", "empty messages", [](std::size_t b) { return rosBag(b, [](RosMessages& all, int n) { all.message(2, n, {}); }); }},
        {"ros_bag", "", "transforms",
         [](std::size_t b) {
             return rosBag(b, [](RosMessages& all, int n) { all.message(1, n, rosTransform(n * 0.1, kRosStartNs + n * kRosLineNs, {})); });
         }},
        {"ros_bag", "", "lines far apart",
         [](std::size_t b) { return rosBag(b, [](RosMessages& all, int n) { lineOfThree(all, n, 1900); }); }},
        {"ros_bag", "", "lines of one sweep",
         [](std::size_t b) { return rosBag(b, [](RosMessages& all, int n) { lineOfThree(all, n, 1); }); }},
        {"ros_message", "", "values without bytes",
         [](std::size_t b) {
             std::string nested = "T1[1000] a\n";
             for (int n = 1; n < 30; ++n) nested += "===\nMSG: fuzz/T" + std::to_string(n) + "\nT" + std::to_string(n + 1) + "[1000] a\n";
             nested += "===\nMSG: fuzz/T30\n";
             const std::string length{static_cast<char>(nested.size() % 256), static_cast<char>(nested.size() / 256)};
             return '\0' + length + nested + std::string(b, '\0');
         }},
        {"packed", ".xyz.gz", "zeros", [](std::size_t b) { return gzipBytes(std::string(b * 1000, '\0')); }},
        {"packed", ".xyz.gz", "one point over and over", [](std::size_t b) { return gzipBytes(repeated("1 2 3\n", 60 * b)); }},
        {"packed", ".xyz.gz", "half of it one point over and over",
         [](std::size_t b) { return gzipBytes(looseText(b) + repeated("1 2 3\n", 55 * b)); }},
        {"packed", ".xyz.gz", "empty members", [](std::size_t b) { return repeated(gzipBytes(""), b); }},
        {"numpy", ".npy", "bytes as coordinates",
         [](std::size_t b) {
             return npyBytes(npyHeader("'|u1'", false, "(" + std::to_string(b / 3) + ", 3)"),
                             repeated("\1\2\3\4\5", b).substr(0, b / 3 * 3));
         }},
        {"numpy", ".npy", "fields",
         [](std::size_t) { return npyBytes("{'descr': [" + repeated("('a', '<f4', (64,)), ", 1300) + "], ", ""); }},
        {"e57", ".e57", "bits as coordinates", [](std::size_t b) { return bitPoints(b, false); }},
        {"e57", ".e57", "bits far apart", [](std::size_t b) { return bitPoints(b, true); }},
        {"e57", ".e57", "scans",
         [](std::size_t b) {
             return e57Bytes(std::vector<E57Part>(b / 300, {e57Cartesian({{1, 2, 3}}), ""}));
         }},
        {"capture", ".bin", "false starts",
         [](std::size_t b) { return colaTelegrams(1) + repeated(std::string("\2\2\2\2\0\0\xff\0", 8), b); }},
        {"capture", ".bin", "jumping counters", [](std::size_t b) { return colaTelegrams(b / 100, 1900); }},
        {"capture", ".pcap", "empty packets", [](std::size_t b) { return captureOf(std::vector<TcpPart>(b / 70), {.link = Link::Raw}); }},
        {"capture", ".pcap", "connections",
         [](std::size_t b) {
             std::vector<TcpPart> parts;
             for (std::uint32_t n = 0; parts.size() * 250 < b; ++n) {
                 parts.push_back({n, "", true, kEpochNs + n});
                 parts.push_back({n + 1, colaTelegrams(1), false, kEpochNs + n});
             }
             return captureOf(parts, {.link = Link::Raw});
         }},
        {"capture", ".pcap", "segments backwards",
         [](std::size_t b) {
             std::vector<TcpPart> parts{{100, colaTelegrams(1)}};
             for (std::size_t n = 0; n * 70 < b; ++n)
                 parts.push_back({static_cast<std::uint32_t>(1U << 30U) - static_cast<std::uint32_t>(n), "xx"});
             return captureOf(parts, {.link = Link::Raw});
         }},
        {"place", "", "readings",
         [](std::size_t b) {
             return R"({"format":"edgescan-pose/1","inclinometer":[{"tilt_x_deg":1})" + repeated(R"(,{"tilt_x_deg":1})", b) + "]}";
         }},
        {"place", "", "nested lists", [](std::size_t b) { return "{\"a\":" + std::string(b, '[') + "}"; }},
        {"session", "", "runs", [](std::size_t b) { return R"({"format":"edgescan-session/1","selected":[)" + repeated("1,", b) + "1]}"; }},
        {"session", "", "nested lists", [](std::size_t b) { return "{\"layout\":" + std::string(b, '[') + "}"; }},
        {"cola_stream", "", "false starts",
         [](std::size_t b) { return std::string("\2\377") + repeated(std::string("\2\2\2\2\0\0\xff\0", 8), b); }},
        {"scan_telegram", "", "channels", [](std::size_t b) { return std::string("\0", 1) + repeated("ffff ", b); }},
    };
    return kinds;
}

} // namespace edgescan::test
