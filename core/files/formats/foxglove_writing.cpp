// Clouds for Foxglove and Lichtblick: the cloud, its edges, and the scanner's place in the mine as transforms.
#include "core/files/formats/foxglove.h"

#include "core/base/base64.h"
#include "core/base/json_text.h"
#include "core/base/memory.h"
#include "core/containers/mcap/writer.h"
#include "core/files/point_tables/column_rows.h"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan::files {
namespace {

using FoxgloveJson = nlohmann::ordered_json;

constexpr std::uint64_t kUnknownTimeNs = 1'000'000'000; // no date is known; the same scan gives the same bytes
constexpr std::uint16_t kTransformSchema = 1, kCloudSchema = 2;
enum FoxgloveChannel : std::uint16_t { Transforms = 1, WholeCloud, EdgesAlone, LineByLine };

FoxgloveJson objectSchema(const char* title, const FoxgloveJson& properties) {
    return {{"title", title}, {"type", "object"}, {"properties", properties}};
}
FoxgloveJson numbersSchema(std::initializer_list<const char*> names) {
    FoxgloveJson properties = FoxgloveJson::object();
    for (const char* name : names) properties[name] = {{"type", "number"}};
    return {{"type", "object"}, {"properties", properties}};
}
FoxgloveJson timeSchema() {
    return {{"type", "object"}, {"properties", {{"sec", {{"type", "integer"}}}, {"nsec", {{"type", "integer"}}}}}};
}

/// The messages' fields as docs.foxglove.dev/docs/visualization/message-schemas names them.
std::string transformSchema() {
    return jsonText(objectSchema("foxglove.FrameTransform", {{"timestamp", timeSchema()},
                                                             {"parent_frame_id", {{"type", "string"}}},
                                                             {"child_frame_id", {{"type", "string"}}},
                                                             {"translation", numbersSchema({"x", "y", "z"})},
                                                             {"rotation", numbersSchema({"x", "y", "z", "w"})}}));
}
std::string cloudSchema() {
    const FoxgloveJson field = {
        {"type", "object"},
        {"properties", {{"name", {{"type", "string"}}}, {"offset", {{"type", "integer"}}}, {"type", {{"type", "integer"}}}}}};
    const FoxgloveJson pose = {
        {"type", "object"},
        {"properties", {{"position", numbersSchema({"x", "y", "z"})}, {"orientation", numbersSchema({"x", "y", "z", "w"})}}}};
    return jsonText(objectSchema("foxglove.PointCloud", {{"timestamp", timeSchema()},
                                                         {"frame_id", {{"type", "string"}}},
                                                         {"pose", pose},
                                                         {"point_stride", {{"type", "integer"}}},
                                                         {"fields", {{"type", "array"}, {"items", field}}},
                                                         {"data", {{"type", "string"}, {"contentEncoding", "base64"}}}}));
}

FoxgloveJson vectorOf(const Eigen::Vector3d& v) { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }
FoxgloveJson turnOf(const Eigen::Matrix3d& turn) {
    const Eigen::Quaterniond q(turn);
    return {{"x", q.x()}, {"y", q.y()}, {"z", q.z()}, {"w", q.w()}};
}
FoxgloveJson timeOf(std::uint64_t ns) { return {{"sec", ns / 1'000'000'000}, {"nsec", ns % 1'000'000'000}}; }

/// All rows as binary records, and what a message says of them.
struct PackedCloud {
    std::string frame;
    std::size_t stride = 0;
    FoxgloveJson fields = FoxgloveJson::array();
    std::string records;
    [[nodiscard]] std::string_view rows(std::size_t first, std::size_t count) const {
        return std::string_view(records).substr(first * stride, count * stride);
    }
};

PackedCloud packed(const CloudColumns& cloud, std::string frame) {
    static constexpr std::array<int, 4> kTypes{7, 8, 5, 1}; // FLOAT32, FLOAT64, UINT32, UINT8 of foxglove.PackedElementField
    static constexpr std::array<std::size_t, 4> kSizes{4, 8, 4, 1};
    PackedCloud all;
    all.frame = std::move(frame);
    for (const CloudColumn& column : cloud.columns) {
        all.fields.push_back({{"name", column.name}, {"offset", all.stride}, {"type", kTypes[column.values.index()]}});
        all.stride += kSizes[column.values.index()];
    }
    appendRecords(all.records, cloud);
    return all;
}

/// foxglove.PointCloud of these records.
std::string cloudMessage(const PackedCloud& cloud, std::string_view records, std::uint64_t ns) {
    FoxgloveJson head{{"timestamp", timeOf(ns)},
                      {"frame_id", cloud.frame},
                      {"pose", {{"position", vectorOf(Eigen::Vector3d::Zero())}, {"orientation", turnOf(Eigen::Matrix3d::Identity())}}},
                      {"point_stride", cloud.stride},
                      {"fields", cloud.fields}};
    std::string text = jsonText(head);
    text.back() = ',';
    return text + "\"data\":\"" + base64(records) + "\"}";
}

class FoxgloveFile {
public:
    FoxgloveFile() : encoder_(kFoxgloveLibrary) {
        encoder_.schema({kTransformSchema, "foxglove.FrameTransform", "jsonschema", transformSchema()});
        encoder_.schema({kCloudSchema, "foxglove.PointCloud", "jsonschema", cloudSchema()});
        encoder_.channel({Transforms, kTransformSchema, "/tf", "json", {}});
    }
    void topic(FoxgloveChannel channel, const char* name) { encoder_.channel({channel, kCloudSchema, name, "json", {}}); }
    void message(FoxgloveChannel channel, std::uint64_t ns, const std::string& text) {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
        encoder_.message({channel, sequence_[channel - 1]++, ns, ns, {bytes, text.size()}});
    }
    void transform(const char* parent, const char* child, const Eigen::Vector3d& shift, const Eigen::Matrix3d& turn, std::uint64_t ns) {
        const FoxgloveJson message{{"timestamp", timeOf(ns)},
                                   {"parent_frame_id", parent},
                                   {"child_frame_id", child},
                                   {"translation", vectorOf(shift)},
                                   {"rotation", turnOf(turn)}};
        this->message(Transforms, ns, jsonText(message));
    }
    std::string finish(const std::map<std::string, std::string>& about) {
        encoder_.metadata({kFoxgloveMetadata, about});
        encoder_.finish();
        const Bytes bytes = encoder_.take();
        return {bytes.begin(), bytes.end()};
    }

private:
    containers::McapEncoder encoder_;
    std::array<std::uint32_t, 4> sequence_{};
};

std::uint64_t nsOf(double seconds) { return static_cast<std::uint64_t>(std::llround(seconds * 1e6)) * 1000; }

/// Where x y z are, and the transforms that lead there from the mine grid. One scanner frame holds for a scan that did not move.
std::string writeFrames(FoxgloveFile& file, CloudColumns& cloud, std::uint64_t ns) {
    if (cloud.frame == CoordinateFrame::Scanner) return "scanner";
    if (cloud.frame == CoordinateFrame::Mine && cloud.choices.doubles) {
        file.transform("mine", "scanner", cloud.sensorM, cloud.turn, ns);
        return "mine";
    }
    const Eigen::Vector3d sensor = cloud.frame == CoordinateFrame::Mine ? Eigen::Vector3d(cloud.sensorM - cloud.originM) : cloud.sensorM;
    file.transform("mine", "mine_origin", cloud.originM, Eigen::Matrix3d::Identity(), ns);
    file.transform("mine_origin", "scanner", sensor, cloud.turn, ns);
    if (cloud.frame == CoordinateFrame::Mine) subtractOrigin(cloud);
    return "mine_origin";
}

/// The records of the rows that are edges; empty where the cloud does not say it.
std::string edgeRecords(const CloudColumns& cloud, const PackedCloud& all) {
    std::string records;
    const CloudColumn* edge = columnNamed(cloud, "edge");
    for (std::size_t row = 0; edge != nullptr && row < rowsOf(cloud); ++row) {
        if (numberIn(*edge, row) != 0) records += all.rows(row, 1);
    }
    return records;
}

/// Each line's points at its own time, so that a sweep grows as it did.
void writeLines(FoxgloveFile& file, const CloudColumns& cloud, const PackedCloud& all) {
    const CloudColumn* line = columnNamed(cloud, "line");
    if (line == nullptr || cloud.lineTimesS.size() != cloud.lines) return;
    file.topic(LineByLine, kFoxgloveLinesTopic);
    for (std::size_t first = 0, end = 0; first < rowsOf(cloud); first = end) {
        const double number = numberIn(*line, first);
        for (end = first; end < rowsOf(cloud) && numberIn(*line, end) == number;) ++end;
        const std::uint64_t ns = nsOf(cloud.lineTimesS[static_cast<std::size_t>(number)]);
        file.message(LineByLine, ns, cloudMessage(all, all.rows(first, end - first), ns));
    }
}

std::string threeNumbers(const Eigen::Vector3d& v) { return jsonText(nlohmann::ordered_json{v.x(), v.y(), v.z()}); }

} // namespace

