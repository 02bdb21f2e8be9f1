// Reads what foxgloveBytes() wrote. Other programs' messages are named by the reader of recordings.
#include "core/files/formats/foxglove.h"

#include "core/base/base64.h"
#include "core/base/bounded_json.h"
#include "core/base/checked_size.h"
#include "core/containers/mcap/reader.h"
#include "core/files/formats/format.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/point_columns.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostCloudFields = 64;
constexpr std::uint64_t kLargestCloudRecord = 4096;

ByteView viewOf(std::string_view bytes) { return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}; }

bool looksLikeFoxglove(const Source& source) {
    const std::string_view text = source.text();
    return text.starts_with(containers::kMcapMagic) && text.substr(0, 128).find(kFoxgloveLibrary) != std::string_view::npos;
}

const containers::McapMetadata* aboutCloud(const containers::McapContent& content) {
    const auto found = std::ranges::find(content.metadata, kFoxgloveMetadata, &containers::McapMetadata::name);
    return found == content.metadata.end() ? nullptr : &*found;
}

std::string entryOf(const containers::McapMetadata& about, const char* key) {
    const auto found = about.entries.find(key);
    return found == about.entries.end() ? std::string() : found->second;
}

std::optional<Eigen::Vector3d> vectorFrom(const std::string& text) {
    const auto json = parseJson(text, "", kReadingJson);
    if (!json || !json->is_array() || json->size() != 3) return std::nullopt;
    Eigen::Vector3d v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(*json)[axis].is_number()) return std::nullopt;
        v[static_cast<Eigen::Index>(axis)] = (*json)[axis].get<double>();
    }
    return v;
}

std::optional<std::uint64_t> wholeIn(const nlohmann::json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number_unsigned()) return std::nullopt;
    return found->get<std::uint64_t>();
}

/// foxglove.PackedElementField: its numbers for types.
std::optional<Scalar> scalarOfElement(std::uint64_t type) {
    static constexpr std::array<Scalar, 9> kScalars{Scalar::UInt8,  Scalar::UInt8, Scalar::Int8,    Scalar::UInt16, Scalar::Int16,
                                                    Scalar::UInt32, Scalar::Int32, Scalar::Float32, Scalar::Float64};
    if (type == 0 || type >= kScalars.size()) return std::nullopt;
    return kScalars[type];
}

std::optional<std::vector<RecordField>> fieldsOf(const nlohmann::json& message, std::uint64_t stride) {
    const auto list = message.find("fields");
    if (list == message.end() || !list->is_array() || list->size() > kMostCloudFields) return std::nullopt;
    std::vector<RecordField> fields;
    for (const nlohmann::json& element : *list) {
        if (!element.is_object() || !element.contains("name") || !element["name"].is_string()) return std::nullopt;
        const auto offset = wholeIn(element, "offset"), type = wholeIn(element, "type");
        const auto scalar = scalarOfElement(type.value_or(0));
        if (!offset || !scalar || *offset > stride || stride - *offset < sizeOf(*scalar)) return std::nullopt;
        fields.push_back({element["name"].get<std::string>(), *scalar, 0, *offset, stride});
    }
    return fields;
}

Result<Done> readCloud(PointTable& table, const containers::McapMessage& message, const Source& source) {
    const std::string_view text(reinterpret_cast<const char*>(message.payload.data()), message.payload.size());
    const auto json = parseJson(text, source.path.string(), {text.size(), 6, 1000});
    if (!json) return json.error();
    const Error wrong = source.refused("its point cloud is not as foxglove.PointCloud describes one", kCopyAgain);
    const auto stride = json->is_object() ? wholeIn(*json, "point_stride") : std::nullopt;
    if (!stride || *stride == 0 || *stride > kLargestCloudRecord || !json->contains("data") || !(*json)["data"].is_string()) return wrong;
    const auto fields = fieldsOf(*json, *stride);
    const auto bytes = bytesOfBase64((*json)["data"].get_ref<const std::string&>());
    if (!fields || !bytes) return wrong;
    const std::uint64_t points = productOf({table.width, table.height});
    if (points == 0 || bytes->size() != productOf({points, *stride}))
        return source.refused("promises " + std::to_string(points) + " points of " + std::to_string(*stride) + " bytes and holds " +
                                  std::to_string(bytes->size()) + " bytes of them",
                              kCopyAgain);
    const auto picked = pickFields(*fields);
    if (!picked) return wrong;
    if (!readRecords(table, *picked, points, std::as_bytes(std::span(*bytes)), false, source)) return source.cancelled();
    return Done{};
}

Result<PointTable> readFoxglovePoints(const Source& source) {
    const auto content = containers::readMcap(viewOf(source.text()), source.path.string(), [&] { return source.goOn("reading", 0.0); });
    if (!content) return content.error();
    const containers::McapMetadata* about = aboutCloud(*content);
    if (about == nullptr) return source.refused("the record \"edgescan\" that says what the messages are is not there", kCopyAgain);
    PointTable table;
    table.format = "Foxglove";
    table.width = wholeNumber(entryOf(*about, "width")).value_or(0);
    table.height = wholeNumber(entryOf(*about, "height")).value_or(0);
    table.description = entryOf(*about, "description");
    table.sensor = vectorFrom(entryOf(*about, "sensor_m")).value_or(Eigen::Vector3d::Zero());
    const std::string topic = entryOf(*about, "topic");
    const auto cloud = std::ranges::find_if(content->messages, [&](const containers::McapMessage& message) {
        const containers::McapChannel* channel = containers::channelOf(*content, message);
        return channel != nullptr && channel->topic == topic;
    });
    if (cloud == content->messages.end()) return source.refused("there is no message on " + topic.substr(0, 40), kCopyAgain);
    if (auto read = readCloud(table, *cloud, source); !read) return read.error();
    if (const auto origin = vectorFrom(entryOf(*about, "origin_m"))) {
        for (Eigen::Vector3d& p : table.points) p += *origin;
    }
    table.remarks = content->warnings;
    if (!content->clean && table.remarks.empty()) table.remarks.emplace_back("The file was cut off behind its points.");
    return table;
}

std::string recordOfFoxglove(std::string_view bytes) {
    const auto content = containers::readMcap(viewOf(bytes), "");
    const containers::McapMetadata* about = content ? aboutCloud(*content) : nullptr;
    return about != nullptr ? entryOf(*about, "record") : std::string();
}

} // namespace

Format foxgloveFormat() {
    return {.title = "Foxglove, Lichtblick",
            .reads = {".foxglove.mcap"},
            .writes = {".foxglove.mcap"},
            .recognises = looksLikeFoxglove,
            .read = readingOf<readFoxglovePoints>,
            .write = foxgloveBytes,
            .record = recordOfFoxglove,
            .keepsIntensity = true,
            .aboutOrigin = true};
}

} // namespace edgescan::files