Result<std::string> foxgloveBytes(CloudColumns cloud, const std::string& where, bool) {
    if (auto enough = checkRoom(cloud, where, 40); !enough) return enough.error();
    const bool timed = !cloud.lineTimesS.empty();
    const std::uint64_t start = cloud.startS ? nsOf(*cloud.startS) : kUnknownTimeNs;
    const std::uint64_t end = timed ? nsOf(cloud.lineTimesS.back()) : start;
    const CoordinateFrame frame = cloud.frame;
    FoxgloveFile file;
    const std::string frameId = writeFrames(file, cloud, start);
    // Foxglove takes red, green, blue and alpha as colours when they follow each other.
    if (columnNamed(cloud, "red") != nullptr) cloud.columns.push_back({"alpha", std::vector<std::uint8_t>(rowsOf(cloud), 255)});
    const PackedCloud all = packed(cloud, frameId);
    const bool edgesOnly = columnNamed(cloud, "red") != nullptr && columnNamed(cloud, "edge") == nullptr;
    const char* topic = edgesOnly ? kFoxgloveEdgesTopic : kFoxgloveCloudTopic;
    if (!edgesOnly) writeLines(file, cloud, all);
    file.topic(WholeCloud, topic);
    file.message(WholeCloud, end, cloudMessage(all, all.records, end));
    if (const std::string edges = edgeRecords(cloud, all); !edges.empty()) {
        file.topic(EdgesAlone, kFoxgloveEdgesTopic);
        file.message(EdgesAlone, end, cloudMessage(all, edges, end));
    }
    std::map<std::string, std::string> about{{"topic", topic},
                                             {"width", std::to_string(cloud.width)},
                                             {"height", std::to_string(cloud.height)},
                                             {"frame", frameText(cloud)},
                                             {"sensor_m", threeNumbers(cloud.sensorM)}};
    if (frame == CoordinateFrame::Mine && frameId == "mine_origin") about["origin_m"] = threeNumbers(cloud.originM);
    if (!cloud.description.empty()) about["description"] = cloud.description;
    if (!cloud.record.empty()) about["record"] = cloud.record;
    return file.finish(about);
}

} // namespace edgescan::files
